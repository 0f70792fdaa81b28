"""A load in air and wind through FMPy, both standards and both interfaces: against an independent pendulum in space, closed
forms, and the book."""

import math
import re

import numpy as np
import pytest
from fmpy import read_model_description, simulate_fmu
from fmpy.validation import validate_fmu
from scipy.integrate import solve_ivp

from conftest import ROOT, lemnis, typst, words

ENDS = {"FMI 2": ".fmi2.fmu", "FMI 3": ".fmu"}
SCENE = ROOT / "models/scenes/container_in_wind.toml"
G, MASS, LENGTH = 9.81, 100e3 / 9.81, 15.0
DELTA, KAPPA = 80.0 / MASS, 0.5 * 1.225 * 1.2 * 15.0 / MASS


def held(folder, wind, extra=""):
    """FMUs of the scene's crane, held by its brakes, with another wind."""
    text = SCENE.read_text(encoding="utf-8")
    text = re.sub(r"v_air = \{.*?\] \}\nchi_air = \{.*?\] \}\n", wind, text, flags=re.DOTALL)
    text = text.replace('M_A  = "500 kN.m"', 'M_A  = "0 kN.m"\nM_S  = "1e6 kN.m"' + extra)
    text = text.replace('M_sl  = "300 kN.m" ', 'M_sl  = "0 kN.m"\nM_Bsl = "1e6 kN.m" ')
    scene = folder / "held.toml"
    scene.write_text(text, encoding="utf-8")
    lemnis("fmu", scene, "--output", folder)
    return {standard: str(folder / f"ContainerInWind{end}") for standard, end in ENDS.items()}


@pytest.fixture(scope="module")
def windy(tmp_path_factory):
    return held(tmp_path_factory.mktemp("windy"), 'v_air = "0 m/s"\nchi_air = "0 deg"\n')


def pendulum(times, gusts):
    """Place of a load on its rope in x, up and z, from two angles of the rope (Lagrange), in wind along x and z over time."""

    def place(a, b):
        return LENGTH * np.array([math.cos(b) * math.sin(a), -math.cos(b) * math.cos(a), math.sin(b)])

    def rates(t, y):
        a, b, da, db = y
        along = np.array([math.cos(b) * math.cos(a), math.cos(b) * math.sin(a), 0.0])
        aside = np.array([-math.sin(b) * math.sin(a), math.sin(b) * math.cos(a), math.cos(b)])
        speed = LENGTH * (along * da + aside * db)
        wind = np.array([gusts(t)[0], 0.0, gusts(t)[1]])
        against = speed - wind
        force = -(DELTA + KAPPA * np.linalg.norm(against)) * against + np.array([0.0, -G, 0.0])
        # l² cos² b a″ = Q_a + 2 l² sin b cos b a′ b′ and l² b″ = Q_b − l² sin b cos b a′².
        dda = (force @ along * LENGTH / LENGTH**2 + 2 * math.sin(b) * math.cos(b) * da * db) / math.cos(b) ** 2
        ddb = force @ aside / LENGTH - math.sin(b) * math.cos(b) * da**2
        return [da, db, dda, ddb]

    y, found, start = np.zeros(4), [np.array([0.0, -LENGTH, 0.0])], times[0]
    for end in times[1:]:
        y = solve_ivp(rates, (start, end), y, method="DOP853", rtol=1e-12, atol=1e-13).y[:, -1]
        found.append(place(y[0], y[1]))
        start = end
    return np.array(found)


@pytest.mark.parametrize("kind", ["CoSimulation", "ModelExchange"])
@pytest.mark.parametrize("standard", ENDS)
def test_gusts_against_an_independent_pendulum(windy, standard, kind):
    """Steps of the wind at whole seconds, from in front, from the side and from behind."""
    assert not validate_fmu(windy[standard])
    steps = [(0.0, 0.0, 0.0), (1.0, 16.0, 0.3), (5.0, 11.0, 1.9), (9.0, -14.0, 0.4), (13.0, 0.0, 0.0)]
    rows = []
    for (t, v, chi), following in zip(steps, [*steps[1:], (20.0, 0.0, 0.0)]):
        rows += [(t, v, chi), (following[0], v, chi)]
    inputs = np.array(rows, dtype=[("time", float), ("v_air", float), ("chi_air", float)])
    result = simulate_fmu(windy[standard], fmi_type=kind, stop_time=16.0, output_interval=0.5, step_size=1e-3, relative_tolerance=1e-9,
                          input=inputs, output=["x_Q", "y_Q", "z_Q", "F_air", "S_R"])
    times = np.unique(np.round(result["time"], 9))

    def gusts(t):
        speed, to = next((v, chi) for start, v, chi in reversed(steps) if t >= start - 1e-9)
        return speed * math.cos(to), speed * math.sin(to)

    # Between two outputs the wind does not change.
    wanted = pendulum(times, lambda t: gusts(min(t + 1e-6, 16.0)) if abs(t % 1) < 1e-12 else gusts(t))
    for time, place in zip(times, wanted):
        at = np.argmin(np.abs(result["time"] - time))
        found = [result[name][at] for name in ("x_Q", "y_Q", "z_Q")]
        # In Model Exchange FMPy's own solver goes over the steps of the wind.
        allowed = 1e-7 if kind == "CoSimulation" else 1e-4
        assert np.allclose(found, place, atol=allowed), (time, found, place)
    assert result["F_air"].max() > 2e3


STRAIGHT = """v_air = { between = "linear", over = [["0 s", "0 m/s"], ["2 s", "16 m/s"], ["7 s", "-6 m/s"], ["10 s", "10 m/s"]] }
chi_air = { between = "linear", over = [["1 s", "0 deg"], ["9 s", "120 deg"]] }
"""


@pytest.mark.parametrize("kind", ["CoSimulation", "ModelExchange"])
def test_a_wind_that_rises_straight_against_an_independent_pendulum(kind, tmp_path):
    """Speed and direction change between their times, and hold after the last of them; told by the scene, they are outputs."""
    fmus = held(tmp_path, STRAIGHT)
    told = ([0, 2, 7, 10], [0, 16, -6, 10]), ([1, 9], np.radians([0, 120]))
    wind = lambda t: [np.interp(t, *course) for course in told]
    for standard, path in fmus.items():
        result = simulate_fmu(path, fmi_type=kind, stop_time=14.0, output_interval=0.5, step_size=1e-3, relative_tolerance=1e-9,
                              output=["x_Q", "y_Q", "z_Q", "v_air", "chi_air"], record_events=False)
        wanted = pendulum(result["time"], lambda t: (wind(t)[0] * math.cos(wind(t)[1]), wind(t)[0] * math.sin(wind(t)[1])))
        found = np.column_stack([result[name] for name in ("x_Q", "y_Q", "z_Q")])
        assert np.allclose(np.column_stack([result["v_air"], result["chi_air"]]), [wind(t) for t in result["time"]], atol=1e-9)
        assert np.abs(wanted[:, [0, 2]]).max() > 0.2, "it swings"
        allowed = 1e-7 if kind == "CoSimulation" else 1e-4
        assert np.allclose(found, wanted, atol=allowed), (standard, np.abs(found - wanted).max())


def test_small_swings_lose_their_logarithmic_decrement(tmp_path):
    """Drag left out, the swing's peaks fall by exp(−π δ/ω_d) from one side to the other."""
    text = 'v_air = "0 m/s"\n'
    fmus = held(tmp_path, text, '\nphi_R = "0.02 deg"')
    damped = math.sqrt(G / LENGTH - DELTA**2 / 4)
    period = 2 * math.pi / damped
    result = simulate_fmu(fmus["FMI 3"], start_values={"A_Q": 0.0}, stop_time=3 * period, output_interval=period, step_size=1e-3,
                          output=["x_Q"])
    peaks = result["x_Q"] / result["x_Q"][0]
    assert np.allclose(peaks, np.exp(-DELTA / 2 * result["time"]), rtol=1e-6)


def test_inputs_and_results(windy):
    variables = {variable.name: variable for variable in read_model_description(windy["FMI 3"]).modelVariables}
    assert {name: variables[name].causality for name in ("v_air", "chi_air", "A_Q", "d_Q", "Q_air", "F_air", "P_air")} == {
        "v_air": "input", "chi_air": "input", "A_Q": "parameter", "d_Q": "parameter", "Q_air": "parameter", "F_air": "output",
        "P_air": "output"}


def test_a_crane_without_air_has_nothing_of_it(tmp_path):
    lemnis("fmu", ROOT / "models/scenes/portal_004_motion.toml", "--output", tmp_path)
    names = {variable.name for variable in read_model_description(str(tmp_path / "PortalCraneMotion.fmu")).modelVariables}
    assert not {name for name in names if "air" in name or name in ("d_Q", "c_wQ", "A_Q")}


@pytest.mark.parametrize("language", ["en", "zh", "bg"])
def test_the_book_tells_of_it(language, tmp_path):
    lemnis("book", SCENE, "--language", language, "--format", "typ", "--output", tmp_path)
    book = typst(tmp_path / "ContainerInWind.typ")
    known = words(language)
    for group, word in (("input", "air"), ("section", "motion_air"), ("purpose", "motion_air")):
        assert known[group][word] in book, (group, word)
    for symbol in ('delta_"air"', 'kappa_"air"', 'u_"air"', 'W_"air"', 'P_"air"'):
        assert symbol in book, symbol
