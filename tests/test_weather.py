"""Wind on the bodies of a crane, the slope of its ground and a given slewing speed while it moves: against a model of its own, energies, places and
areas from the geometry alone (`tests/oracles/luffing_resistances.py`), solved by SciPy; what is conserved; what pins carry by
one system of equations of all bodies; both standards and both interfaces."""

from math import pi, radians

import numpy as np
import pytest
from fmpy import simulate_fmu
from fmpy.validation import validate_fmu
from scipy.integrate import solve_ivp

from oracles import luffing_resistances as oracle
from test_braked import C_V, FROM, J_M, L_M, M_F, Crane, braked
from test_commands import ENDS, Stepped, as_told, course, same_bits, written

CRANE = oracle.DoubleLink()
# A gust from the rear and one from the front, linear between, on a slope that grows.
GUST = [(0.0, 0.0), (1.0, 0.0), (3.0, 400.0), (4.0, 400.0), (6.0, -300.0), (9.0, 0.0)]
SLOPE = [(0.0, radians(1.0)), (2.0, radians(1.0)), (8.0, radians(2.0))]
# In 1/s, of a crane whose load does not swing.
SLEWED = [(0.0, 0.0), (1.0, 0.0), (4.0, 1.6 / 60), (7.0, -1.2 / 60)]
MOMENT = 1.6e6
TIMES = [round(0.1 * i, 10) for i in range(101)]
LENGTH, SWING = 15.0, radians(1.0)


class Outdoors(Crane):
    """The same crane with what wind, slope and slewing do: by how far areas and weights move forward and up, and by the inertia of
    all masses about the slewing axis, through the foot of the boom."""

    def __init__(self, low, high, loaded):
        nodes, self.shaft = 32, J_M
        at = np.cos(pi * (np.arange(nodes) + 0.5) / nodes)
        fit = lambda f: np.polynomial.Chebyshev.fit(low + (high - low) * (at + 1) / 2,
                                                    [float(f(oracle.mpf(x))) for x in low + (high - low) * (at + 1) / 2],
                                                    nodes - 1, domain=[low, high])
        places = lambda x, of: [o + of(b) * t for b, (o, t) in zip(CRANE.bodies, CRANE.placed(x))]
        head = lambda x: CRANE.hangs(x)[0]
        swept = lambda x: sum(b.area * m.real for b, m in zip(CRANE.bodies, places(x, lambda b: b.middle)))

        def weighed(x):
            load = CRANE.load * head(x) if loaded else 0
            return sum(b.mass * oracle.G * c for b, c in zip(CRANE.bodies, places(x, lambda b: b.centre))) + load

        def masses(y):
            for b, (o, t) in zip(CRANE.bodies, CRANE.placed(y)):
                for side in (1, -1):
                    yield b.mass / 2, o + (b.centre + side * oracle.sqrt(b.inertia / b.mass) * b.along) * t
            if loaded:
                yield CRANE.load / oracle.G, head(y)

        def inert(x):
            return sum(m * abs(oracle.first(lambda y: list(masses(y))[i][1], x)) ** 2 for i, (m, _) in enumerate(masses(x)))

        self.swept, self.forward, self.up = fit(swept), fit(lambda x: weighed(x).real), fit(lambda x: weighed(x).imag)
        self.bodies = fit(inert)
        self.slewed = loaded
        self.about = fit(lambda x: sum(m * place.real**2 for m, place in masses(x)))
        self.about_change = self.about.deriv()
        self.bodies_change = self.bodies.deriv()
        self.ratio = fit(lambda x: oracle.first(CRANE.driven, x) * 2 * oracle.pi / oracle.mpf(L_M))
        self.ratio_change = self.ratio.deriv()
        self.head = [fit(lambda x: head(x).real), fit(lambda x: head(x).imag)]
        self.swept_change, self.forward_change, self.up_change = (f.deriv() for f in (self.swept, self.forward, self.up))
        self.travel = [f.deriv() for f in self.head]
        self.bend = [f.deriv() for f in self.travel]

    def inertia_change(self, x):
        return self.bodies_change(x) + 2 * self.shaft * self.ratio(x) * self.ratio_change(x)

    def given(self, t, x, rate, moment):
        """On the boom by the drive, weights on the slope, wind and friction, while it moves forward."""
        pressure, slope = (np.interp(t, *zip(*rows)) for rows in (GUST, SLOPE))
        weights = self.forward_change(x) * np.sin(slope) - self.up_change(x) * np.cos(slope)
        speed = 2 * pi * np.interp(t, *zip(*SLEWED)) if self.slewed else 0.0
        weights += speed**2 * self.about_change(x) / 2
        return moment + weights + pressure * self.swept_change(x) - C_V * rate - M_F - self.inertia_change(x) * rate**2 / 2

    def alone(self, t, y):
        return [y[1], self.given(t, y[0], y[1], MOMENT) / self.inertia(y[0])]

    def swings(self, t, y):
        """With the load of a mass on a rope of constant length, by Lagrange's equations of both angles."""
        x, rate, phi, turns = y
        slope, mass = np.interp(t, *zip(*SLOPE)), 100e3 / 9.81
        d, dd = (np.array([f(x) for f in of]) for of in (self.travel, self.bend))
        along, inward = np.array([np.cos(phi), np.sin(phi)]), np.array([-np.sin(phi), np.cos(phi)])
        gravity = 9.81 * np.array([np.sin(slope), -np.cos(slope)])
        # The load's acceleration but for those of both angles.
        rest = dd * rate**2 + LENGTH * inward * turns**2 - gravity
        left = np.array([[self.inertia(x) + mass * d @ d, mass * LENGTH * d @ along],
                         [mass * LENGTH * d @ along, mass * LENGTH**2]])
        right = [self.given(t, x, rate, MOMENT) - mass * d @ rest, -mass * LENGTH * along @ rest]
        acceleration, swing = np.linalg.solve(left, right)
        return [rate, acceleration, turns, swing]

    def run(self, rope):
        start = [FROM, 0.0, SWING, 0.0] if rope else [FROM, 0.0]
        breaks = sorted({0.0, TIMES[-1], *(t for t, _ in [*GUST, *SLOPE, *SLEWED] if t < TIMES[-1])})
        found, y = {}, np.array(start)
        for a, b in zip(breaks, breaks[1:]):
            solved = solve_ivp(self.swings if rope else self.alone, (a, b), y, method="DOP853", rtol=1e-12, atol=1e-14,
                               dense_output=True)
            found |= {t: solved.sol(t) for t in TIMES if a <= t <= b}
            y = solved.y[:, -1]
        return np.array([found[t] for t in TIMES])


def scene(name, rope):
    angle = lambda rows: course(rows, "linear", "rad", 1.0)
    more = f'p_wm = {course(GUST, "linear", "Pa", 1.0)}\nsigma_m = {angle(SLOPE)}\n'
    if not rope:
        more += f'n_sm = {course(SLEWED, "linear", "1/min", 1 / 60)}\n'
    load = f'l_R = "{LENGTH} m"\nphi_R = "{SWING!r} rad"' if rope else ""
    return braked(name, f'"{MOMENT / 1e3} kN.m"', '"0"', rope=load, more=more)


@pytest.fixture(scope="module", params=["rigid", "swing"])
def manoeuvre(request, tmp_path_factory):
    """The FMUs, their outputs and what these should be."""
    rope, name = request.param == "swing", f"Weather{request.param.title()}"
    paths = written(tmp_path_factory.mktemp("weather"), name, scene(name, rope))
    names = ["theta_1", "omega_1", "phi_R", "omega_R"] if rope else ["theta_1", "omega_1"]
    return paths, names, Outdoors(radians(43.5), radians(69), not rope).run(rope)


@pytest.mark.parametrize("standard", ENDS)
@pytest.mark.parametrize("kind", ["CoSimulation", "ModelExchange"])
def test_a_manoeuvre_in_a_gust_on_a_slope_is_that_of_a_model_of_its_own(manoeuvre, standard, kind):
    paths, names, expected = manoeuvre
    assert not validate_fmu(paths[standard])
    run = simulate_fmu(paths[standard], fmi_type=kind, stop_time=TIMES[-1], output_interval=0.1, relative_tolerance=1e-11,
                       output=names, record_events=False)
    found = np.array([[row[name] for name in names] for row in run])
    ranges = np.ptp(expected, axis=0)
    assert len(found) == len(expected) and ranges[0] > 0.03
    apart = np.abs(found - expected).max(axis=0) / ranges
    assert (apart <= 1e-7).all(), apart


@pytest.mark.parametrize("standard", ENDS)
def test_communication_steps_change_no_bit(manoeuvre, standard):
    same_bits(manoeuvre[0][standard], 1000, 6)


def free(name, more):
    """The rigid crane without friction."""
    text = braked(name, f'"{MOMENT / 1e3} kN.m"', '"0"', more=more)
    for line in (f'c_v = "{C_V / 1e3} kN.m.s"\n', f'M_F = "{M_F / 1e3} kN.m"\n'):
        assert line in text
        text = text.replace(line, "")
    return text


def test_energy_is_the_work_of_drive_wind_and_centrifugal_forces(tmp_path):
    """Kinetic and potential energy on the slope less what drive, a steady wind and steady slewing have done stays what it is."""
    pressure, slope, speed = 250.0, radians(1.5), 1.4 / 60
    text = free("Work", f'p_wm = "{pressure} Pa"\nsigma_m = "{slope!r} rad"\nn_sm = "{speed!r} 1/s"\n')
    crane = Outdoors(radians(43.5), radians(69), True)
    fmu = Stepped(written(tmp_path, "Work", text)["FMI 3"])
    rows = fmu.run([0.1 * i for i in range(61)], ["theta_1", "omega_1", "M_wind", "M_slope", "M_Omega"])
    fmu.close()
    kept, sizes = [], []
    for x, rate, wind, slopes, slewed in rows:
        kinetic = crane.inertia(x) * rate**2 / 2
        height = crane.up(x) * np.cos(slope) - crane.forward(x) * np.sin(slope)
        work = MOMENT * x + pressure * crane.swept(x) + (2 * pi * speed)**2 * crane.about(x) / 2
        kept.append(kinetic + height - work)
        sizes.append(kinetic)
        assert wind == pytest.approx(pressure * crane.swept_change(x), rel=1e-9)
        leaning = crane.forward_change(x) * np.sin(slope) + crane.up_change(x) * (1 - np.cos(slope))
        assert slopes == pytest.approx(leaning, rel=1e-9)
        assert slewed == pytest.approx((2 * pi * speed)**2 * crane.about_change(x) / 2, rel=1e-9)
    assert max(sizes) > 1e4 and np.ptp(kept) <= 1e-8 * max(sizes), np.ptp(kept) / max(sizes)


PINS = {"O1": ("F_O1.x", "F_O1.y"), "B": ("F_B.x", "F_B.y"), "C": ("F_C.x", "F_C.y"), "O3": ("F_O3.x", "F_O3.y"),
        "M": ("F_M.x", "F_M.y")}


@pytest.mark.parametrize("angle, rate, pressure, slope, speed", [(50.0, 0.03, 600.0, 2.0, 0.0), (61.3, -0.05, -900.0, -1.0, 1.1),
                                                                 (78.1, 0.02, 0.0, 3.0, -1.7), (66.6, 0.04, 450.0, 0.0, 0.0),
                                                                 (55.5, 0.01, 0.0, 0.0, 2.3)])
def test_pins_carry_what_acts_in_motion(tmp_path, angle, rate, pressure, slope, speed):
    """All forces of the moving bodies by one system of equations, of d'Alembert's forces, weights on the slope, wind and centrifugal
    forces of halves of each body's mass."""
    name = "Pins"
    path = written(tmp_path, name, free(name, 'p_wm = "0 Pa"\nsigma_m = "0 deg"\nn_sm = "0 1/min"\n'))["FMI 3"]
    names = [*sum(PINS.values(), ()), "M_D"]
    rates, found = as_told(path, [radians(angle), rate], names, {"p_wm": pressure, "sigma_m": radians(slope), "n_sm": speed / 60})

    phi, turning = oracle.mpf(radians(angle)), oracle.mpf(rates[1])
    down = oracle.mpc(oracle.sin(oracle.mpf(radians(slope))), -oracle.cos(oracle.mpf(radians(slope))))
    turns, origins, _ = CRANE.turns(phi)
    forces, couples = [], []
    for i, (b, (w, e), (travel, bend), (o, t)) in enumerate(zip(CRANE.bodies, turns, origins, CRANE.placed(phi))):
        arm = b.centre * t
        travel, bend = travel + 1j * w * arm, bend + (1j * e - w**2) * arm
        forces.append((i, o + arm, b.mass * (oracle.G * down - travel * turning - bend * oracle.mpf(rate) ** 2)))
        forces.append((i, o + b.middle * t, oracle.mpf(pressure) * b.area))
        for side in (1, -1):
            place = o + (b.centre + side * oracle.sqrt(b.inertia / b.mass) * b.along) * t
            forces.append((i, place, b.mass / 2 * (2 * oracle.pi * oracle.mpf(speed) / 60) ** 2 * place.real))
        couples.append(-b.inertia * (w * turning + e * oracle.mpf(rate) ** 2))
    head = lambda x: CRANE.hangs(x)[0]
    step = oracle.mpf(10) ** -12
    second = (head(phi + step) - 2 * head(phi) + head(phi - step)) / step**2
    mass = CRANE.load / oracle.G
    load = mass * (oracle.G * down - oracle.first(head, phi) * turning - second * oracle.mpf(rate) ** 2)
    load += mass * (2 * oracle.pi * oracle.mpf(speed) / 60) ** 2 * head(phi).real
    moment, carried = CRANE.hold(phi, forces, couples, load)
    size = float(max(carried))
    assert abs(found["M_D"] - float(moment)) <= 1e-12 * size * 26.3, (found["M_D"], float(moment))
    for pin, wanted in zip(("O1", "B", "C", "O3"), carried):
        x, y = (found[name] for name in PINS[pin])
        assert abs(np.hypot(x, y) - float(wanted)) <= 1e-12 * size, (pin, np.hypot(x, y), float(wanted))
    assert abs(np.hypot(*(found[name] for name in PINS["M"])) - float(carried[6])) <= 1e-12 * size
