"""A crane on a column that an engine slews: the coupling's inertia and limit in motion follow from the drive, by hand; the motion is
that of slewing alone with these numbers, and a slip in closed form; the engine's torque curve in the book."""

import math
import re

import numpy as np
import pytest
from fmpy import read_model_description, simulate_fmu
from fmpy.validation import validate_fmu
from scipy.optimize import minimize_scalar

from conftest import ROOT, lemnis, typst, words
from test_slewing_column import AREAS, G, SLOPE, UPPER, by_hand
from test_slewing_coupling import Pieces

ENDS = {"FMI 2": ".fmi2.fmu", "FMI 3": ".fmu"}
KINDS = ("CoSimulation", "ModelExchange")
SCENE = ROOT / "models/scenes/slewing_engine.toml"
RATIO, EFFICIENCY, SHAFT, OWN, REACH, LOAD = 1100.0, 0.8, 0.4, 3e5, 20.0, 5e3 * G
# Load, pressure and speed (1/min) of the cases, and in front of the axis the wind areas.
CASES, PLACES = [(1.0, 250.0, 1.5), (1.25, 40.0, 0.8), (0.0, 800.0, 0.0)], [-0.3, 7.0]
CURVE = [(700.0, 140.0), (1100.0, 172.0), (1400.0, 178.0), (1800.0, 159.0), (2000.0, 120.0)]
IDLE, DELAYED_BRAKE, K_LIM = 800.0, 120.0, 1.1
J_0 = OWN + sum(g / G * r * r for g, r, _ in UPPER)
J_D = SHAFT * RATIO**2
NAMES = ["psi_sl", "omega_sl", "omega_d", "psi_slip", "W_slip"]
MOTION = """[slewing.motion]
from = "0 deg"
to = "360 deg"
step = "15 deg"
speed = "9 deg/s"
"""


def torque(psi, case):
    """What the coupling transmits in start and stop, at a slewing angle."""
    factor, pressure, speed = CASES[case]
    load = factor * LOAD
    outer = -math.sin(SLOPE) * math.sin(psi) * (sum(g * r for g, r, _ in UPPER) + load * REACH) \
        + pressure * math.cos(psi) * sum(a * r for (a, _), r in zip(AREAS, PLACES))
    friction = float(by_hand(psi, REACH, LOAD, case)[3])
    gear, inertia = RATIO * EFFICIENCY, J_0 + load / G * REACH**2
    against = (friction + abs(outer)) / gear
    behind = friction - abs(outer)
    behind = behind / gear if behind > 0 else behind * EFFICIENCY / RATIO
    stop = DELAYED_BRAKE - SHAFT * (DELAYED_BRAKE + behind) / (SHAFT + inertia * EFFICIENCY / RATIO**2)
    if speed == 0.0:
        return max(against, stop)
    rest = inertia / (RATIO**2 * EFFICIENCY)
    turns, points = speed * RATIO, np.array(CURVE)
    ways = [n for n in points[:, 0] if IDLE < n < turns] + [IDLE, turns]
    peak, idle = (max(np.interp(n, *points.T) for n in of) for of in (ways, [IDLE]))
    rate = max((peak - against) / (SHAFT + rest), (idle - against) / rest)
    return max(against + rest * rate, stop)


def limit():
    """The greatest of all cases over a turn, at the slewing axis."""
    most = 0.0
    for case in range(3):
        angles = np.linspace(0.0, 2 * np.pi, 721)
        best = angles[np.argmax([torque(psi, case) for psi in angles])]
        found = minimize_scalar(lambda psi: -torque(psi, case), bounds=(best - 0.01, best + 0.01), method="bounded", options={"xatol": 1e-10})
        most = max(most, -found.fun)
    return float(K_LIM * most * RATIO)


M_LIM = limit()


def built(folder, text, name):
    (folder / f"{name}.toml").write_text(text, encoding="utf-8")
    lemnis("fmu", folder / f"{name}.toml", "--output", folder)
    return {standard: str(folder / f"{name}{end}") for standard, end in ENDS.items()}


@pytest.fixture(scope="module")
def fmus(tmp_path_factory):
    """The ready scene, and slewing alone with the same numbers by hand."""
    folder, text = tmp_path_factory.mktemp("engine"), SCENE.read_text("utf-8")
    told = text[text.index("[slewing]\n") + len("[slewing]\n"):]
    weight, ahead = sum(g for g, *_ in UPPER), sum(g * r for g, r, _ in UPPER)
    alone = f"""name = "ByHand"
title = "By hand"
[slewing]
J_sl = "{J_0!r} kg.m2"
R = {{ input = "{REACH} m" }}
Q = {{ input = "{LOAD!r} N" }}
{told}
[slewing.coupling]
J_d = "{J_D!r} kg.m2"
M_lim = "{M_LIM!r} N.m"
[slewing.slope]
gamma_s = "0.3 deg"
G_u = "{weight!r} N"
r_u = "{ahead / weight!r} m"
{MOTION}"""
    return {"drive": built(folder, text, "SlewingEngine"), "hand": built(folder, alone, "ByHand")}


@pytest.mark.parametrize("standard", ENDS)
def test_inertia_and_limit_are_those_of_the_drive(fmus, standard):
    assert not validate_fmu(fmus["drive"][standard])
    variables = {variable.name: variable for variable in read_model_description(fmus["drive"][standard]).modelVariables}
    for name, wanted in [("J_d", J_D), ("M_lim", M_LIM), ("J_sl", J_0), ("R", REACH), ("Q", LOAD)]:
        assert float(variables[name].start) == pytest.approx(wanted, rel=1e-12), name
    assert [variables[name].causality for name in ("J_d", "M_lim", "R", "Q")] == ["parameter", "parameter", "input", "input"]


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("standard", ENDS)
def test_the_motion_is_that_of_slewing_alone(fmus, standard, kind):
    one, other = (simulate_fmu(fmus[of][standard], fmi_type=kind, stop_time=28.0, output_interval=0.25, relative_tolerance=1e-10, output=NAMES,
                               record_events=False) for of in ("drive", "hand"))
    assert one["psi_slip"][-1] > 0.1 and one["omega_sl"].max() > 0.1 and one["omega_sl"][-1] == 0.0
    for name in NAMES:
        assert np.abs(one[name] - other[name]).max() <= 1e-10 * np.abs(other[name]).max(), name


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("standard", ENDS)
def test_a_slip_in_closed_form(tmp_path, standard, kind):
    """On level ground without viscous friction both sides have constant accelerations until they meet."""
    text = SCENE.read_text("utf-8")
    slope = text[text.index("[supports.slope]"): text.index("[[supports.areas]]")]
    level = text.replace(slope, "").replace('c_sl  = "120 kN.m.s"\n', "").replace('    ["18 s", "0 kN.m"],\n    ["28 s", "0 kN.m"],\n', "")
    level = level[: level.index("M_Bsl = {")]
    path = built(tmp_path, level, "SlewingEngine")[standard]
    start = {variable.name: variable.start for variable in read_model_description(path).modelVariables}
    most, dry, inertia = float(start["M_lim"]), 30e3, J_0 + LOAD / G * REACH**2
    # Without the slope the greatest start resists less.
    assert 0.99 * M_LIM < most < M_LIM
    run = Pieces()
    outer = (most - dry) / inertia
    run.then(0.0, (outer, (260e3 - most) / J_D), most)
    _, omega, omega_d, _ = run.then(2.0, (outer, (100e3 - most) / J_D), most)
    meet = 2.0 + (omega_d - omega) / (outer + (most - 100e3) / J_D)
    both = (100e3 - dry) / (inertia + J_D)
    run.then(meet, (both, both), 0.0)
    assert meet < 8.0
    found = simulate_fmu(path, fmi_type=kind, stop_time=8.0, output_interval=0.25, relative_tolerance=1e-12,
                         output=["psi_sl", "omega_sl", "omega_d", "W_slip"], record_events=False)
    expected = np.array([run.state(t) for t in found["time"]])
    apart = np.abs(np.array([[row[name] for name in ("psi_sl", "omega_sl", "omega_d", "W_slip")] for row in found]) - expected)
    assert (apart.max(axis=0) <= 1e-9 * np.abs(expected).max(axis=0)).all(), apart.max(axis=0)


@pytest.mark.parametrize("language", ["en", "zh", "bg"])
def test_the_book_has_the_engines_curve_and_the_coupling_in_motion(language, tmp_path):
    lemnis("book", SCENE, "--language", language, "--format", "typ", "--output", tmp_path)
    book = typst(tmp_path / "SlewingEngine.typ")
    known = words(language)
    for said in (known["curve"]["start_torque"], known["assumption"]["turning_moving"].split("$")[0], known["use"]["turning_moving"]):
        assert said in book, said
    # Both follow from the drive by formulas of their own.
    assert re.search(r'\bJ_"d" &=', book) and re.search(r'\bM_\("lim" i\) &=', book)
