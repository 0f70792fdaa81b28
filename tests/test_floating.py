"""A floating crane in FMPy, both standards and both interfaces, against an implementation of its own: sections clipped as
polygons along the hull, equilibrium and energy by SciPy; and in the book."""

import math
import re

import numpy as np
import pytest
from fmpy import extract, instantiate_fmu, read_model_description, simulate_fmu
from fmpy.validation import validate_fmu
from scipy.optimize import brentq, fsolve, minimize_scalar

from conftest import ROOT, lemnis, typst, words

ENDS = {"FMI 2": ".fmi2.fmu", "FMI 3": ".fmu"}
SCENE = ROOT / "models/scenes/floating_static.toml"
G, RHO = 9.81, 1025.0
T = 1e3 * G
# Weights of the scene with their places; tanks: length, breadth, filled, middle, bottom.
MASSES = [(1450 * T, -0.8, 0.0, 2.6), (620 * T, 12.0, 0.0, 13.5), (480 * T, -13.5, 0.0, 0.8)]
TANKS = [(12.0, 8.0, 1.6, -8.0, side * 7.5, 0.2, 4.0) for side in (1, -1)]
WIND = 250.0 * (150.0 * (3.3 - 1.1) + 240.0 * (19.0 - 1.1))
AXIS, HIGH = 12.0, 38.0
NODES, FACTORS = np.polynomial.legendre.leggauss(6)


def clipped(polygon, level, slope):
    """The part of a polygon (y, z) below z = level + slope y."""
    found = []
    for (y, z), (v, w) in zip(polygon, polygon[1:] + polygon[:1]):
        here, there = level + slope * y - z, level + slope * v - w
        if here > 0:
            found.append((y, z))
        if (here > 0) != (there > 0):
            part = here / (here - there)
            found.append((y + part * (v - y), z + part * (w - z)))
    return found


def area(polygon):
    """Area with its first moments, by the shoelace formula."""
    sums = np.zeros(3)
    for (y, z), (v, w) in zip(polygon, polygon[1:] + polygon[:1]):
        cross = y * w - v * z
        sums += np.array([cross / 2, cross * (y + v) / 6, cross * (z + w) / 6])
    return sums


def below(stations, plane):
    """Volume of a hull (x and polygon of each section) below a plane, and its first moments: between places where a corner
    meets the plane they are polynomials of x."""
    level, along, across = plane
    sums = np.zeros(4)
    for (x, one), (u, other) in zip(stations, stations[1:]):
        depth = [(level + along * x + across * y - z, level + along * u + across * v - w) for (y, z), (v, w) in zip(one, other)]
        breaks = sorted({0.0, 1.0, *(p / (p - q) for p, q in depth if p * q < 0)})
        for start, end in zip(breaks, breaks[1:]):
            for node, factor in zip(NODES, FACTORS):
                t = start + (end - start) * (node + 1) / 2
                at = x + t * (u - x)
                section = [((1 - t) * y + t * v, (1 - t) * z + t * w) for (y, z), (v, w) in zip(one, other)]
                wet = clipped(section, level + along * at, across)
                if len(wet) > 2:
                    whole, side, up = area(wet)
                    sums += factor * (end - start) / 2 * (u - x) * np.array([whole, at * whole, side, up])
    return sums


def box(length, breadth, depth, x=0.0, y=0.0, z=0.0):
    section = [(y - breadth / 2, z), (y + breadth / 2, z), (y + breadth / 2, z + depth), (y - breadth / 2, z + depth)]
    return [(x - length / 2, section), (x + length / 2, section)]


def level(stations, volume, along, across, found=below):
    """Where a liquid of this volume stands."""
    return brentq(lambda z: found(stations, (z, along, across))[0] - volume, -60.0, 80.0, xtol=1e-13, rtol=1e-14)


class Hull:
    """A hull with what it bears: weight and moments, liquids among them at rest as the scene has them."""

    def __init__(self, stations, masses, tanks, moments=(0.0, 0.0)):
        self.stations, self.moments = stations, np.array(moments)
        self.open = []
        self.tanks = [(box(l, b, deep, x, y, z), l * b * h, RHO * G) for l, b, h, x, y, z, deep in tanks]
        self.solid = masses
        self.weight = sum(mass[0] for mass in masses) + sum(volume * heavy for _, volume, heavy in self.tanks)

    def bearing(self, stations, plane):
        """Volume with its first moments, without what is open to the water: walls and permeability of each."""
        lost = [share * below(walls, plane) for walls, share in self.open]
        return below(stations, plane) - sum(lost, np.zeros(4))

    def level(self, along, across):
        return level(self.stations, self.weight / (RHO * G), along, across, self.bearing)

    def gravity(self, along, across):
        sums = sum(mass[0] * np.array(mass[1:]) for mass in self.solid)
        for walls, volume, heavy in self.tanks:
            sums = sums + heavy * below(walls, (level(walls, volume, along, across), along, across))[1:]
        sums[:2] += self.moments
        return sums / self.weight

    def arm(self, plane):
        volume, *moment = self.bearing(self.stations, plane)
        return np.array(moment) / volume - self.gravity(*plane[1:])

    def rest(self):
        """Draft and slopes at rest."""
        wanted = self.weight / (RHO * G)

        def apart(plane):
            arm = self.arm(plane)
            return [self.bearing(self.stations, plane)[0] / wanted - 1, arm[0] + plane[1] * arm[2], arm[1] + plane[2] * arm[2]]

        upright = self.level(0.0, 0.0)
        found, _, done, _ = fsolve(apart, [upright, 0.0, 0.0], xtol=1e-14, full_output=True)
        assert np.abs(apart(found)).max() < 1e-10
        return found

    def lying(self, heel, along):
        """Height of the centre of gravity over that of buoyancy at a heel and a trim, and the water's plane."""
        across = math.tan(heel)
        plane = (self.level(along, across), along, across)
        normal = np.array([-along, -across, 1.0])
        return -normal @ self.arm(plane) / np.linalg.norm(normal), plane

    def trim(self, heel):
        """Of least energy at a heel."""
        return minimize_scalar(lambda t: self.lying(heel, t)[0], bounds=(-0.2, 0.2), method="bounded", options={"xatol": 1e-9})

    def energy(self, heel):
        """Least height of the centre of gravity over that of buoyancy at a heel, over all trims."""
        return self.trim(heel).fun


def crane(psi, reach, load, lost=False, centred=False):
    hung = [] if lost else [(load, AXIS + reach * math.cos(psi), reach * math.sin(psi), HIGH)]
    hull = Hull(box(60.0, 24.0, 4.5), MASSES + hung, TANKS, (0.0, WIND))
    if centred:
        hull.moments[1] -= hull.gravity(0.0, 0.0)[1] * hull.weight
    return hull


@pytest.fixture(scope="module")
def fmus(tmp_path_factory):
    folder = tmp_path_factory.mktemp("floating")
    lemnis("fmu", SCENE, "--output", folder)
    return {standard: str(folder / f"FloatingCraneStatic{end}") for standard, end in ENDS.items()}


def at(fmu, names, start=None, **given):
    """Results at one place."""
    inputs = np.array([(t, *given.values()) for t in (0.0, 1.0)], dtype=[(name, float) for name in ("time", *given)])
    found = simulate_fmu(fmu, fmi_type="CoSimulation", stop_time=1.0, output_interval=1.0, input=inputs, output=list(names),
                         start_values=start or {})
    return {name: found[name][-1] for name in names}


@pytest.mark.parametrize("standard", ENDS)
def test_its_inputs_and_results(fmus, standard):
    assert not validate_fmu(fmus[standard])
    description = read_model_description(fmus[standard])
    causality = {variable.name: variable.causality for variable in description.modelVariables}
    wanted = {name: "input" for name in ("psi_sl", "R", "Q")} | {name: "parameter" for name in ("L", "G_m[2]", "h_t[1]", "p_w")}
    wanted |= {name: "output" for name in ("phi", "theta", "T", "f_1", "f_low", "GM", "A_res", "phi_2", "d_A", "GZ[5]")}
    assert {name: causality[name] for name in wanted} == wanted


@pytest.mark.parametrize("kind", ["CoSimulation", "ModelExchange"])
@pytest.mark.parametrize("standard", ENDS)
def test_heel_and_trim_of_a_crane_that_slews_and_luffs(fmus, standard, kind):
    times = np.linspace(0.0, 40.0, 9)
    given = {"psi_sl": np.radians(9.0) * times, "R": 12.0 + 0.4 * times, "Q": 900e3 + 10e3 * times}
    inputs = np.array(list(zip(times, *given.values())), dtype=[(name, float) for name in ("time", *given)])
    found = simulate_fmu(fmus[standard], fmi_type=kind, stop_time=40.0, output_interval=5.0, input=inputs,
                         output=["psi_sl", "R", "Q", "T", "phi", "theta", "beta", "f_1", "f_2", "f_3", "f_4", "f_low"])
    assert np.ptp(found["psi_sl"]) > 5.0
    for row in found:
        draft, along, across = crane(row["psi_sl"], row["R"], row["Q"]).rest()
        size = math.sqrt(1 + along**2 + across**2)
        free = [(4.5 - draft - x * along - y * across) / size for x, y in [(30, -12), (30, 12), (-30, 12), (-30, -12)]]
        wanted = {"T": draft, "phi": math.atan(across), "theta": math.atan(along), "beta": math.acos(1 / size),
                  **{f"f_{i + 1}": value for i, value in enumerate(free)}, "f_low": min(free)}
        for name, value in wanted.items():
            assert row[name] == pytest.approx(value, abs=1e-9), name


def test_levers_and_areas_past_deck_edge_and_bilge(fmus):
    names = [f"{name}[{i}]" for name in ("GZ", "e") for i in range(1, 6)]
    found = at(fmus["FMI 3"], names, psi_sl=2.0, R=25.0, Q=100 * T)
    hull = crane(2.0, 25.0, 100 * T, centred=True)
    upright, step = hull.energy(0.0), 1e-4
    for i, heel in enumerate(np.radians([5.0, 10.0, 15.0, 20.0, 30.0]), 1):
        assert found[f"e[{i}]"] == pytest.approx(hull.energy(heel) - upright, abs=1e-9)
        slope = (hull.energy(heel + step) - hull.energy(heel - step)) / (2 * step)
        assert found[f"GZ[{i}]"] == pytest.approx(slope, abs=1e-5)


def test_a_load_is_lost(fmus):
    psi, reach, load = math.radians(70.0), 25.0, 100 * T
    names = ["phi", "phi_Q0", "A_I", "A_II", "phi_2", "d_A", "A_res"]
    found = at(fmus["FMI 3"], names, psi_sl=psi, R=reach, Q=load)
    loaded, empty, end = crane(psi, reach, load), crane(psi, reach, load, lost=True), math.radians(20.0)
    heel, rest = (math.atan(hull.rest()[2]) for hull in (loaded, empty))
    low = empty.energy(rest)
    drives, stops = empty.energy(heel) - low, empty.energy(-end) - low
    rolls = brentq(lambda phi: empty.energy(phi) - low - drives, -end, rest - 1e-3, xtol=1e-10)
    wanted = {"phi": heel, "phi_Q0": rest, "A_I": drives, "A_II": stops, "phi_2": rolls,
              "d_A": stops - drives - math.radians(2.13), "A_res": loaded.energy(end) - loaded.energy(heel)}
    for name, value in wanted.items():
        assert found[name] == pytest.approx(value, abs=1e-7), name


def test_a_sudden_wind(fmus):
    """From a roll of 2° against it; the tangent lies beyond the deck's edge."""
    psi, reach, load = math.radians(250.0), 25.0, 100 * T
    found = at(fmus["FMI 3"], ["phi", "phi_s", "phi_dyn", "M_c", "M_g"], {"phi_f": math.radians(45.0)}, psi_sl=psi, R=reach, Q=load)
    loaded, struck, end = crane(psi, reach, load), crane(psi, reach, load), -math.radians(45.0)
    struck.moments[1] -= WIND
    heel, rest = (math.atan(hull.rest()[2]) for hull in (loaded, struck))
    start = heel + math.radians(2.0)
    high = struck.energy(start)
    rolls = brentq(lambda phi: struck.energy(phi) - high, end, rest - 1e-3, xtol=1e-10)
    low = loaded.energy(start)
    chord = minimize_scalar(lambda phi: (loaded.energy(phi) - low) / (phi - start), bounds=(end, rest), method="bounded",
                            options={"xatol": 1e-7})
    assert end + 0.1 < chord.x < -math.radians(12.0)
    wanted = {"phi": heel, "phi_s": rest, "phi_dyn": rolls, "M_c": -loaded.weight * chord.fun, "M_g": WIND}
    for name, value in wanted.items():
        assert found[name] == pytest.approx(value, rel=1e-7, abs=1e-7), name


@pytest.mark.parametrize("psi", [70.0, 250.0])
def test_openings_come_to_the_water(fmus, psi):
    """Heights at rest, and heels by the independent hull; where one floods before phi_f, areas end there."""
    psi, reach, load = math.radians(psi), 25.0, 100 * T
    places = [(-22.0, 8.0, 7.2), (-22.0, -8.0, 7.2)]
    names = [f"{name}[{i}]" for name in ("f_o", "phi_o", "phi_o0") for i in (1, 2)]
    found = at(fmus["FMI 3"], [*names, "phi", "A_res", "A_II"], {"phi_f": math.radians(40.0)}, psi_sl=psi, R=reach, Q=load)
    loaded, empty = crane(psi, reach, load), crane(psi, reach, load, lost=True)
    draft, along, across = loaded.rest()
    side = math.copysign(1.0, across)

    def over(hull, heel, place):
        """Height of a place over the water at a heel, at the trim of least energy."""
        draft, x, y = hull.lying(heel, hull.trim(heel).x)[1]
        return place[2] - draft - x * place[0] - y * place[1]

    heels = [[], []]
    for i, place in enumerate(places):
        height = (place[2] - draft - place[0] * along - place[1] * across) / math.sqrt(1 + along**2 + across**2)
        assert found[f"f_o[{i + 1}]"] == pytest.approx(height, abs=1e-9)
        for hull, sign, name, known in ((loaded, side, "phi_o", heels[0]), (empty, -side, "phi_o0", heels[1])):
            if sign * place[1] > 0:
                heel = brentq(lambda phi: over(hull, sign * phi, place), 0.1, 0.8, xtol=1e-9)
                assert found[f"{name}[{i + 1}]"] == pytest.approx(heel, abs=1e-6), name
                known.append(heel)
            else:
                assert found[f"{name}[{i + 1}]"] > 0.8
    ends = [min(known) for known in heels]
    assert all(math.radians(20.0) < end < math.radians(40.0) for end in ends)
    heel = math.atan(across)
    assert found["A_res"] == pytest.approx(loaded.energy(side * ends[0]) - loaded.energy(heel), abs=1e-6)
    rest = math.atan(empty.rest()[2])
    assert found["A_II"] == pytest.approx(empty.energy(-side * ends[1]) - empty.energy(rest), abs=1e-6)


def raked(sections):
    """A pontoon with raked ends, by sections of half breadth and height."""
    text = SCENE.read_text(encoding="utf-8")
    head, rest = text.split("L     =")
    rest = rest[rest.index("R     =") :].replace("[[hull.masses]]", "@", 1)
    cut = "".join(
        f'[[hull.sections]]\nx_h = "{x} m"\npoints = [{", ".join(f"{chr(34)}{y} m, {z} m{chr(34)}" for y, z in points)}]\n'
        for x, points in sections
    )
    return head + rest.replace("@", cut + "[[hull.masses]]")


RAKED = [(x, [(12.0, low), (12.0, 4.5)]) for x, low in [(-32.0, 3.0), (-25.0, 0.0), (10.0, 0.0), (25.0, 0.0), (32.0, 3.0)]]


def test_a_pontoon_with_raked_ends(tmp_path):
    path = tmp_path / "raked.toml"
    path.write_text(raked(RAKED), encoding="utf-8")
    lemnis("fmu", path, "--output", tmp_path)
    fmu = str(tmp_path / "FloatingCraneStatic.fmu")
    stations = [(x, [(-12.0, low), (12.0, low), (12.0, top), (-12.0, top)]) for x, [(_, low), (_, top)] in RAKED]
    for psi in (0.3, 1.6, 2.9):
        found = at(fmu, ["T", "phi", "theta", "T_0", "x_B", "z_B", "e[5]"], psi_sl=psi, R=25.0, Q=100 * T)
        hull = crane(psi, 25.0, 100 * T)
        hull.stations = stations
        draft, along, across = hull.rest()
        volume = hull.weight / (RHO * G)
        upright = level(stations, volume, 0.0, 0.0)
        _, x, _, z = below(stations, (upright, 0.0, 0.0)) / volume
        wanted = {"T": draft, "phi": math.atan(across), "theta": math.atan(along), "T_0": upright, "x_B": x, "z_B": z}
        for name, value in wanted.items():
            assert found[name] == pytest.approx(value, abs=1e-9), name
        hull = crane(psi, 25.0, 100 * T, centred=True)
        hull.stations = stations
        assert found["e[5]"] == pytest.approx(hull.energy(math.radians(30.0)) - hull.energy(0.0), abs=1e-8)


DAMAGE = """
[[hull.flooded]]
mu_f = "0.95"
l_f = "10 m"
b_f = "9 m"
d_f = "4.5 m"
x_f = "-20 m"
y_f = "7.5 m"
[hull.tow]
F_p = "400 kN"
chi_p = "60 deg"
z_p = "5 m"
z_lp = "1.1 m"
"""


def alone():
    """The scene without its further load cases, and without what acts in these alone."""
    text = re.sub(r"^load_case\..*\n", "", SCENE.read_text(encoding="utf-8"), flags=re.M)
    for start, end in (("[[hull.flooded]]", "[hull.loss]"), ("[[hull.load_cases]]", "[hull.motion]")):
        head, rest = text.split(start, 1)
        text = head + rest[rest.index(end):]
    return text


def damaged(folder):
    """The scene with a flooded compartment, under tow."""
    path = folder / "damaged.toml"
    text = alone().replace("[hull.loss]", DAMAGE + "[hull.loss]")
    text = text.replace('f_min     = "0.5 m"\n', "").replace("FloatingCraneStatic", "FloatingCraneDamaged")
    path.write_text(text, encoding="utf-8")
    return path


@pytest.fixture(scope="module")
def flooded(tmp_path_factory):
    folder = tmp_path_factory.mktemp("flooded")
    lemnis("fmu", damaged(folder), "--output", folder)
    return {standard: str(folder / f"FloatingCraneDamaged{end}") for standard, end in ENDS.items()}


@pytest.mark.parametrize("standard", ENDS)
def test_a_flooded_compartment_under_tow(flooded, standard):
    """Heel, trim and levers of the hull that has lost the buoyancy of a compartment, and the tow rope's moment."""
    pull, chi = 400e3 * (5.0 - 1.1), math.radians(60.0)
    for psi, load in ((0.4, 60 * T), (2.2, 0.0), (4.4, 100 * T)):
        found = at(flooded[standard], ["T", "phi", "theta", "T_0", "y_B", "x_B", "M_p", "A_res", "e[3]"], psi_sl=psi, R=25.0, Q=load)
        hull, centred = crane(psi, 25.0, load), crane(psi, 25.0, load, centred=True)
        for each in (hull, centred):
            each.open = [(box(10.0, 9.0, 4.5, -20.0, 7.5), 0.95)]
        hull.moments += pull * np.array([math.cos(chi), math.sin(chi)])
        centred.moments[0] += pull * math.cos(chi)
        draft, along, across = hull.rest()
        upright = hull.level(0.0, 0.0)
        _, x, y, _ = hull.bearing(hull.stations, (upright, 0.0, 0.0)) / (hull.weight / (RHO * G))
        wanted = {"T": draft, "phi": math.atan(across), "theta": math.atan(along), "T_0": upright, "x_B": x, "y_B": y, "M_p": pull}
        for name, value in wanted.items():
            assert found[name] == pytest.approx(value, rel=1e-9, abs=1e-9), name
        assert found["e[3]"] == pytest.approx(centred.energy(math.radians(15.0)) - centred.energy(0.0), abs=1e-8)
        heel = math.atan(across)
        end = math.copysign(math.radians(20.0), heel)
        assert found["A_res"] == pytest.approx(hull.energy(end) - hull.energy(heel), abs=1e-7)


def test_a_compartment_that_nothing_floods_changes_nothing(fmus, flooded):
    """As its permeability goes to zero, and the pull with it, the intact hull."""
    names = ["T", "phi", "theta", "GM", "A_res", "phi_2"]
    intact = at(fmus["FMI 3"], names, psi_sl=1.0, R=25.0, Q=100 * T)
    errors = []
    for share in (1e-2, 1e-3, 1e-4):
        found = at(flooded["FMI 3"], names, {"mu_f[1]": share, "F_p": 0.0}, psi_sl=1.0, R=25.0, Q=100 * T)
        errors.append([abs(found[name] - intact[name]) for name in names])
    assert all(8.0 < one / other < 12.0 for before, after in zip(errors, errors[1:]) for one, other in zip(before, after))


def test_derivatives_of_the_fmu(fmus, tmp_path):
    """The library's directional derivatives against central differences of its own values."""
    description = read_model_description(fmus["FMI 3"])
    model = instantiate_fmu(extract(fmus["FMI 3"], str(tmp_path / "unzipped")), description)
    reference = {variable.name: variable.valueReference for variable in description.modelVariables}
    model.enterInitializationMode()
    model.exitInitializationMode()
    results = [reference[name] for name in ("phi", "theta", "T", "f_low", "phi_2", "d_A", "GZ[4]")]
    start = {"psi_sl": 1.1, "R": 25.0, "Q": 100 * T}
    model.setFloat64([reference[name] for name in start], list(start.values()))
    for name, value in start.items():
        exact = np.array(model.getDirectionalDerivative(results, [reference[name]], [1.0]))
        step, ends = 1e-5 * value, []
        for sign in (1, -1):
            model.setFloat64([reference[name]], [value + sign * step])
            ends.append(np.array(model.getFloat64(results)))
        model.setFloat64([reference[name]], [value])
        assert exact == pytest.approx((ends[0] - ends[1]) / (2 * step), rel=1e-6, abs=1e-8 / value)
    model.terminate()
    model.freeInstance()


@pytest.mark.parametrize("language", ["en", "zh", "bg"])
def test_the_book_names_its_criteria(language, tmp_path):
    lemnis("book", SCENE, "--language", language, "--format", "typ", "--output", tmp_path)
    book = typst(tmp_path / "FloatingCraneStatic.typ")
    known = words(language)
    for section in ("afloat_upright", "afloat_small", "afloat_posture", "afloat_residual", "afloat_lost", "afloat_levers"):
        assert known["section"][section] in book, section
    for check in ("afloat_heel", "afloat_freeboard", "afloat_residual", "afloat_lost", "afloat_energy", "afloat_water"):
        assert known["check"][check] in book, check
    assert "46 CFR 173" in book and "IS Code 2008" in book
    lemnis("book", damaged(tmp_path), "--language", language, "--format", "typ", "--output", tmp_path)
    book = typst(tmp_path / "FloatingCraneDamaged.typ")
    for name in ("afloat_tow", "afloat_flooded"):
        assert known["input"][name] in book and known["assumption"][name] in book, name
