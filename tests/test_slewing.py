"""Slewing by itself in FMPy: both standards and both interfaces, its reach and its load from outside."""

import math

import numpy as np
import pytest
from fmpy import read_model_description, simulate_fmu
from fmpy.validation import validate_fmu

from conftest import ROOT, lemnis

ENDS = {"FMI 2": ".fmi2.fmu", "FMI 3": ".fmu"}
SCENE = ROOT / "models/scenes/slewing.toml"


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
