"""Spreader and load of a container bridge as two bodies in motion: against Newton's equations of three constraints, written from the
places of both bodies and solved with their multipliers by numpy and SciPy, in both standards and interfaces; energy, small sway and
limits."""

import math
import numpy as np
import pytest
from fmpy import simulate_fmu
from fmpy.fmi1 import FMICallException
from fmpy.validation import validate_fmu
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

from conftest import lemnis
from test_bridge import ENDS, G, LOAD, ROPES, SPREADER, TROLLEY, over, pendulum, written

LENGTH, DRAG = 18.0, 250 * 45
SLINGS = {"l_s": 6.0, "e_s": 0.8, "e_1": 0.3, "i_1": 2.0}
KINDS = {
    "trapezoid": {},
    "parallel": {"a_u": 2.4},
    "turned": {"a_o": 1.6, "a_u": 2.4, "b_u": 2.0},
}
RATES = [(0.0, 0.5), (4.0, -0.3), (9.0, 0.0), (11.0, -0.35), (15.0, 0.0)]
HOISTS = [(0.0, 0.0), (2.0, 1.0), (7.0, -0.8), (14.0, 0.0)]
OUTPUT = ["x_t", "v_t", "phi_R", "omega_R", "psi_s", "omega_psi", "l_R", "beta_s", "x_L", "y_Q", "N_s", "S_R", "F_phi", "S_s1", "S_s2", "a_l",
          "F_dr", "P_dr"]


def moving(folder, name, ropes=None, rates=(), hoists=(), slings=None, more=""):
    """The ready bridge's FMUs with slings, in motion."""
    own = SLINGS | (slings or {})
    table = "\n[trolley.slings]\n" + "".join(f'{key} = "{value!r} m"\n' for key, value in own.items())
    return written(folder, name, ropes=ropes, a_t=over(rates) if rates else "",
                   v_h=over(hoists).replace("m/s2", "m/s") if hoists else "", more=more + table)


class Bodies:
    """Spreader (place of its centre of gravity, turn) and load (place) in fixed axes, on a trolley that follows its acceleration: two
    sides' ropes and the slings as constraints of their lengths."""

    def __init__(self, ropes=None, slings=None, load=LOAD, zeta=0.0, length=LENGTH):
        own = ROPES | (ropes or {}) | SLINGS | (slings or {})
        self.__dict__.update(own)
        self.lean, self.load, self.zeta, self.start_length = own["b_o"] - own["b_u"], load, zeta, length
        self.mass = np.array([SPREADER, SPREADER, SPREADER * self.i_1**2, load, load])
        self.l_e = pendulum(length, ROPES | (ropes or {}))[0] if zeta else length

    def arm(self, q, x, y):
        """A point of the spreader from its centre of gravity, and what that changes by with the turn, twice."""
        sin, cos = math.sin(q[2]), math.cos(q[2])
        here = np.array([cos * x - sin * y, sin * x + cos * y])
        return here, np.array([-here[1], here[0]])

    def lines(self, q, x):
        """The three lines: vector, its two-by-five derivative, and place of its turned arm."""
        found = []
        for side in (1, -1):
            here, turned = self.arm(q, side * self.a_u, self.e_1)
            d = np.zeros((2, 5))
            d[0, 0] = d[1, 1] = 1.0
            d[:, 2] = turned
            found.append((q[:2] + here - np.array([x + side * self.a_o, 0.0]), d, here))
        here, turned = self.arm(q, 0.0, self.e_1 - self.e_s)
        d = np.zeros((2, 5))
        d[0, 0] = d[1, 1] = -1.0
        d[:, 2] = -turned
        d[0, 3] = d[1, 4] = 1.0
        found.append((q[3:] - q[:2] - here, d, -here))
        return found

    def constraints(self, q, v, x, v_t, a, l, reel):
        """Gradients, what the speeds along them must be, and what accelerations must be."""
        gradient, speeds, rates = [], [], []
        for i, (line, d, here) in enumerate(self.lines(q, x)):
            base = np.array([v_t if i < 2 else 0.0, 0.0])
            push = np.array([a if i < 2 else 0.0, 0.0])
            rate = d @ v - base
            gradient.append(line @ d)
            speeds.append(line @ base + (l * reel if i < 2 else 0.0))
            rates.append((reel**2 if i < 2 else 0.0) - rate @ rate - line @ (-here * v[2] ** 2 - push))
        return np.array(gradient), np.array(speeds), np.array(rates)

    def sway(self, q, v, x, v_t):
        place, turned = self.arm(q, 0.0, self.e_1)
        middle, rate = q[:2] + place - np.array([x, 0.0]), v[:2] + turned * v[2] - np.array([v_t, 0.0])
        return math.atan2(middle[0], -middle[1]), (rate[1] * middle[0] - rate[0] * middle[1]) / (middle @ middle)

    def accelerated(self, told, q, v, x, v_t):
        phi, omega = self.sway(q, v, x, v_t)
        return told + 2 * self.zeta * math.sqrt(G * self.l_e) * omega

    def solve(self, told, reel, q, v, x, v_t, l):
        a = self.accelerated(told, q, v, x, v_t) if self.zeta else told
        gradient, _, rates = self.constraints(q, v, x, v_t, a, l, reel)
        system = np.block([[np.diag(self.mass), -gradient.T], [gradient, np.zeros((3, 3))]])
        weights = self.mass * np.array([0.0, -G, 0.0, 0.0, -G])
        found = np.linalg.solve(system, np.concatenate([weights, rates]))
        return a, found[:5], found[5:]

    def at_rest(self, phi, x):
        """The spreader's middle in this direction, by bisection of the turn on the loop as it stands."""
        def place(turn):
            half = self.a_u * np.array([math.cos(turn), math.sin(turn)])
            square = lambda r: np.array([np.sum((r * np.array([math.sin(phi), -math.cos(phi)]) + s * half - np.array([s * self.a_o, 0.0])) ** 2)
                                         + self.lean**2 - self.start_length**2 for s in (1, -1)])
            r = brentq(lambda r: square(r).sum(), 0.3 * self.start_length, 2 * self.start_length, xtol=1e-14)
            return r, square(r)[0] - square(r)[1]
        turn = brentq(lambda b: place(b)[1], -0.6, 0.6, xtol=1e-15) if phi and self.a_o != self.a_u else 0.0
        middle = place(turn)[0] * np.array([math.sin(phi), -math.cos(phi)])
        down = np.array([math.sin(turn), -math.cos(turn)])
        spreader = middle + self.e_1 * down
        load = middle + self.e_s * down + np.array([0.0, -self.l_s])
        return np.array([x + spreader[0], spreader[1], turn, x + load[0], load[1]])

    def run(self, times, rates=(), hoists=(), phi=0.0, x=-12.0):
        """Rows like those of the FMU; where the hoist's speed jumps, impulses of the three lines change the speeds."""
        told = lambda rows, t: next((value for time, value in reversed(rows) if t >= time), 0.0)
        q, v, state = self.at_rest(phi, x), np.zeros(5), np.array([x, 0.0, self.start_length])
        breaks = sorted({0.0, float(times[-1]), *(time for time, _ in [*rates, *hoists] if time < times[-1])})
        found = []
        for begin, end in zip(breaks, breaks[1:]):
            command, reel = told(list(rates), begin), -told(list(hoists), begin)
            gradient, speeds, _ = self.constraints(q, v, state[0], state[1], 0.0, state[2], reel)
            system = np.block([[np.diag(self.mass), -gradient.T], [gradient, np.zeros((3, 3))]])
            v = np.linalg.solve(system, np.concatenate([self.mass * v, speeds]))[:5]

            def f(_, y):
                a, acceleration, _ = self.solve(command, reel, y[:5], y[5:10], y[10], y[11], y[12])
                return np.concatenate([y[5:10], acceleration, [y[11], a, reel]])

            here = [t for t in times if begin <= t < end or t == end == times[-1]]
            solved = solve_ivp(f, (begin, end), np.concatenate([q, v, state]), method="DOP853", rtol=1e-12, atol=1e-13, dense_output=True)
            found += [self.row(command, reel, solved.sol(t)) for t in here]
            q, v, state = solved.y[:5, -1], solved.y[5:10, -1], solved.y[10:, -1]
        return {name: np.array([row[name] for row in found]) for name in OUTPUT}

    def row(self, command, reel, y):
        q, v, (x, v_t, l) = y[:5], y[5:10], y[10:]
        a, _, pulls = self.solve(command, reel, q, v, x, v_t, l)
        (sea, *_), (land, *_), (slings, rate, _) = self.lines(q, x)
        phi, omega = self.sway(q, v, x, v_t)
        speed = rate @ v
        # A multiplier times its line is the force on the body.
        on_ropes = -(pulls[0] * sea + pulls[1] * land)
        along = np.array([math.sin(phi), -math.cos(phi)])
        weight = (SPREADER + self.load) * G
        against = 0.008 * (weight + TROLLEY * G) + DRAG + weight * (1 - 0.98**2)
        force = math.copysign(against, v_t if v_t else a) + TROLLEY * a - on_ropes[0]
        power = force * v_t
        return {"x_t": x, "v_t": v_t, "phi_R": phi, "omega_R": omega, "psi_s": math.atan2(slings[0], -slings[1]),
                "omega_psi": (slings[0] * speed[1] - slings[1] * speed[0]) / (slings @ slings), "l_R": l, "beta_s": q[2],
                "x_L": q[3], "y_Q": q[4], "N_s": -pulls[2] * self.l_s, "S_R": on_ropes @ along, "F_phi": on_ropes[0],
                "S_s1": -pulls[0] * l / 2, "S_s2": -pulls[1] * l / 2, "a_l": a, "F_dr": force, "P_dr": power * 0.9 if power < 0 else power / 0.9}


def scale(name):
    return 1e6 if name[0] in "NSFP" else 10.0 if name in ("x_t", "x_L", "y_Q", "l_R") else 1.0


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return tmp_path_factory.mktemp("bodies")


@pytest.fixture(scope="module")
def hoisted(folder):
    return {kind: moving(folder, f"Hoisted{kind}", ropes, RATES, HOISTS, more='phi_R = "4 deg"\n') for kind, ropes in KINDS.items()}


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("standard", ENDS)
@pytest.mark.parametrize("interface", ["CoSimulation", "ModelExchange"])
def test_motion_and_pulls_by_constraints(hoisted, kind, standard, interface):
    """Starts, stops and hoisting by jumps, released from a sway."""
    path = hoisted[kind][standard]
    assert not validate_fmu(path)
    result = simulate_fmu(path, fmi_type=interface, stop_time=20.0, output_interval=0.25, relative_tolerance=1e-10, output=OUTPUT)
    wanted = Bodies(KINDS[kind]).run(result["time"], RATES, HOISTS, math.radians(4))
    assert np.ptp(wanted["psi_s"] - wanted["phi_R"]) > 0.1 and np.abs(wanted["phi_R"]).max() > 0.08
    # At a jump of what is told, either side of it is right.
    breaks = {time for time, _ in [*RATES, *HOISTS]}
    smooth = np.array([time not in breaks for time in result["time"]])
    for name in OUTPUT:
        at = smooth if name not in ("x_t", "v_t", "phi_R", "psi_s", "l_R", "beta_s", "x_L", "y_Q") else slice(None)
        error = np.abs(result[name] - wanted[name])[at].max()
        assert error <= 3e-6 * scale(name), (name, error)


def test_feedback_answers_to_the_spreader(folder):
    rates = RATES[:3]
    paths = moving(folder, "Fed", rates=rates, more='zeta_f = "0.3"\n')
    result = simulate_fmu(paths["FMI 3"], stop_time=40.0, output_interval=0.25, output=OUTPUT)
    wanted = Bodies(zeta=0.3).run(result["time"], rates)
    smooth = np.array([time not in {time for time, _ in rates} for time in result["time"]])
    for name in OUTPUT:
        error = np.abs(result[name] - wanted[name])[smooth].max()
        assert error <= 5e-6 * scale(name), (name, error)
    # The sway goes, and the trolley has the speed that it is told.
    assert np.abs(result["phi_R"][-8:]).max() < 0.1 * np.abs(result["phi_R"]).max()


def energy(bodies, q, v):
    return 0.5 * bodies.mass @ v**2 + G * (SPREADER * q[1] + bodies.load * q[4])


def speeds(bodies, row):
    """Places and speeds of both bodies from the angles and angular velocities of an FMU's row, by the loop."""
    own = Bodies.__new__(Bodies)
    own.__dict__.update(bodies.__dict__)
    q = own.at_rest(float(row["phi_R"]), 0.0)
    psi, l_s = float(row["psi_s"]), own.l_s
    joint = q[:2] + own.arm(q, 0.0, own.e_1 - own.e_s)[0]
    q[3:] = joint + l_s * np.array([math.sin(psi), -math.cos(psi)])
    gradient, _, _ = own.constraints(q, np.zeros(5), 0.0, 0.0, 0.0, own.start_length, 0.0)
    place, turned = own.arm(q, 0.0, own.e_1)
    middle = q[:2] + place
    sway = np.zeros(5)
    sway[0], sway[1], sway[2] = -middle[1], middle[0], turned[1] * middle[0] - turned[0] * middle[1]
    slings = np.array([q[3] - joint[0], q[4] - joint[1]])
    turn = own.arm(q, 0.0, own.e_1 - own.e_s)[1]
    spin = np.array([slings[1], -slings[0], slings[1] * turn[0] - slings[0] * turn[1], -slings[1], slings[0]])
    system = np.array([*gradient, sway, spin])
    right = np.array([0.0, 0.0, 0.0, float(row["omega_R"]) * (middle @ middle), float(row["omega_psi"]) * l_s**2])
    return q, np.linalg.solve(system, right)


@pytest.mark.parametrize("kind", KINDS)
def test_energy_stays(folder, kind):
    """A release from a great sway, without commands: over two minutes, on the scene's own solver at a short step."""
    paths = moving(folder, f"Free{kind}", KINDS[kind], more='phi_R = "15 deg"\n[trolley.dynamics]\nstep = "4 ms"\n')
    result = simulate_fmu(paths["FMI 3"], fmi_type="CoSimulation", stop_time=120.0, output_interval=0.5, output=OUTPUT)
    bodies = Bodies(KINDS[kind])
    lowest = energy(bodies, bodies.at_rest(0.0, 0.0), np.zeros(5))
    found = np.array([energy(bodies, *speeds(bodies, row)) for row in result]) - lowest
    assert np.ptp(result["psi_s"]) > 0.3
    assert np.abs(found / found[0] - 1).max() < 1e-9


@pytest.mark.parametrize("kind", KINDS)
def test_small_sway_has_both_frequencies(folder, kind):
    """In either mode a sway follows its cosine, but for what grows with the cube of its amplitude."""
    paths = moving(folder, f"Small{kind}", KINDS[kind])
    known = simulate_fmu(paths["FMI 3"], stop_time=0.1, output=["omega_s1", "omega_s2", "sigma_s1", "sigma_s2", "h_r"])[-1]
    for mode in (1, 2):
        omega, shape = (float(known[f"{name}_s{mode}"]) for name in ("omega", "sigma"))
        errors = []
        for size in (0.04, 0.02):
            scale = 1.0 / max(1.0, abs(shape) * known["h_r"] / SLINGS["l_s"])
            start = {"phi_R": size * scale, "psi_s": size * scale * shape * known["h_r"] / SLINGS["l_s"]}
            result = simulate_fmu(paths["FMI 3"], fmi_type="ModelExchange", stop_time=2 * math.pi / omega, relative_tolerance=1e-11,
                                  start_values={name: float(value) for name, value in start.items()}, output=["phi_R", "psi_s"])
            errors.append(max(np.abs(result[name] - value * np.cos(omega * result["time"])).max() for name, value in start.items()))
        assert errors[0] < 2.0 * 0.04**3 * (1 + (omega * math.sqrt(SLINGS["l_s"] / G)) ** 4), errors
        assert errors[0] / errors[1] == pytest.approx(8.0, rel=0.05), errors


def test_parallel_ropes_are_the_double_pendulum(folder):
    """The equations of the schoolbook, for any angles."""
    paths = moving(folder, "Double", KINDS["parallel"], more='phi_R = "40 deg"\n')
    result = simulate_fmu(paths["FMI 3"], fmi_type="ModelExchange", stop_time=15.0, output_interval=0.1, relative_tolerance=1e-11,
                          start_values={"psi_s": 0.1}, output=["phi_R", "psi_s", "omega_R", "omega_psi", "beta_s"])
    m_1, m_2, l_1, l_2 = SPREADER, LOAD, LENGTH, SLINGS["l_s"]

    def f(_, y):
        apart, (w_1, w_2) = y[0] - y[1], y[2:]
        mass = np.array([[(m_1 + m_2) * l_1, m_2 * l_2 * math.cos(apart)], [l_1 * math.cos(apart), l_2]])
        right = [-m_2 * l_2 * w_2**2 * math.sin(apart) - (m_1 + m_2) * G * math.sin(y[0]), l_1 * w_1**2 * math.sin(apart) - G * math.sin(y[1])]
        return [w_1, w_2, *np.linalg.solve(mass, right)]

    wanted = solve_ivp(f, (0, 15), [math.radians(40), 0.1, 0, 0], method="DOP853", rtol=1e-12, atol=1e-12, t_eval=result["time"]).y
    for name, values in zip(("phi_R", "psi_s", "omega_R", "omega_psi"), wanted):
        assert np.abs(result[name] - values).max() < 2e-6, name
    assert np.abs(result["beta_s"]).max() < 1e-15


@pytest.mark.parametrize("kind", ["trapezoid", "parallel"])
def test_short_slings_are_one_body(folder, kind):
    """Of a spreader that is loaded at the joint of its slings: as these get shorter their motion comes to that, in proportion."""
    one = Bodies(KINDS[kind])
    one.mass = np.array([SPREADER, SPREADER, SPREADER * one.i_1**2, 1e-9, 1e-9])
    # A load as a point of the spreader: both as one rigid body.
    both, deep = SPREADER + LOAD, (SPREADER * one.e_1 + LOAD * one.e_s) / (SPREADER + LOAD)
    inertia = SPREADER * (one.i_1**2 + (one.e_1 - deep) ** 2) + LOAD * (one.e_s - deep) ** 2
    one.e_1, one.mass[:3] = deep, [both, both, inertia]
    times = np.linspace(0, 8, 33)
    rigid = one.run(times, phi=math.radians(8))
    errors = []
    for length in (0.2, 0.05):
        paths = moving(folder, f"Short{kind}{int(1000 * length)}", KINDS[kind], slings={"l_s": length}, more='phi_R = "8 deg"\n')
        # Along the line of the ropes, so that they do not sway of their own.
        result = simulate_fmu(paths["FMI 3"], fmi_type="CoSimulation", stop_time=8.0, output_interval=0.25, output=["phi_R", "psi_s"],
                              start_values={"psi_s": math.radians(8)})
        errors.append(np.abs(result["phi_R"] - rigid["phi_R"]).max())
    assert errors[1] < 2e-3 and errors[0] / errors[1] == pytest.approx(4.0, rel=0.25), errors


def test_a_light_load_leaves_the_spreader_alone(folder):
    paths = moving(folder, "Light", more='phi_R = "8 deg"\n')
    result = simulate_fmu(paths["FMI 3"], stop_time=10.0, output_interval=0.25, output=["phi_R", "N_s"], start_values={"Q": 1e-3})
    wanted = Bodies(load=1e-4 / G).run(result["time"], phi=math.radians(8))
    assert np.abs(result["phi_R"] - wanted["phi_R"]).max() < 2e-6
    assert np.all(result["N_s"] > 0) and np.abs(result["N_s"]).max() < 2e-3


@pytest.mark.parametrize("standard", ENDS)
@pytest.mark.parametrize("interface", ["CoSimulation", "ModelExchange"])
def test_slings_that_would_push_end_the_run(folder, capsys, standard, interface):
    """A load that is thrown over its joint: where its slings pull no more, by the constraints as they stand, the run ends with what is
    wrong."""
    paths = moving(folder, "Pushed")
    start = {"psi_s": 1.4, "w_psi": 1.0}
    rows = []
    with pytest.raises(FMICallException):
        simulate_fmu(paths[standard], fmi_type=interface, stop_time=5.0, output_interval=0.01, output=["N_s"], start_values=start,
                     relative_tolerance=1e-10, step_finished=lambda time, recorder: rows.append((time, recorder.rows[-1][1])) or True)
    assert rows[0][1] > 0 and all(pull >= 0 for _, pull in rows)
    bodies = Bodies()
    q = bodies.at_rest(0.0, 0.0)
    q[3:] = q[3:] + bodies.l_s * np.array([math.sin(1.4), 1 - math.cos(1.4)])
    v = np.array([0.0, 0.0, 0.0, bodies.l_s * math.cos(1.4), bodies.l_s * math.sin(1.4)])

    def f(_, y):
        return np.concatenate([y[5:], bodies.solve(0.0, 0.0, y[:5], y[5:], 0.0, 0.0, LENGTH)[1]])

    slack = lambda _, y: -bodies.solve(0.0, 0.0, y[:5], y[5:], 0.0, 0.0, LENGTH)[2][2]
    slack.terminal = True
    end = solve_ivp(f, (0, 5), np.concatenate([q, v]), method="DOP853", rtol=1e-11, atol=1e-11, events=slack).t[-1]
    assert 0 <= end - rows[-1][0] <= 0.0101, (end, rows[-1])
    message = capsys.readouterr().out
    assert "the slings are slack" in message and "start and stop more gently" in message


def test_ropes_that_would_push_end_the_run(folder, capsys):
    """Released where the load pulls the spreader's joint beyond one side's ropes."""
    paths = moving(folder, "Aslant", slings={"e_s": 4.0})
    bodies = Bodies(slings={"e_s": 4.0})
    found = simulate_fmu(paths["FMI 3"], stop_time=0.01, output=["S_s1", "S_s2"], start_values={"psi_s": 0.2})[0]
    assert found["S_s1"] > 0 and found["S_s2"] > 0 and abs(found["S_s1"] / found["S_s2"] - 1) > 0.2
    with pytest.raises(FMICallException):
        simulate_fmu(paths["FMI 3"], stop_time=0.01, output=["S_s1"], start_values={"psi_s": 1.0})
    # The moment of what pulls the spreader aside, about the joints of the other side, by the constraints as they stand.
    q = bodies.at_rest(0.0, 0.0)
    q[3:] = q[3:] + bodies.l_s * np.array([math.sin(1.0), 1 - math.cos(1.0)])
    pulls = -bodies.solve(0.0, 0.0, q, np.zeros(5), 0.0, 0.0, LENGTH)[2]
    slack = "sea" if pulls[0] < 0 else "land"
    assert pulls[:2].min() < 0 < pulls[2] and f"the {slack} side's ropes are slack, each would have to push with" in capsys.readouterr().out
