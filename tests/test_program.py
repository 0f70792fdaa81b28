"""What the program says it does: levels that are decided, default experiments that run, scenes from the standard input,
tables beside their summary, and a sign of life."""

import csv
import json
import os
import re
import subprocess
import time
import tomllib
import zipfile

import pytest
from fmpy import simulate_fmu

from conftest import LEMNIS, ROOT, lemnis, typst

SCENES = sorted((ROOT / "models/scenes").glob("*.toml"))
DEFAULT = (ROOT / "models/scenes/lemniscate.toml").read_text(encoding="utf-8")
# A crank and rocker whose drive and friction are too quick for inner steps of 10 ms.
CRANK = """
name = "Crank"
title = "A crank that turns once"
[luffing]
fidelity = "rigid"
driven = "boom"
branch = "left"
X_1 = "2 m"
X_2 = "6 m"
X_3 = "5 m"
X_4 = "10 m"
X_5 = "5 m"
X_6 = "0 m"
beta_0 = "180 deg"
X_8 = "0 m"
Q = "100 kN"
[luffing.motion]
from = "0 deg"
to = "350 deg"
step = "5 deg"
speed = "1 deg/s"
[luffing.weights]
G_1 = "100 kN"
s_1 = "1 m"
chi_1 = "0 deg"
G_2 = "50 kN"
s_2 = "2 m"
chi_2 = "180 deg"
G_3 = "40 kN"
s_3 = "1 m"
chi_3 = "0 deg"
[luffing.dynamics]
J_1 = "1000 kg.m2"
J_2 = "50000 kg.m2"
J_3 = "10000 kg.m2"
M_A = "900 kN.m"
c_v = "100 kN.m.s"
"""


def written(folder, text, name="scene.toml"):
    path = folder / name
    path.write_text(text, encoding="utf-8")
    return path


def test_no_two_ready_scenes_share_a_name():
    names = [tomllib.loads(path.read_text(encoding="utf-8"))["name"] for path in SCENES]
    assert len(set(names)) == len(names) > 10


@pytest.mark.parametrize("command", ["build", "fmu"])
def test_an_fmu_runs_its_default_experiment(command, tmp_path):
    """The scene gives no inner step, so one is chosen, and stands in the FMU's scene."""
    told = lemnis(command, written(tmp_path, CRANK), "--output", tmp_path)
    step = re.search(r'luffing\.dynamics\.step = "(\d+ ms)" is chosen', told).group(1)
    for name in ("Crank.fmu", "Crank.fmi2.fmu"):
        with zipfile.ZipFile(tmp_path / name) as archive:
            scene = tomllib.loads(archive.read("resources/scene.toml").decode())
        assert scene["luffing"]["dynamics"]["step"] == step
        assert simulate_fmu(str(tmp_path / name), output_interval=5.0)["time"][-1] == 350.0


@pytest.mark.parametrize("command", ["build", "fmu", "book", "check"])
def test_a_step_that_is_too_long_is_refused_with_its_line(command, tmp_path):
    path = written(tmp_path, CRANK + 'step = "10 ms"\n')
    out = [] if command == "check" else ["--output", tmp_path / "out"]
    message = lemnis(command, path, *out, expect=1)
    line = 1 + path.read_text(encoding="utf-8").splitlines().index('step = "10 ms"')
    assert "cannot run its default experiment" in message and f"scene.toml:{line}:8" in message
    assert 'step = "5 ms" runs' in message and not (tmp_path / "out").exists()


def test_an_experiment_that_never_ends_is_refused(tmp_path):
    started = time.monotonic()
    message = lemnis("check", written(tmp_path, CRANK.replace('"1 deg/s"', '"1e-6 deg/s"')), expect=1)
    assert "lasts 3.5e8 s" in message and "raise the speed" in message and time.monotonic() - started < 5


def test_check_tells_the_level(tmp_path):
    levels = {"lemniscate": "static", "portal_004_motion": "swing", "boat_hoist_003": "kinematic",
              "boat_hoist_003_hydraulic": "hydraulic"}
    for name, level in levels.items():
        path = ROOT / f"models/scenes/{name}.toml"
        assert lemnis("check", path).rstrip().endswith(f'at level "{level}"')
        assert json.loads(lemnis("check", path, "--json"))["level"] == level


def test_check_decides_as_build_does(tmp_path):
    auto = DEFAULT.replace('driven = "boom"', 'fidelity = "auto"\ndriven = "boom"', 1)

    def asking(accuracy):
        return written(tmp_path, auto.replace("[project]", f'accuracy = {{ "A.x" = "{accuracy}" }}\n[project]', 1))

    checked, built = lemnis("check", asking("1 mm")), lemnis("build", asking("1 mm"), "--output", tmp_path)
    verdict = next(line for line in built.splitlines() if line.startswith("the cheapest that keeps"))
    assert verdict in checked and 'at level "table"' in checked
    assert json.loads(lemnis("check", asking("1 mm"), "--json"))["level"] == "table"
    refused = [lemnis(command, asking("1e-15 mm"), expect=1) for command in ("check", "fmu")]
    assert refused[0] == refused[1] and "nothing keeps to the accuracy" in refused[0]


def test_what_weighs_by_the_dynamics_weighs_the_same_without_them(tmp_path):
    dynamics = '[luffing.dynamics]\nJ_1 = "621000 kg.m2"\nJ_2 = "21000 kg.m2"\nJ_3 = "72000 kg.m2"\ng = "10 m/s2"\n'
    text = DEFAULT.replace('driven = "boom"', 'fidelity = "auto"\ndriven = "boom"', 1).replace('"160 kN"', '"16 t"', 1)
    text = text.replace("[project]", 'accuracy = { "A.x" = "1 m" }\n[project]', 1).split("[luffing.published]")[0]
    found = json.loads(lemnis("check", written(tmp_path, text + dynamics), "--json"))
    assert found["level"] == "table" and set(found["variables"]["Q"]["values"]) == {160e3}


def test_a_table_of_motion_agrees_with_its_summary_and_its_book(tmp_path):
    path = ROOT / "models/scenes/portal_004_motion.toml"
    head, *rows = csv.reader(lemnis("check", path, "--csv").splitlines())
    column = [float(row[head.index("V_AX [m/s]")]) for row in rows]
    summary = json.loads(lemnis("check", path, "--json"))["summary"]["V_AX_max"]["value"]
    assert max(column, key=abs) == pytest.approx(summary, rel=1e-9)
    lemnis("book", path, "--format", "typ", "--level", "full", "--output", tmp_path)
    book = typst(tmp_path / "PortalCraneMotion.typ")
    row = next(line for line in book.splitlines() if line.strip().startswith("[44],"))
    assert f"{column[0]:.4f}".replace("-", "−") in row
    assert "passed at omega_1 = 0.5 deg/s" in lemnis("check", path)


@pytest.mark.parametrize("name", ["boat_hoist_003", "car_4x2", "lemniscate"])
def test_trade_advises_what_the_scene_takes(name, tmp_path):
    path = ROOT / f"models/scenes/{name}.toml"
    told = lemnis("trade", path, "--output", tmp_path, "--rounds", 1)
    advice = re.search(r"add (accuracy = \{.*?\})", told).group(1)
    text = path.read_text(encoding="utf-8")
    lemnis("check", written(tmp_path, text.replace("\ntitle", f"\n{advice}\ntitle", 1)))


@pytest.mark.skipif(os.name == "nt", reason="a pseudo-terminal")
def test_trade_shows_its_progress_on_a_terminal(tmp_path):
    """Before the first reference is there, which takes longest."""
    import pty

    leader, follower = pty.openpty()
    scene = ROOT / "models/scenes/boat_hoist_003_hydraulic.toml"
    running = subprocess.Popen([LEMNIS, "trade", scene, "--output", tmp_path], stdout=subprocess.DEVNULL, stderr=follower)
    try:
        assert b"measuring" in os.read(leader, 1000) and running.poll() is None
    finally:
        running.kill()
        running.wait()
        os.close(leader)
        os.close(follower)


def piped(text, *arguments):
    return subprocess.run([LEMNIS, *map(str, arguments)], input=text, capture_output=True, text=True, encoding="utf-8")


def test_a_scene_may_come_from_the_standard_input(tmp_path):
    text = DEFAULT.replace("LemniscateCrane", "Piped")
    assert piped(text, "check", "-").stdout == lemnis("check", written(tmp_path, text))
    for command, name in [("build", "Piped.fmu"), ("fmu", "Piped.fmi2.fmu"), ("book", "Piped.pdf")]:
        folder = tmp_path / command
        done = piped(text, command, "-", "--output", folder)
        assert done.returncode == 0 and (folder / name).exists(), done.stderr
    both = piped(text, "book", "-", ROOT / "models/scenes/ports_001.toml", "--level", "summary", "--output", tmp_path / "both")
    assert both.returncode == 0 and len(list((tmp_path / "both").iterdir())) == 2, both.stderr
    wrong = piped(text.replace("X_1 =", "X_11 ="), "check", "-")
    assert wrong.returncode == 1 and "standard input:" in wrong.stderr
    assert "cannot be watched" in piped(text, "book", "-", "--watch").stderr
