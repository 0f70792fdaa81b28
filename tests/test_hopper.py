"""The hopper of a crane in FMPy, both standards and both interfaces, and in the book: against exact fractions."""

from fractions import Fraction as F

import numpy as np
import pytest
from fmpy import read_model_description, simulate_fmu
from fmpy.validation import validate_fmu

from conftest import ROOT, lemnis, typst, words
from test_commands import Stepped, same_bits

ENDS = {"FMI 2": ".fmi2.fmu", "FMI 3": ".fmu"}
SCENE = ROOT / "models/scenes/hopper.toml"
# The scene's numbers in t and s.
MOST, START, FEED, POUR = F(24), F(10), F(450, 3600), F(1)
LOADS = [10, 70, 130, 310, 370, 430, 490, 610]
POURS = [(F(t), F(t + 8)) for t in LOADS]
STANDS = (F(330), F(510))


def by_hand(times):
    """Contents, mass brought, taken and spilled (t) at the times, with the times at which it gets full or empty: piece by
    piece between all that is told, each cut where the contents come to an end."""
    told = {t for pour in POURS for t in pour} | set(STANDS)
    held, brought, taken, spilled, now = START, F(0), F(0), F(0), F(0)
    ends, found = [], {}
    for time in sorted(told | {F(t) for t in times}):
        into = POUR if any(a <= now < b for a, b in POURS) else F(0)
        wanted = F(0) if STANDS[0] <= now < STANDS[1] else FEED
        left, gain = time - now, into - wanted
        room = (MOST - held) / gain if gain > 0 else held / -gain if gain < 0 else left
        free = min(left, room)
        if 0 < room < left:
            ends.append((now + free, "full" if gain > 0 else "empty"))
        held += gain * free
        brought += into * left
        taken += wanted * free + min(into, wanted) * (left - free)
        spilled += max(gain, F(0)) * (left - free)
        now = time
        found[time] = [held, brought, taken, spilled]
    return np.array([[float(value) * 1e3 for value in found[F(t)]] for t in times]), ends


NAMES = ["m_h", "m_in", "m_out", "m_s"]


@pytest.fixture(scope="module")
def fmus(tmp_path_factory):
    folder = tmp_path_factory.mktemp("hopper")
    lemnis("fmu", SCENE, "--output", folder)
    return {standard: str(folder / f"Hopper{end}") for standard, end in ENDS.items()}


def written(folder, name, changes):
    text = SCENE.read_text(encoding="utf-8").replace('name  = "Hopper"', f'name  = "{name}"')
    head, rest = text.split("q_in  = ", 1)
    rest = rest.split("[hopper.motion]", 1)[1]
    text = f"{head}{{told}}\n[hopper.motion]{rest}"
    for old, new in changes.items():
        assert old in text, old
        text = text.replace(old, new)
    path = folder / f"{name}.toml"
    path.write_text(text, encoding="utf-8")
    lemnis("fmu", path, "--output", folder)
    return {standard: str(folder / f"{name}{end}") for standard, end in ENDS.items()}


def test_what_the_scene_tells_by_hand():
    _, ends = by_hand([660])
    # From 16.75 t the feeder takes 134 s; in the last load but one 2.5 t fill it.
    assert ends == [(F(272), "empty"), (F("492.5"), "full")]
    assert by_hand([660])[0][0].tolist() == [13250.0, 64000.0, 55250.0, 5500.0]


@pytest.mark.parametrize("standard", ENDS)
def test_its_states_events_and_results(fmus, standard):
    assert not validate_fmu(fmus[standard])
    description = read_model_description(fmus[standard])
    variables = {variable.name: variable for variable in description.modelVariables}
    assert {variables[name].causality for name in ("q_in", "y_f", "q_out", "q_s", "full", "empty", "G_h", "t_run")} == {"output"}
    assert variables["m_max"].causality == "parameter" and variables["full"].type == "Boolean"
    assert int(description.numberOfEventIndicators) == 2
    assert int(description.numberOfContinuousStates) == 4
    assert float(description.defaultExperiment.stopTime) == 660.0


@pytest.mark.parametrize("kind", ["CoSimulation", "ModelExchange"])
@pytest.mark.parametrize("standard", ENDS)
def test_the_default_experiment(fmus, standard, kind):
    result = simulate_fmu(fmus[standard], fmi_type=kind, output_interval=1.0, relative_tolerance=1e-9, record_events=False,
                          output=[*NAMES, "q_out", "q_s", "full", "empty", "phi_h", "G_h"])
    assert result["time"][-1] == 660.0 and len(result) == 661
    wanted, ends = by_hand([round(t) for t in result["time"]])
    near = 1e-8 if kind == "CoSimulation" else 1e-3
    for name, value in zip(NAMES, wanted.T):
        assert np.abs(result[name] - value).max() <= near, (name, np.abs(result[name] - value).max())
    # What came is somewhere: to rounding in each of the importers' steps.
    apart = result["m_h"] + result["m_out"] + result["m_s"] - 10e3 - result["m_in"]
    assert np.abs(apart).max() <= 1e-12 * 74e3
    times = result["time"]
    # At 272 s it gets empty, a rounding before or after.
    assert set(times[result["empty"].astype(bool)]) - {272.0} == {float(t) for t in range(273, 310)}
    assert set(times[result["full"].astype(bool)]) == {float(t) for t in range(493, 510)}
    assert np.allclose(result["q_s"][(times > 492.5) & (times < 498.0)], 1000.0, rtol=1e-14)
    assert not result["q_out"][(times > 272.5) & (times < 309.5)].any()
    assert np.allclose(result["G_h"], result["m_h"] * 9.81, rtol=1e-14)


@pytest.mark.parametrize("standard", ENDS)
def test_any_communication_step_gives_the_same_bits(fmus, standard):
    found = same_bits(fmus[standard], 3700, 21)
    assert found[3700] != found[0]


@pytest.mark.parametrize("standard", ENDS)
def test_events_are_found_where_they_are(fmus, standard):
    """Just before and after each, in Co-Simulation."""
    _, ends = by_hand([660])
    fmu = Stepped(fmus[standard])
    times = [0.0] + [float(end) + by for end, _ in ends for by in (-1e-6, 1e-6)]
    rows = fmu.run(times, ["m_h", "m_s", "q_out"])[1:]
    fmu.close()
    assert rows[0][0] == pytest.approx(125e-6, abs=1e-9) and rows[1][0] == 0.0 and rows[1][2] == 0.0
    assert rows[2][0] == pytest.approx(24e3 - 1e-3, abs=1e-8) and rows[3][:2] == [24e3, pytest.approx(1e-3, abs=1e-8)]


INPUTS = [(name, float) for name in ("time", "q_in", "y_f")]


def driven(path, kind, rows):
    """A hopper under inputs, from 10 t on."""
    names = {v.name for v in read_model_description(path).modelVariables if v.causality == "input"}
    assert names == {"q_in", "y_f"}
    result = simulate_fmu(path, fmi_type=kind, stop_time=200.0, step_size=0.5, output_interval=0.5, relative_tolerance=1e-6,
                          input=np.array(rows, dtype=INPUTS), record_events=False, start_values={"m_h": 10e3, "y_f": 1.0},
                          output=["m_h", "m_in", "m_out", "m_s", "full", "empty"])
    apart = result["m_h"] + result["m_out"] + result["m_s"] - 10e3 - result["m_in"]
    assert len(result) == 401 and np.abs(apart).max() <= 1e-12 * 60e3
    return result


@pytest.mark.parametrize("standard", ENDS)
def test_inputs_that_grow_in_co_simulation(tmp_path, standard):
    """The feeder empties 10 t in 80 s; from 100 s on the flow from the grab grows by 2 kg/s², and after 62.5 s it is more
    than the feeder takes. FMPy holds an input over each step: the contents are a sum of these."""
    path = written(tmp_path, "Open", {"{told}": ""})[standard]
    result = driven(path, "CoSimulation", [(0.0, 0.0, 1.0), (100.0, 0.0, 1.0), (200.0, 200.0, 1.0)])
    wanted = [10e3]
    for step in range(400):
        into = 2.0 * max(0.0, step / 2 - 100.0)
        wanted.append(max(0.0, wanted[-1] + (into - 125.0) / 2))
    assert wanted[-1] > 1300.0 and np.abs(result["m_h"] - wanted).max() <= 1e-8


@pytest.mark.parametrize("standard", ENDS)
def test_inputs_that_jump_in_model_exchange(tmp_path, standard):
    """Empty at 80 s; from 100 s on 500 kg/s come in, and 375 kg/s stay: full at 164 s; at 180 s no more comes."""
    path = written(tmp_path, "Open", {"{told}": ""})[standard]
    jumps = [(0.0, 0.0), (100.0, 0.0), (100.0, 500.0), (180.0, 500.0), (180.0, 0.0), (200.0, 0.0)]
    result = driven(path, "ModelExchange", [(*row, 1.0) for row in jumps])
    held = np.interp(result["time"], [0.0, 80.0, 100.0, 164.0, 180.0, 200.0], [10e3, 0.0, 0.0, 24e3, 24e3, 21.5e3])
    spilled = np.interp(result["time"], [0.0, 164.0, 180.0, 200.0], [0.0, 0.0, 6e3, 6e3])
    assert np.abs(result["m_h"] - held).max() <= 1e-2 and np.abs(result["m_s"] - spilled).max() <= 1e-2
    within = [(80.0, 100.0, "empty"), (164.0, 180.0, "full")]
    for start, end, name in within:
        inside = (result["time"] > start) & (result["time"] < end)
        outside = (result["time"] < start) | (result["time"] > end)
        assert result[name][inside].all() and not result[name][outside].any(), name


@pytest.mark.parametrize("standard", ENDS)
def test_in_the_steady_balance_the_contents_come_back(tmp_path, standard):
    """At 480 t/h the feeder takes 8 t in 60 s: after each cycle the hopper holds what it did."""
    pours = ", ".join(f'["{60 * i} s", "3600 t/h"], ["{60 * i + 8} s", "0 t/h"]' for i in range(20))
    told = f'q_in = {{ between = "steps", over = [{pours}, ["1200 s", "0 t/h"]] }}'
    path = written(tmp_path, "Steady", {"{told}": told, '"450 t/h"': '"480 t/h"'})[standard]
    fmu = Stepped(path)
    rows = np.array(fmu.run([60.0 * i for i in range(21)], ["m_h", "q_g", "k_q", "t_c_max", "d_m"]))
    fmu.close()
    assert np.abs(rows[:, 0] - 10e3).max() <= 1e-9 * 10e3
    assert np.allclose(rows[:, 1:], [8e3 / 60.0, 1.0, 60.0, 8e3 * (1 - 8 / 60)], rtol=1e-14)


@pytest.mark.parametrize("language", ["en", "zh", "bg"])
def test_the_book_has_balance_and_cycle(language, tmp_path):
    lemnis("book", SCENE, "--language", language, "--format", "typ", "--output", tmp_path)
    book = typst(tmp_path / "Hopper.typ")
    known = words(language)
    for section in ("hopper_balance", "hopper_capacity", "hopper_contents", "hopper_times", "hopper_flow"):
        assert known["section"][section] in book, section
    for check in ("hopper_fed", "hopper_reserve", "hopper_weight", "hopper_cycles", "hopper_mass"):
        assert known["check"][check] in book, check
    for curve in ("hopper_weight", "hopper_run"):
        assert known["curve"][curve] in book, curve
    # 8 t every 60 s, over 450 t/h; 90 s of that and 8 t less 8 s of it.
    for number in ("480", "1.067", "64", "11.25", "18.25", "5.75"):
        assert (number.replace(".", ",") if language == "bg" else number) in book, number


@pytest.mark.parametrize("kind", ["CoSimulation", "ModelExchange"])
@pytest.mark.parametrize("standard", ENDS)
def test_contents_that_are_an_input(tmp_path, standard, kind):
    """Level static, with a grab too slow for the feeder: 8 t each 70 s, where the feeder takes 8.75 t."""
    changes = {"{told}": "", 'fidelity = "flow" ': 'fidelity = "static" ', 'm_h   = "10 t" ': "", '"60 s"': '"70 s"'}
    path = written(tmp_path, "Still", changes)[standard]
    assert not validate_fmu(path)
    inputs = np.array([(0.0, 0.0), (24.0, 24e3)], dtype=[("time", float), ("m_h", float)])
    result = simulate_fmu(path, fmi_type=kind, stop_time=24.0, step_size=1.0, output_interval=1.0, input=inputs,
                          output=["m_h", "G_h", "phi_h", "n_g", "t_run", "t_low", "t_full", "k_q", "m_res"])
    held = result["m_h"]
    assert held[-1] > 20e3
    wanted = {"G_h": held * 9.81, "phi_h": held / 24e3, "n_g": (24e3 - held) / 8e3, "t_run": held / 125.0,
              "t_low": held / (125.0 - 8e3 / 70.0), "k_q": 64.0 / 70.0, "m_res": 5750.0}
    for name, value in wanted.items():
        assert np.allclose(result[name], value, rtol=1e-13, atol=1e-9), name
    assert np.isinf(result["t_full"]).all()
