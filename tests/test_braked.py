"""What drives weigh in motion and how their brakes stop it: the reduced equation of motion, of energies that an oracle of the
geometry alone gives (`tests/oracles/luffing_resistances.py`), solved by SciPy; the closed form as a limit; both standards and
both interfaces; the inertia of the motor's shaft by the way of every drive."""

from ctypes import c_double
from math import cos, pi, radians, sin, sqrt

import numpy as np
import pytest
from fmpy import read_model_description, simulate_fmu
from fmpy.validation import validate_fmu
from scipy.integrate import solve_ivp

from conftest import ROOT, lemnis
from oracles import luffing_resistances as oracle
from test_commands import ENDS, Stepped, course, exchanged, same_bits, written

SCENES = ROOT / "models/scenes"
# Of the ready scene: inertia of the motor's shaft, travel of the rack for one turn; torque and delay of each brake.
J_M, L_M = 0.7, 0.0031
BRAKES = [(50.0, 0.2), (60.0, 1.2)]
# Viscous and dry friction, and what the motor gives until the brakes are called.
C_V, M_F, M_A, CALLED = 2e6, 20e3, 900e3, 3.0
FROM = radians(44)


def braked(name, moment, call, changes=(), rope="", more=""):
    """The ready scene in motion: the motor's moment and the brakes' command as the scene has them."""
    text = (SCENES / "portal_004_drive.toml").read_text(encoding="utf-8").replace("PortalCraneDrive", name)
    inertias = "".join(f'J_{i} = "{value} kg.m2"\n' for i, value in enumerate((951600, 201200, 114500), 1))
    dynamics = (f'[luffing.dynamics]\n{inertias}c_v = "{C_V / 1e3} kN.m.s"\nM_F = "{M_F / 1e3} kN.m"\nstep = "5 ms"\n'
                f'M_A = {moment}\nu_br = {call}\n{rope}\n{more}')
    level = "swing" if rope else "rigid"
    text = text.replace("[luffing]\n", f'[luffing]\nfidelity = "{level}"\n', 1)
    for old, new in changes:
        assert text.count(old) >= 1, old
        text = text.replace(old, new)
    return text.replace("[luffing.limits]", dynamics + "[luffing.limits]", 1)


def commanded(name, called=CALLED, **more):
    return braked(name, course([(0.0, M_A), (called, 0.0)], "steps"), course([(0.0, 0.0), (called, 1.0)], "steps", "1", 1.0),
                  **more)


class Crane:
    """Energies of the crane by the boom's angle, between two angles, as polynomials through what the oracle finds: potential
    energy, inertia of all that moves, turn of the motor's shaft."""

    def __init__(self, low, high, shaft=J_M):
        crane, nodes = oracle.DoubleLink(), 14
        at = np.cos(pi * (np.arange(nodes) + 0.5) / nodes)
        fit = lambda f: np.polynomial.Chebyshev.fit(low + (high - low) * (at + 1) / 2,
                                                    [float(f(oracle.mpf(x))) for x in low + (high - low) * (at + 1) / 2],
                                                    nodes - 1, domain=[low, high])
        centres = lambda x: [o + b.centre * t for b, (o, t) in zip(crane.bodies, crane.placed(x))]
        head = lambda x: crane.hangs(x)[0]

        def potential(x):
            return sum(b.mass * oracle.G * c.imag for b, c in zip(crane.bodies, centres(x))) + crane.load * head(x).imag

        def inertia(x):
            # Of each body as two masses at the ends of its radius of gyration, and of the load at the head.
            def masses(y):
                for b, (o, t) in zip(crane.bodies, crane.placed(y)):
                    for side in (1, -1):
                        yield b.mass / 2, o + (b.centre + side * oracle.sqrt(b.inertia / b.mass) * b.along) * t
                yield crane.load / oracle.G, head(y)

            places = [[p for _, p in masses(x + k * oracle.STEP)] for k in (-2, -1, 1, 2)]
            travels = [(8 * (r - l) - rr + ll) / (12 * oracle.STEP) for ll, l, r, rr in zip(*places)]
            return sum(m * abs(v) ** 2 for (m, _), v in zip(masses(x), travels))

        self.potential, self.bodies = fit(potential), fit(inertia)
        self.ratio = fit(lambda x: oracle.first(crane.driven, x) * 2 * oracle.pi / oracle.mpf(L_M))
        self.weight, self.bodies_change = self.potential.deriv(), self.bodies.deriv()
        self.ratio_change, self.shaft = self.ratio.deriv(), shaft

    def inertia(self, x):
        return self.bodies(x) + self.shaft * self.ratio(x) ** 2

    def acceleration(self, x, rate, moment, torque, way):
        """While it moves one way: motor's moment at the boom, brakes' torque at the shaft."""
        resists = M_F + abs(self.ratio(x)) * torque
        change = self.bodies_change(x) + 2 * self.shaft * self.ratio(x) * self.ratio_change(x)
        given = moment - self.weight(x) - C_V * rate - way * resists
        return (given - 0.5 * change * rate ** 2) / self.inertia(x)

    def run(self, called, brakes, times):
        """Angle and rate at times, from rest, by pieces: the motor's moment, then brakes one after another until rest."""
        ends = [called, *(called + delay for _, delay in brakes), 1e3]
        moments = [M_A] + [0.0] * (len(brakes) + 1)
        torques = [0.0, 0.0, *np.cumsum([torque for torque, _ in brakes])]
        start, y, found, rest = 0.0, np.array([FROM, 0.0]), {}, None
        for end, moment, torque in zip(ends, moments, torques):
            stop = lambda t, y: y[1] if t > 1e-6 else 1.0
            stop.terminal, stop.direction = True, -1
            solved = solve_ivp(lambda t, y: [y[1], self.acceleration(y[0], y[1], moment, torque, 1.0)], (start, end), y,
                               method="DOP853", rtol=1e-12, atol=1e-14, events=stop, dense_output=True)
            found |= {t: solved.sol(t) for t in times if start <= t <= solved.t[-1]}
            start, y = solved.t[-1], solved.y[:, -1]
            if solved.status == 1:
                rest = start
                break
        found |= {t: np.array([y[0], 0.0]) for t in times if t > rest}
        return np.array([found[t] for t in times]), rest


@pytest.fixture(scope="module")
def crane():
    return Crane(radians(43.5), radians(48))


@pytest.fixture(scope="module")
def stop(tmp_path_factory):
    return written(tmp_path_factory.mktemp("stop"), "Stop", commanded("Stop"))


TIMES = [round(0.1 * i, 10) for i in range(81)]


@pytest.mark.parametrize("standard", ENDS)
@pytest.mark.parametrize("kind", ["CoSimulation", "ModelExchange"])
def test_a_stop_by_two_brakes_is_that_of_the_reduced_equation(crane, stop, standard, kind):
    """From rest by the motor, then by no brake, one and both; and held after that, to the last bit."""
    assert not validate_fmu(stop[standard])
    expected, rest = crane.run(CALLED, BRAKES, TIMES)
    assert CALLED + BRAKES[0][1] < rest < TIMES[-1] - 1.0
    run = simulate_fmu(stop[standard], fmi_type=kind, stop_time=TIMES[-1], output_interval=0.1, relative_tolerance=1e-10,
                       output=["theta_1", "omega_1", "u_br"], record_events=False)
    found = np.array([[row["theta_1"], row["omega_1"]] for row in run])
    moved = np.abs(expected - expected[0]).max(axis=0)
    assert moved[0] > 0.01 and (np.abs(found - expected) <= 1e-6 * moved).all(), np.abs(found - expected).max(axis=0) / moved
    held = [row["theta_1"] for row in run if row["time"] > rest + 0.1]
    assert len(held) >= 10 and len(set(held)) == 1 and all(row["omega_1"] == 0.0 for row in run if row["time"] > rest + 0.1)


def test_the_motor_s_shaft_is_most_of_what_is_stopped(crane):
    """So that the test above asks for it, and for its change with the angle."""
    x, rate = crane.run(CALLED, BRAKES, [CALLED])[0][0]
    shaft = crane.shaft * crane.ratio(x) ** 2
    change = crane.shaft * crane.ratio(x) * crane.ratio_change(x) * rate ** 2
    assert shaft > 0.5 * crane.inertia(x) and abs(change) > 1e-4 * abs(crane.inertia(x) * crane.acceleration(x, rate, M_A, 0.0, 1))


def test_a_short_stop_comes_near_its_closed_form(crane, tmp_path):
    """A constant inertia under constant torques: the shorter the stop, the nearer, in proportion to its angle."""
    apart = []
    for i, called in enumerate((1.0, 0.1, 0.01)):
        changes = [('tau_b = "0.2 s"', 'tau_b = "0 s"'), ('tau_b2 = "1.2 s"', 'tau_b2 = "0 s"')]
        path = written(tmp_path, f"Short{i}", commanded(f"Short{i}", called, changes=changes))["FMI 3"]
        fmu = Stepped(path)
        (at, rate), = [fmu.run([0.0, called], ["theta_1", "omega_1"])[-1]]
        fmu.slave.doStep(currentCommunicationPoint=called, communicationStepSize=2.0)
        end, still = fmu.get(["theta_1", "omega_1"])
        fmu.close()
        against = crane.weight(at) + M_F + 110.0 * abs(crane.ratio(at))
        closed = rate ** 2 * crane.inertia(at) / against / 2
        assert still == 0.0 and end > at
        apart.append(abs((end - at) / closed - 1))
    assert apart[0] < 0.2 and apart[1] < 0.12 * apart[0] and apart[2] < 0.12 * apart[1] + 1e-9, apart


def test_a_base_that_could_slew_changes_nothing(crane, tmp_path):
    """The same stop where the crane stands on a slewing ring at rest; slewing, its book's identities hold."""
    ring = '\n[slewing]\nJ_sl = "5000 t.m2"\n'
    expected, _ = crane.run(CALLED, BRAKES, TIMES)
    run = simulate_fmu(written(tmp_path, "Ring", commanded("Ring") + ring)["FMI 3"], stop_time=TIMES[-1], output_interval=0.1,
                       relative_tolerance=1e-10, output=["theta_1", "omega_1", "psi_sl"], record_events=False)
    found = np.array([[row["theta_1"], row["omega_1"]] for row in run])
    assert (np.abs(found - expected) <= 1e-6 * np.abs(expected - expected[0]).max(axis=0)).all()
    assert not any(row["psi_sl"] for row in run)
    ready = (SCENES / "portal_004_braked.toml").read_text(encoding="utf-8")
    # A plane that turns meets no slope.
    ready = "\n".join(line for line in ready.split("\n") if not line.startswith("sigma_m"))
    (tmp_path / "slews.toml").write_text(ready + ring + 'c_sl = "10 kN.m.s"\nomega_sl = "5 deg/s"\n', encoding="utf-8")
    assert "identities that hold" in lemnis("check", tmp_path / "slews.toml")


@pytest.mark.parametrize("standard", ENDS)
def test_communication_steps_change_no_bit(stop, standard):
    found = same_bits(stop[standard], 800, 5)
    assert found[800] != found[0]


def test_brakes_as_an_input_fall_on_at_time_events(tmp_path, crane):
    """Called between communication points; lifted at once, and called again; both interfaces, and states that are saved."""
    paths = written(tmp_path, "Input", braked("Input", f'"{M_A / 1e3} kN.m"', '"0"'))
    steps = np.array([(0.0, 0.0), (1.0, 1.0), (1.7, 0.0), (2.5, 1.0)], dtype=[("time", "f8"), ("u_br", "f8")])
    held = lambda t: steps["u_br"][np.searchsorted(steps["time"], t, side="right") - 1]
    runs = {}
    for standard, path in paths.items():
        fmu = Stepped(path)
        rows = []
        for i in range(500):
            fmu.set("u_br", float(held(i / 100)))
            fmu.slave.doStep(currentCommunicationPoint=i / 100, communicationStepSize=0.01)
            rows.append(fmu.get(["theta_1", "omega_1", "M_R"]))
        fmu.close()
        runs[standard] = np.array(rows)
    assert (runs["FMI 2"] == runs["FMI 3"]).all()
    resists = lambda t: runs["FMI 3"][round(t * 100) - 1, 2]
    ratio = lambda t: abs(crane.ratio(runs["FMI 3"][round(t * 100) - 1, 0]))
    rate = lambda t: runs["FMI 3"][round(t * 100) - 1, 1]
    for t, torque in ((0.9, 0.0), (1.1, 0.0), (1.3, 50.0), (1.6, 50.0), (1.8, 0.0), (2.6, 0.0), (2.8, 50.0)):
        assert resists(t) == pytest.approx(-(M_F + C_V * rate(t) + torque * ratio(t)), rel=1e-9), t
    variables = {v.name: v for v in read_model_description(paths["FMI 3"]).modelVariables}
    assert variables["u_br"].causality == "input" and variables["u_br"].variability == "discrete"
    fmu, references = exchanged(paths["FMI 3"])
    events = lambda: fmu.updateDiscreteStates()
    assert not events()[4]
    fmu.setFloat64([references["u_br"]], [1.0])
    fmu.setTime(1.0)
    *_, defined, at = events()
    assert defined and at == 1.2
    fmu.setTime(at)
    *_, defined, at = events()
    assert defined and at == 2.2
    fmu.setTime(at)
    assert not events()[4]
    fmu.terminate()
    fmu.freeInstance()


def meet(a, r, b, s):
    """Where circles around two points meet, on the left of the way from the first."""
    d = abs(b - a)
    along = (d * d + r * r - s * s) / (2 * d)
    return a + (b - a) / d * (along + 1j * sqrt(r * r - along * along))


def turned(x):
    return complex(cos(x), sin(x))


def rack(joint, anchor, sense=1):
    return lambda x: abs(joint * turned(sense * x) - anchor)


def crank(arm, centre, rod, radius):
    def way(x):
        at = arm * turned(x)
        pin = meet(centre, radius, at, rod) - centre
        return radius * np.arctan2(pin.imag, pin.real)
    return way


# Drive, angle of the boom, and the way that the motor gives, of itself from the geometry.
DRIVES = {
    "double link, rack": ("portal_004_new", 'kind = "rack"\nE_x = "-4 m"\nE_y = "10 m"\ns_d = "8 m"\nchi_d = "10 deg"\n'
                          'r_z = "200 mm"\neta_d = "0.97"\n', 60.0, rack(8 * turned(radians(10)), -4 + 10j)),
    "ellipsograph, rack": ("ellipsograph_motion", 'kind = "rack"\nE_x = "-6 m"\nE_y = "-3 m"\ns_d = "9 m"\nchi_d = "5 deg"\n',
                           50.0, rack(9 * turned(radians(5)), -6 - 3j, -1)),
    "ellipsograph, sector": ("ellipsograph_motion", 'kind = "sector"\nr_s = "4 m"\ndelta_s = "-100 deg"\nr_z = "150 mm"\n'
                             'eta_d = "0.95"\n', 50.0, lambda x: -4.0 * x),
    "curved trunk, sector": ("curved_trunk_motion", 'kind = "sector"\nr_s = "4 m"\ndelta_s = "100 deg"\nr_z = "150 mm"\n'
                             'eta_d = "0.95"\n', 60.0, lambda x: 4.0 * x),
    "curved trunk, crank": ("curved_trunk_motion", 'kind = "crank"\nE_x = "-3.7 m"\nE_y = "8.2 m"\ns_d = "6 m"\n'
                            'chi_d = "0 deg"\nr_cr = "2.1 m"\nl_cr = "7 m"\nbranch = "left"\neta_d = "0.95"\n', 60.0,
                            crank(6.0, -3.7 + 8.2j, 7.0, 2.1)),
}
BODIES = {"portal_004_new": ("boom", "jib", "rocker"), "ellipsograph_motion": ("boom", "link"),
          "curved_trunk_motion": ("boom", "trunk")}


def accelerations(folder, scene, drive, motor, points):
    """Of the driving link by the FMU's equations: at an angle (deg), rates and moments of the drive."""
    text = (SCENES / f"{scene}.toml").read_text(encoding="utf-8")
    tables = {}
    for part in text.split("\n["):
        tables[part.split("]")[0].lstrip("[")] = part
    for name in ("luffing.drive", "luffing.dynamics", "luffing.hoisting", "luffing.limits", "project"):
        tables.pop(name, None)
    keys = {"portal_004_new": "123", "ellipsograph_motion": "bl", "curved_trunk_motion": "bt"}[scene]
    inertias = "".join(f'J_{key} = "{1e5 * (i + 1)} kg.m2"\n' for i, key in enumerate(keys))
    bodies = "".join(f'[[cases.body]]\non = "{body}"\nJ_s = "0 kg.m2"\n' for body in BODIES[scene])
    shaft = (f'[cases.motor]\nP_N = "1000 kW"\nn_N = "970 1/min"\nlambda_M = "9"\nk_a = "1.7"\nJ_M = "{motor} kg.m2"\n'
             f'l_M = "{L_M * 1e3} mm"\neta_M = "0.85"\nheating = "I"\n') if motor else ""
    if not motor:
        drive = "".join(f"{line}\n" for line in drive.splitlines() if line[:3] not in ("r_z", "eta"))
    more = {"luffing.drive": f"luffing.drive]\n{drive}",
            "luffing.dynamics": f'luffing.dynamics]\n{inertias}M_A = "0 kN.m"\n',
            "cases": f'cases]\n[[cases.case]]\nname = "I"\nk_Q = "1"\nalpha_s = "0 deg"\np_w = "0 Pa"\nv_s = "50 mm/s"\n'
                     f'{bodies}{shaft}'}
    if not motor and 'kind = "rack"' not in drive:
        more.pop("luffing.drive"), more.pop("cases")
    text = "\n[".join([*tables.values(), *more.values()])
    # The crank meets its rod from there on.
    text = text.replace('from  = "42 deg"', 'from  = "44 deg"')
    text = text.replace('fidelity = "swing"', 'fidelity = "rigid"')
    if "fidelity" not in text:
        text = text.replace("[luffing]\n", '[luffing]\nfidelity = "rigid"\n', 1)
    name = "Heavy" if motor else "Light"
    text = "\n".join(line if not line.startswith("name ") or "PortalCrane" not in line and "Motion" not in line
                     else f'name = "{name}"' for line in text.split("\n"))
    fmu, references = exchanged(written(folder, name, text)["FMI 3"])
    fmu.enterContinuousTimeMode()
    found = []
    for angle, rate, moment in points:
        fmu.enterEventMode()
        fmu.setFloat64([references["M_A"]], [moment])
        fmu.updateDiscreteStates()
        fmu.enterContinuousTimeMode()
        fmu.setContinuousStates((c_double * 2)(radians(angle), rate), 2)
        fmu.enterEventMode()
        fmu.updateDiscreteStates()
        fmu.enterContinuousTimeMode()
        rates = (c_double * 2)()
        fmu.getContinuousStateDerivatives(rates, 2)
        found.append(rates[1])
    fmu.terminate()
    fmu.freeInstance()
    return found


@pytest.mark.parametrize("drive", DRIVES)
def test_the_motor_weighs_by_the_way_of_its_drive(tmp_path, drive):
    """Inertia, and its change with the angle, that the equations have more with a motor than without: by the square of the
    way's derivative, of the geometry by differences."""
    scene, text, angle, way = DRIVES[drive]
    found = {}
    for motor in (0.0, 2.0):
        a, b, c = accelerations(tmp_path, scene, text, motor, [(angle, 0.01, 9e5), (angle, 0.01, 2e6), (angle, 0.06, 2e6)])
        inertia = 1.1e6 / (b - a)
        found[motor] = np.array([inertia, -2 * inertia * (c - b) / (0.06 ** 2 - 0.01 ** 2)])
    x, h = radians(angle), 1e-3
    f = {k: way(x + k * h) for k in (-3, -2, -1, 0, 1, 2, 3)}
    once = (45 * (f[1] - f[-1]) - 9 * (f[2] - f[-2]) + f[3] - f[-3]) / (60 * h)
    twice = (270 * (f[1] + f[-1]) - 27 * (f[2] + f[-2]) + 2 * (f[3] + f[-3]) - 490 * f[0]) / (180 * h * h)
    expected = 2.0 * (2 * pi / L_M) ** 2 * np.array([once ** 2, 2 * once * twice])
    more = found[2.0] - found[0.0]
    # What is found by differences of accelerations has a part of the whole inertia for its rounding.
    assert more[0] > found[0.0][0] and np.abs(more - expected).max() <= 1e-6 * expected[0], (more, expected)
