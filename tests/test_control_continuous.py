"""Slewing under a continuous controller, in FMPy: both standards and both interfaces against closed forms of a rigid shaft and
against SciPy, the limit of sampled controllers, exact derivatives, a saved state, the same bits for every communication step."""

import re

import numpy as np
import pytest
from fmpy import read_model_description, simulate_fmu
from fmpy.validation import validate_fmu
from scipy.integrate import solve_ivp

from conftest import ROOT, lemnis
from test_commands import ENDS, Stepped, same_bits, written
from test_control import SHAFT
from test_slewing_coupling import PLAIN

KINDS = ("CoSimulation", "ModelExchange")
SPEED = ROOT / "models/scenes/slewing_by_speed.toml"

# A rigid shaft; SI.
J, A, OMEGA = 4.0e6, 0.03, 0.1
FINE = '\n[slewing.dynamics]\nstep = "10 ms"\n'
DAMPED = {"over": (6e6, 1e6), "critical": (6e6, 2.25e6), "under": (6e6, 5e6)}


def shaft(folder, name, gains, **keys):
    k_p, k_i = (gain / 1e3 for gain in gains)
    keys = {"friction": 0, "cycle": "", "more": FINE, "ramp": A, "limit": 1e6, "command": f'"{OMEGA} rad/s"', **keys}
    return written(folder, name, SHAFT.format(name=name, k_p=k_p, k_i=k_i, **keys))


def told(rows, between="steps", unit="rad/s"):
    return f'{{ between = "{between}", over = [' + ", ".join(f'["{t} s", "{v} {unit}"]' for t, v in rows) + "] }"


def behind(t, k_p, k_i, inertia=J):
    """Error under a set point that rises by 1 rad/s²: J e'' + K_p e' + K_i e = 0 from e = 0, e' = 1 on."""
    t = np.maximum(t, 0.0)
    decay, square = k_p / (2 * inertia), k_p ** 2 / (4 * inertia ** 2) - k_i / inertia
    own = np.sqrt(abs(square))
    if square == 0.0:
        return t * np.exp(-decay * t)
    if square > 0.0:
        return (np.exp((own - decay) * t) - np.exp(-(own + decay) * t)) / (2 * own)
    return np.exp(-decay * t) * np.sin(own * t) / own


def chased(rows, ramp):
    """Corners of a set point that goes from zero towards a command straight between rows, no faster than its ramp."""
    corners, at = [(rows[0][0], 0.0)], 0.0
    for (start, value), (end, following) in zip(rows, [*rows[1:], (np.inf, rows[-1][1])]):
        slope = (following - value) / (end - start)
        left = value - at
        if left:
            # The distance left changes by the slope less what the set point does towards the command.
            way = np.sign(left)
            meets = start + abs(left) / (ramp - way * slope) if ramp > way * slope else np.inf
            if meets >= end:
                at += way * ramp * (end - start)
                corners.append((end, at))
                continue
            at = value + slope * (meets - start)
            corners.append((meets, at))
            start, value = meets, at
        if not np.isfinite(end):
            continue
        at = following if abs(slope) <= ramp else value + np.sign(slope) * ramp * (end - start)
        corners.append((end, at))
    return corners


def lagging(corners, times, k_p, k_i, inertia=J):
    """Error behind a set point with corners, in closed form: each change of its slope adds its own."""
    slopes = [0.0, *((b[1] - a[1]) / (b[0] - a[0]) for a, b in zip(corners, corners[1:])), 0.0]
    return sum((after - before) * behind(times - t, k_p, k_i, inertia) for (t, _), before, after in zip(corners, slopes, slopes[1:]))


@pytest.fixture(scope="module")
def shafts(tmp_path_factory):
    folder = tmp_path_factory.mktemp("shafts")
    return {case: shaft(folder, case.title(), gains) for case, gains in DAMPED.items()}


@pytest.mark.parametrize("case", DAMPED)
@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("standard", ENDS)
def test_a_step_of_the_command_in_closed_form(shafts, standard, kind, case):
    """The set point goes up in a straight line and stays: two straight lines, of which the second begins at c/a."""
    path = shafts[case][standard]
    assert not validate_fmu(path)
    run = simulate_fmu(path, fmi_type=kind, stop_time=12.0, output_interval=0.1, relative_tolerance=1e-12,
                       output=["omega_sl", "omega_rsl", "M_sl"], record_events=False)
    t, gains = run["time"], DAMPED[case]
    error = A * (behind(t, *gains) - behind(t - OMEGA / A, *gains))
    point = np.minimum(A * t, OMEGA)
    apart = [np.abs(run["omega_rsl"] - point).max(), np.abs(run["omega_sl"] - (point - error)).max()]
    print(standard, kind, case, apart)
    assert max(apart) <= 1e-9


# Straight commands, in rad/s: slower than the ramp; faster, so that the set point falls behind and catches up on the next piece;
# off the set point at the start.
STRAIGHT = [(0.0, 0.0), (4.0, 0.08), (6.0, 0.08), (7.0, -0.06), (14.0, 0.01), (16.0, 0.01)]
AHEAD = [(0.0, 0.05), (5.0, 0.1), (6.0, 0.02), (6.5, 0.1), (12.0, 0.1)]


def test_corners_of_a_set_point_behind_straight_commands():
    """By hand: 0.08 − 0.03 (t − 6) = −0.06 + 0.01 (t − 7) at t = 9.75; 0.03 t = 0.05 + 0.01 t at t = 2.5; from 0.1 at 5 s the set
    point falls to 0.07 at 6 s; at 6 + 0.05/0.19 s it meets the command that comes back, and rises."""
    assert np.array(chased(STRAIGHT, A)) == pytest.approx(np.array([(0, 0), (4, 0.08), (6, 0.08), (7, 0.05), (9.75, -0.0325),
                                                                    (14, 0.01), (16, 0.01)]), abs=1e-15)
    t = 6 + 0.05 / 0.19
    at = 0.07 - 0.03 * (t - 6)
    assert np.array(chased(AHEAD, A)) == pytest.approx(np.array([(0, 0), (2.5, 0.075), (5, 0.1), (6, 0.07), (t, at),
                                                                 (6.5, at + 0.03 * (6.5 - t)),
                                                                 (6.5 + (0.1 - at - 0.03 * (6.5 - t)) / 0.03, 0.1), (12, 0.1)]),
                                                       abs=1e-14)


@pytest.mark.parametrize("rows", [STRAIGHT, AHEAD], ids=["straight", "ahead"])
@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("standard", ENDS)
def test_straight_commands_in_closed_form(tmp_path, standard, kind, rows):
    """The set point keeps up with a command that goes straight, as far as its ramp allows."""
    gains = DAMPED["under"]
    path = shaft(tmp_path, "Straight", gains, command=told(rows, "linear"))[standard]
    run = simulate_fmu(path, fmi_type=kind, stop_time=18.0, output_interval=0.1, relative_tolerance=1e-12,
                       output=["omega_sl", "omega_rsl", "omega_csl"], record_events=False)
    t, corners = run["time"], chased(rows, A)
    point = np.interp(t, *zip(*corners))
    apart = [np.abs(run["omega_rsl"] - point).max(), np.abs(run["omega_sl"] - (point - lagging(corners, t, *gains))).max(),
             np.abs(run["omega_csl"] - np.interp(t, *zip(*rows))).max()]
    print(standard, kind, apart)
    assert max(apart) <= 1e-9


def test_straight_commands_are_the_limit_of_sampled_ones(tmp_path):
    """At the limit of the moment too; over two decades of the cycle."""
    last = {}
    for cycle in (None, 0.1, 0.01, 1e-3):
        name = f"Straight{'' if cycle is None else round(cycle * 1e4)}"
        path = shaft(tmp_path, name, (1e6, 5e6), cycle="" if cycle is None else f'T_csl = "{cycle} s"', limit=80.0,
                     command=told(STRAIGHT, "linear"))["FMI 3"]
        last[cycle] = simulate_fmu(path, stop_time=16.0, output_interval=0.5, output=["omega_sl"], record_events=False)["omega_sl"]
    off = [np.abs(last[cycle] - last[None]).max() for cycle in (0.1, 0.01, 1e-3)]
    orders = -np.diff(np.log10(off))
    print(off, orders)
    assert np.abs(orders - 1.0).max() <= 0.1


def test_the_command_acts_at_events_and_there_are_two_states_more(shafts):
    for standard in ENDS:
        description = read_model_description(shafts["under"][standard])
        variables = {v.name: v for v in description.modelVariables}
        assert (variables["omega_csl"].causality, variables["omega_csl"].variability) == ("input", "discrete")
        assert (variables["M_sl"].causality, variables["M_sl"].variability) == ("output", "continuous")
        assert "T_csl" not in variables and "omega_ssl" not in variables
        states = [unknown.variable.derivative.name for unknown in description.derivatives]
        assert states == ["psi_sl", "omega_sl", "omega_rsl", "epsilon_sl"]


def moments(rows, gains, c, limit, end, times, inertia=J):
    """Speed and integral part of the moment by SciPy, from one change to the next. States: speed, set point, M_i. Beyond the limit
    M_i waits while the error asks for more; where it would wait and go on by turns, K_p e + M_i stays at the limit."""
    k_p, k_i = gains
    y, t, mode, found = np.zeros(3), 0.0, ("free", 0), {0.0: (0.0, 0.0)}
    seen = []

    def parts(y, mode, way):
        omega, point, part = y
        error = point - omega
        moment = k_p * error + part if mode[0] == "free" else mode[1] * limit
        slope = (moment - c * omega) / inertia
        drift = way * A - slope
        grows = {"free": k_i * error, "falls": k_i * error, "waits": 0.0, "stays": -k_p * drift}[mode[0]]
        return error, slope, drift, grows

    def following(mode, y, way, which):
        """By the event itself, the first or the second of its mode: what is zero there has the sign of rounding."""
        error, _, drift, _ = parts(y, mode if mode[1] else ("waits", np.sign(k_p * (y[1] - y[0]) + y[2])), way)
        asked = k_p * error + y[2]
        sign = np.sign(asked)
        if mode[0] in ("falls", "stays"):
            return ("free", 0) if which == 0 else ("waits", sign)
        if mode[0] == "free" and sign * drift > 0:
            return "waits", sign
        if mode[0] == "waits" and which == 1:
            return "falls", sign
        return ("stays", sign) if sign * (k_p * drift + k_i * error) > 0 else ("free", 0)

    changes = [*rows, (end, rows[-1][1])]
    for (start, command), (stop, _) in zip(changes, changes[1:]):
        way = np.sign(command - y[1])
        while t < stop:
            sign = mode[1]
            ends = []
            if way:
                ends.append((lambda t, y: (command - y[1]) * way, "point"))
            if mode[0] == "free":
                ends += [(lambda t, y, s=s: limit - s * (k_p * (y[1] - y[0]) + y[2]), "mode") for s in (1, -1)]
            elif mode[0] == "stays":
                ends += [(lambda t, y: sign * (k_p * parts(y, mode, way)[2] + k_i * (y[1] - y[0])), "mode"),
                         (lambda t, y: -sign * parts(y, mode, way)[2], "mode")]
            else:
                ends += [(lambda t, y: sign * (k_p * (y[1] - y[0]) + y[2]) - limit, "mode"),
                         (lambda t, y: (sign if mode[0] == "waits" else -sign) * (y[1] - y[0]), "mode")]
            for event, _ in ends:
                event.terminal, event.direction = True, -1

            def rates(_, y):
                _, slope, _, grows = parts(y, mode, way)
                return [slope, way * A, grows]

            run = solve_ivp(rates, (t, stop), y, rtol=1e-12, atol=[1e-14, 1e-14, 1e-6], events=[event for event, _ in ends],
                            dense_output=True, method="DOP853")
            for time in times[(times > t) & (times <= run.t[-1])]:
                at = run.sol(time)
                found[time] = (at[0], at[2])
            t, y = run.t[-1], run.y[:, -1].copy()
            of_mode = len(ends) - 2
            for i, ((_, kind), at) in enumerate(zip(ends, run.t_events)):
                if len(at) and kind == "point":
                    y[1], way = command, 0
                elif len(at):
                    mode = following(mode, y, way, i - of_mode)
                    seen.append(mode[0])
    return np.array([found[time] for time in times]), seen


# Gains, friction, limit and what the limit does with the integral: each is met.
LIMITED = {
    "waits": ((6e6, 5e6), 2e5, 80e3, {"waits", "free"}),
    "stays": ((1e6, 5e6), 2e5, 80e3, {"stays", "free"}),
    "heavy": ((1.5e6, 0.4e6), 8e5, 110e3, {"waits", "free"}),
}
ROWS = [(0.0, 0.1), (9.0, -0.08), (21.0, 0.0)]


@pytest.mark.parametrize("case", LIMITED)
def test_the_limit_and_what_the_integral_does_there(tmp_path, case):
    gains, c, limit, met = LIMITED[case]
    paths = shaft(tmp_path, "Limited", gains, friction=c / 1e3, limit=limit / 1e3, command=told([*ROWS, (40.0, 0.0)]))
    times = np.array([i / 4 for i in range(161)])
    expected, seen = moments(ROWS, gains, c, limit, 40.0, times)
    assert met <= set(seen), seen
    for standard, path in paths.items():
        for kind in KINDS:
            run = simulate_fmu(path, fmi_type=kind, stop_time=40.0, output_interval=0.25, relative_tolerance=1e-11,
                               output=["omega_sl", "epsilon_sl", "M_sl"], record_events=False)
            apart = np.abs(run["omega_sl"] - expected[:, 0]).max() / OMEGA
            wound = np.abs(gains[1] * run["epsilon_sl"] - expected[:, 1]).max() / limit
            print(case, standard, kind, apart, wound, seen)
            assert max(apart, wound) <= 1e-7
            assert np.abs(run["M_sl"]).max() == limit


@pytest.mark.parametrize("case", ["linear", "stays"])
def test_sampled_controllers_tend_to_it_at_first_order(tmp_path, case):
    """Over three decades of the cycle: within its limit, and at it, where the sampled integral waits and goes on by turns."""
    gains, limit = (DAMPED["under"], 1e6) if case == "linear" else ((1e6, 5e6), 80.0)
    last = {}
    for cycle in (None, 0.1, 0.01, 1e-3, 1e-4):
        name = f"Cycle{'' if cycle is None else round(cycle * 1e4)}"
        line = "" if cycle is None else f'T_csl = "{cycle} s"'
        path = shaft(tmp_path, name, gains, cycle=line, limit=limit)["FMI 3"]
        run = simulate_fmu(path, stop_time=5.0, output_interval=1.0, output=["omega_sl"], record_events=False)
        last[cycle] = run["omega_sl"][3:]
    off = [np.abs(last[cycle] - last[None]).max() for cycle in (0.1, 0.01, 1e-3, 1e-4)]
    orders = -np.diff(np.log10(off))
    print(case, off, orders)
    assert np.abs(orders - 1.0).max() <= 0.1


@pytest.mark.parametrize("between", ["linear", "steps"])
@pytest.mark.parametrize("standard", ENDS)
def test_any_communication_step_gives_the_same_bits(tmp_path, standard, between):
    """Of the ready scene without a cycle, with friction that sticks and a load that swings: its command straight, or in steps."""
    text = re.sub(r'(?m)^T_csl.*\n', "", SPEED.read_text(encoding="utf-8"))
    if between == "steps":
        text = text.replace('"linear", shaped = "8.51 s"', '"steps"')
    found = same_bits(written(tmp_path, "SlewingBySpeed", text)[standard], 3700, 21)
    assert found[3700] != found[0]


@pytest.mark.parametrize("command", [f'"{OMEGA} rad/s"', told([(0.0, 0.0), (3.0, 0.1), (9.0, 0.0)], "linear")], ids=["held", "straight"])
def test_a_saved_state_goes_on_in_the_same_bits(tmp_path, command):
    gains, c, limit, _ = LIMITED["stays"]
    path = shaft(tmp_path, "Saved", gains, friction=c / 1e3, limit=limit / 1e3, command=command)["FMI 3"]
    names = ["omega_sl", "M_sl", "omega_rsl", "epsilon_sl"]
    fmu = Stepped(path)
    fmu.run([0.0, 3.1], names)
    assert fmu.get(["M_sl"])[0] == limit
    once, again = fmu.again([3.1, 3.7, 9.0], names)
    fmu.close()
    assert once == again


def test_derivatives_are_those_of_the_law(shafts):
    """M = K_p (ω_r − ω) + K_i ε and J ω' = M, by states and by a gain."""
    k_p, k_i = DAMPED["under"]
    fmu = Stepped(shafts["under"]["FMI 3"])
    fmu.run([0.0, 1.0], ["omega_sl"])
    names = {v.name: v.valueReference for v in fmu.description.modelVariables}
    for known, slope in (("omega_rsl", k_p), ("omega_sl", -k_p), ("epsilon_sl", k_i)):
        found = fmu.slave.getDirectionalDerivative([names["M_sl"], names["der(omega_sl)"]], [names[known]], [1.0])
        assert list(found) == pytest.approx([slope, slope / J], rel=1e-14), known
    found = fmu.slave.getDirectionalDerivative([names["der(epsilon_sl)"]], [names["omega_sl"]], [1.0])
    assert list(found) == [-1.0]
    fmu.close()


CONTROL = """[slewing.control]
K_psl = "3000 kN.m.s"
K_isl = "3000 kN.m"
{cycle}
a_sl = "0.06 rad/s2"
M_maxsl = "600 kN.m"
omega_csl = {command}
[slewing.coupling]"""


def test_a_drive_behind_a_coupling_that_slips(tmp_path):
    """It has the speed of the drive; friction holds the crane in the end. Both interfaces agree, and sampled controllers are off
    by their cycle in proportion, the heat of the coupling too."""
    names, found = ["omega_sl", "omega_d", "W_slip"], {}
    for cycle in (None, 10, 1):
        control = CONTROL.format(cycle="" if cycle is None else f'T_csl = "{cycle} ms"', command=told([(0, 0.1), (12, 0), (40, 0)]))
        text = PLAIN.format(drive='c_sl = "200 kN.m.s"').replace("[slewing.coupling]", control)
        path = written(tmp_path, "Plain", text)["FMI 3"]
        for kind in KINDS if cycle is None else KINDS[:1]:
            run = simulate_fmu(path, fmi_type=kind, stop_time=40.0, output_interval=0.25, relative_tolerance=1e-10, output=names,
                               record_events=False)
            found[cycle, kind] = np.array([run[name] for name in names])
    continuous = found[None, KINDS[0]]
    sizes = np.abs(continuous).max(axis=1)
    assert continuous[0, -1] == 0.0 and sizes[2] > 0.0
    assert (np.abs(found[None, KINDS[1]] - continuous).max(axis=1) <= 1e-7 * sizes).all()
    long, short = (np.abs(found[cycle, KINDS[0]] - continuous).max(axis=1) for cycle in (10, 1))
    assert np.abs(np.log10(long / short) - 1.0).max() <= 0.1


@pytest.mark.parametrize("kind", KINDS)
def test_the_energy_of_the_drive_is_kinetic_energy_and_friction(tmp_path, kind):
    """∫M ω dt = J ω²/2 + ∫c ω² dt, by Simpson's rule over a fine run through the limit."""
    gains, c, limit, _ = LIMITED["stays"]
    path = shaft(tmp_path, "Energy", gains, friction=c / 1e3, limit=limit / 1e3)["FMI 2"]
    run = simulate_fmu(path, fmi_type=kind, stop_time=9.0, output_interval=0.01, relative_tolerance=1e-11,
                       output=["omega_sl", "M_sl"], record_events=False)
    power = (run["M_sl"] - c * run["omega_sl"]) * run["omega_sl"]
    work = (power[0] + power[-1] + 4 * power[1:-1:2].sum() + 2 * power[2:-1:2].sum()) * 0.01 / 3
    assert work == pytest.approx(J * run["omega_sl"][-1] ** 2 / 2, rel=1e-6)


@pytest.mark.parametrize("between", ["linear", "steps"])
@pytest.mark.parametrize("language", ["en", "zh", "bg"])
def test_the_book_has_the_law(tmp_path, language, between):
    text = re.sub(r'(?m)^T_csl.*\n', "", SPEED.read_text(encoding="utf-8"))
    if between == "steps":
        text = text.replace('"linear", shaped = "8.51 s"', '"steps"')
    (tmp_path / "scene.toml").write_text(text, encoding="utf-8")
    lemnis("book", tmp_path / "scene.toml", "--format", "typ", "--language", language, "--output", tmp_path)
    [page] = tmp_path.glob("*.typ")
    book = page.read_text(encoding="utf-8")
    assert 'dot(epsilon)_"sl"' in book and 'M_"a sl"' in book and 'omega_"n sl"' not in book and 'T_"c sl"' not in book
