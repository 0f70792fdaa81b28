"""The Python package: the numbers of the program and the FMU, exact derivatives, and nothing that harms the interpreter."""

import doctest
import importlib
import json
import multiprocessing
import pickle
import re
import signal
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest
from conftest import ROOT
from fmpy import simulate_fmu

import lemnis
from lemnis import program

sys.path.insert(0, str(ROOT / "tests/oracles"))

SCENES = ROOT / "models/scenes"
STANDING = ["lemniscate", "rope_compensation", "boat_hoist_003", "slewing"]
MOVING = ["portal_004_motion", "rope_motion"]
MODULES = ["lemnis", "lemnis.errors", "lemnis.scene", "lemnis.study", "lemnis.table"]


@pytest.fixture(scope="module")
def scene():
    return lemnis.Scene.default()


@pytest.fixture(scope="module")
def moving():
    return lemnis.Scene.read(SCENES / "portal_004_motion.toml")


def same(one, other):
    """Whether two arrays have the same bits, but for the sign of zero."""
    one, other = np.asarray(one, float) + 0.0, np.asarray(other, float) + 0.0
    return one.shape == other.shape and one.tobytes() == other.tobytes()


def infinite(values):
    """In JSON, infinite values are null."""
    return [np.nan if value is None else value for value in values]


@pytest.mark.parametrize("name", STANDING + MOVING)
def test_results_are_those_of_the_program(name):
    path = SCENES / f"{name}.toml"
    done = subprocess.run([program.path(), "check", "--json", path], capture_output=True, check=True)
    told = json.loads(done.stdout)
    scene = lemnis.Scene.read(path)
    table = scene.results()
    assert sorted(table) == sorted(told["variables"]) and scene.level == told["level"]
    for name, column in table.items():
        known = told["variables"][name]
        finite = np.where(np.isfinite(column), column, np.nan)
        assert same(finite, infinite(known["values"])), name
        assert table.units[name] == known["unit"]
    summary = scene.summary()
    assert {name: known["value"] for name, known in told["summary"].items()} == {
        name: result.value if np.isfinite(result.value) else None for name, result in summary.items()
    }
    checks = [(check["check"], check["passed"], check["limit"]) for check in told["checks"]]
    assert checks == [(check.id, check.passed, check.limit) for check in scene.checks()] and checks


@pytest.mark.parametrize("name", STANDING + MOVING)
def test_values_at_the_positions_of_the_table_are_those_of_the_table(name):
    scene = lemnis.Scene.read(SCENES / f"{name}.toml")
    table = scene.results()
    coordinate = next(iter(scene.variables))
    outputs = [name for name in table if scene.variables[name].role == "output"]
    again = scene.evaluate({coordinate: table[coordinate]}, outputs=outputs)
    assert all(same(again[name], table[name]) for name in outputs) and outputs


def test_a_dimension_that_is_set_is_one_that_the_scene_gives(scene):
    """Whether a key is set in the model or written into the scene, which is read again: the same bits."""
    theta_1 = scene.results()["theta_1"]
    for key, quantity in scene.quantities.items():
        value = 1.001 * quantity.value if quantity.value else 0.01
        try:
            set_ = scene.evaluate({key: value}, theta_1=theta_1)
        except lemnis.ModelError as error:
            assert "itself" in str(error) or "not given" in str(error), key
            continue
        read = scene.replace({key: value}).evaluate(theta_1=theta_1)
        assert all(same(set_[name], read[name]) for name in read), key


def test_the_keys_that_stand_by_themselves_are_many(scene):
    free = [key for key in scene.quantities if key.startswith("luffing.X_") or ".weights." in key]
    found = scene.jacobian("M_D", free, theta_1=1.2)
    assert found.shape == (1, len(free)) and len(free) == 17
    # Where the crane slews has nothing to do with the moment that holds its boom.
    assert [key for key, by in zip(free, found[0]) if by == 0.0] == ["luffing.X_8"]


def test_derivatives_are_those_of_fifty_digits(scene):
    """By central differences of 1e-30 of an independent calculation with 120 digits, at ten places."""
    from lemniscate_derivatives import OUTER, SCENE, results
    from mpmath import mpf

    of, wrt = ["R", "A.y", "theta_3", "M_Q", "F_d"], ["theta_1", "X_2", "luffing.weights.G_1"]
    places = np.linspace(0.9, 2.0, 10)
    found = scene.jacobian(of, wrt, theta_1=places)
    for place, derivatives in zip(places, found):
        theta_1 = mpf(float(place))
        for j, name in enumerate(wrt):
            known = name.split(".")[-1]
            moved = [
                results(SCENE, theta_1 + step) if known == "theta_1" else results({**SCENE, known: SCENE[known] + step}, theta_1)
                for step in (OUTER, -OUTER)
            ]
            exact = [float((moved[0][name] - moved[1][name]) / (2 * OUTER)) for name in of]
            assert np.allclose(derivatives[:, j], exact, rtol=1e-12, atol=1e-9 * (known == "G_1"))


def test_rates_have_derivatives_by_states_and_commands(moving):
    """Against differences of the rates themselves, which are linear in the command."""
    place = {"theta_1": 1.1, "omega_1": 0.02, "M_A": 4e5}
    rate = "der(omega_1)"
    (exact,) = moving.jacobian(rate, ["omega_1", "M_A", "theta_1"], place)
    for j, (name, step) in enumerate([("omega_1", 1e-6), ("M_A", 1e3), ("theta_1", 1e-6)]):
        low, high = moving.evaluate({**place, name: place[name] + np.array([-step, step])}, outputs=rate)[rate]
        assert (high - low) / (2 * step) == pytest.approx(exact[j], rel=1e-7)


@pytest.mark.parametrize("fmi", [2, 3])
def test_the_fmu_gives_the_same_bits(scene, moving, tmp_path, fmi):
    path = scene.fmu(tmp_path / "crane.fmu", fmi=fmi)
    found = simulate_fmu(str(path), stop_time=5.0, output_interval=1.0, start_values={"Q": 120e3}, output=["theta_1", "R", "M_D"])
    table = scene.evaluate(theta_1=found["theta_1"], Q=120e3, outputs=["R", "M_D"])
    assert same(found["R"], table["R"]) and same(found["M_D"], table["M_D"])
    path = moving.fmu(tmp_path / "moving.fmu", fmi=fmi)
    outputs, start = ["theta_1", "omega_1", "R", "phi_R"], {"M_A": 6e5}
    outputs = [name for name in outputs if name in moving.variables]
    found = simulate_fmu(str(path), stop_time=3.0, output_interval=0.1, start_values=start, output=outputs)
    table = moving.simulate(3.0, step=0.1, start=start, outputs=outputs)
    assert len(outputs) >= 3 and np.ptp(table["theta_1"]) > 0
    assert all(same(found[name], table[name]) for name in outputs)


def test_a_folder_is_no_file(scene, tmp_path):
    with pytest.raises(IsADirectoryError, match=r"is a folder: give the file too, such as .*LemniscateCrane\.fmi2\.fmu"):
        scene.fmu(tmp_path, fmi=2)
    assert not any(tmp_path.iterdir())


def test_inputs_of_a_run_are_functions_or_arrays(moving):
    at = np.array([0.0, 1.0, 2.0])
    values = np.array([0.0, 6e5, 6e5])
    one = moving.simulate(2.0, step=0.1, inputs={"M_A": (at, values)})
    other = moving.simulate(2.0, step=0.1, inputs={"M_A": lambda t: 6e5 * min(t, 1.0)})
    assert list(one)[0] == "time" and one.shape == (21,) and one["time"][-1] == 2.0
    assert np.allclose(one["theta_1"], other["theta_1"], rtol=1e-12)
    assert moving.simulate(2.0, step=0.3, outputs="R")["time"][-1] == 2.0


@pytest.mark.parametrize("step", [0.37, 1.0, 10.0])
def test_a_run_tells_when_slewing_comes_to_rest(step):
    """Coasting on level ground against Coulomb friction alone: t = (J_sl + m R²) omega_sl / M_Fsl, for every step."""
    text = (SCENES / "slewing.toml").read_text()
    for key, value in {"c_sl": "0 kN.m.s", "gamma_s": "0 deg"}.items():
        text, found = re.subn(rf'(?m)^{key}( *)= ".*?"', rf'{key}\1= "{value}"', text)
        assert found == 1
    table = lemnis.Scene.parse(text).simulate(40.0, step=step, start={"omega_sl": 0.05, "M_sl": 0.0}, outputs="omega_sl")
    (event,) = table.events
    assert event == (event.time, "z.sl_rest")
    assert event.time == pytest.approx((9e6 + 16e3 * 25.0**2) * 0.05 / 40e3, abs=1e-9)
    assert table["omega_sl"][table["time"] > event.time].tolist() == [0.0] * int(np.sum(table["time"] > event.time))


@pytest.mark.parametrize("name", ["load_on_ground", "slewing_coupling"])
def test_a_run_tells_the_events_that_an_importer_finds(name, tmp_path):
    """Model Exchange in FMPy, whose own solver finds them by event indicators: those, and the breaks of the commands."""
    scene = lemnis.Scene.read(SCENES / f"{name}.toml")
    table = scene.simulate()
    path = scene.fmu(tmp_path / "crane.fmu")
    stop = float(table["time"][-1])
    found = simulate_fmu(str(path), fmi_type="ModelExchange", stop_time=stop, record_events=True, relative_tolerance=1e-9)["time"]
    met = found[1:][np.diff(found) == 0.0]
    breaks = {float(at) for at in re.findall(r'^ *\["([\d.]+) s"', scene.text, re.M)}
    located = np.array([event.time for event in table.events])
    assert len(located) >= 3 and np.all(np.diff(located) > 0.0)
    assert all(name in scene.variables and scene.variables[name].role == "indicator" for _, name in table.events)
    assert all(np.min(np.abs(met - time)) < 5e-6 for time in located)
    others = [time for time in met if np.min(np.abs(located - time)) >= 5e-6]
    assert {round(float(time), 9) for time in others} <= breaks


def test_a_run_that_ends_says_why_and_keeps_what_came_before(scene):
    with pytest.raises(lemnis.RunEnded, match="the run ends at .* s: ") as ended:
        scene.simulate(20.0, step=1.0, inputs={"theta_1": lambda t: 1.2 + t}, outputs="R")
    assert 1 <= ended.value.table.shape[0] < 20 and np.isfinite(ended.value.table["R"]).all()


def test_rows_do_not_depend_on_threads_or_on_each_other(scene):
    random = np.random.default_rng(7)
    theta_1 = random.uniform(1.0, 2.0, 5000)
    X_1 = random.uniform(18.5, 20.0, 5000)
    inputs, outputs = {"theta_1": theta_1, "luffing.X_1": X_1}, ["R", "M_D", "F_d"]
    one, two = (scene.evaluate(inputs, outputs=outputs, threads=n, faults="nan") for n in (1, 2))
    order = random.permutation(5000)
    mixed = scene.evaluate({name: value[order] for name, value in inputs.items()}, outputs=outputs, faults="nan")
    single = scene.evaluate(theta_1=theta_1[7], X_1=X_1[7], outputs=outputs)
    for name in outputs:
        assert same(one[name], two[name]) and same(one[name][order], mixed[name]) and same(one[name][7], single[name])
    jacobians = [scene.jacobian(outputs, ["theta_1", "X_1"], inputs, threads=n) for n in (1, 2)]
    assert same(*jacobians)


def test_rows_that_do_not_exist_are_told(scene):
    theta_1 = np.array([[1.2, 1.3], [6.0, 5.0]])
    with pytest.raises(lemnis.ModelError, match=r"at \[1, 0\]$"):
        scene.evaluate(theta_1=theta_1)
    table = scene.evaluate(theta_1=theta_1, outputs="R", faults="nan")
    assert list(table.faults) == [2, 3] and "does not close" in table.faults[2]
    assert np.isnan(table["R"]).tolist() == [[False, False], [True, True]]
    # The first of many, however many threads look for it.
    many = np.full(20_000, 1.2)
    many[[777, 3000, 19_000]] = 6.0
    with pytest.raises(lemnis.ModelError, match=r"at \[777\]$"):
        scene.evaluate(theta_1=many)


def test_many_threads_share_a_scene(scene):
    theta_1 = np.linspace(1.0, 2.0, 300)
    wanted = scene.evaluate(theta_1=theta_1)
    with ThreadPoolExecutor(8) as pool:
        found = list(pool.map(lambda _: lemnis_work(scene, theta_1), range(64)))
    assert all(same(one, wanted["M_D"]) for one in found)


def lemnis_work(scene, theta_1):
    scene.jacobian("M_D", "luffing.X_1", theta_1=theta_1)
    return scene.evaluate(theta_1=theta_1)["M_D"]


@pytest.mark.parametrize("method", ["spawn"] if sys.platform == "win32" else ["fork", "spawn"])
def test_other_processes_take_a_scene(scene, method):
    theta_1 = np.linspace(1.0, 2.0, 3000)
    wanted = lemnis_work(scene, theta_1)
    with multiprocessing.get_context(method).Pool(2) as pool:
        found = pool.starmap(lemnis_work, [(scene, theta_1)] * 2)
    assert all(same(one, wanted) for one in found)


def test_a_scene_pickles_as_its_text(scene):
    again = pickle.loads(pickle.dumps(scene))
    assert again == scene and hash(again) == hash(scene) and len(pickle.dumps(scene)) < len(scene.text.encode()) + 200


def test_numbers_of_other_types_are_numbers_or_refused(scene):
    wanted = scene.evaluate(theta_1=np.array([1.0, 1.5]), outputs="R")["R"]
    assert same(scene.evaluate(theta_1=[1, 1.5], outputs="R")["R"], wanted)
    assert same(scene.evaluate(theta_1=np.array([1, 9, 1.5, 9])[::2], outputs="R")["R"], wanted)
    assert same(scene.evaluate(theta_1=np.array([1.5, 1])[::-1], outputs="R")["R"], wanted)
    assert same(scene.evaluate(theta_1=np.array([1, 1.5], np.float32), outputs="R")["R"], wanted)
    assert same(scene.evaluate(theta_1=np.array([1, 1.5], ">f8"), outputs="R")["R"], wanted)
    assert scene.evaluate(theta_1=np.empty((0, 3)), outputs="R")["R"].shape == (0, 3)
    assert scene.evaluate(theta_1=np.ones((2, 1)), Q=[1e5, 2e5, 3e5])["M_Q"].shape == (2, 3)
    for wrong in ["1.2", [1.0, "a"], [[1.0], [1.0, 2.0]], 1j, None, True, [None], {"a": 1.0}, b"1"]:
        with pytest.raises(TypeError, match="theta_1"):
            scene.evaluate(theta_1=wrong)
    with pytest.raises(ValueError, match="shapes that do not fit"):
        scene.evaluate(theta_1=[1.0, 1.1], Q=[1.0, 2.0, 3.0])
    for wrong in [np.nan, np.inf, -np.inf]:
        with pytest.raises(lemnis.ModelError, match="must be a finite number"):
            scene.evaluate(theta_1=wrong)
    with pytest.raises(lemnis.ModelError, match="did you mean `theta_1`"):
        scene.evaluate(theta1=1.2)
    with pytest.raises(lemnis.ModelError, match="is a result and cannot be set"):
        scene.evaluate(R=20.0)
    with pytest.raises(lemnis.ModelError, match="given twice"):
        scene.evaluate({"luffing.X_1": 19.0}, X_1=19.0)
    with pytest.raises(lemnis.ModelError, match="Q = -0.001 kN"):
        scene.evaluate(Q=[1.0, -1.0])
    with pytest.raises(lemnis.ModelError, match="no result"):
        scene.jacobian("Q", "theta_1")
    for wrong in [{"stop": -1.0}, {"step": np.nan}, {"step": 0.0}]:
        with pytest.raises(ValueError, match="must be positive"):
            scene.simulate(**wrong)


def test_a_wrong_scene_is_told_with_its_places(scene, tmp_path):
    text = scene.text.replace('"19.3 m"', '"起重机"').replace("X_2 =", "X2 =")
    path = tmp_path / "crane.toml"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(lemnis.SceneError) as wrong:
        lemnis.Scene.read(path)
    found = wrong.value.diagnostics
    assert len(found) == 3 and found == lemnis.diagnostics(text)
    assert {text[one.start : one.end] for one in found} > {'"起重机"', "X2"}
    for one in found:
        assert text.split("\n")[one.line - 1][one.column - 1 :].startswith(text[one.start : one.end].split("\n")[0])
    assert (wrong.value.line, wrong.value.column, wrong.value.help) == (found[0].line, found[0].column, found[0].help)
    told = str(wrong.value)
    assert f"{path}:{found[0].line}:{found[0].column}" in told and "did you mean `X_2`?" in told
    again = pickle.loads(pickle.dumps(wrong.value))
    assert str(again) == told and again.diagnostics == found
    # As the program tells it.
    done = subprocess.run([program.path(), "check", path], capture_output=True, encoding="utf-8")
    assert done.returncode == 1 and all(one.message in done.stderr for one in found)
    path.write_bytes(b"name = '\xff'")
    with pytest.raises(lemnis.SceneError, match="not text in UTF-8: byte 8"):
        lemnis.Scene.read(path)
    with pytest.raises(FileNotFoundError):
        lemnis.Scene.read(tmp_path / "nothing.toml")
    for text in ["", "[", "name = " + "[" * 10_000, "x" * (1 << 20) + "y", "\0", "a = 1\n" * 1000]:
        with pytest.raises(lemnis.SceneError):
            lemnis.Scene.parse(text)


def test_replaced_values_keep_comments(scene):
    changed = scene.replace({"luffing.X_1": "19.5 m", "luffing.X_2": np.float64(6.6), "luffing.motion.step": "2 deg", "name": "Other"})
    before, after = scene.text.splitlines(), changed.text.splitlines()
    differing = [(a, b) for a, b in zip(before, after) if a != b]
    assert len(before) == len(after) and len(differing) == 4
    assert all(a.partition("#")[2] == b.partition("#")[2] for a, b in differing)
    assert changed.quantities["luffing.X_2"].value == 6.6 and changed.name == "Other"
    assert scene.replace({"g": "9.80665 m/s2"}).quantities["g"].value == 9.80665
    # A list of tables, a note where a value comes from, and an input.
    hoist = lemnis.Scene.read(SCENES / "boat_hoist_003.toml")
    listed = next(key for key in hoist.quantities if "[2]" in key and hoist.quantities[key].given)
    assert hoist.replace({listed: 1.25 * hoist.quantities[listed].value}).quantities[listed].value == 1.25 * hoist.quantities[listed].value
    noted = scene.replace({"luffing.X_1": "19.4 m"})
    noted = lemnis.Scene.parse(noted.text.replace('"19.4 m"', '{ value = "19.4 m", source = "drawing" }'))
    assert 'X_1 = "19.6 m"' in noted.replace({"luffing.X_1": 19.6}).text
    slewing = lemnis.Scene.read(SCENES / "slewing.toml")
    assert 'R     = { input = "20 m" }' in slewing.replace({"slewing.R": 20.0}).text
    with pytest.raises(lemnis.SceneError, match="did you mean `X_1`"):
        scene.replace({"luffing.X_11": "19 m"})
    with pytest.raises(lemnis.ModelError, match="no quantity that this scene gives"):
        scene.replace({"luffing.driven": 3.0})
    for wrong in (True, None, [1.0]):
        with pytest.raises(TypeError, match="luffing.X_1"):
            scene.replace({"luffing.X_1": wrong})
    for wrong in ("", ".", "luffing.", "luffing[0].X_1", 'a."', "luffing[1].X_1"):
        with pytest.raises(lemnis.ModelError, match="no key"):
            scene.replace({wrong: "1 m"})


def test_what_is_left_open_is_decided_first(moving):
    text = moving.text.replace('fidelity = "swing"', 'fidelity = "auto"')
    scene = lemnis.Scene.parse('accuracy = { R = "1 m" }\n' + text)
    for ask in (scene.results, scene.evaluate, scene.checks, lambda: scene.jacobian("R", "theta_1")):
        with pytest.raises(lemnis.ModelError, match="decided"):
            ask()
    assert scene.decided().results().shape == moving.results().shape


def test_book_synthesis_and_measuring_come_from_the_program(scene, moving, tmp_path):
    book = scene.book(tmp_path / "deep/crane.pdf", language="bg")
    subprocess.run([program.path(), "book", "--language", "bg", "--output", tmp_path, "-"], input=scene.text.encode(), check=True, capture_output=True)
    assert book.read_bytes() == (tmp_path / f"{scene.name}.pdf").read_bytes()
    assert [path.name for path in book.parent.iterdir()] == ["crane.pdf"]
    found = lemnis.Scene.read(SCENES / "rope_luffing.toml").synth(seed=1)
    assert "residual of the conditions" in found.report and found.scene.name.endswith("_synth") and found.front == ()
    text = (SCENES / "rope_luffing.toml").read_text(encoding="utf-8")
    front = lemnis.Scene.parse(text.replace('"least T_max"', '"least T_max and least Delta_L_T"')).synth(seed=1).front
    assert len(front) > 1 and all(point["l_l_max [m]"] <= 100 for point in front)
    pulls, others = ([point[head] for point in front] for head in list(front[0])[:2])
    assert pulls == sorted(pulls) and others == sorted(others, reverse=True)
    assert found.scene.quantities["luffing.tackle.E_x"].value != lemnis.Scene.read(SCENES / "rope_luffing.toml").quantities["luffing.tackle.E_x"].value
    with pytest.raises(lemnis.SceneError, match="asks for no synthesis"):
        scene.synth()
    with pytest.raises(ValueError, match=".pdf or .html"):
        scene.book(tmp_path / "crane.doc")
    with pytest.raises(OSError, match="cannot read"):
        scene.fmu(tmp_path / "crane.fmu", platforms=tmp_path / "nowhere")
    assert not list(tmp_path.glob("*.fmu")) and not list(tmp_path.glob(".lemnis*"))


INTERRUPTED = {
    "evaluate": "[scene.evaluate(theta_1=np.linspace(1, 2, 1_000_000)) for _ in range(100)]",
    "simulate": "hydraulic.simulate(1e4, step=0.01)",
    "book": "moving.book(folder + '/crane.pdf', level='full')",
    "synth": "synthesis.synth()",
}


@pytest.mark.skipif(sys.platform == "win32", reason="a console has Ctrl+C, a test has not")
@pytest.mark.parametrize("what", INTERRUPTED)
def test_control_c_ends_what_takes_long(what, tmp_path):
    code = f"""
import numpy as np, lemnis, sys
scene = lemnis.Scene.default()
moving = lemnis.Scene.read({str(SCENES / "portal_crane.toml")!r})
hydraulic = lemnis.Scene.read({str(SCENES / "boat_hoist_003_hydraulic.toml")!r})
synthesis = lemnis.Scene.read({str(SCENES / "portal_004_synthesis.toml")!r})
folder = {str(tmp_path)!r}
print("ready", flush=True)
try:
    {INTERRUPTED[what]}
except KeyboardInterrupt:
    print("interrupted", flush=True)
    assert scene.evaluate(theta_1=1.2)["R"] > 0
    print("goes on", flush=True)
"""
    child = subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, text=True, start_new_session=True)
    assert child.stdout.readline() == "ready\n"
    time.sleep(0.5)
    started = time.monotonic()
    child.send_signal(signal.SIGINT)
    lines = [child.stdout.readline()]
    took = time.monotonic() - started
    lines.append(child.stdout.readline())
    assert lines == ["interrupted\n", "goes on\n"] and child.wait(30) == 0
    assert not list(tmp_path.iterdir())
    # A tenth of a second where nothing else runs.
    assert took < 2.0, f"{took:.3f} s"


def test_a_million_rows_take_little_memory():
    code = """
import resource, numpy as np, lemnis
scene = lemnis.Scene.default()
theta_1 = np.linspace(1.0, 2.0, 1_000_000)
scene.evaluate(theta_1=theta_1[:10_000], outputs="R")
before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
assert np.isfinite(scene.evaluate(theta_1=theta_1, outputs="R")["R"]).all()
print(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before)
"""
    if sys.platform != "linux":
        pytest.skip("memory is counted on Linux")
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    # Six copies of eight megabytes.
    assert int(done.stdout) < 48_000 * 1.3


def test_arrow_has_columns_and_units(scene):
    import nanoarrow

    table = scene.results()
    stream = nanoarrow.ArrayStream(table)
    fields = list(stream.schema.fields)
    assert [field.name for field in fields] == list(table)
    assert fields[0].metadata[b"unit"] == b"rad"
    batch = stream.read_all()
    for i, column in enumerate(table.values()):
        assert same(nanoarrow.Array(batch.child(i)).to_pylist(), column)


@pytest.mark.parametrize("name", MODULES)
def test_examples_in_docstrings_hold(name):
    module = importlib.import_module(name)
    found = doctest.testmod(module, optionflags=doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE)
    assert found.failed == 0


@pytest.mark.parametrize("document", ["README.md", "python/README.md"])
def test_the_examples_of_the_documents_run(document, scene, tmp_path):
    (tmp_path / "crane.toml").write_text(scene.text, encoding="utf-8")
    code = re.search(r"```python\n(import lemnis.*?)```", (ROOT / document).read_text(encoding="utf-8"), re.S)[1]
    code = code.replace('"models/scenes', f'"{SCENES.as_posix()}')
    subprocess.run([sys.executable, "-X", "utf8", "-c", code], check=True, cwd=tmp_path)
    assert (tmp_path / "crane.pdf").read_bytes().startswith(b"%PDF")


def test_what_is_public_is_described():
    for name in lemnis.__all__:
        one = getattr(lemnis, name)
        assert name == "__version__" or (one.__doc__ and "Mapping" not in one.__doc__[:8]), name
    for name, one in vars(lemnis.Scene).items():
        assert name.startswith("_") or (one.__doc__ or getattr(one, "__func__", one).__doc__), name


def test_types_are_as_told(tmp_path):
    for command in (["mypy", "--strict", "-p", "lemnis"], ["mypy.stubtest", "lemnis._lemnis"]):
        done = subprocess.run([sys.executable, "-m", *command], capture_output=True, text=True, cwd=tmp_path)
        assert done.returncode == 0, done.stdout + done.stderr


def test_the_command_lies_in_the_package(tmp_path):
    command = [sys.executable, "-m", "lemnis"]
    done = subprocess.run([*command, "--version"], capture_output=True, text=True, check=True)
    assert done.stdout == f"lemnis {lemnis.__version__}\n"
    subprocess.run([*command, "fmu", "--output", tmp_path], check=True, capture_output=True)
    assert len(list(tmp_path.glob("*.fmu"))) == 2


def test_the_module_does_without_typst():
    """So that building a wheel compiles it once, with the program."""
    done = subprocess.run(["cargo", "tree", "-p", "lemnis-python", "--prefix", "none"], capture_output=True, text=True, cwd=ROOT, check=True)
    assert "lemnis-models" in done.stdout and "typst" not in done.stdout


def test_a_notebook_shows_the_drawing(scene):
    shown = scene._repr_html_()
    assert "<svg" in shown and "epsilon_Y" in shown and "<table>" in scene.results()._repr_html_()
