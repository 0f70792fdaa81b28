"""A crane on a column that an engine slews: the coupling's inertia and limit in motion follow from the drive and the friction from the
column, by hand; the motion is that of slewing alone with these numbers; stick, start, stop and slip in closed form; a ring's friction;
the engine's torque curve and the equations of motion in the book."""

import math
import re

import numpy as np
import pytest
from fmpy import read_model_description, simulate_fmu
from fmpy.validation import validate_fmu
from scipy.optimize import brentq, minimize_scalar

import test_slewing_column
import test_slewing_ring
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


def torque(psi, case, rope):
    """What the coupling transmits in start and stop, at a slewing angle, the load swung out on a rope (m) in steady slewing."""
    factor, pressure, speed = CASES[case]
    load, omega = factor * LOAD, speed * 2 * math.pi / 60
    theta = brentq(lambda theta: G * math.tan(theta) - omega**2 * (REACH + rope * math.sin(theta)), 0.0, 1.0, xtol=1e-15)
    out = REACH + rope * math.sin(theta)
    outer = -math.sin(SLOPE) * math.sin(psi) * (sum(g * r for g, r, _ in UPPER) + load * REACH) \
        + pressure * math.cos(psi) * sum(a * r for (a, _), r in zip(AREAS, PLACES))
    friction = float(by_hand(psi, REACH, LOAD, case)[3])
    gear, inertia = RATIO * EFFICIENCY, J_0 + load / G * out**2
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


def over_a_turn(of):
    """The greatest of a function of the slewing angle."""
    angles = np.linspace(0.0, 2 * np.pi, 721)
    best = angles[np.argmax([of(psi) for psi in angles])]
    found = minimize_scalar(lambda psi: -of(psi), bounds=(best - 0.01, best + 0.01), method="bounded", options={"xatol": 1e-10})
    return float(-found.fun)


def friction():
    """Of the column in the load case of heating, the first."""
    return over_a_turn(lambda psi: float(by_hand(psi, REACH, LOAD, 0)[3]))


def limit(rope=0.0):
    """Of the coupling in all cases, at the slewing axis."""
    return K_LIM * RATIO * max(over_a_turn(lambda psi: torque(psi, case, rope)) for case in range(3))


M_LIM, M_F = limit(), friction()
# Wind area of all that slews, and its centre in front of the axis.
AREA = sum(area for area, _ in AREAS)
AHEAD = sum(area * place for (area, _), place in zip(AREAS, PLACES)) / AREA
EXPOSED = f'A_ws = "{AREA!r} m2"\nr_ws = "{AHEAD!r} m"\n'


def built(folder, text, name):
    (folder / f"{name}.toml").write_text(text, encoding="utf-8")
    lemnis("fmu", folder / f"{name}.toml", "--output", folder)
    return {standard: str(folder / f"{name}{end}") for standard, end in ENDS.items()}


def by_itself(text, rope="", most=M_LIM):
    """Slewing alone with the numbers of the ready scene by hand."""
    told = text[text.index("[slewing]\n") + len("[slewing]\n"):]
    weight, ahead = sum(g for g, *_ in UPPER), sum(g * r for g, r, _ in UPPER)
    return f"""name = "ByHand"
title = "By hand"
[slewing]
J_sl = "{J_0!r} kg.m2"
R = {{ input = "{REACH} m" }}
Q = {{ input = "{LOAD!r} N" }}
M_Fsl = "{M_F!r} N.m"
{rope}{told}
[slewing.coupling]
J_d = "{J_D!r} kg.m2"
M_lim = "{most!r} N.m"
[slewing.slope]
gamma_s = "0.3 deg"
G_u = "{weight!r} N"
r_u = "{ahead / weight!r} m"
{MOTION}"""


@pytest.fixture(scope="module")
def fmus(tmp_path_factory):
    """The ready scene, and slewing alone with the same numbers."""
    folder, text = tmp_path_factory.mktemp("engine"), SCENE.read_text("utf-8")
    return {"drive": built(folder, text, "SlewingEngine"), "hand": built(folder, by_itself(text), "ByHand")}


@pytest.mark.parametrize("standard", ENDS)
def test_inertia_limit_and_friction_are_those_of_drive_and_column(fmus, standard):
    assert not validate_fmu(fmus["drive"][standard])
    variables = {variable.name: variable for variable in read_model_description(fmus["drive"][standard]).modelVariables}
    for name, wanted in [("J_d", J_D), ("M_lim", M_LIM), ("M_Fsl", M_F), ("J_sl", J_0), ("R", REACH), ("Q", LOAD)]:
        assert float(variables[name].start) == pytest.approx(wanted, rel=1e-12), name
    assert [variables[name].causality for name in ("J_d", "M_lim", "M_Fsl", "R", "Q")] == ["parameter"] * 3 + ["input"] * 2


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("standard", ENDS)
def test_the_motion_is_that_of_slewing_alone(fmus, standard, kind):
    one, other = (simulate_fmu(fmus[of][standard], fmi_type=kind, stop_time=28.0, output_interval=0.25, relative_tolerance=1e-10, output=NAMES,
                               record_events=False) for of in ("drive", "hand"))
    assert one["psi_slip"][-1] > 0.1 and one["omega_sl"].max() > 0.1 and one["omega_sl"][-1] == 0.0
    for name in NAMES:
        assert np.abs(one[name] - other[name]).max() <= 1e-10 * np.abs(other[name]).max(), name


SWINGING = ["psi_sl", "omega_sl", "omega_d", "psi_slip", "x_Q", "y_Q", "z_Q", "S_R"]


@pytest.mark.parametrize("by_drive", [True, False])
def test_a_load_that_swings_is_that_of_slewing_alone(tmp_path, by_drive):
    """On the rope of the drive, on which it swings out in steady slewing too, or on one that slewing gives; in a wind that turns all that
    slews, too."""
    air = '[slewing.air]\nQ_air = "5 t"\nd_Q = "120 N.s/m"\nc_wQ = "1.2"\nA_Q = "6 m2"\nv_air = "8 m/s"\nchi_air = "30 deg"\n'
    text = SCENE.read_text("utf-8").replace('fidelity = "rigid"\n', 'fidelity = "swing"\nphi_R = "2 deg"\n') + air
    rope = 'l_R = "18 m"\n'
    beside = text.replace("heating  = 1\n", "heating  = 1\n" + rope) if by_drive else text.replace('phi_R = "2 deg"\n', 'phi_R = "2 deg"\n' + rope)
    assert beside.count("l_R") == 1
    paths = built(tmp_path, beside, "SlewingEngine"), built(tmp_path, by_itself(text, rope + EXPOSED, limit(18.0 if by_drive else 0.0)), "ByHand")
    for standard in ENDS:
        assert not validate_fmu(paths[0][standard])
        for kind in KINDS:
            one, other = (simulate_fmu(of[standard], fmi_type=kind, stop_time=28.0, output_interval=0.25, relative_tolerance=1e-10, output=SWINGING,
                                       record_events=False) for of in paths)
            assert one["psi_slip"][-1] > 0.1 and np.ptp(one["z_Q"]) > 0.5
            for name in SWINGING:
                assert np.abs(one[name] - other[name]).max() <= 1e-10 * np.abs(other[name]).max(), name
    lemnis("book", tmp_path / "SlewingEngine.toml", "--format", "typ", "--output", tmp_path)
    book, known = typst(tmp_path / "SlewingEngine.typ"), words("en")
    for said in (known["section"]["slewing_swing"], known["assumption"]["slewing_level_swing"], known["assumption"]["slewing_hook"].split("$")[0]):
        assert said in book, said
    assert known["assumption"]["slewing_level_rigid"] not in book


def on_level_ground(told):
    """Without viscous friction, under moments (N·m) of the drive from times (s) on."""
    text = SCENE.read_text("utf-8")
    slope = text[text.index("[supports.slope]"): text.index("[[supports.areas]]")]
    rows = "".join(f'    ["{time} s", "{moment!r} N.m"],\n' for time, moment in told)
    return text[: text.index("c_sl  =")].replace(slope, "") + f'M_sl = {{ between = "steps", over = [\n{rows}] }}\n'


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("standard", ENDS)
def test_it_sticks_starts_and_coasts_in_closed_form(tmp_path, monkeypatch, standard, kind):
    """The column's friction holds a drive that gives a little less, not one that gives a little more; then a start under a constant
    moment, and a stop by friction alone."""
    monkeypatch.setattr(test_slewing_column, "SLOPE", 0.0)
    dry, whole, near, push = friction(), J_0 + LOAD / G * REACH**2 + J_D, 1e-6, 100e3
    told = [(0.0, dry * (1 - near)), (2.0, dry * (1 + near)), (4.0, push), (8.0, 0.0), (30.0, 0.0)]
    path = built(tmp_path, on_level_ground(told), "SlewingEngine")[standard]
    found = simulate_fmu(path, fmi_type=kind, stop_time=30.0, output_interval=0.25, relative_tolerance=1e-12, output=["psi_sl", "omega_sl", "psi_slip"],
                         record_events=False)
    barely, quick, slow = dry * near / whole, (push - dry) / whole, dry / whole
    top = 2 * barely + 4 * quick
    ends = 8.0 + top / slow
    assert 9.0 < ends < 30.0 and not found["psi_slip"].any()
    assert not found["omega_sl"][found["time"] <= 2.0].any() and found["omega_sl"][-1] == 0.0
    speed = np.interp(found["time"], [0.0, 2.0, 4.0, 8.0, ends, 30.0], [0.0, 0.0, 2 * barely, top, 0.0, 0.0])
    assert np.abs(found["omega_sl"] - speed).max() <= 1e-9 * top
    angle = 2 * barely + 4 * (2 * barely + top) / 2 + top**2 / (2 * slow)
    assert found["psi_sl"][-1] == pytest.approx(angle, rel=1e-9)


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("standard", ENDS)
def test_a_slip_in_closed_form(tmp_path, monkeypatch, standard, kind):
    """On level ground without viscous friction both sides have constant accelerations until they meet."""
    monkeypatch.setattr(test_slewing_column, "SLOPE", 0.0)
    path = built(tmp_path, on_level_ground([(0.0, 260e3), (2.0, 100e3), (8.0, 48e3)]), "SlewingEngine")[standard]
    start = {variable.name: variable.start for variable in read_model_description(path).modelVariables}
    most, dry, inertia = float(start["M_lim"]), friction(), J_0 + LOAD / G * REACH**2
    assert float(start["M_Fsl"]) == pytest.approx(dry, rel=1e-12)
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


def test_a_ring_rubs_by_the_greatest_of_its_forms(tmp_path):
    """The textbook's form by equilibrium of the rolling elements, the maker's by its load, both in the load case of heating over a turn."""
    text = test_slewing_ring.SCENE.read_text("utf-8")
    assert 'mu_n = "0.008"' in text and 'mu_m = "0.004"' in text and "heating  = 1 " in text
    moving = text + '[slewing]\nfidelity = "rigid"\nc_sl = "300 kN.m.s"\n'
    angles = np.linspace(0.0, 2 * np.pi, 721)
    vertical, horizontal, moment = test_slewing_ring.by_hand(angles, 25.0, 16e3 * G, 0)
    diameter = test_slewing_ring.DIAMETER
    textbook = 0.008 * diameter / 2 * np.abs(test_slewing_ring.spread(vertical, moment)).sum(axis=1)
    maker = 0.004 / 2 * (4.1 * moment + vertical * diameter + 2.05 * horizontal * diameter)
    assert textbook.max() != pytest.approx(maker.max(), rel=1e-3)
    path = built(tmp_path, moving, "SlewingPortal")["FMI 3"]
    start = {variable.name: variable.start for variable in read_model_description(path).modelVariables}
    wanted = max(textbook.max(), maker.max())
    assert wanted * (1 - 1e-12) <= float(start["M_Fsl"]) <= wanted * (1 + 1e-5)


@pytest.mark.parametrize("language", ["en", "zh", "bg"])
def test_the_book_has_the_engines_curve_and_the_coupling_in_motion(language, tmp_path):
    lemnis("book", SCENE, "--language", language, "--format", "typ", "--output", tmp_path)
    book = typst(tmp_path / "SlewingEngine.typ")
    known = words(language)
    for said in (known["curve"]["start_torque"], known["assumption"]["turning_moving"].split("$")[0], known["position"]["turning_moving"],
                 known["caption"]["taken"], *(known["section"][f"slewing_{part}"] for part in ("inertia", "slope", "motion", "coupling"))):
        assert said in book, said
    # Both follow from the drive by formulas of their own.
    assert re.search(r'\bJ_"d" &=', book) and re.search(r'\bM_\("lim" i\) &=', book)
