"""A luffing mechanism on a slewing ring and on a portal, in FMPy, both standards and both interfaces: reach, weights and their
moments against the independent mechanism of the floating crane's test, what the support bears by hand; the same crane by numbers; and
in the book."""

import json
import math
import re

import numpy as np
import pytest
from fmpy import read_model_description, simulate_fmu
from fmpy.validation import validate_fmu

from conftest import ROOT, lemnis, words
from test_floating_crane import G, links

ENDS = {"FMI 2": ".fmi2.fmu", "FMI 3": ".fmu"}
COLUMN = ROOT / "models/scenes/slewing_engine.toml"
RING, PORTAL = (ROOT / f"models/scenes/portal_004_{name}.toml" for name in ("ring", "corners"))
KINDS = [(standard, kind) for standard in ENDS for kind in ("CoSimulation", "ModelExchange")]
OFFSET, FOOT = 1.5, 8.0


def by_hand(angles):
    """Reach and height of the head, weight of the mechanism, its moments about the slewing axis and by heights, its inertia."""
    rows = []
    for theta in angles:
        head, masses, places = links(theta)
        out = places[:, 0] + OFFSET
        rows.append((head[0] + OFFSET, head[1], G * masses.sum(), G * masses @ out, G * masses @ places[:, 1], masses @ out**2))
    return np.array(rows).T


def swept(path, kind, names):
    """Slews once round while it luffs in."""
    times = np.linspace(0.0, 60.0, 61)
    given = {"psi": np.radians(6.0) * times, "theta_1": np.radians(44.0 + 38.0 * times / 60.0), "Q": 98100.0 - 500.0 * times}
    inputs = np.array(list(zip(times, *given.values())), dtype=[(name, float) for name in ("time", *given)])
    return simulate_fmu(path, fmi_type=kind, stop_time=60.0, output_interval=1.0, input=inputs, output=[*given, *names])


@pytest.fixture(scope="module")
def fmus(tmp_path_factory):
    folder = tmp_path_factory.mktemp("carried")
    for scene in (RING, PORTAL):
        lemnis("fmu", scene, "--output", folder)
    return {(name, standard): str(folder / f"Portal004{name}{end}") for name in ("Ring", "Corners") for standard, end in ENDS.items()}


@pytest.mark.parametrize("standard", ENDS)
@pytest.mark.parametrize("name", ["Ring", "Corners"])
def test_its_inputs_and_results(fmus, name, standard):
    assert not validate_fmu(fmus[name, standard])
    variables = {variable.name: variable for variable in read_model_description(fmus[name, standard]).modelVariables}
    assert {name: variables[name].causality for name in ("psi", "theta_1", "Q", "R", "W_1", "M_r1")} == {
        "psi": "input", "theta_1": "input", "Q": "input", "R": "output", "W_1": "output", "M_r1": "output"}
    # Its dimensions are constants of the FMU; what no result needs is none of it.
    assert not {"X_1", "G_1", "dR", "dM_r1"} & set(variables)


@pytest.mark.parametrize("standard, kind", KINDS)
def test_a_crane_that_slews_and_luffs_on_its_ring(fmus, standard, kind):
    cases = [(1.0, 250.0), (1.25, 40.0), (0.0, 800.0)]
    names = ["R", "h_A", "W_1", "M_r1", "M_h1", "J_lm", "h_Q", "J_0", *(f"{of}[{i}]" for of in "VHM" for i in (1, 2, 3))]
    found = swept(fmus["Ring", standard], kind, names)
    reach, high, weight, forward, up, inertia = by_hand(found["theta_1"])
    for name, wanted in zip(names, (reach, high, weight, forward, up, inertia, high + FOOT)):
        assert np.allclose(found[name], wanted, rtol=1e-11, atol=1e-6 if name.startswith("M") else 0), name
    bodies = [(62e3 * G, -3.2, 3.5), (30e3 * G, -2.5, 11.0)]
    slope, areas = math.radians(0.3), [(38.0, 4.0), (24.0, 13.0)]
    own = 1.2e6 + sum(g * r**2 for g, r, _ in bodies) / G + inertia
    assert np.allclose(found["J_0"], own, rtol=1e-11)
    psi = found["psi"]
    for i, (factor, pressure) in enumerate(cases, 1):
        load = factor * found["Q"]
        all_of_it = sum(g for g, *_ in bodies) + weight + load
        ahead = sum(g * r for g, r, _ in bodies) + forward + load * reach
        lean = sum(g * h for g, _, h in bodies) + weight * FOOT + up + load * (FOOT + high)
        force, turn = pressure * sum(a for a, _ in areas), pressure * sum(a * h for a, h in areas)
        x = ahead * math.cos(slope) * np.cos(psi) + lean * math.sin(slope)
        y = ahead * math.cos(slope) * np.sin(psi) + turn
        assert np.allclose(found[f"V[{i}]"], all_of_it * math.cos(slope), rtol=1e-12)
        assert np.allclose(found[f"H[{i}]"], np.hypot(all_of_it * math.sin(slope), force), rtol=1e-12)
        assert np.allclose(found[f"M[{i}]"], np.hypot(x, y), rtol=1e-10)


@pytest.mark.parametrize("standard, kind", KINDS)
def test_corner_loads_of_a_crane_that_slews_and_luffs(fmus, standard, kind):
    names = ["R", "V", "M", *(f"N_r[{i}]" for i in (1, 2, 3, 4)), *(f"K[{i}]" for i in (1, 2, 3, 4))]
    found = swept(fmus["Corners", standard], kind, names)
    reach, _, weight, forward, *_ = by_hand(found["theta_1"])
    load, psi, side = found["Q"], found["psi"], 10.5
    still = [(78e3 * G, 0.0, 0.0), (4e3 * G, -2.5, 3.0)]
    slews = [(62e3 * G, -1.1), (30e3 * G, -2.0)]
    empty = sum(g for g, *_ in still) + sum(g for g, _ in slews) + weight
    turn = sum(g * r for g, r in slews) + forward
    m_x = sum(g * y for g, _, y in still) + 250.0 * (34.0 * 7.0 + 62.0 * 19.0) + (turn + load * reach) * np.sin(psi)
    m_y = sum(g * x for g, x, _ in still) + (turn + load * reach) * np.cos(psi)
    for i, (front, left) in enumerate([(1, -1), (1, 1), (-1, 1), (-1, -1)], 1):
        wanted = (empty + load) / 4 + front * m_y / (2 * side) + left * m_x / (2 * side)
        assert wanted.min() > 0  # no leg is lifted
        assert np.allclose(found[f"N_r[{i}]"], wanted, rtol=1e-11)
    holds = empty * side / 2 - sum(g * x for g, x, _ in still) - turn * np.cos(psi)
    tips = load * (reach * np.cos(psi) - side / 2)
    there = tips > 1.0
    assert there.sum() > 10 and np.allclose(found["K[1]"][there], (holds / tips)[there], rtol=1e-10)


def test_the_same_crane_by_numbers(tmp_path):
    """At one luffing angle a reach, a height and one more body: every result that both have is the same."""
    text = RING.read_text("utf-8")
    head, masses, places = links(math.radians(44.0))
    out = places[:, 0] + OFFSET
    weight, high = float(G * masses.sum()), float(head[1])
    far, up = float(G * masses @ out) / weight, float(G * masses @ places[:, 1]) / weight
    body = {"G_u": f"{weight!r} N", "r_u": f"{far!r} m", "h_u": f"{FOOT + up!r} m"}
    own = float(masses @ out**2) - weight / G * far**2
    numbers = text[: text.index("[luffing]")]
    for old, new in [
        ('theta_1 = "44 deg"', f'R = "{float(head[0]) + OFFSET!r} m"'), ('h_1   = "8 m"', ""), ('J_e      = "1200000 kg.m2"', f'J_e = "{1.2e6 + own!r} kg.m2"'),
        ("[supports.slope]", "[[supports.upper]]\n" + "".join(f'{k} = "{v}"\n' for k, v in body.items()) + "[supports.slope]"),
        ('gamma = "0.3 deg"', f'gamma = "0.3 deg"\nh_Q = "{FOOT + high!r} m"'), ('name  = "Portal004Ring"', 'name = "ByNumbers"'),
    ]:
        assert old in numbers
        numbers = numbers.replace(old, new, 1)
    (tmp_path / "numbers.toml").write_text(numbers, encoding="utf-8")
    for scene in (tmp_path / "numbers.toml", RING):
        lemnis("fmu", scene, "--output", tmp_path)
    by_name = []
    for name in ("ByNumbers", "Portal004Ring"):
        path = str(tmp_path / f"{name}.fmu")
        outputs = [v.name for v in read_model_description(path).modelVariables if v.causality == "output" and v.type == "Float64"]
        times = np.linspace(0.0, 60.0, 21)
        inputs = np.array([(t, math.radians(6.0) * t) for t in times], dtype=[("time", float), ("psi", float)])
        by_name.append((outputs, simulate_fmu(path, stop_time=60.0, output_interval=3.0, input=inputs, output=outputs)))
    both = [name for name in by_name[0][0] if name in by_name[1][0]]
    assert len(both) > 150
    for name in both:
        one, other = (found[name] for _, found in by_name)
        assert np.allclose(one, other, rtol=1e-10, atol=1e-10 * max(1e-3, np.nanmax(np.abs(one[np.isfinite(one)]), initial=0.0))), name


@pytest.mark.parametrize("language", ["en", "zh", "bg"])
def test_the_book_draws_what_the_reach_changes(language, tmp_path):
    for scene, curve in ((RING, "upper_reach"), (PORTAL, "portal_reach")):
        folder = tmp_path / scene.stem
        lemnis("book", scene, "--language", language, "--format", "typ", "--output", folder)
        book = next(folder.rglob("*.typ")).read_text("utf-8")
        known = words(language)
        for said in (known["curve"][curve], known["section"]["carried_luffing"], known["assumption"]["carried_level"]):
            assert said in book, said


def corner_loads(theta, psi, load):
    """Corner loads of the portal over arrays of both angles."""
    reach, _, weight, forward, *_ = by_hand(np.atleast_1d(theta))
    side = 10.5
    still = [(78e3 * G, 0.0, 0.0), (4e3 * G, -2.5, 3.0)]
    slews = [(62e3 * G, -1.1), (30e3 * G, -2.0)]
    empty = sum(g for g, *_ in still) + sum(g for g, _ in slews) + weight
    turn = sum(g * r for g, r in slews) + forward + load * reach
    m_x = sum(g * y for g, _, y in still) + 250.0 * (34.0 * 7.0 + 62.0 * 19.0) + turn * np.sin(psi)
    m_y = sum(g * x for g, x, _ in still) + turn * np.cos(psi)
    return np.array([(empty + load) / 4 + front * m_y / (2 * side) + left * m_x / (2 * side)
                     for front, left in [(1, -1), (1, 1), (-1, 1), (-1, -1)]])


def most_of_both(f, ends, count=48):
    """The greatest of f over two angles: a scan, then finer ones around its best place."""
    (a, b), (c, d) = ends
    for _ in range(7):
        x, y = np.linspace(a, b, count), np.linspace(c, d, count)
        values = f(*np.meshgrid(x, y, indexing="ij"))
        i, j = np.unravel_index(values.argmax(), values.shape)
        (a, b) = (x[max(i - 2, 0)], x[min(i + 2, count - 1)])
        (c, d) = (y[max(j - 2, 0)], y[min(j + 2, count - 1)])
    return values[i, j], x[i], y[j]


def judged(scene, tmp_path, *replaced):
    text = scene.read_text("utf-8")
    for old, new in replaced:
        assert old in text
        text = text.replace(old, new, 1)
    (tmp_path / "judged.toml").write_text(text, encoding="utf-8")
    told = json.loads(lemnis("check", tmp_path / "judged.toml", "--json"))
    return told["summary"]


START = ('theta_1 = "44 deg"', 'theta_1 = "75 deg"')


def test_the_greatest_corner_load_is_that_of_all_reaches(tmp_path):
    """Wherever it begins to luff."""
    found = judged(PORTAL, tmp_path, START)
    both = ((math.radians(44.0), math.radians(82.0)), (0.0, 2 * np.pi))
    for name, sign in (("N_r_max", 1.0), ("N_4_min", -1.0)):
        load = lambda theta, psi: (sign * corner_loads(theta.ravel(), psi.ravel(), 98.1e3)).max(axis=0).reshape(theta.shape)
        wanted, theta, psi = most_of_both(load, both)
        assert found[name]["value"] == pytest.approx(sign * wanted, rel=1e-9)
        at = found[name]["at"]
        assert at["theta_1"] == pytest.approx(theta, abs=1e-6) and at["psi"] == pytest.approx(psi, abs=1e-6), (name, at)
    assert judged(PORTAL, tmp_path) == found


def scanned(path, of, sign=1):
    """The greatest of a result of all load cases, by the FMU over both angles."""
    names = [f"{of}[{i}]" for i in (1, 2, 3)]

    def most(theta, psi):
        times = np.arange(theta.size) * 1.0
        given = {"theta_1": theta.ravel(), "psi": psi.ravel()}
        inputs = np.array(list(zip(times, *given.values())), dtype=[(key, float) for key in ("time", *given)])
        values = simulate_fmu(path, stop_time=times[-1], output_interval=1.0, input=inputs, output=names)
        return (sign * np.array([values[name] for name in names])).max(axis=0).reshape(theta.shape)

    return most


def test_what_is_greatest_within_both_ranges(tmp_path, fmus):
    """Of the ring and its drive: values of the FMU, looked through and then looked through more finely."""
    found = judged(RING, tmp_path, START)
    both = ((math.radians(44.0), math.radians(82.0)), (0.0, 2 * np.pi))
    inside = 0
    for name, of, sign in [("M_top", "M", 1), ("P_low", "P_min", -1), ("M_st_top", "M_st", 1), ("a_start_max", "a_start", 1),
                           ("a_stop_max", "a_stop", 1), ("t_stop_max", "t_stop", 1), ("F_t_max", "F_t", 1)]:

        wanted, theta, psi = most_of_both(scanned(fmus["Ring", "FMI 3"], of, sign), both)
        at = found[name]["at"]
        # A scan never finds more than there is; on a ridge it finds a little less, and the place less sharply.
        value = sign * found[name]["value"]
        assert wanted - 1e-11 * abs(wanted) <= value <= wanted + 1e-6 * abs(wanted), name
        assert at["theta_1"] == pytest.approx(theta, abs=2e-3), (name, at, theta)
        # Slope and wind leave no moment at two angles across from each other, where a start is as hard.
        assert math.remainder(at["psi"] - psi, math.pi) == pytest.approx(0.0, abs=2e-3), (name, at, psi)
        inside += both[0][0] < at["theta_1"] < both[0][1]
    assert inside >= 2


def on_a_column(text):
    """The same crane on a column in three bearings."""
    ring, own, other = text[text.index('kind  = "ring"'): text.index("Q     =")], text.index("[supports.contact]"), COLUMN.read_text("utf-8")
    bearings = other[other.index("[supports.bearings]"): other.index("[supports.slewing_drive]")]
    return text[:own].replace(ring, 'kind = "column"\nh_uf = "6.5 m"\n') + bearings + text[text.index("[supports.slewing_drive]"):]


def without_limits(text):
    return text.replace(text[text.index("[supports.limits]"): text.index("[luffing]\n")], "")


def engine(text, torque):
    """With an engine of one torque (N·m) at all its speeds."""
    start, end = (text.index(f"[supports.slewing_drive.{name}]") for name in ("start", "brake"))
    points = "".join(f'[[supports.slewing_drive.start.curve]]\nn_en = "{n} 1/min"\nT_en = "{torque!r} N.m"\n' for n in (250, 1100))
    kind = '[supports.slewing_drive.start]\nkind = "engine"\nn_idle = "300 1/min"\nn_gov = "1000 1/min"\n'
    # Where it begins to luff says nothing of where it is weak; what it may take is not judged here.
    return without_limits(text[:start].replace(*START) + kind + points + text[end:])


@pytest.mark.parametrize("support", ["ring", "column"])
def test_an_engine_is_strong_enough_at_every_reach(tmp_path, support):
    """What resists most by a scan of the FMU over both angles: an engine that gives a little less is refused and told where, one that
    gives a little more starts there, in the longest time of all."""
    both = ((math.radians(44.0), math.radians(82.0)), (0.0, 2 * np.pi))
    text, plain = RING.read_text("utf-8"), tmp_path / "plain.toml"
    if support == "column":
        text = on_a_column(text)
    plain.write_text(without_limits(text), encoding="utf-8")
    lemnis("fmu", plain, "--output", tmp_path)
    most, theta, psi = most_of_both(scanned(str(tmp_path / "Portal004Ring.fmu"), "T_0"), both)
    weak, strong = tmp_path / "weak.toml", tmp_path / "strong.toml"
    weak.write_text(engine(text, float(most) * (1 - 1e-4)), encoding="utf-8")
    said = lemnis("check", weak, expect=1)
    found = re.search(r"T_0 = ([\d.]+) N\.m resist at psi = ([\d.]+) deg at theta_1 = ([\d.]+) deg", said)
    assert [float(number) for number in found.groups()] == pytest.approx([most, math.degrees(psi), math.degrees(theta)], rel=1e-4, abs=0.2)
    strong.write_text(engine(text, float(most) * (1 + 1e-3)), encoding="utf-8")
    told = json.loads(lemnis("check", strong, "--json"))["summary"]["t_eng_max"]
    lemnis("fmu", strong, "--output", tmp_path)
    wanted, theta, psi = most_of_both(scanned(str(tmp_path / "Portal004Ring.fmu"), "t_eng"), both)
    assert wanted * (1 - 1e-11) <= told["value"] <= wanted * (1 + 1e-6)
    assert told["at"]["theta_1"] == pytest.approx(theta, abs=2e-3)
    assert math.remainder(told["at"]["psi"] - psi, math.pi) == pytest.approx(0.0, abs=2e-3)
