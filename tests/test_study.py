"""Studies: designs as they should be drawn, rows as the program reads their scenes, the same bits wherever they are computed."""

import csv
import json
import math
import multiprocessing
import os
import re
import signal
import subprocess
import sys
import time
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor
from statistics import NormalDist

import numpy as np
import pyarrow
import pytest
from conftest import LEMNIS, ROOT, lemnis, typst
from mpmath import mp
from pyarrow import parquet
from scipy.stats import qmc

import lemnis as package
from lemnis.study import chunk

PATH = ROOT / "models/scenes/portal_004_study.toml"
PORTAL = PATH.read_text(encoding="utf-8")
DIMENSIONS = ["X_1", "X_2", "X_3", "X_4", "X_5", "X_6"]


@pytest.fixture(scope="module")
def scene():
    return package.Scene.read(PATH)


def crane(n=64):
    """The study of the portal crane with so many designs."""
    return PORTAL.replace("n       = 512", f"n       = {n}")


def same(one, other):
    """Whether two studies have the same bits."""
    columns = all(one[name].tobytes() == other[name].tobytes() for name in one)
    fails = all(np.array_equal(one.fails[name], other.fails[name]) for name in one.fails)
    return list(one) == list(other) and list(one.fails) == list(other.fails) and columns and fails and one.faults == other.faults


def points(n, seed, count):
    """Points of a cube, as the study draws them: each number evenly from its range, brought back to (0, 1)."""
    scene = package.Scene.default()
    keys = [f"luffing.{name}" for name in DIMENSIONS[:count]]
    study = scene.monte_carlo(n, seed, {key: "± 1e-6 %" for key in keys}, "R_max")
    middle = [scene.quantities[key].value for key in keys]
    return np.stack([(study[key] / value - 1) / 2e-8 + 0.5 for key, value in zip(keys, middle)], axis=1)


def counts(columns, cells):
    """How many points lie in each box of a grid, in order: Owen's scrambling moves boxes and keeps these numbers."""
    at = [np.minimum((column * cell).astype(int), cell - 1) for column, cell in zip(columns, cells)]
    return sorted(np.bincount(np.ravel_multi_index(at, cells), minlength=math.prod(cells)))


def test_designs_are_a_scrambled_sequence_of_sobol():
    """In each projection to two axes, boxes of every shape hold as many points as those of the same sequence from scipy."""
    n, axes = 256, 5
    found = points(n, 5, axes)
    known = qmc.Sobol(axes, scramble=False).random(n)
    for axis in range(axes):
        assert counts([found[:, axis]], [n]) == [1] * n
    for a in range(axes):
        for b in range(a):
            for power in range(1, 8):
                for cells in ((2**power, 2 ** (8 - power)), (2**power, 2 ** (7 - power))):
                    assert counts([found[:, a], found[:, b]], cells) == counts([known[:, a], known[:, b]], cells), (a, b, cells)
    again = points(n, 6, axes)
    assert not np.allclose(found, again, atol=1e-3)


def test_the_first_designs_of_a_longer_study_are_those_of_a_shorter_one():
    short, long = (package.Scene(PORTAL).monte_carlo(n, 9, outputs="dM at theta_1 = 60 deg") for n in (16, 24))
    assert all(long[name][:16].tobytes() == short[name].tobytes() for name in short)


def test_laws_have_their_quantiles():
    """Of 1024 points that lie one in each part of their range, the sorted values are the quantiles of these parts."""
    n, scene = 1024, package.Scene.default()
    laws = {"X_1": "normal, sd 2 mm", "X_2": "triangular 4 m to 8 m", "X_3": "± 0.5 %", "X_4": "normal ± 3 mm"}
    value = {name: scene.quantities[f"luffing.{name}"].value for name in laws}
    laws["X_2"] = f"triangular {value['X_2'] - 1e-3} m to {value['X_2'] + 3e-3} m"
    study = scene.monte_carlo(n, 3, {f"luffing.{name}": law for name, law in laws.items()}, "R_max")
    edges = np.arange(n + 1) / n

    def between(name, quantile):
        found, ends = np.sort(study[f"luffing.{name}"]), np.array([quantile(edge) for edge in edges])
        return np.all((ends[:-1] - 1e-12 <= found) & (found <= ends[1:] + 1e-12))

    def normal(deviation, mean):
        law = NormalDist(mean, deviation)
        return lambda p: law.inv_cdf(p) if 0 < p < 1 else (-1e9 if p == 0 else 1e9)

    def triangular(p):
        low, mode, high = -1e-3, 0.0, 3e-3
        turn = (mode - low) / (high - low)
        if p < turn:
            return value["X_2"] + low + math.sqrt(p * (high - low) * (mode - low))
        return value["X_2"] + high - math.sqrt((1 - p) * (high - low) * (high - mode))

    assert between("X_1", normal(2e-3, value["X_1"]))
    assert between("X_4", normal(1e-3, value["X_4"]))
    assert between("X_2", triangular)
    assert between("X_3", lambda p: value["X_3"] * (1 + 0.005 * (2 * p - 1)))


def test_normal_values_are_exact():
    """Against fifty digits: the part of all below a value, from the values that the study has at known parts."""
    scene, mp.dps = package.Scene.default(), 50
    drawn = scene.monte_carlo(64, 2, {"luffing.X_1": "normal, sd 1 m"}, "R_max")["luffing.X_1"]
    even = scene.monte_carlo(64, 2, {"luffing.X_1": "± 1 m"}, "R_max")["luffing.X_1"]
    for normal, uniform in zip(drawn, even):
        # The same point: its place in (0, 1) has 33 bits.
        part = (round((uniform - 18.3) / 2 * 2**32 - 0.5) + 0.5) / 2**32
        exact = 19.3 + mp.sqrt(2) * mp.erfinv(2 * mp.mpf(part) - 1)
        assert abs(float(exact) - normal) < 2e-14, part


@pytest.mark.parametrize("design", [0, 5, 63])
def test_a_row_has_the_bits_of_the_program(scene, design, tmp_path):
    study = scene.monte_carlo(64)
    changes = {name: float(study[name][design]) for name in study if name.startswith("luffing.")}
    path = tmp_path / "design.toml"
    path.write_text(scene.replace(changes).text, encoding="utf-8")
    done = subprocess.run([LEMNIS, "check", "--json", path], capture_output=True, text=True, encoding="utf-8")
    told = json.loads(done.stdout)
    for name in ("dM_max", "gamma_min", "N_max"):
        assert told["summary"][name]["value"] == study[name][design], name
    columns = told["variables"]
    place = columns["theta_1"]["values"].index(math.radians(82))
    assert columns["dM"]["values"][place] == study["dM at theta_1 = 82 deg"][design]
    fails = {check["check"]: not check["passed"] for check in told["checks"] if check["check"] in study.fails}
    assert fails == {name: bool(column[design]) for name, column in study.fails.items()} and len(fails) == 3
    assert (done.returncode == 4) == any(fails.values())


def test_any_executor_has_the_bits_of_one_thread(scene, monkeypatch):
    monkeypatch.setattr("lemnis.study.CHUNK", 24)
    one = scene.monte_carlo(64, threads=1)
    assert same(one, scene.monte_carlo(64, threads=2))
    with ThreadPoolExecutor(2) as executor:
        assert same(one, scene.monte_carlo(64, executor=executor))
    with ProcessPoolExecutor(2, mp_context=multiprocessing.get_context("spawn")) as executor:
        assert same(one, scene.monte_carlo(64, executor=executor))
        assert executor.submit(chunk, scene.text, 0, 1).result()[0][0].tobytes() == one["luffing.balance.d_1"][:1].tobytes()


def test_the_command_has_the_bits_of_python(scene, tmp_path):
    path, rows = tmp_path / "crane.toml", tmp_path / "rows.csv"
    path.write_text(crane(), encoding="utf-8")
    told = lemnis("sweep", path, "--csv", rows)
    study = package.Scene.read(path).sweep()
    assert same(study, scene.monte_carlo(64)) and "64 designs, seed 1" in told
    assert sorted(found.name for found in tmp_path.iterdir()) == ["crane.toml", "rows.csv"]
    table = list(csv.DictReader(rows.open(encoding="utf-8", newline="")))
    assert [int(row["design"]) for row in table] == list(range(64))
    for name in study:
        [head] = [head for head in table[0] if head.rsplit(" [", 1)[0] == name]
        assert head.endswith(f"[{study.units[name]}]")
        assert np.array([float(row[head]) for row in table]).tobytes() == study[name].tobytes()
    fails = [[name for name, column in study.fails.items() if column[row]] for row in range(64)]
    assert [list(filter(None, row["fails"].split("; "))) for row in table] == fails
    summary = json.loads(lemnis("sweep", path, "--json"))
    for output in summary["outputs"]:
        values = study[output["name"]]
        percentiles = np.percentile(values, [5, 50, 95])
        assert [output[key] for key in ("p5", "p50", "p95")] == list(percentiles)
        assert [output["least"], output["greatest"]] == [values.min(), values.max()]
    assert [one["fails"] for one in summary["requirements"]] == [int(column.sum()) for column in study.fails.values()]
    # The straight line of each quantity by itself, from numpy.
    for varied, law in zip(summary["varied"], (2e-3 / 3**0.5, 2e-3 / 3**0.5, math.radians(0.1) / 3**0.5, 1e-3)):
        for output, effect in varied["effects"].items():
            slope = np.polyfit(study[varied["key"]], study[output], 1)[0]
            assert math.isclose(effect["sampled"], slope * law, rel_tol=1e-6, abs_tol=1e-9), (varied["key"], output)


def test_effects_have_the_derivatives_of_the_jacobian(scene, tmp_path):
    """At a position: the exact derivative times the standard deviation of the law."""
    told = json.loads(lemnis("sweep", PATH, "--json"))
    of, keys = "dM at theta_1 = 82 deg", [one["key"] for one in told["varied"]]
    jacobian = scene.jacobian("dM", keys, theta_1=math.radians(82))
    deviation = [2e-3 / 3**0.5, 2e-3 / 3**0.5, math.radians(0.1) / 3**0.5, 1e-3, 0.5e-3, math.radians(0.1) / 3**0.5]
    for one, slope, size in zip(told["varied"], jacobian.reshape(-1), deviation):
        assert math.isclose(one["effects"][of]["exact"], slope * size, rel_tol=1e-12), one["key"]


def test_designs_that_cannot_be_are_rows(tmp_path):
    scene = package.Scene(PORTAL)
    study = scene.monte_carlo(64, vary={"luffing.balance.l_1": "± 40 %"}, outputs=["dM_max", "R at theta_1 = 60 deg"])
    refused = np.isnan(study["dM_max"])
    assert 0 < refused.sum() < 64 and set(study.faults) == set(np.flatnonzero(refused))
    assert not any(column[refused].any() for column in study.fails.values())
    design, reason = next(iter(study.faults.items()))
    with pytest.raises(package.SceneError, match=re.escape(reason.split(";")[0])):
        scene.replace({"luffing.balance.l_1": float(study["luffing.balance.l_1"][design])})
    path = tmp_path / "crane.toml"
    text = crane().replace('"normal ± 3 mm"', '"± 40 %"')
    path.write_text(text, encoding="utf-8")
    told = lemnis("sweep", path, "--csv", tmp_path / "rows.csv")
    table = list(csv.DictReader((tmp_path / "rows.csv").open(encoding="utf-8", newline="")))
    known = [row["refused"] for row in table if row["refused"]]
    share, often, of, first = re.search(r"refused: (\S+) % of all designs; (\d+) of (\d+) like this: (.*)", told).groups()
    assert len(table) == 64 and 0 < len(known) == int(of) and math.isclose(float(share), 100 * len(known) / 64, rel_tol=5e-3)
    # The first of those that differ by numbers alone, of which there are most.
    shapes = [re.sub(r"[-+.0-9]", "", reason) for reason in known]
    most = max(map(shapes.count, shapes))
    assert most == int(often) == shapes.count(re.sub(r"[-+.0-9]", "", first)) and first in known


def test_every_combination_in_order():
    scene = package.Scene.default()
    study = scene.sweep({"luffing.X_1": np.array([19.2, 19.3]), "luffing.Q": "160 kN, 170 kN or 180 kN"}, "M_Q_max")
    assert study["luffing.X_1"].tolist() == [19.2] * 3 + [19.3] * 3
    assert study["luffing.Q"].tolist() == [160e3, 170e3, 180e3] * 2
    with pytest.raises(package.SceneError, match="has no end of values"):
        scene.sweep({"luffing.X_1": "± 1 mm"}, "R_max")
    with pytest.raises(package.SceneError, match="`outputs` is missing"):
        package.Scene(PORTAL[: PORTAL.index("[study]")] + PORTAL[PORTAL.index("[luffing]") :]).sweep()
    with pytest.raises(TypeError, match="one dimension"):
        scene.sweep({"luffing.X_1": [[1.0, 2.0]]}, "R_max")


SLEWING = (ROOT / "models/scenes/slewing.toml").read_text(encoding="utf-8") + """
[study]
outputs = ["M_st_max", "M_st at psi_sl = 30 deg"]
n       = 16384
vary    = { "slewing.R" = "10 m to 32 m", "slewing.Q" = "± 10 kN", "slewing.M_Fsl" = "normal, sd 30 kN.m" }
"""


@pytest.mark.skipif(os.name == "nt", reason="Ctrl+C goes to the whole console there")
def test_what_was_broken_off_is_gone_on_with(tmp_path):
    path, rows, whole = tmp_path / "crane.toml", tmp_path / "rows.csv", tmp_path / "whole.csv"
    path.write_text(SLEWING, encoding="utf-8")
    assert "nothing to resume" in lemnis("sweep", path, "--csv", rows, "--resume", expect=3)
    command = [LEMNIS, "sweep", path, "--csv", rows]
    running = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, encoding="utf-8")
    while running.poll() is None and not any(part.read_bytes().count(b"\n") > 1 for part in tmp_path.glob("*.part")):
        time.sleep(0.01)
    running.send_signal(signal.SIGINT)
    out, told = running.communicate(timeout=60)
    assert running.returncode == 0 and "broken off after" in told and "--resume goes on" in out and not rows.exists()
    [part] = tmp_path.glob("*.part")
    kept = part.read_bytes()
    assert 1 < kept.count(b"\n") < 16_385
    lemnis("sweep", path, "--csv", whole)
    expected = whole.read_bytes()
    assert expected.startswith(kept) and expected.count(b"\n") == 16_385
    # A line that was not written to its end.
    part.write_bytes(kept + expected[len(kept) :][:20])
    lemnis("sweep", path, "--csv", rows, "--resume")
    assert rows.read_bytes() == expected and not list(tmp_path.glob("*.part"))
    # Of another scene nothing is gone on with, and what is no row is told.
    part.write_bytes(kept + b"1,2,3\n")
    assert "is no row of this study" in lemnis("sweep", path, "--csv", rows, "--resume", expect=3)
    path.write_text(SLEWING.replace("16384", "8192"), encoding="utf-8")
    assert "nothing to resume" in lemnis("sweep", path, "--csv", rows, "--resume", expect=3)


def test_inputs_stay_inputs():
    """An input starts at the values of the study, and is set by them."""
    scene = package.Scene(SLEWING)
    study = scene.monte_carlo(16)
    assert np.all(np.abs(study["slewing.Q"] - 16 * 9.81e3) <= 10e3) and study["slewing.Q"].std() > 3e3
    found = ~np.isnan(study["M_st_max"])
    assert set(np.flatnonzero(~found)) == set(np.flatnonzero(study["slewing.M_Fsl"] < 0)) == set(study.faults)
    for row in np.flatnonzero(found)[:4]:
        value = {key: float(study[key][row]) for key in ("slewing.R", "slewing.Q", "slewing.M_Fsl")}
        one = scene.replace(value)
        assert "{ input =" in one.text and one.summary()["M_st_max"].value == study["M_st_max"][row]


SLOW = """
import os, signal, sys, threading, time
import lemnis
scene = lemnis.Scene.read(sys.argv[1])
threading.Timer(0.5, os.kill, (os.getpid(), signal.SIGINT)).start()
try:
    scene.monte_carlo(1_000_000)
except KeyboardInterrupt:
    print("heard")
"""


@pytest.mark.skipif(os.name == "nt", reason="Ctrl+C goes to the whole console there")
def test_ctrl_c_is_heard():
    """In a study that takes minutes."""
    done = subprocess.run([sys.executable, "-c", SLOW, str(PATH)], capture_output=True, text=True, timeout=60)
    assert done.stdout == "heard\n", done.stderr


def test_arrow_reads_a_study(scene):
    import nanoarrow

    study = scene.monte_carlo(8)
    stream = nanoarrow.ArrayStream(study)
    fields = list(stream.schema.fields)
    assert [field.name for field in fields] == [*study, "fails", "refused"]
    assert {field.metadata[b"unit"] for field in fields[:-2]} == {b"m", b"rad", b"N", b"N.m"}


def test_parquet_has_what_the_csv_has(tmp_path):
    """Written and read by pyarrow: every bit, what fails, what is refused and why, and the units."""
    text = crane().replace('"normal ± 3 mm"', '"± 40 %"')
    (tmp_path / "crane.toml").write_text(text, encoding="utf-8")
    lemnis("sweep", tmp_path / "crane.toml", "--csv", tmp_path / "rows.csv")
    study = package.Scene(text).sweep()
    parquet.write_table(pyarrow.table(study), tmp_path / "rows.parquet")
    table = parquet.read_table(tmp_path / "rows.parquet")
    units = [f" [{(field.metadata or {}).get(b'unit', b'').decode()}]".replace(" []", "") for field in table.schema]
    with (tmp_path / "rows.csv").open(encoding="utf-8", newline="") as file:
        heads, *rows = csv.reader(file)
    assert heads == ["design", *(field.name + unit for field, unit in zip(table.schema, units))]
    columns = [table[name].to_pylist() for name in study]
    assert [[float(cell or "nan").hex() for cell in row[1:-2]] for row in rows] == [[v.hex() for v in row] for row in zip(*columns)]
    texts = [[text or "" for text in table[name].to_pylist()] for name in ("fails", "refused")]
    assert [row[-2:] for row in rows] == [list(row) for row in zip(*texts)] and all(map(any, texts))


def test_the_chapter_tells_what_the_command_tells(tmp_path):
    """Percentiles and shares as printed in the book."""
    path = tmp_path / "crane.toml"
    path.write_text(crane(256), encoding="utf-8")
    told = json.loads(lemnis("sweep", path, "--json"))
    lemnis("book", path, "--format", "typ", "--output", tmp_path)
    source = typst(tmp_path / "PortalCraneStudy.typ")
    chapter = source[source.index("Spread over many designs") :]
    assert "let count = [256]" in chapter
    [moment, angle, force, _] = told["outputs"]
    for output, factor, decimals in ((moment, 1e3, 1), (angle, math.pi / 180, 2), (force, 1e3, 0)):
        cells = ", ".join(f"[{output[key] / factor:.{decimals}f}]" for key in ("least", "p5", "p50", "p95", "greatest"))
        assert cells in re.sub(r"\],\s*\[", "], [", chapter), cells
    share = 100 * told["failed"] / 256
    assert f"{share:.3g} %" in chapter
