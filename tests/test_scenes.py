"""Every kind of scene gives both FMUs and a book."""

import csv
import json
import math
import os
import re
import subprocess
import tomllib

import numpy as np
import pytest
from fmpy import read_model_description, simulate_fmu
from fmpy.validation import validate_fmu

from conftest import LEMNIS, ROOT, lemnis

DEFAULT = (ROOT / "models/scenes/lemniscate.toml").read_text(encoding="utf-8")
BARE = DEFAULT[: DEFAULT.index("[luffing.weights]")]
ROCKER = (
    DEFAULT[: DEFAULT.index("[luffing.published]")]
    .replace('driven = "boom"', 'driven = "rocker"')
    .replace('branch = "left"', 'branch = "right"')
    .replace('from  = "60 deg"', 'from  = "50 deg"')
    .replace('to    = "120 deg"', 'to    = "130 deg"')
)
PORTAL = (ROOT / "models/scenes/portal_004_new.toml").read_text(encoding="utf-8")


def balanced(balance):
    """The portal crane with another balance, without limits on it."""
    start, drive, limits = (PORTAL.index(f"[luffing.{table}]") for table in ("balance", "drive", "limits"))
    lines = balance.replace("; ", "\n")
    return f"{PORTAL[:start]}[luffing.balance]\n{lines}\n\n{PORTAL[drive:limits]}"


SCENES = {
    "tail weight": balanced('kind = "tail"; G_c = "600 kN"; r_c = "4 m"; chi_c = "0 deg"'),
    "parallelogram lever": balanced(
        'kind = "parallelogram"; G_c = "600 kN"; r_c = "4 m"; chi_c = "-2 deg"; r_1 = "3 m"; alpha_K = "5 deg"; '
        'd_1 = "6 m"; delta_1 = "143 deg"'),
    "straight rail": balanced(
        'kind = "straight_rail"; G_c = "300 kN"; r_1 = "8 m"; alpha_K = "2 deg"; H_x = "-2 m"; H_y = "11 m"; '
        'lambda = "70 deg"'),
    "curved rail": balanced(
        'kind = "curved_rail"; G_c = "300 kN"; r_1 = "9 m"; alpha_K = "10 deg"; L_r = "14 m"; y_0 = "10 m"; '
        'phi_0 = "60 deg"'),
    "rocker driven": ROCKER,
    "rack": DEFAULT.replace('kind  = "cylinder"', 'kind  = "rack"').replace('D_c   = "320 mm"', "").replace('d_r   = "220 mm"', ""),
    "load alone": BARE,
    "kinematic": BARE.replace('Q = "160 kN"', ""),
    "kinematic with cylinder": DEFAULT.replace('Q = "160 kN"', "").replace(
        DEFAULT[DEFAULT.index("[luffing.weights]") : DEFAULT.index("[luffing.drive]")], ""),
    "jib by its angle": DEFAULT.replace('X_7 = "1.354 m"', 'beta_0 = "163.122 deg"'),
    "jib by its axis": DEFAULT.replace('X_7 = "1.354 m"', 'AC = "22.3 m"'),
    "parallelogram": BARE.replace('"14.7 m"', '"19.3 m"').replace('X_2 = "6.5 m"', 'X_2 = "5 m"')
                         .replace('"6.4 m"', '"3 m"').replace('"5.3 m"', '"4 m"').replace('"60 deg"', '"30 deg"')
                         .replace('to    = "120 deg"', 'to    = "80 deg"'),
    "portal crane": (ROOT / "models/scenes/portal_004.toml").read_text(encoding="utf-8"),
    "steering under the PLC": (ROOT / "models/scenes/boat_hoist_003_hydraulic.toml").read_text(encoding="utf-8"),
    "hostile words": BARE.replace("Lemniscate level-luffing crane 16 t × 30 m",
                                  "#read(\\\"/etc/passwd\\\") $x$ *b* _i_ `c` <l> @r = - + / \\\\ { } [ ] // /* ${7*7} {{ 7 }} <% if %> %s %n"),
}


@pytest.mark.parametrize("name", SCENES)
def test_scene_builds_and_runs(name, tmp_path):
    scene = tmp_path / "scene.toml"
    scene.write_text(SCENES[name], encoding="utf-8")
    lemnis("build", scene, "--output", tmp_path)
    model = tomllib.loads(SCENES[name])["name"]
    assert (tmp_path / f"{model}.pdf").read_bytes().startswith(b"%PDF")
    for suffix in (".fmu", ".fmi2.fmu"):
        path = str(tmp_path / (model + suffix))
        assert validate_fmu(path) == []
        variables = {v.name for v in read_model_description(path).modelVariables if v.causality == "output"}
        result = simulate_fmu(path, output=sorted(variables))
        assert len(result) > 10
        for variable in variables - {"O1P", "P", "P.x", "P.y", "O", "O.y", "R_O", "R_in", "R_out"}:  # at infinity
            assert np.isfinite(result[variable]).all(), variable
        for variable in variables:
            assert not np.isnan(result[variable]).any(), variable


@pytest.mark.parametrize("number", range(20))
def test_random_scene_runs_in_fmpy(number, tmp_path):
    """All random scenes run as models and through the C ABI (tests/random); these here too, for the first twenty steps of
    their default experiments."""
    command = ["cargo", "test", "-q", "--release", "--workspace", "--test", "random_scenes", "--", "--nocapture"]
    told = subprocess.run(command, cwd=ROOT, env=dict(os.environ, LEMNIS_SCENE=str(number)), check=True,
                          capture_output=True, encoding="utf-8").stdout
    text = re.search(r"running 1 test\n(.*?)^(?: +\d+ |seed )", told, re.DOTALL | re.MULTILINE)[1]
    scene = tmp_path / "scene.toml"
    scene.write_text(text, encoding="utf-8")
    done = subprocess.run([LEMNIS, "fmu", scene, "--output", tmp_path], capture_output=True, encoding="utf-8")
    if done.returncode != 0:
        assert "; 0 legal" in told and re.search(r"^ +--> ", done.stderr, re.MULTILINE) and "panic" not in done.stderr, done.stderr
        return
    for path in map(str, tmp_path.glob("*.fmu")):
        assert validate_fmu(path) == []
        description = read_model_description(path)
        outputs = [v.name for v in description.modelVariables if v.causality == "output"]
        step = float(description.defaultExperiment.stepSize)
        end = min(20 * step, float(description.defaultExperiment.stopTime))
        for interface in ("CoSimulation", "ModelExchange"):
            result = simulate_fmu(path, fmi_type=interface, stop_time=end, step_size=step,
                                  output_interval=step, output=outputs)
            assert len(result) > end / step and result["time"][-1] > end * (1 - 1e-9)
            for output in outputs:
                assert not np.isnan(result[output]).any(), (interface, output)


def test_csv_has_the_numbers_of_json_in_the_units_of_the_trade():
    head, *rows = csv.reader(lemnis("check", "--csv").splitlines())
    assert [row[0] for row in rows] == [str(angle) for angle in range(60, 121)]
    variables = json.loads(lemnis("check", "--json"))["variables"]
    factors = {"deg": math.pi / 180, "deg/s": math.pi / 180, "kN": 1e3, "kN.m": 1e3, "mm/s": 1e-3, "L/min": 1e-3 / 60}
    compared = 0
    for column, name in enumerate(head):
        symbol, unit = name.rstrip("]").split(" [")
        for row, value in zip(rows, variables[symbol]["values"]):
            if value is not None:
                # 15 digits are right to 5e-15 of the value.
                assert math.isclose(float(row[column]) * factors.get(unit, 1), value, rel_tol=6e-15), (name, row[0])
                compared += 1
    assert compared > 2000
