"""A load put down and picked up again through FMPy, both standards and both interfaces: against an independent code, closed
forms, an account of energy from outside, and the book."""

import math
import re

import numpy as np
import pytest
from fmpy import read_model_description, simulate_fmu
from fmpy.validation import validate_fmu
from scipy.integrate import solve_ivp

from conftest import ROOT, lemnis, typst, words
from test_fmpy import Slave

ENDS = {"FMI 2": ".fmi2.fmu", "FMI 3": ".fmu"}
SCENE = ROOT / "models/scenes/load_on_ground.toml"
G, STIFFNESS, DAMPING, GAIN, GROUND, LENGTH = 9.81, 2e6, 20e3, 0.4, -13.0, 25.0
HOIST = re.compile(r"v_h = \{.*?\] \}\n", re.DOTALL)
OUTPUTS = ["l_R", "v_R", "s_Q", "v_Q", "phi_R", "omega_R", "S_R", "N_G", "h_G", "W_blow", "A.y"]


def fmus(folder, text):
    folder.mkdir(exist_ok=True)
    scene = folder / "scene.toml"
    scene.write_text(text, encoding="utf-8")
    lemnis("fmu", scene, "--output", folder)
    name = re.search(r'^name *= "(.*)"', text, re.M)[1]
    return {standard: str(folder / f"{name}{end}") for standard, end in ENDS.items()}


def scene(**replaced):
    """Its hoist commanded from outside."""
    text = HOIST.sub('v_h = "0 m/s"\n', SCENE.read_text(encoding="utf-8"))
    for old, new in replaced.items():
        assert old in text, old
        text = text.replace(old, new)
    return text


@pytest.fixture(scope="module")
def commanded(tmp_path_factory):
    text = scene(**{'l_R = "25 m" ': 'phi_R = "0.03 rad"\nl_R = "25 m" ', 'M_F  = "20 kN.m"': 'step = "1 ms"\nM_F  = "20 kN.m"'})
    return fmus(tmp_path_factory.mktemp("commanded"), text)


# Lowered swinging, put down, loaded and unloaded on the ground, picked up, lifted, stopped.
SPEEDS = [(0.0, 0.0), (0.5, 0.4), (6.5, 0.0), (10.0, -0.3), (16.0, 0.0)]
LOADS = [(0.0, 100e3), (7.5, 160e3), (8.5, 60e3)]
END = 18.0


def at(told, time):
    return next(value for start, value in reversed(told) if time >= start)


def signals(**told):
    """Inputs that change at once, for FMPy."""
    times = sorted({start for course in told.values() for start, _ in course} - {0.0})
    rows = [(0.0, *(at(course, 0.0) for course in told.values()))]
    for time in times:
        rows += [(time, *(at(course, time - 1e-9) for course in told.values())), (time, *(at(course, time) for course in told.values()))]
    rows.append((100.0, *(at(course, 100.0) for course in told.values())))
    return np.array(rows, dtype=[("time", float), *((name, float) for name in told)])


def independent(head, times):
    """The load in x and y below a head that stands, in Cartesian coordinates, on a rope that pulls by stiffness and damping;
    the ground takes its speed and lets it go where the rope pulls up more than it weighs. Returns rows of the rope's length and
    angle, the load's distance, the forces of rope and ground, and what blows took."""

    def rope(t, y, mass):
        x, up, u, v, length, rate = y
        distance = math.hypot(x, head - up)
        speed = (x * u - (head - up) * v) / distance
        spring = STIFFNESS * (distance - length)
        return spring, spring + DAMPING * (speed - rate), distance

    def rates(t, y, mass, stands, pulls, ramp):
        x, up, u, v, length, rate = y
        force, distance = (rope(t, y, mass)[1] if pulls else 0.0), math.hypot(x, head - up)
        if stands:
            return [0.0, 0.0, 0.0, 0.0, rate, ramp]
        return [u, v, -force * x / distance / mass, force * (head - up) / distance / mass - G, rate, ramp]

    mass, stands, pulls, blown, swing = at(LOADS, 0.0) / G, False, True, 0.0, 0.03
    # Stretched by what of the load's weight lies along the rope.
    stretched = LENGTH + mass * G / STIFFNESS * math.cos(swing)
    y = np.array([stretched * math.sin(swing), head - stretched * math.cos(swing), 0.0, 0.0, LENGTH, 0.0])
    rows, now = [], 0.0
    changes = sorted({start for course in (SPEEDS, LOADS) for start, _ in course} | set(times) | {END})
    for end in changes:
        while now < end:
            command, mass = at(SPEEDS, now), at(LOADS, now) / G
            ramp = math.copysign(GAIN, command - y[5]) if abs(command - y[5]) > 1e-13 else 0.0
            arguments = (mass, stands, pulls, ramp)

            def crossing(value):
                def event(t, y, *_):
                    return value(t, y)
                event.terminal, event.direction = True, -1
                return event

            def upright(y):
                return (head - y[1]) / math.hypot(y[0], head - y[1])

            events = [
                crossing(lambda t, y: y[1] - GROUND if not stands else mass * G - (rope(t, y, mass)[1] if pulls else 0.0) * upright(y)),
                crossing(lambda t, y: rope(t, y, mass)[1] if pulls else -min(rope(t, y, mass)[0], rope(t, y, mass)[1])),
                crossing(lambda t, y: (command - y[5]) * ramp if ramp else 1.0),
            ]
            solved = solve_ivp(rates, (now, end), y, method="DOP853", rtol=1e-12, atol=1e-13, events=events, args=arguments)
            now, y = solved.t[-1], solved.y[:, -1]
            if solved.status != 1:
                break
            touched, slackened, reached = (len(found) > 0 for found in solved.t_events)
            if touched and not stands:
                blown += 0.5 * mass * (y[2] ** 2 + y[3] ** 2)
                y[1:4], stands = [GROUND, 0.0, 0.0], True
            elif touched:
                stands = False
            if slackened:
                pulls = not pulls
            if reached:
                y[5] = command
            spring, force, _ = rope(now, y, mass)
            if pulls and force < 0.0:
                pulls = False
        if any(abs(end - time) < 1e-12 for time in times):
            mass = at(LOADS, end) / G
            force, distance = (rope(end, y, mass)[1] if pulls else 0.0), math.hypot(y[0], head - y[1])
            ground = mass * G - force * (head - y[1]) / distance if stands else 0.0
            rows.append([y[4], distance, math.atan2(y[0], head - y[1]), force, ground, y[1] - GROUND, blown])
    return np.array(rows)


@pytest.mark.parametrize("kind", ["CoSimulation", "ModelExchange"])
@pytest.mark.parametrize("standard", ENDS)
def test_a_cycle_against_an_independent_code(commanded, standard, kind):
    assert not validate_fmu(commanded[standard])
    run = simulate_fmu(commanded[standard], fmi_type=kind, stop_time=END, output_interval=0.1, step_size=1e-3,
                       relative_tolerance=1e-10, input=signals(v_h=SPEEDS, Q=LOADS), output=OUTPUTS, record_events=False)
    told = {start for course in (SPEEDS, LOADS) for start, _ in course}
    # At a change of an input FMPy's rows are those of before or after it.
    plain = np.array([all(abs(time - start) > 1e-6 for start in told) and time > 0.0 for time in run["time"]])
    run = run[plain]
    times = np.round(run["time"], 9)
    wanted = independent(run["A.y"][0], list(times))
    found = np.column_stack([run[name] for name in ("l_R", "s_Q", "phi_R", "S_R", "N_G", "h_G", "W_blow")])
    scale = np.array([1.0, 1.0, 1.0, 1e5, 1e5, 1.0, 1e3])
    allowed = 1e-8 if kind == "CoSimulation" else 1e-6
    apart = np.abs(found - wanted) / scale
    print(standard, kind, apart.max(axis=0))
    assert apart.max() < allowed, (apart.max(axis=0), times[apart.max(axis=1).argmax()])
    stands = run["N_G"] > 0.0
    assert stands.sum() > 40 and (run["S_R"][stands] == 0.0).any() and run["h_G"][-1] > 0.2
    for load in (100e3, 160e3, 60e3):
        assert np.isclose(run["N_G"], load).any(), load


@pytest.mark.parametrize("kind", ["CoSimulation", "ModelExchange"])
@pytest.mark.parametrize("standard", ENDS)
def test_energy_from_outside(standard, kind, tmp_path):
    """What the hoist gives is what the load and the rope have of it, and what the blow took, to 1e-6 of what is exchanged."""
    text = scene(**{'d_R = "20 kN.s/m"\n': ""})
    run = simulate_fmu(fmus(tmp_path, text)[standard], fmi_type=kind, stop_time=END, output_interval=5e-4, step_size=5e-4,
                       relative_tolerance=1e-10, input=signals(v_h=SPEEDS), output=OUTPUTS)
    mass = 100e3 / G
    power = -run["S_R"] * run["v_R"]
    work = np.concatenate([[0.0], np.cumsum(0.5 * (power[1:] + power[:-1]) * np.diff(run["time"]))])
    height = run["A.y"] - run["s_Q"] * np.cos(run["phi_R"])
    energy = 0.5 * mass * run["v_Q"] ** 2 + mass * G * height + run["S_R"] ** 2 / (2 * STIFFNESS)
    left = work - (energy - energy[0]) - run["W_blow"]
    exchanged = np.abs(power[1:] * np.diff(run["time"])).sum()
    print(standard, kind, np.abs(left).max() / exchanged, run["W_blow"][-1])
    assert np.abs(left).max() < 1e-6 * exchanged, (np.abs(left).max(), exchanged)
    touch = np.argmax(run["N_G"] > 0.0)
    before = run["v_Q"][: touch + 1][run["v_Q"][: touch + 1] != 0.0][-1]
    assert run["W_blow"][-1] == pytest.approx(0.5 * mass * before**2, rel=3e-3)


def test_any_communication_step_has_the_same_events(tmp_path):
    """What the scene tells: the same to the last bit."""
    path = fmus(tmp_path, SCENE.read_text(encoding="utf-8"))["FMI 3"]
    ends = []
    for step in (0.5, 0.04, 0.0125):
        run = simulate_fmu(path, fmi_type="CoSimulation", stop_time=24.0, output_interval=step, output=OUTPUTS, record_events=False)
        ends.append([run[name][-1] for name in OUTPUTS])
    assert ends[0] == ends[1] == ends[2]
    assert ends[0][OUTPUTS.index("W_blow")] > 500.0 and ends[0][OUTPUTS.index("h_G")] > 0.5


def test_lifted_without_a_jump_where_the_rope_pulls_as_much_as_it_weighs(commanded):
    run = simulate_fmu(commanded["FMI 3"], stop_time=END, output_interval=1e-3, step_size=1e-3, input=signals(v_h=SPEEDS),
                       output=OUTPUTS, fmi_type="CoSimulation")
    stands = run["N_G"] > 0.0
    last = np.nonzero(stands)[0][-1]
    force, up = run["S_R"], np.cos(run["phi_R"])
    # The rope is stretched by 0.3 m/s.
    assert force[last] * up[last] == pytest.approx(100e3, abs=STIFFNESS * 0.3 * 1.1e-3)
    assert np.abs(np.diff(force[last - 50 : last + 50])).max() < STIFFNESS * 0.3 * 1.1e-3
    assert np.allclose(run["N_G"][stands], (100e3 - force * up)[stands], atol=1e-6)


SPACE = """
[luffing.slewing]
J_sl  = "2500000 kg.m2"
c_sl  = "3000 kN.m.s"
M_Bsl = "300 kN.m"
"""


@pytest.mark.parametrize("slews", [False, True])
def test_in_model_exchange_as_in_co_simulation_while_the_crane_moves(slews, tmp_path):
    """The boom luffs, or the crane slews and luffs, over a load that stands, and drags it up."""
    text = scene(**{'M_S  = "2000 kN.m" ': 'M_S = "0 kN.m"\nM_A = "0 kN.m" '})
    if slews:
        text = text.replace("[luffing.limits]", SPACE + "[luffing.limits]")
    path = fmus(tmp_path, text)["FMI 3"]
    assert not validate_fmu(path)
    brakes = [(0.0, 2e6), (6.5, 0.0)]
    told = {"v_h": SPEEDS, "M_S": brakes, "M_A": [(0.0, 0.0), (6.5, 1.4e6)]}
    place = ["s_Q", "phi_R"]
    if slews:
        told |= {"M_Bsl": [(0.0, 3e5), (6.5, 0.0)], "M_sl": [(0.0, 0.0), (6.5, 3e5)]}
        place = ["x_Q", "y_Q", "z_Q"]
    names = [*place, "S_R", "N_G", "h_G", "W_blow", "A.x", "A.y", "theta_1"]
    runs = [simulate_fmu(path, fmi_type=kind, stop_time=15.0, output_interval=0.1, step_size=1e-3, relative_tolerance=1e-10,
                         input=signals(**told), output=names, record_events=False) for kind in ("CoSimulation", "ModelExchange")]
    steps = [start for course in told.values() for start, _ in course]
    inside, outside = ([row for row in run if all(abs(row["time"] - start) > 1e-6 for start in steps)] for run in runs)
    assert len(inside) == len(outside) > 100
    scale = [*([1.0] * len(place)), 1e5, 1e5, 1.0, 1e3, 1.0, 1.0, 1.0]
    apart = np.array([[abs(a[name] - b[name]) / size for name, size in zip(names, scale)] for a, b in zip(inside, outside)])
    print(slews, apart.max(axis=0))
    assert apart.max() < 1e-4, apart.max(axis=0)
    stands = [row for row in inside if row["N_G"] > 0.0]
    heads = [row["A.x"] for row in stands]
    assert max(heads) - min(heads) > 0.5 and inside[-1]["h_G"] > 0.1, "dragged at, and lifted"
    if not slews:
        # It stays where it was put down.
        x = [row["A.x"] + row["s_Q"] * math.sin(row["phi_R"]) for row in stands]
        assert max(x) - min(x) < 1e-6


@pytest.mark.parametrize("kind", ["CoSimulation", "ModelExchange"])
def test_an_empty_hook_lies_until_its_rope_is_taut(commanded, kind):
    """Unloaded on the ground and picked up, the hook hangs at its rope's end without a force; loaded there, on its stretch."""
    loads = [(0.0, 100e3), (8.0, 0.0), (15.0, 60e3)]
    run = simulate_fmu(commanded["FMI 3"], fmi_type=kind, stop_time=END, output_interval=0.25, output=OUTPUTS, record_events=False,
                       input=signals(v_h=SPEEDS, Q=loads))
    lies, hangs = (run["time"] > 8.1) & (run["time"] < 11.5), (run["time"] > 12.5) & (run["time"] < 14.9)
    assert np.all(run["N_G"][lies | hangs] == 0.0) and np.all(run["S_R"][lies | hangs] == 0.0)
    assert np.all(run["h_G"][lies] == 0.0) and np.allclose(run["s_Q"][hangs], run["l_R"][hangs], atol=1e-6)
    assert run["S_R"][-1] == pytest.approx(60e3, rel=0.1)


OIL = """[luffing.hoisting]
l_R = "25 m"
c_R = "2000 kN/m"
d_R = "20 kN.s/m"
a_h = "0.4 m/s2"
v_h = { between = "steps", over = [["0 s", "0.3 m/s"], ["5 s", "0 m/s"], ["11 s", "-0.3 m/s"], ["20 s", "0 m/s"]] }

[luffing.ground]
y_G = "GROUND m"

"""


@pytest.mark.parametrize("standard", ENDS)
def test_derivatives_in_closed_form_and_a_saved_state(commanded, standard, tmp_path):
    """While the rope takes its part of a load that stands: N_G = Q - S_R cos phi_R, S_R = c_R (s_Q - l_R) + d_R (v_Q - v_R);
    what was saved there goes on as it did."""
    slave = Slave(commanded[standard], str(tmp_path / "fmu"))
    time = 0.0

    def step():
        nonlocal time
        slave.write("v_h", at(SPEEDS, time + 1e-9))
        slave.fmu.doStep(currentCommunicationPoint=time, communicationStepSize=0.05)
        time += 0.05

    while not (time > 10.0 and slave.read("S_R") > 20e3):
        step()
    force, angle, ground = (slave.read(name) for name in ("S_R", "phi_R", "N_G"))
    cosine, sine = math.cos(angle), math.sin(angle)
    assert 20e3 < force < 90e3 and ground == pytest.approx(100e3 - force * cosine, rel=1e-12)
    by = {"Q": 1.0, "s_Q": -STIFFNESS * cosine, "l_R": STIFFNESS * cosine, "v_Q": -DAMPING * cosine, "v_R": DAMPING * cosine,
          "phi_R": force * sine, "omega_R": 0.0}
    unknowns = [slave.references[name] for name in ("N_G", "S_R", "h_G", "der(v_Q)", "der(omega_R)")]
    for known, wanted in by.items():
        found = slave.fmu.getDirectionalDerivative(unknowns, [slave.references[known]], [1.0])
        assert found[0] == pytest.approx(wanted, rel=1e-12, abs=1e-6), known
        if known not in ("Q", "phi_R"):
            assert found[1] * cosine == pytest.approx(-wanted, rel=1e-12), known
        # It stands, whatever the rope pulls.
        assert np.allclose(found[2:], 0.0, atol=1e-9), (known, found)
    save, load = ("getFMUState", "setFMUState") if standard == "FMI 3" else ("getFMUstate", "setFMUstate")
    saved, begun = getattr(slave.fmu, save)(), time
    ends = []
    for _ in range(2):
        getattr(slave.fmu, load)(saved)
        time = begun
        for _ in range(20):
            step()
        ends.append([slave.read(name) for name in OUTPUTS])
    assert ends[0] == ends[1] and ends[0][OUTPUTS.index("h_G")] > 0.05, "lifted"


def test_beside_oil(tmp_path):
    """A cylinder luffs while the load is put down, stands and is picked up: as in Model Exchange; it stays where it stands."""
    text = (ROOT / "models/scenes/luffing_cylinder.toml").read_text(encoding="utf-8")
    start = simulate_fmu(fmus(tmp_path / "start", text)["FMI 3"], stop_time=0.01, output=["A.y"])["A.y"][0]
    text = re.sub(r'l_R   = "15 m".*\n', "", text).replace("[luffing.limits]", OIL.replace("GROUND", f"{start - 26.0}") + "[luffing.limits]")
    path = fmus(tmp_path / "oil", text)["FMI 3"]
    names = ["s_Q", "phi_R", "S_R", "N_G", "h_G", "W_blow", "A.x", "A.y", "theta_1", "l_R"]
    inside, outside = (simulate_fmu(path, fmi_type=kind, stop_time=20.0, output_interval=0.1, relative_tolerance=1e-8, output=names,
                                    record_events=False) for kind in ("CoSimulation", "ModelExchange"))
    scale = np.array([1.0, 1.0, 1e5, 1e5, 1.0, 1e3, 1.0, 1.0, 1.0, 1.0])
    apart = np.array([np.abs(inside[name] - np.interp(inside["time"], outside["time"], outside[name])).max() for name in names]) / scale
    stands = inside[inside["N_G"] > 0.0]
    x = stands["A.x"] + stands["s_Q"] * np.sin(stands["phi_R"])
    print(apart, len(stands), np.ptp(x), np.ptp(stands["A.x"]), inside["h_G"][-1], inside["W_blow"][-1])
    assert len(stands) > 20 and np.ptp(x) < 1e-4 and np.ptp(stands["A.x"]) > 0.1 and inside["h_G"][-1] > 0.1
    assert apart.max() < 1e-4, apart


def test_inputs_and_results(commanded):
    variables = {variable.name: variable for variable in read_model_description(commanded["FMI 3"]).modelVariables}
    assert {name: variables[name].causality for name in ("y_G", "N_G", "h_G", "W_blow", "Q")} == {
        "y_G": "parameter", "N_G": "output", "h_G": "output", "W_blow": "output", "Q": "input"}


def test_a_crane_without_ground_has_nothing_of_it(tmp_path):
    lemnis("fmu", ROOT / "models/scenes/portal_004_motion.toml", "--output", tmp_path)
    names = {variable.name for variable in read_model_description(str(tmp_path / "PortalCraneMotion.fmu")).modelVariables}
    assert not names & {"y_G", "N_G", "h_G", "z.ground"}


def test_a_rope_longer_than_the_way_to_the_ground_begins_slack(tmp_path):
    run = simulate_fmu(fmus(tmp_path, scene(**{'l_R = "25 m" ': 'l_R = "28 m" '}))["FMI 3"], stop_time=0.2, output=OUTPUTS)
    assert run["S_R"].max() == run["h_G"].max() == run["W_blow"].max() == 0.0 and np.all(run["N_G"] == 100e3)


@pytest.mark.parametrize("language", ["en", "zh", "bg"])
def test_the_book_tells_of_it(language, tmp_path):
    lemnis("book", SCENE, "--language", language, "--format", "typ", "--output", tmp_path)
    book = typst(tmp_path / "LoadOnGround.typ")
    known = words(language)
    for group, word in (("input", "ground"), ("section", "motion_ground"), ("purpose", "motion_ground")):
        assert known[group][word] in book, (group, word)
    assert known["section"]["motion_standing"] in book and known["purpose"]["motion_standing"] in book
    # Its rope pulls with half of 100 kN.
    assert re.search(r'N_G &= .*\n?.*50', book) and "N_G &=" in book
    for symbol in ("h_G", "N_G", "y_G"):
        assert symbol in book, symbol
