"""A slope under a crane that luffs and slews: against a model of its own, written in the frame of the ground with the rope as a
constraint, energies and places from the geometry alone (`tests/oracles/luffing_resistances.py`), solved by SciPy; what pins carry by
one system of equations of all bodies; what holds it; beside oil; exact derivatives, both standards and both interfaces, the book."""

import json
import re
from math import atan2, cos, pi, radians, sin

import numpy as np
import pytest
from fmpy import read_model_description, simulate_fmu
from fmpy.validation import validate_fmu
from scipy.integrate import solve_ivp

from conftest import ROOT, lemnis, words
from oracles import luffing_resistances as oracle
from test_braked import C_V, FROM, M_F, braked
from test_commands import ENDS, Stepped, as_told, same_bits, written
from test_crane_wind import cylinder
from test_control_continuous import KINDS
from test_weather import CRANE, PINS, Outdoors

GAMMA, G_U, R_U = radians(2.5), 1.6e6, -2.2
J_SL, C_SL, M_SL, MOMENT = 2.5e6, 3e6, 250e3, 1.6e6
PSI, LENGTH, SWING, SIDE = radians(35.0), 15.0, radians(3.0), radians(-2.0)
TIMES = [round(0.1 * i, 10) for i in range(81)]
MASS = 100e3 / 9.81
SLOPE = f'\n[slewing.slope]\ngamma_s = "{GAMMA!r} rad"\nG_u = "{G_U / 1e3} kN"\nr_u = "{R_U} m"\n'


def scene(name, rope, slope=SLOPE, more=""):
    load = f'l_R = "{LENGTH} m"\nphi_R = "{SWING!r} rad"' if rope else ""
    side = f'chi_R = "{SIDE!r} rad"\n' if rope else ""
    return braked(name, f'"{MOMENT / 1e3} kN.m"', '"0"', rope=load) + (
        f'\n[slewing]\nJ_sl = "{J_SL} kg.m2"\nc_sl = "{C_SL / 1e3} kN.m.s"\nM_sl = "{M_SL / 1e3} kN.m"\npsi_sl = "{PSI!r} rad"\n'
        f'{side}{more}{slope}')


def points(x):
    """Each body as two masses at the ends of its radius of gyration: its number, mass and place."""
    for i, (b, (o, t)) in enumerate(zip(CRANE.bodies, CRANE.placed(x))):
        for side in (1, -1):
            yield i, b.mass / 2, o + (b.centre + side * oracle.sqrt(b.inertia / b.mass) * b.along) * t


class Leaning(Outdoors):
    """The same crane on a turntable, on a slope that falls in the direction in which it stands at no angle."""

    def __init__(self, low, high, loaded):
        super().__init__(low, high, loaded)
        nodes = 32
        xs = low + (high - low) * (np.cos(pi * (np.arange(nodes) + 0.5) / nodes) + 1) / 2

        def about(x):
            load = CRANE.load / oracle.G * CRANE.hangs(x)[0].real ** 2 if loaded else 0
            return sum(m * p.real ** 2 for _, m, p in points(x)) + load

        self.about = np.polynomial.Chebyshev.fit(xs, [float(about(oracle.mpf(x))) for x in xs], nodes - 1, domain=[low, high])
        self.about_change = self.about.deriv()

    def acting(self, x, rate, psi, turning):
        """On luffing and slewing by drives, friction, weights on the slope and what moves itself."""
        weights = self.forward_change(x) * sin(GAMMA) * cos(psi) - self.up_change(x) * cos(GAMMA)
        luffing = MOMENT + weights - C_V * rate - M_F - self.inertia_change(x) * rate**2 / 2 + self.about_change(x) * turning**2 / 2
        across = -(self.forward(x) + G_U * R_U) * sin(GAMMA) * sin(psi)
        return np.array([luffing, M_SL - C_SL * turning + across - self.about_change(x) * rate * turning])

    def inertias(self, x):
        return np.array([self.inertia(x), J_SL + self.about(x)])

    def alone(self, _, y):
        a = self.acting(*y) / self.inertias(y[0])
        return [y[1], a[0], y[3], a[1]]

    def hook(self, x, psi):
        """Place, travel with each joint, and second travels, in the frame of the ground: forward at no angle, up, to the left."""
        (x_0, y_0), (x_1, y_1), (x_2, y_2) = ([f(x) for f in of] for of in (self.head, self.travel, self.bend))
        ahead, aside = np.array([cos(psi), 0.0, sin(psi)]), np.array([-sin(psi), 0.0, cos(psi)])
        up = np.array([0.0, 1.0, 0.0])
        return (x_0 * ahead + y_0 * up, [x_1 * ahead + y_1 * up, x_0 * aside], [x_2 * ahead + y_2 * up, x_1 * aside, -x_0 * ahead])

    def swings(self, _, y):
        """With the load on a rope of constant length, by the multiplier of that."""
        x, rate, psi, turning = y[:4]
        place, velocity = y[4:7], y[7:10]
        at, ways, (bend, both, circle) = self.hook(x, psi)
        out, off = place - at, velocity - ways[0] * rate - ways[1] * turning
        left, right = np.zeros((6, 6)), np.zeros(6)
        left[:2, :2], right[:2] = np.diag(self.inertias(x)), self.acting(x, rate, psi, turning)
        left[2:5, 2:5], right[2:5] = MASS * np.eye(3), MASS * 9.81 * np.array([sin(GAMMA), -cos(GAMMA), 0.0])
        left[:2, 5], left[2:5, 5] = [out @ way for way in ways], -out
        left[5, :2], left[5, 2:5] = [-out @ way for way in ways], out
        right[5] = out @ (bend * rate**2 + 2 * both * rate * turning + circle * turning**2) - off @ off
        a = np.linalg.solve(left, right)
        return [rate, a[0], turning, a[1], *velocity, *a[2:5]]

    def run(self, rope):
        start = [FROM, 0.0, PSI, 0.0]
        if rope:
            down = np.array([cos(SIDE) * sin(SWING), -cos(SIDE) * cos(SWING), sin(SIDE)]) * LENGTH
            at = self.hook(FROM, PSI)[0]
            start += [*(at + self.turned(down, PSI)), 0.0, 0.0, 0.0]
        solved = solve_ivp(self.swings if rope else self.alone, (0.0, TIMES[-1]), start, method="DOP853", rtol=1e-12, atol=1e-13,
                           t_eval=TIMES)
        assert (solved.y[1][1:] > 0.0).all(), "dry friction is that of a boom that rises"
        if not rope:
            return solved.y.T
        seen = [self.turned(y[4:7] - self.hook(y[0], y[2])[0], -y[2]) for y in solved.y.T]
        return np.hstack([solved.y[:4].T, np.array(seen)])

    @staticmethod
    def turned(v, psi):
        return np.array([v[0] * cos(psi) - v[2] * sin(psi), v[1], v[0] * sin(psi) + v[2] * cos(psi)])


@pytest.fixture(scope="module", params=["rigid", "swing"])
def manoeuvre(request, tmp_path_factory):
    """The FMUs, their outputs, what these should be, and the model of its own."""
    rope, name = request.param == "swing", f"Slope{request.param.title()}"
    paths = written(tmp_path_factory.mktemp("slope"), name, scene(name, rope))
    names = ["theta_1", "omega_1", "psi_sl", "omega_sl"] + (["x_Q", "y_Q", "z_Q"] if rope else [])
    crane = Leaning(radians(43.0), radians(69), not rope)
    return paths, names, crane.run(rope), crane


@pytest.mark.parametrize("standard", ENDS)
@pytest.mark.parametrize("kind", KINDS)
def test_a_crane_on_a_slope_is_that_of_a_model_in_the_ground_s_frame(manoeuvre, standard, kind):
    paths, names, expected, crane = manoeuvre
    assert not validate_fmu(paths[standard])
    run = simulate_fmu(paths[standard], fmi_type=kind, stop_time=TIMES[-1], output_interval=0.1, relative_tolerance=1e-11,
                       output=[*names, "M_gamma", "M_gammal"], record_events=False)
    found = np.array([[row[name] for name in names] for row in run])
    ranges = np.ptp(expected, axis=0)
    assert len(found) == len(expected) and ranges[0] > 0.03 and ranges[2] > 0.1
    apart = np.abs(found - expected).max(axis=0) / ranges
    print(standard, kind, dict(zip(names, apart)))
    assert (apart <= 1e-7).all(), dict(zip(names, apart))
    for row in run:
        x, psi = row["theta_1"], row["psi_sl"]
        across = -(crane.forward(x) + G_U * R_U) * sin(GAMMA) * sin(psi)
        lifts = crane.forward_change(x) * sin(GAMMA) * cos(psi) + crane.up_change(x) * (1 - cos(GAMMA))
        assert row["M_gamma"] == pytest.approx(across, rel=1e-9, abs=1e-3)
        assert row["M_gammal"] == pytest.approx(lifts, rel=1e-9, abs=1e-3)


@pytest.mark.parametrize("standard", ENDS)
def test_any_communication_step_gives_the_same_bits(tmp_path, standard):
    told = '{ between = "linear", over = [["0 s", "250 kN.m"], ["5 s", "400 kN.m"], ["12 s", "-100 kN.m"]] }'
    text = scene("Told", True).replace(f'M_sl = "{M_SL / 1e3} kN.m"', f"M_sl = {told}")
    assert told in text
    found = same_bits(written(tmp_path, "Told", text)[standard], 1200, 7)
    assert found[1200] != found[0]


@pytest.mark.parametrize("angle, rate, psi, turning", [(50.0, 0.03, 20.0, 0.0), (61.3, -0.05, 200.0, 0.12), (66.6, 0.04, -75.0, -0.2)])
def test_pins_carry_what_leans(tmp_path, angle, rate, psi, turning):
    """All forces in the mechanism's plane by one system of equations, each body as two masses that luff, slew and lean."""
    text = scene("Pins", False)
    for line in (f'c_v = "{C_V / 1e3} kN.m.s"\n', f'M_F = "{M_F / 1e3} kN.m"\n'):
        assert line in text
        text = text.replace(line, "")
    path = written(tmp_path, "Pins", text)["FMI 3"]
    names = [*sum(PINS.values(), ()), "M_D"]
    rates, found = as_told(path, [radians(angle), rate, radians(psi), turning], names)

    phi, gaining = oracle.mpf(radians(angle)), oracle.mpf(rates[1])
    steep = oracle.mpf(GAMMA)
    lean = oracle.G * oracle.mpc(oracle.sin(steep) * oracle.cos(oracle.mpf(radians(psi))), -oracle.cos(steep))
    step = oracle.mpf(10) ** -12

    def weighs(mass, place):
        """Of a mass whose place (m) is a function of the boom's angle."""
        once = (place(phi + step) - place(phi - step)) / (2 * step)
        twice = (place(phi + step) - 2 * place(phi) + place(phi - step)) / step**2
        outward = place(phi).real * oracle.mpf(turning) ** 2
        return mass * (lean + outward - once * gaining - twice * oracle.mpf(rate) ** 2)

    forces = []
    for j, (i, mass, place) in enumerate(points(phi)):
        forces.append((i, place, weighs(mass, lambda x: list(points(x))[j][2])))
    load = weighs(CRANE.load / oracle.G, lambda x: CRANE.hangs(x)[0])
    moment, carried = CRANE.hold(phi, forces, [0] * 4, load)
    size = float(max(carried))
    assert abs(found["M_D"] - float(moment)) <= 1e-11 * size * 26.3, (found["M_D"], float(moment))
    for pin, wanted in zip(("O1", "B", "C", "O3"), carried):
        x, y = (found[name] for name in PINS[pin])
        assert abs(np.hypot(x, y) - float(wanted)) <= 1e-11 * size, (pin, np.hypot(x, y), float(wanted))
    assert abs(np.hypot(*(found[name] for name in PINS["M"])) - float(carried[6])) <= 1e-11 * size


@pytest.mark.parametrize("standard", ENDS)
def test_friction_holds_it_on_the_slope_up_to_its_moment(tmp_path, standard):
    """Across the slope it stays where friction is more than the moment of its weights, and turns downhill where that is less."""
    across = abs(float(Leaning(radians(43.0), radians(69), True).forward(FROM)) + G_U * R_U) * sin(GAMMA) * sin(PSI)
    for part, moves in ((1.001, False), (0.999, True)):
        held = scene("Held", False, more=f'M_Fsl = "{across * part / 1e3!r} kN.m"\n').replace(f'M_sl = "{M_SL / 1e3} kN.m"\n', "")
        held = held.replace(f'M_A = "{MOMENT / 1e3} kN.m"', 'M_A = "0 kN.m"\nM_S = "9000 kN.m"')
        (tmp_path / str(part)).mkdir(exist_ok=True)
        run = simulate_fmu(written(tmp_path / str(part), "Held", held)[standard], stop_time=4.0, output_interval=0.5,
                           output=["psi_sl", "omega_sl", "M_Rsl", "M_gamma"], record_events=False)
        if moves:
            assert (run["omega_sl"][1:] * run["M_gamma"][1:] > 0.0).all()
        else:
            assert np.abs(run["omega_sl"]).max() == 0.0 and np.ptp(run["psi_sl"]) == 0.0
            assert np.abs(run["M_Rsl"] + run["M_gamma"]).max() <= 1e-9 * across
            assert abs(run["M_gamma"][0]) == pytest.approx(across, rel=1e-9)


def test_a_load_at_rest_hangs_plumb(tmp_path):
    """By the angles of gravity in the frame that slews it keeps its place while nothing moves."""
    down = np.array([sin(GAMMA) * cos(PSI), -cos(GAMMA), -sin(GAMMA) * sin(PSI)])
    text = scene("Plumb", True, more='M_Fsl = "9000 kN.m"\n').replace(f'M_A = "{MOMENT / 1e3} kN.m"', 'M_A = "0 kN.m"\nM_S = "9000 kN.m"')
    for key, old, new in (("phi_R", SWING, atan2(down[0], -down[1])), ("chi_R", SIDE, float(np.arcsin(down[2])))):
        assert f'{key} = "{old!r} rad"' in text
        text = text.replace(f'{key} = "{old!r} rad"', f'{key} = "{new!r} rad"')
    run = simulate_fmu(written(tmp_path, "Plumb", text)["FMI 3"], stop_time=5.0, output_interval=0.5,
                       output=["x_Q", "y_Q", "z_Q", "S_R", "omega_1", "omega_sl"], record_events=False)
    for name, part in zip(("x_Q", "y_Q", "z_Q"), down):
        assert np.abs(run[name] - LENGTH * part).max() <= 1e-12 * LENGTH
    assert np.abs(run["S_R"] - 100e3).max() <= 1e-6 and np.abs(run["omega_sl"]).max() == 0.0


def test_it_acts_beside_oil(tmp_path):
    """The same for the slope as for a drive that gives the same: acceleration of slewing, at a start with the load in line with the boom."""
    text = cylinder().replace('M_sl = "200 kN.m"\n', 'M_sl = "200 kN.m"\npsi_sl = "50 deg"\n')
    assert 'psi_sl = "50 deg"' in text
    text += '\n[slewing.slope]\ngamma_s = "0.03 rad"\nG_u = "900 kN"\nr_u = "1.5 m"\n'
    names, found = ["der(omega_sl)", "M_gamma", "M_gammal", "S_R"], []
    for number, slope in enumerate(("0.03 rad", "0 rad")):
        (tmp_path / str(number)).mkdir()
        path = written(tmp_path / str(number), re.search(r'(?m)^name += "(\w+)"', text)[1], text.replace("0.03 rad", slope))["FMI 3"]
        fmu = Stepped(path)
        found.append(fmu.get(names))
        if number:
            fmu.slave.setFloat64([fmu.references["M_sl"]], [200e3 + found[0][1]])
            found.append(fmu.get(names))
        fmu.close()
    leaning, level, driven = found
    assert level[1] == level[2] == 0.0 and abs(leaning[1]) > 1e4 and abs(leaning[2]) > 1e4
    assert abs(leaning[0] - level[0]) > 1e-5 and leaning[3] != level[3]
    assert driven[0] == pytest.approx(leaning[0], rel=1e-12)


@pytest.mark.parametrize("plumb", [True, False])
def test_oil_begins_as_it_holds_the_crane_on_the_slope(tmp_path, plumb):
    """With its valve closed and the load hanging plumb nothing moves; with the load straight below the head, luffing does not begin to."""
    text = cylinder().replace('M_sl = "200 kN.m"\n', f'psi_sl = "{PSI!r} rad"\nM_Fsl = "9000 kN.m"\n')
    assert "M_Fsl" in text
    text = re.sub(r"(?ms)^(u_v|y_b1) = .*?^\] \} *", r'\1 = "0" ', text)
    # Nothing leaks past the piston.
    text = re.sub(r"(?m)^k_L .*$", 'k_L = "0 m3/(s.Pa)"', text)
    text += f'\n[slewing.slope]\ngamma_s = "{GAMMA!r} rad"\nG_u = "900 kN"\nr_u = "1.5 m"\n'
    if plumb:
        down = [sin(GAMMA) * cos(PSI), -cos(GAMMA), -sin(GAMMA) * sin(PSI)]
        angles = f'phi_R = "{atan2(down[0], -down[1])!r} rad"\n'
        text = re.sub(r'(?m)^phi_R.*\n', "", text).replace("l_R ", angles + "l_R ", 1)
        text = text.replace("M_Fsl", f'chi_R = "{float(np.arcsin(down[2]))!r} rad"\nM_Fsl', 1)
    path = written(tmp_path, re.search(r'(?m)^name += "(\w+)"', text)[1], text)["FMI 3"]
    fmu = Stepped(path)
    [begins] = fmu.get(["der(omega_1)"])
    # Of what would have it begin: the moments of the slope over an inertia of 1e7 kg·m².
    assert abs(begins) <= 1e-14, begins
    if plumb:
        rows = np.array(fmu.run([0.1 * i for i in range(51)], ["theta_1", "p_A", "x_Q", "z_Q"]))
        assert (np.ptp(rows, axis=0) <= np.array([1e-10, 100.0, 1e-8, 1e-8])).all(), np.ptp(rows, axis=0)
    fmu.close()


def test_derivatives_of_the_moments(manoeuvre):
    paths, names, _, crane = manoeuvre
    fmu = Stepped(paths["FMI 3"])
    fmu.run([0.0, 1.0], ["omega_sl"])
    x, psi = fmu.get(["theta_1", "psi_sl"])
    weight, slope = crane.forward(x) + G_U * R_U, crane.forward_change(x)
    wanted = {
        "psi_sl": (-weight * sin(GAMMA) * cos(psi), -slope * sin(GAMMA) * sin(psi)),
        "gamma_s": (-weight * cos(GAMMA) * sin(psi), slope * cos(GAMMA) * cos(psi) + crane.up_change(x) * sin(GAMMA)),
        "G_u": (-R_U * sin(GAMMA) * sin(psi), 0.0),
        "r_u": (-G_U * sin(GAMMA) * sin(psi), 0.0),
        "theta_1": (-slope * sin(GAMMA) * sin(psi),
                    crane.forward_change.deriv()(x) * sin(GAMMA) * cos(psi) + crane.up_change.deriv()(x) * (1 - cos(GAMMA))),
    }
    for known, (turns, lifts) in wanted.items():
        found = fmu.slave.getDirectionalDerivative([fmu.references[name] for name in ("M_gamma", "M_gammal")], [fmu.references[known]], [1.0])
        assert found[0] == pytest.approx(turns, rel=1e-8), known
        assert found[1] == pytest.approx(lifts, rel=1e-8, abs=1e-6), known
    fmu.close()


def test_a_crane_without_it_has_nothing_of_it(tmp_path):
    [path, _] = written(tmp_path, "Level", scene("Level", True, slope="")).values()
    names = {variable.name for variable in read_model_description(path).modelVariables}
    assert not names & {"gamma_s", "G_u", "r_u", "M_gamma", "M_gammal"}


@pytest.mark.parametrize("language", ["en", "zh", "bg"])
def test_the_book_tells_of_it(tmp_path, language):
    known = words(language)
    books = []
    for name, slope in (("leaning", SLOPE), ("level", "")):
        (tmp_path / name).mkdir()
        (tmp_path / name / "scene.toml").write_text(scene("Told", True, slope=slope), encoding="utf-8")
        lemnis("book", tmp_path / name / "scene.toml", "--format", "typ", "--language", language, "--output", tmp_path / name)
        [page] = (tmp_path / name).glob("*.typ")
        books.append(page.read_text(encoding="utf-8"))
    leaning, level = books
    plain = max(known["assumption"]["slope_under_slewing"].split("$"), key=len)
    told = [plain, known["section"]["motion_leaning"], known["purpose"]["motion_leaning"]]
    for text in told:
        assert text in leaning and text not in level, text


def test_trade_tells_what_it_costs_to_leave_it_out(tmp_path):
    """A table within that of slewing is a part of its own; what leaving it out costs is far more than rounding."""
    led = '{ between = "linear", over = [["0 s", "1600 kN.m"], ["8 s", "1500 kN.m"]] }'
    text = scene("Told", True).replace(f'M_A = "{MOMENT / 1e3} kN.m"', f"M_A = {led}")
    assert led in text
    (tmp_path / "scene.toml").write_text(text, encoding="utf-8")
    lemnis("trade", tmp_path / "scene.toml", "--rounds", "1", "--step", "0.5", "--output", tmp_path)
    told = json.loads((tmp_path / "Told_trade.json").read_text(encoding="utf-8"))
    parts = {part["without"]: part["errors"] for part in told["parts"]["left_out"]}
    assert set(parts) == {"slewing", "slewing.slope"}
    assert parts["slewing.slope"]["A.x"]["max"] > 0.1
