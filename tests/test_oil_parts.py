"""Anti-cavitation valves, load-holding valves and limits of the pump through FMPy, both standards and both interfaces: against an
independent crane and cylinder, solved by SciPy's Radau, and closed forms at rest."""

import math
import re
import sys

import numpy as np
import pytest
from fmpy import read_model_description, simulate_fmu
from fmpy.validation import validate_fmu
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

from conftest import ROOT, lemnis, words
from test_levels import scene

sys.path.insert(0, str(ROOT / "tests/oracles"))
import hydraulic_cylinder as crane  # noqa: E402

ENDS = {"FMI 2": ".fmi2.fmu", "FMI 3": ".fmu"}
SCENE = ROOT / "models/scenes/luffing_cylinder.toml"
BAR, LITRE = 1e5, 1e-3 / 60
ANTI_CAVITATION = {"p_ac": 0.2 * BAR, "k_ac": 2e-7}
LOAD_HOLDING = {"p_lh": 180 * BAR, "i_lh": 4.0, "dp_lh": 30 * BAR, "x_T": 0.05}
PUMP = {"Q_Pmax": 300 * LITRE, "P_Pmax": 60e3}
TANK = {"p_tank": 3 * BAR}
UNITS = {"p_ac": "Pa", "k_ac": "m3/(s.Pa)", "p_lh": "Pa", "i_lh": "1", "dp_lh": "Pa", "x_T": "1", "Q_Pmax": "m3/s", "P_Pmax": "W", "p_tank": "Pa"}
STATES = ("theta_1", "omega_1", "p_1", "p_2", "p_A", "p_B", "x_v", "v_v")
# To the last bits.
FINEST = {"xtol": 1e-300, "rtol": 4 * np.finfo(float).eps}
# What states are measured by.
SIZES = np.array([1.0, 0.1, 100 * BAR, 100 * BAR, 100 * BAR, 100 * BAR, 1.0, 100.0])


def built(folder, *parts):
    """FMUs of the oracle's crane, with parts of its oil."""
    back = complex(crane.X2) + crane.X4 * complex(math.cos(crane.BETA_0), -math.sin(crane.BETA_0))
    spin = 6e3 * abs(complex(crane.X2) - crane.X4 * complex(math.cos(crane.BETA_0), -math.sin(crane.BETA_0))) ** 2 / 12
    given = {
        "s_2": f"{abs(back) / 2!r} m", "chi_2": f"{math.degrees(math.atan2(back.imag, back.real))!r} deg", "J_2": f"{spin!r} kg.m2",
        "J_1": f"{20e3 * crane.X1**2 / 12!r} kg.m2", "J_3": f"{4e3 * crane.X3**2 / 12!r} kg.m2", "c_v": "20 kN.m.s", "M_F": "0 kN.m",
        "l_min": f"{crane.SHORT} m", "l_max": f"{crane.LONG} m", "tol": "1e-9", "u_v": "0",
    }
    text = scene("hydraulic")
    for name, value in given.items():
        text, count = re.subn(rf'(?m)^{name}( *)= ".*?"', rf'{name}\1= "{value}"', text)
        assert count == 1, name
    more = "".join(f'{name} = "{value!r} {UNITS[name]}"\n' for part in parts for name, value in part.items())
    text = text.replace("[luffing.hydraulics]\n", f"[luffing.hydraulics]\n{more}").replace(" 1\"\n", "\"\n")
    (folder / "crane.toml").write_text(text, encoding="utf-8")
    lemnis("fmu", folder / "crane.toml", "--output", folder)
    return {standard: str(folder / f"Crane_hydraulic{end}") for standard, end in ENDS.items()}


def pumped(edge, port, pump):
    """Flow through an edge of the pump, and the pump's pressure: as much as it asks for, and no more than the pump has."""
    asked = edge * crane.root(crane.SUPPLY - port)
    if not pump or asked <= 0:
        return asked, crane.SUPPLY

    def behind(flow):
        """The edge's law solved for its fall: p = r √s where r is its root and s = √(p² + LAMINAR²) = (r² + √(r⁴ + 4 LAMINAR²))/2."""
        fall = flow / edge
        return port + fall * math.sqrt((fall**2 + math.hypot(fall**2, 2 * crane.LAMINAR)) / 2)

    flow = min(asked, pump["Q_Pmax"])
    if behind(flow) * flow > pump["P_Pmax"]:
        flow = brentq(lambda flow: behind(flow) * flow - pump["P_Pmax"], 0.0, flow, **FINEST)
    return flow, crane.SUPPLY if flow == asked else behind(flow)


def rates(y, command, load, torn, parts):
    """Of the oracle's cylinder with those parts; torn lines of bore and annulus."""
    theta, w, p1, p2, pa, pb, x, v = y
    inertia, slope, moment, length, arm = crane.mechanism(theta, load)
    edge = crane.VALVE * abs(x)
    tank = parts.get("tank", {"p_tank": 0.0})["p_tank"]
    if x >= 0:
        q1, q2 = pumped(edge, p1 - tank, parts.get("pump"))[0], -edge * crane.root(p2 - tank)
    else:
        q1, q2 = -edge * crane.root(p1 - tank), pumped(edge, p2 - tank, parts.get("pump"))[0]
    l1, l2 = crane.LINE * crane.root(p1 - pa), crane.LINE * crane.root(p2 - pb)
    r1, r2 = (max(0.0, p - crane.OPENING) * crane.SLOPE for p in (p1, p2))
    drawn = [0.0, 0.0]
    if valves := parts.get("anti_cavitation"):
        drawn = [valves["k_ac"] * max(0.0, tank - valves["p_ac"] - p) for p in (pa, pb)]
    if valves := parts.get("load_holding"):
        opens = lambda own, pilot: min(1.0, max(0.0, (own + valves["i_lh"] * pilot - valves["p_lh"]) / valves["dp_lh"]))
        l1 *= opens(pa, p2) if l1 < 0 else 1.0
        l2 *= opens(pb, p1) if l2 < 0 else 1.0
        relieves = crane.VALVE * max(0.0, valves["x_T"] - abs(x))
        r1, r2 = (r + tear * crane.LINE * crane.root(p) + relieves * crane.root(p - tank) for r, tear, p in zip((r1, r2), torn, (p1, p2)))
    leak = crane.LEAK * (pa - pb)
    speed = arm * w
    va, vb = crane.DEAD + crane.A_A * (length - crane.SHORT), crane.DEAD + crane.A_B * (crane.LONG - length)
    force = crane.A_A * pa - crane.A_B * pb
    return [w, (force * arm - crane.VISCOUS * w - moment - slope * w * w / 2) / inertia,
            crane.BETA / crane.PORT * (q1 - l1 - r1), crane.BETA / crane.PORT * (q2 - l2 - r2),
            crane.BETA / va * (l1 - leak - crane.A_A * speed + drawn[0]), crane.BETA / vb * (l2 + leak + crane.A_B * speed + drawn[1]),
            v, crane.W_N**2 * (command - x) - 2 * crane.ZETA * crane.W_N * v]


def reference(start, rows, stop, interval, parts):
    """States at whole intervals. Rows: time, command, load in N, torn lines; each holds until the next."""
    y, found = np.array(start), [np.array(start)]
    for row, following in zip(rows, [*rows[1:], (stop,)]):
        begin, end = row[0], following[0]
        times = np.arange(round(begin / interval) + 1, round(end / interval) + 1) * interval
        law = lambda t, y: rates(y, row[1], row[2] / crane.G, row[3:] or (0.0, 0.0), parts)
        part = solve_ivp(law, (begin, end), y, method="Radau", t_eval=np.append(times[:-1], end), rtol=1e-10, atol=1e-10 * SIZES, max_step=0.02)
        assert part.success
        y = part.y[:, -1]
        found += list(part.y.T)
    return np.array(found)


def simulated(path, kind, rows, stop, interval, output, **parameters):
    """As in the rows, from 65 deg."""
    names = ["u_v", "Q", *(["y_b1", "y_b2"] if len(rows[0]) == 5 else [])]
    held = [(end, *row[1:]) for row, (end, *_) in zip(rows, rows[1:])]
    both = [row for pair in zip(rows, held) for row in pair] + [rows[-1]]
    inputs = np.array(both, dtype=[(name, float) for name in ("time", *names)])
    start = {"theta_1": math.radians(65), "p_P": crane.SUPPLY, **parameters}
    return simulate_fmu(path, fmi_type=kind, start_values=start, stop_time=stop, output_interval=interval, relative_tolerance=1e-9,
                        input=inputs, output=output, record_events=False)


# The commands of the field test; then with lines torn open while the crane hangs on its valve; then full speed with a pump that
# is too small for it.
FIELD = [(0.0, 0.6, 160e3), (1.5, -1.0, 20e3), (2.5, 1.0, 400e3)]
TORN = [(0.0, 0.6, 160e3, 0.0, 0.0), (1.0, 0.0, 160e3, 0.0, 0.0), (1.5, 0.0, 160e3, 1.0, 0.0), (2.5, -0.5, 160e3, 1.0, 0.0)]
FAST = [(0.0, 1.0, 160e3), (1.2, 0.3, 400e3), (2.0, -1.0, 100e3)]
RUNS = {
    "anti_cavitation": (FIELD, 4.0, {"anti_cavitation": ANTI_CAVITATION}),
    "load_holding": (TORN, 3.0, {"load_holding": LOAD_HOLDING}),
    "pump": (FAST, 3.0, {"pump": PUMP}),
    "all": (FIELD, 4.0, {"anti_cavitation": ANTI_CAVITATION, "load_holding": LOAD_HOLDING, "pump": PUMP}),
    "tank": (TORN, 3.0, {"anti_cavitation": ANTI_CAVITATION, "load_holding": LOAD_HOLDING, "tank": TANK}),
}


@pytest.fixture(scope="module", params=list(RUNS))
def case(request, tmp_path_factory):
    rows, stop, parts = RUNS[request.param]
    fmus = built(tmp_path_factory.mktemp(request.param), *parts.values())
    start = simulated(fmus["FMI 3"], "CoSimulation", rows, 1e-6, 1e-6, output=STATES)
    wanted = reference([float(start[name][0]) for name in STATES], rows, stop, 0.01, parts)
    return request.param, fmus, wanted


@pytest.mark.parametrize("kind", ["CoSimulation", "ModelExchange"])
@pytest.mark.parametrize("standard", ENDS)
def test_a_run_against_an_independent_solver(case, standard, kind):
    name, fmus, wanted = case
    rows, stop, parts = RUNS[name]
    assert not validate_fmu(fmus[standard])
    result = simulated(fmus[standard], kind, rows, stop, 0.01, output=[*STATES, "cavitates"])
    found = np.column_stack([result[state] for state in STATES])
    assert found.shape == wanted.shape
    apart = np.abs(found - wanted) / SIZES
    print(f"\n  {name}, {standard}, {kind}: apart at most {dict(zip(STATES, apart.max(axis=0)))}")
    assert apart.max() < (1e-7 if kind == "CoSimulation" else 5e-6)


def least(result, names=("p_1", "p_2", "p_A", "p_B")):
    return min(float(result[name].min()) for name in names)


def test_no_pressure_falls_below_vacuum_in_the_field_test(tmp_path):
    """Without anti-cavitation valves the same commands tear the oil; with them the tank gives what the chambers lack."""
    rows = [(0.0, 0.6, 160e3), (1.5, -1.0, 20e3), (2.5, 1.0, 400e3), (4.5, 0.0, 160e3)]
    found = {}
    for name, parts in (("without", ()), ("with", (ANTI_CAVITATION,))):
        folder = tmp_path / name
        folder.mkdir()
        path = built(folder, *parts)["FMI 3"]
        outputs = ["p_1", "p_2", "p_A", "p_B", "cavitates", *(["Q_acA", "Q_acB"] if parts else [])]
        found[name] = simulated(path, "CoSimulation", rows, 6.0, 0.001, output=outputs)
    assert least(found["without"]) < -10 * BAR and found["without"]["cavitates"].any()
    assert -BAR < least(found["with"]) < -ANTI_CAVITATION["p_ac"] and not found["with"]["cavitates"].any()
    for flow, pressure in (("Q_acA", "p_A"), ("Q_acB", "p_B")):
        wanted = ANTI_CAVITATION["k_ac"] * np.maximum(0.0, -ANTI_CAVITATION["p_ac"] - found["with"][pressure])
        assert wanted.max() > 1e-4 and np.allclose(found["with"][flow], wanted, rtol=1e-12, atol=1e-18)


def test_the_load_is_held_with_a_broken_line(tmp_path):
    """Hanging on its valve the crane stays where it is, but for what leaks past the piston; with valves
    that any pressure opens it falls. The valve opens where the other port has (p_lh − p_A)/i_lh."""
    path = built(tmp_path, ANTI_CAVITATION, LOAD_HOLDING)["FMI 3"]
    rows = [(0.0, 0.6, 160e3, 0.0, 0.0), (1.0, 0.6, 160e3, 1.0, 1.0), (1.5, 0.0, 160e3, 1.0, 1.0)]
    held = simulated(path, "CoSimulation", rows, 12.0, 0.01, output=["theta_1", "p_1", "p_2", "p_A", "p_B", "y_lhA", "Q_b1"])
    late = held["time"] > 2.5
    assert np.abs(held["p_1"][late]).max() < 0.01 * BAR and held["p_A"][late].min() > 50 * BAR
    assert held["y_lhA"][late].max() == 0.0
    # What the pump gives leaves by the tear.
    assert held["Q_b1"].max() > 1e-3
    assert np.allclose(held["Q_b1"], np.where(held["time"] > 1.005, crane.LINE * crane.root(held["p_1"]), 0), atol=1e-12)
    # What leaks past the piston and what the oil gives way by is all that the bore's volume changes by.
    times, p_a, p_b = held["time"][late], held["p_A"][late], held["p_B"][late]
    first, last = (crane.mechanism(held["theta_1"][late][i])[3] for i in (0, -1))
    volume = crane.DEAD + crane.A_A * ((first + last) / 2 - crane.SHORT)
    leaks = crane.LEAK * np.trapezoid(p_a - p_b, times)
    changes = [crane.A_A * (last - first), volume / crane.BETA * (p_a[-1] - p_a[0]), leaks]
    assert abs(sum(changes)) < 1e-3 * max(map(abs, changes)) and abs(last - first) < 0.01
    loose = simulated(path, "CoSimulation", rows, 4.0, 0.01, ["theta_1"], p_lh=1e3, dp_lh=1e3)
    assert loose["theta_1"][-1] < held["theta_1"][-1] - 0.05

    lowered = simulated(path, "CoSimulation", [(0.0, 0.6, 160e3, 0.0, 0.0), (1.0, -0.1, 160e3, 0.0, 0.0)], 1.6, 1e-4,
                        output=["p_2", "p_A", "y_lhA"])
    after = lowered["time"] > 1.05
    opens = after & (lowered["y_lhA"] > 0)
    excess = lowered["p_A"] + LOAD_HOLDING["i_lh"] * lowered["p_2"] - LOAD_HOLDING["p_lh"]
    assert opens.any() and np.allclose(lowered["y_lhA"], np.clip(excess / LOAD_HOLDING["dp_lh"], 0, 1), atol=1e-12)


def test_the_pump_keeps_its_limits(tmp_path):
    """Flow through the pump's edge and its pressure, by the outputs alone: each limit governs for a time, neither is exceeded."""
    path = built(tmp_path, ANTI_CAVITATION, PUMP)["FMI 3"]
    result = simulated(path, "CoSimulation", FAST, 3.0, 0.001, output=["p_1", "p_2", "x_v", "p_s"])
    fed = np.where(result["x_v"] >= 0, result["p_1"], result["p_2"])
    drop = result["p_s"] - fed
    flow = crane.VALVE * np.abs(result["x_v"]) * drop / (drop**2 + crane.LAMINAR**2) ** 0.25
    power = flow * result["p_s"]
    assert flow.max() < PUMP["Q_Pmax"] * (1 + 1e-9) and power.max() < PUMP["P_Pmax"] * (1 + 1e-9)
    by_flow, by_power = (np.isclose(found, most, rtol=1e-9) for found, most in ((flow, PUMP["Q_Pmax"]), (power, PUMP["P_Pmax"])))
    assert by_flow.sum() > 50 and by_power.sum() > 50
    assert np.all(by_flow | by_power | (np.abs(result["p_s"] - crane.SUPPLY) < 1))


def test_inputs_and_results(tmp_path):
    """What is told over time is an output; a part that the scene has not has no variable."""
    lemnis("fmu", SCENE, "--output", tmp_path)
    variables = {variable.name: variable for variable in read_model_description(str(tmp_path / "LuffingCylinder.fmu")).modelVariables}
    outputs = ("Q_acA", "Q_acB", "y_lhA", "y_lhB", "Q_b1", "Q_b2", "p_s", "y_b1", "u_v")
    assert {variables[name].causality for name in outputs} == {"output"} and variables["y_b2"].causality == "input"
    assert {variables[name].causality for name in UNITS} == {"parameter"}
    folder = tmp_path / "without"
    folder.mkdir()
    names = {variable.name for variable in read_model_description(built(folder)["FMI 3"]).modelVariables}
    assert "p_A" in names and not names & {*UNITS, *outputs[:-1], "y_b2", "z.suction_A", "z.hold_A", "z.flow"}


def test_the_ready_scene_holds_its_load_when_the_line_tears(tmp_path):
    """It luffs in and abruptly out without cavitating, stays when the line of the bore tears, and is let down on its valve, never
    faster than the drive bears it."""
    lemnis("fmu", SCENE, "--output", tmp_path)
    for end in ENDS.values():
        result = simulate_fmu(str(tmp_path / f"LuffingCylinder{end}"), stop_time=48.0, output_interval=0.01,
                              output=["theta_1", "y_b1", "cavitates", "F_d", "p_s"])
        at = lambda time: float(np.interp(time, result["time"], result["theta_1"]))
        assert not result["cavitates"].any() and result["p_s"].min() < 0.5 * crane.SUPPLY
        assert at(20) > at(0) + 0.3 and at(24) < at(20) - 0.1
        # The oil swings on in its chambers.
        assert result["y_b1"][-1] == 1 and abs(at(36) - at(29)) < math.radians(0.1) and at(42) < at(36) - 0.05
        assert result["F_d"][result["time"] > 36].min() > 0


@pytest.mark.parametrize("language", ["en", "zh", "bg"])
def test_the_book_tells_of_it(language, tmp_path):
    lemnis("book", SCENE, "--language", language, "--format", "typ", "--output", tmp_path)
    book = (tmp_path / "LuffingCylinder.typ").read_text(encoding="utf-8")
    known = words(language)["use"]
    assert all(known[word] in book for word in ("anti_cavitation", "pump_limits"))
    for symbol in ('p_"ac"', 'y_("lh" A)', 'Q_("b" 1)', "Q_(T 1)", "p_s"):
        assert symbol in book, symbol
