"""Slewing by itself in FMPy: both standards and both interfaces, its reach and its load from outside."""

import math

import numpy as np
import pytest
from fmpy import read_model_description, simulate_fmu
from fmpy.validation import validate_fmu

from conftest import ROOT, lemnis

ENDS = {"FMI 2": ".fmi2.fmu", "FMI 3": ".fmu"}
SCENE = ROOT / "models/scenes/slewing.toml"
SWINGING = ROOT / "models/scenes/slewing_swing.toml"


@pytest.fixture(scope="module")
def fmus(tmp_path_factory):
    folder = tmp_path_factory.mktemp("slewing")
    lemnis("fmu", SCENE, "--output", folder)
    return {standard: str(folder / f"Slewing{end}") for standard, end in ENDS.items()}


@pytest.mark.parametrize("standard", ENDS)
def test_what_the_scene_leaves_open_is_an_input(fmus, standard):
    assert not validate_fmu(fmus[standard])
    variables = {variable.name: variable for variable in read_model_description(fmus[standard]).modelVariables}
    assert {name: variables[name].causality for name in ("R", "Q", "M_sl", "M_Bsl", "J_sl", "J_tot")} == {
        "R": "input", "Q": "input", "M_sl": "input", "M_Bsl": "input", "J_sl": "parameter", "J_tot": "output"}


def test_a_crane_slews_out_brakes_and_meets_its_stop(fmus):
    """The load is drawn in at 10 s, the brake falls at 18 s: two standards and two interfaces give one run, and what its
    parts do between the events is that of one shaft with friction, solved here by itself."""
    times = [0.0, 10.0, 10.0, 18.0, 18.0, 40.0]
    given = {"M_sl": [300e3] * 4 + [0.0] * 2, "M_Bsl": [0.0] * 4 + [900e3] * 2, "R": [25.0] * 2 + [12.0] * 4,
             "Q": [156960.0] * 6}
    inputs = np.array([tuple(row) for row in zip(times, *given.values())],
                      dtype=[("time", float)] + [(name, float) for name in given])
    runs = {}
    for standard, path in fmus.items():
        for kind in ("CoSimulation", "ModelExchange"):
            runs[standard, kind] = simulate_fmu(path, fmi_type=kind, stop_time=40.0, output_interval=0.5, input=inputs,
                                                relative_tolerance=1e-9, output=["psi_sl", "omega_sl", "J_tot"],
                                                record_events=False)
    weight, arm, slope = 156960.0, -1.2 * 180e3 * 9.81, math.sin(math.radians(0.5))

    def rate(psi, omega, reach, moment, brake):
        inertia = 9e6 + weight / 9.81 * reach * reach
        tilt = -(arm + weight * reach) * slope * math.sin(psi)
        return (moment + tilt - 600e3 * omega - 40e3 - brake) / inertia

    psi, omega, expected = math.radians(-60.0), 0.0, {0.0: (math.radians(-60.0), 0.0)}
    h = 1e-3
    for i in range(40_000):
        t = i * h
        moment, brake = (300e3, 0.0) if t < 18.0 - 1e-9 else (0.0, 900e3)
        reach = 25.0 if t < 10.0 - 1e-9 else 12.0
        if t >= 18.0 and omega <= 0.0:
            omega = 0.0
        else:
            half = psi + 0.5 * h * omega, omega + 0.5 * h * rate(psi, omega, reach, moment, brake)
            psi, omega = psi + h * half[1], omega + h * rate(half[0], half[1], reach, moment, brake)
        expected[round(t + h, 6)] = (psi, max(omega, 0.0))
    for key, run in runs.items():
        assert run["J_tot"][0] == 9e6 + 16e3 * 625.0 and run["omega_sl"][-1] == 0.0, key
        for t, at, turning in zip(run["time"], run["psi_sl"], run["omega_sl"]):
            wanted = expected[round(t, 6)]
            assert abs(at - wanted[0]) <= 2e-5 and abs(turning - wanted[1]) <= 2e-4, (key, t, at, turning, wanted)
    first = runs["FMI 3", "CoSimulation"]
    assert np.array_equal(first["psi_sl"], runs["FMI 2", "CoSimulation"]["psi_sl"])


def swung(times, moment, blows, length=18.0, reach=25.0, mass=16e3):
    """The same crane with its load as a point in space, in coordinates that stand still: x downhill, z away from the slope.
    The rope's force is what keeps the second derivative of its length at zero; the wind blows at 30° with the speed told."""
    wind = np.array([math.cos(math.radians(30.0)), math.sin(math.radians(30.0)), 0.0])
    gravity = 9.81 * np.array([math.sin(math.radians(0.5)), 0.0, -math.cos(math.radians(0.5))])

    def rates(t, y):
        psi, omega, place, speed = y[0], y[1], y[2:5], y[5:8]
        forward, left = np.array([math.cos(psi), math.sin(psi), 0]), np.array([-math.sin(psi), math.cos(psi), 0])
        head, moving = reach * forward, reach * omega * left
        along = (place - head) / length
        against = speed - blows(t) * wind
        fall = gravity - (120.0 + 0.5 * 1.225 * 1.2 * 14.0 * math.sqrt(against @ against)) / mass * against
        weight = -180e3 * 1.2 * np.cross(forward, gravity)[2]
        aside = math.sin(math.radians(30.0) - psi)
        blown = 0.5 * 1.225 * blows(t) * abs(blows(t)) * 140.0 * 5.5 * aside
        alone = (moment(t) + weight + blown - 600e3 * omega - 40e3 * math.copysign(1.0, omega or 1.0)) / 9e6
        arm = np.cross(head, along)[2]
        # along · (fall − pull/mass along − head'') + |speed − moving|²/length = 0
        free = along @ (fall - reach * (alone * left - omega**2 * forward)) + (speed - moving) @ (speed - moving) / length
        pull = free / (1.0 / mass + arm * reach * (along @ left) / 9e6)
        return np.concatenate([[omega, alone + pull * arm / 9e6], speed, fall - pull / mass * along]), pull

    psi = math.radians(-60.0)
    start = reach * np.array([math.cos(psi), math.sin(psi), 0]) - [0, 0, length]
    y, found, h = np.concatenate([[psi, 0.0], start, [0.0] * 3]), [], 1e-3
    for i in range(round(times[-1] / h) + 1):
        t = i * h
        if round(t, 6) in times:
            forward, left = np.array([math.cos(y[0]), math.sin(y[0]), 0]), np.array([-math.sin(y[0]), math.cos(y[0]), 0])
            apart = y[2:5] - reach * forward
            found.append([y[0], apart @ forward, apart @ left, rates(t, y)[1]])
        # What is told in steps changes after the end of one of these.
        half, end = t + 0.5 * h, t + (1.0 - 1e-5) * h
        a = rates(t, y)[0]
        b = rates(half, y + 0.5 * h * a)[0]
        c = rates(half, y + 0.5 * h * b)[0]
        d = rates(end, y + h * c)[0]
        y = y + h / 6 * (a + 2 * b + 2 * c + d)
    return np.array(found)


def test_a_load_swings_in_a_wind_that_rises_straight(tmp_path):
    """Told by the scene; the same code in coordinates that stand still has the wind from straight lines of its own."""
    told = {0.0: 8.0, 6.0: -15.0, 11.0: 4.0}
    over = ", ".join(f'["{t} s", "{v} m/s"]' for t, v in told.items())
    text = SWINGING.read_text(encoding="utf-8").replace('v_air = "8 m/s" ', f'v_air = {{ between = "linear", over = [{over}] }} ')
    (tmp_path / "wind.toml").write_text(text, encoding="utf-8")
    lemnis("fmu", tmp_path / "wind.toml", "--output", tmp_path)
    names = ["psi_sl", "x_Q", "z_Q", "S_R"]
    times = [round(0.5 * i, 6) for i in range(29)]
    expected = swung(times, lambda _: 300e3, lambda t: np.interp(t, list(told), list(told.values())))
    for kind in ("CoSimulation", "ModelExchange"):
        run = simulate_fmu(str(tmp_path / "SlewingSwing.fmu"), fmi_type=kind, stop_time=14.0, output_interval=0.5,
                           relative_tolerance=1e-9, output=names, record_events=False)
        apart = np.abs(np.array([[row[name] for name in names] for row in run]) - expected) / [1.0, 1.0, 1.0, 16e3 * 9.81]
        assert apart.max() <= 1e-5, (kind, apart.max(axis=0))


def test_a_load_swings_as_a_point_in_space(tmp_path):
    """Driven out for 12 s and left to run out, in a wind that turns round meanwhile: two standards and two interfaces, against
    a code that knows neither the frame that slews nor the drive's library."""
    lemnis("fmu", SWINGING, "--output", tmp_path)
    names = ["psi_sl", "x_Q", "z_Q", "S_R"]
    told = [(0.0, 300e3, 8.0), (12.0, 300e3, 8.0), (12.0, 0.0, -15.0), (18.0, 0.0, -15.0)]
    inputs = np.array(told, dtype=[("time", float), ("M_sl", float), ("v_air", float)])
    times = [round(0.5 * i, 6) for i in range(37)]
    expected = swung(times, lambda t: 300e3 if t < 12.0 - 1e-9 else 0.0, lambda t: 8.0 if t < 12.0 - 1e-9 else -15.0)
    assert np.abs(expected[:, 1:3]).max() > 0.5, "it swings"
    for end in ENDS.values():
        path = str(tmp_path / f"SlewingSwing{end}")
        assert not validate_fmu(path)
        for kind in ("CoSimulation", "ModelExchange"):
            run = simulate_fmu(path, fmi_type=kind, stop_time=18.0, output_interval=0.5, input=inputs,
                               relative_tolerance=1e-9, output=names, record_events=False)
            rows = np.array([[row[name] for name in names] for row in run])
            assert np.allclose(run["time"], times)
            # At a change of the drive the force in the rope is that before or after it.
            apart = np.abs(rows - expected) / [1.0, 1.0, 1.0, 16e3 * 9.81]
            apart[24, 3] = 0.0
            assert apart.max() <= 1e-5, (end, kind, apart.max(axis=0))
