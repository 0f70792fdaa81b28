"""`lemnis trade`: a table, JSON, CSV and a diagram; the errors that it tells, by another solver; `fidelity = "auto"`."""

import csv
import hashlib
import json
import re
import tomllib
import zipfile

import fmpy
import fmpy.validation
import numpy as np
import pytest
from conftest import ROOT, lemnis, text_of

CRANE = (ROOT / "models/scenes/lemniscate.toml").read_text(encoding="utf-8")
DYNAMICS = (ROOT / "tests/levels/dynamics.toml").read_text(encoding="utf-8")
OIL = (ROOT / "tests/levels/hydraulics.toml").read_text(encoding="utf-8")


def scene(folder, fidelity, tables="", top="", name="scene"):
    """The default crane, quicker and over a part of its range."""
    text = CRANE.replace('driven = "boom" ', f'fidelity = "{fidelity}"\ndriven = "boom" ', 1)
    text = text.replace("[project]", f"{top}\n[project]", 1).replace("\n[luffing.limits]", f"\n{tables}\n[luffing.limits]", 1)
    text = text.replace('to    = "120 deg"', 'to    = "80 deg"', 1).replace('speed = "1 deg/s"', 'speed = "4 deg/s"', 1)
    # What was published of the whole range does not belong to a part of it.
    path = folder / f"{name}.toml"
    path.write_text(text.split("[luffing.published]")[0], encoding="utf-8")
    return path


def without(key, tables):
    return "\n".join(line for line in tables.splitlines() if not line.startswith(key)) + "\n"


SWING = DYNAMICS + 'l_R = "10 m"\n'
ACCURACY = 'accuracy = { "A.x" = "1 mm", "M_Q" = "0.5 kN.m" }'


def trade(path, folder, *arguments):
    text = lemnis("trade", path, "--output", folder, "--rounds", 1, *arguments)
    return text, json.loads((folder / "LemniscateCrane_trade.json").read_text(encoding="utf-8"))


def test_everything_is_written(tmp_path):
    path = scene(tmp_path, "swing", SWING, ACCURACY)
    text, found = trade(path, tmp_path / "out")
    assert {row["level"] for row in found["settings"]} == {"table", "static", "rigid", "swing"}
    assert all(reference["farthest_apart"]["part_of_range"] < 1e-9 for reference in found["references"][2:])
    assert found["choice"] in text and found["choice"].startswith("swing, RK4")
    rows = list(csv.DictReader((tmp_path / "out/LemniscateCrane_trade.csv").open(encoding="utf-8", newline="")))
    assert len(rows) == 2 * len(found["settings"])
    # Metres in JSON and in the units of the trade: the same numbers.
    for row, setting in zip(rows[::2], found["settings"]):
        assert row["result"] == "A.x" and row["unit"] == "m"
        assert float(row["total_max"]) == pytest.approx(setting["errors"]["A.x"]["total"]["max"], rel=1e-12)
    for row, setting in zip(rows[1::2], found["settings"]):
        assert row["unit"] == "kN.m"
        assert float(row["total_max"]) == pytest.approx(setting["errors"]["M_Q"]["total"]["max"] / 1e3, rel=1e-12)
    # The front: each dearer one is more accurate than all before it.
    worst = [max(row["errors"]["A.x"]["total"]["max"] / 1e-3, row["errors"]["M_Q"]["total"]["max"] / 500) for row in found["settings"]]
    costs = [row["cost"] for row in found["settings"]]
    assert costs == sorted(costs)
    front = [worst[i] for i, row in enumerate(found["settings"]) if row["front"]]
    assert len(front) >= 3 and all(b < 0.9 * a for a, b in zip(front, front[1:]))
    cheapest = next(row for row, off in zip(found["settings"], worst) if off < 0.99)
    assert cheapest["holds"] and (cheapest["level"], cheapest["setting"]["step"]) == ("swing", "100 ms")
    svg = (tmp_path / "out/LemniscateCrane_trade.svg").read_text(encoding="utf-8")
    assert svg.startswith("<svg") and len(svg) > 5000
    [page] = text_of(tmp_path / "out/LemniscateCrane_trade.pdf")
    assert "swing" in page and "error over what is allowed" in page


def test_counted_results_are_the_same_again(tmp_path):
    path = scene(tmp_path, "hydraulic", without("u_v", SWING + OIL), 'accuracy = { "p_A" = "1 bar" }')
    seconds = "seconds_per_second"
    found = [trade(path, tmp_path / str(i))[1] for i in range(2)]
    for trades in found:
        for row in trades["settings"] + trades["parts"]["left_out"]:
            assert row.pop(seconds) > 0
    assert found[0] == found[1]


@pytest.mark.parametrize("level", ["rigid", "swing"])
def test_errors_by_another_solver(tmp_path, level):
    """The error that `trade` tells of a coarse step, against FMPy with CVode on the same FMU's Model Exchange."""
    tables = (DYNAMICS if level == "rigid" else SWING) + 'M_A = "1800 kN.m"\nstep = "100 ms"\n'
    path = scene(tmp_path, level, tables, 'accuracy = { "A.x" = "1 mm" }')
    # Four seconds, before the bar meets its end stop.
    text = path.read_text(encoding="utf-8").replace('"80 deg"', '"120 deg"').replace('"4 deg/s"', '"15 deg/s"')
    path.write_text(text, encoding="utf-8")
    _, found = trade(path, tmp_path / "out")
    [row] = [row for row in found["settings"] if row["level"] == level and row["setting"] == {"step": "100 ms"}]
    told = row["errors"]["A.x"]["numerical"]
    assert found["motion"] == "M_A"
    lemnis("fmu", path, "--output", tmp_path)
    fmu = str(tmp_path / "LemniscateCrane.fmu")
    run = {"stop_time": 4.0, "output_interval": 0.1, "output": ["A.x"]}
    coarse = fmpy.simulate_fmu(fmu, fmi_type="CoSimulation", **run)
    fine = fmpy.simulate_fmu(fmu, fmi_type="ModelExchange", solver="CVode", relative_tolerance=1e-11, **run)
    off = np.abs(coarse["A.x"] - fine["A.x"])
    print(level, off.max(), told["max"])
    assert len(off) == 41 and found["duration"] == 4.0
    assert off.max() == pytest.approx(told["max"], rel=0.1) and told["max"] > 1e-8
    assert np.sqrt(np.mean(off**2)) == pytest.approx(told["rms"], rel=0.1)


def test_a_table_as_an_fmu(tmp_path):
    """The same results as of the closed form within the tolerance, in both standards; dimensions cannot be set."""
    closed, table = scene(tmp_path, "static", name="closed"), scene(tmp_path, "table", '[luffing.table]\ntol = "1e-7"\n', name="table")
    results = {}
    for path in (closed, table):
        folder = tmp_path / path.stem
        lemnis("fmu", path, "--output", folder)
        for suffix in ("fmu", "fmi2.fmu"):
            file = str(folder / f"LemniscateCrane.{suffix}")
            assert fmpy.validation.validate_fmu(file) == []
            for kind in ("CoSimulation", "ModelExchange"):
                results[path.stem, suffix, kind] = fmpy.simulate_fmu(file, fmi_type=kind, output_interval=0.01)
    for (_, suffix, kind), found in results.items():
        exact = results["closed", suffix, kind]
        for name in ("A.x", "A.y", "M_Q", "M_D", "V_AX", "F_d"):
            assert np.abs(found[name] - exact[name]).max() <= 1.01e-7 * np.ptp(exact[name]), name
    assert not np.array_equal(results["table", "fmu", "CoSimulation"]["A.x"], results["closed", "fmu", "CoSimulation"]["A.x"])
    description = fmpy.read_model_description(str(tmp_path / "table/LemniscateCrane.fmu"))
    boom = next(v for v in description.modelVariables if v.name == "X_1")
    assert (boom.causality, boom.variability) == ("calculatedParameter", "fixed")


def test_auto_is_the_cheapest_and_the_same_again(tmp_path):
    tables = without("u_v", SWING + OIL)
    cases = {
        'accuracy = { "A.x" = "2 m" }': ("table", set()),
        'accuracy = { "A.x" = "1 mm", "phi_R" = "0.1 deg" }': ("hydraulic", {"dynamics", "hydraulics"}),
    }
    for i, (top, (level, left)) in enumerate(cases.items()):
        path = scene(tmp_path, "auto", tables, top, name=f"auto{i}")
        hashes = []
        for again in range(2):
            folder = tmp_path / f"{i}{again}"
            text = lemnis("fmu", path, "--output", folder)
            assert f"the cheapest that keeps to the accuracy: {level}" in text
            hashes.append(hashlib.sha256((folder / "LemniscateCrane.fmu").read_bytes()).hexdigest())
        assert hashes[0] == hashes[1]
        with zipfile.ZipFile(folder / "LemniscateCrane.fmu") as archive:
            inside = tomllib.loads(archive.read("resources/scene.toml").decode("utf-8"))
        luffing = inside["luffing"]
        assert luffing["fidelity"] == level and {"dynamics", "hydraulics"} & set(luffing) == left
        assert fmpy.validation.validate_fmu(str(folder / "LemniscateCrane.fmu")) == []


def chosen(folder, name, asked, level):
    """The FMU of a ready scene whose level is left to an accuracy, the scene in it, and what is told."""
    text = (ROOT / f"models/scenes/{name}.toml").read_text(encoding="utf-8")
    text = text.replace('fidelity = "swing"', 'fidelity = "auto"').replace("[project]", f"accuracy = {{ {asked} }}\n\n[project]", 1)
    path = folder / "scene.toml"
    path.write_text(text, encoding="utf-8")
    told = lemnis("fmu", path, "--output", folder)
    assert f"the cheapest that keeps to the accuracy: {level}" in told
    file = str(folder / f'{tomllib.loads(text)["name"]}.fmu')
    assert fmpy.validation.validate_fmu(file) == []
    with zipfile.ZipFile(file) as archive:
        return file, tomllib.loads(archive.read("resources/scene.toml").decode("utf-8")), told


@pytest.mark.parametrize("asked, level, left", [("5 m", "table", set()), ("1 mm", "swing", {"hoisting", "slewing", "dynamics"})])
def test_auto_of_a_boom_leaves_out_what_no_accuracy_asks_for(tmp_path, asked, level, left):
    """A boom that slews beside its table: parts at the top of the scene go with a level that has none."""
    file, inside, _ = chosen(tmp_path, "rope_slewing", f'"A.x" = "{asked}"', level)
    luffing = inside["luffing"]
    assert luffing["fidelity"] == level and {"hoisting", "slewing", "dynamics"} & (set(luffing) | set(inside)) == left
    assert np.isfinite(fmpy.simulate_fmu(file, stop_time=2.0)["A.x"]).all()


@pytest.mark.parametrize("asked, level", [('"M_st" = "9000 kN.m"', "rigid"), ('"phi_R" = "0.1 deg"', "swing")])
def test_auto_of_slewing_leaves_out_what_no_accuracy_asks_for(tmp_path, asked, level):
    file, inside, told = chosen(tmp_path, "slewing_swing", asked, level)
    slewing = inside["slewing"]
    assert slewing["fidelity"] == level and ("l_R" in slewing) == (level == "swing") and {"M_sl", "psi_min"} <= set(slewing)
    # The scene gives no step; what was chosen by its work runs with that.
    assert slewing["dynamics"]["step"] in told
    assert np.isfinite(fmpy.simulate_fmu(file, stop_time=2.0)["M_st"]).all()


@pytest.mark.parametrize("name, level", [("slewing_swing", "swing"), ("slewing_cycle", "swing"), ("slewing_coupling", "rigid")])
def test_what_has_its_step_as_a_key_is_traded_too(tmp_path, name, level):
    """Two codes agree on the motion, and errors fall with the fourth power of the step where they are more than roundings."""
    lemnis("trade", ROOT / f"models/scenes/{name}.toml", "--output", tmp_path)
    [path] = tmp_path.glob("*_trade.json")
    told = json.loads(path.read_text(encoding="utf-8"))
    [reference] = [row for row in told["references"] if row["level"] == level]
    assert reference["farthest_apart"]["part_of_range"] < 1e-12
    errors = {float(row["setting"]["step"].removesuffix(" ms")): row["errors"]["psi_sl"]["numerical"]["max"] / told["results"]["psi_sl"]["range"]
              for row in told["settings"] if row["level"] == level}
    steps = sorted(errors, reverse=True)
    assert steps == [100.0, 50.0, 20.0, 10.0, 5.0, 2.0] and errors[2.0] < 1e-13
    fourth = [errors[b] / errors[a] / (b / a) ** 4 for a, b in zip(steps, steps[1:]) if errors[b] > 1e-11]
    assert all(0.4 < part < 1.6 for part in fourth) and (len(fourth) >= 2) == (level == "swing"), fourth


@pytest.mark.parametrize("name, moves, result", [("container_bridge", "x_t", "F_r"), ("bridge_slings", "x_t", "F_r"), ("hopper", "m_h", "q_in")])
def test_commands_in_steps_are_compared_at_their_jumps(tmp_path, name, moves, result):
    """A command jumps at communication steps, and what follows from it at once: two codes agree there too, also on what resists a
    trolley whose speed has come back to rest but for its rounding."""
    lemnis("trade", ROOT / f"models/scenes/{name}.toml", "--output", tmp_path, "--rounds", 1)
    [path] = tmp_path.glob("*_trade.json")
    told = json.loads(path.read_text(encoding="utf-8"))
    [moving] = [reference["farthest_apart"] for reference in told["references"] if reference["farthest_apart"]]
    assert moving["part_of_range"] < 1e-10
    assert told["results"][moves]["range"] > 1.0 and told["results"][result]["range"] > 1.0
    finest = [row for row in told["settings"] if row["setting"] == {"step": "2 ms"}]
    assert len(finest) == 1 and finest[0]["errors"][result]["numerical"]["max"] == 0.0
    assert finest[0]["errors"][moves]["numerical"]["max"] < 1e-10 * told["results"][moves]["range"]


def test_what_nothing_keeps_to_is_said(tmp_path):
    path = scene(tmp_path, "auto", SWING, 'accuracy = { "A.x" = "1e-12 m" }')
    message = lemnis("fmu", path, "--output", tmp_path / "out", expect=1)
    assert "nothing keeps to the accuracy; nearest is swing, RK4" in message and "1e-12 m allowed" in message
    assert not (tmp_path / "out").exists()
    text, found = trade(path, tmp_path / "out")
    assert found["choice"] is None and "nothing keeps to the accuracy" in text


@pytest.mark.parametrize("name", ["rope_motion", "ellipsograph_motion", "curved_trunk_motion"])
def test_single_booms_have_a_trade(tmp_path, name):
    """Their hoist would lift for as long as the crane luffs by a plan, and rests; where the brake holds the boom against its
    motor nothing moves, in which two codes agree."""
    text = lemnis("trade", ROOT / f"models/scenes/{name}.toml", "--rounds", 1, "--output", tmp_path)
    assert "two codes agree" in text and ("a cycle" in text) == (name == "rope_motion")
    told = json.loads(next(tmp_path.glob("*.json")).read_text(encoding="utf-8"))
    swing = [row["errors"] for row in told["settings"] if row["level"] == "swing"]
    assert swing and all(error["total"]["max"] < 1e-4 for row in swing for error in row.values())


def test_a_steering_has_a_trade_too(tmp_path):
    text = lemnis("trade", ROOT / "models/scenes/car_4x2.toml", "--output", tmp_path, "--rounds", 1)
    assert "kinematic" in text and (tmp_path / "Car_trade.svg").exists()


def test_auto_of_a_steering(tmp_path):
    """A coarse demand is met by groups that stand as commanded, a finer one needs cylinders and PLC."""
    hydraulic = (ROOT / "models/scenes/boat_hoist_003_hydraulic.toml").read_text(encoding="utf-8")
    shorter = hydraulic.replace('to    = "20 deg" ', 'to    = "-9.8 deg" ').replace('fidelity = "hydraulic"', 'fidelity = "auto"')
    for allowed, level, tables in (("5 deg", "kinematic", set()), ("0.01 deg", "hydraulic", {"dynamics", "oil", "plc"})):
        path = tmp_path / f"{level}.toml"
        path.write_text(f'accuracy = {{ "theta[1]" = "{allowed}" }}\n{shorter}', encoding="utf-8")
        text, found = lemnis("trade", path, "--output", tmp_path, "--rounds", 1), None
        found = json.loads((tmp_path / "BoatHoistHydraulic_trade.json").read_text(encoding="utf-8"))
        assert found["choice"].startswith(level) and found["choice"] in text
        assert {row["level"] for row in found["settings"]} == {"kinematic", "hydraulic"}
        text = lemnis("fmu", path, "--output", tmp_path / level)
        assert f"the cheapest that keeps to the accuracy: {found['choice']}" in text
        fmu = str(tmp_path / level / "BoatHoistHydraulic.fmu")
        with zipfile.ZipFile(fmu) as archive:
            inside = tomllib.loads(archive.read("resources/scene.toml").decode("utf-8"))
        steering = inside["steering"]
        assert steering["fidelity"] == level and {"dynamics", "oil", "plc"} & set(steering) == tables
        if tables:
            [row] = [row for row in found["settings"] if row["holds"] and row["level"] == level][:1]
            assert f"{float(steering['oil']['tol']):e}" == f"{float(row['setting']['tol']):e}"
        assert fmpy.validation.validate_fmu(fmu) == []


def test_auto_of_a_steering_with_half_its_tables(tmp_path):
    text = (ROOT / "models/scenes/boat_hoist_003_hydraulic.toml").read_text(encoding="utf-8")
    text = text.replace('fidelity = "hydraulic"', 'fidelity = "auto"').split("[steering.plc]")[0]
    path = tmp_path / "half.toml"
    path.write_text(f'accuracy = {{ "theta[1]" = "1 deg" }}\n{text}', encoding="utf-8")
    assert 'fidelity = "auto" without [steering.plc]' in lemnis("check", path, expect=1)


def test_steps_by_the_clock(tmp_path):
    """The default crane in steps of a millisecond, a million of each level: what the last line says follows from the table."""
    text = lemnis("trade", "--realtime")
    rows = [line.split() for line in text.splitlines()[3:-1]]
    assert [row[0] for row in rows] == ["table", "static"] and "1000000 communication steps of 1 ms" in text
    for _, median, nearly_all, worst, rates, most in rows:
        assert 0.0 < float(median) <= float(nearly_all) <= float(worst) and rates == most == "0"
    keeps = [row[0] for row in rows if float(row[3]) < 1000]
    assert text.splitlines()[-1].strip() == (
        f"the largest model that keeps to a step of 1 ms on this machine: {keeps[-1]}" if keeps
        else "no model keeps to a step of 1 ms on this machine: take a longer --step")
    assert "cannot be used with" in lemnis("trade", "--realtime", "--rounds", 2, expect=2)


def test_what_slews_alone_has_steps_by_the_clock():
    """Its own moment turns it."""
    scene = ROOT / "models/scenes/slewing_swing.toml"
    rows = [line.split() for line in lemnis("trade", scene, "--realtime").splitlines()[3:-1]]
    assert [row[0] for row in rows] == ["static", "rigid", "swing"]
    # Four evaluations of RK4 in a quiet step.
    assert all(int(row[5]) % 4 == 0 and int(row[5]) >= 4 for row in rows[1:])


def test_parts_are_left_out_one_by_one(tmp_path):
    """What leaving the air or slewing out costs, against FMPy on FMUs of scenes that people would write without them."""
    container = (ROOT / "models/scenes/container_in_wind.toml").read_text(encoding="utf-8")
    lemnis("trade", ROOT / "models/scenes/container_in_wind.toml", "--output", tmp_path, "--rounds", 1)
    told = json.loads((tmp_path / "ContainerInWind_trade.json").read_text(encoding="utf-8"))
    found = {part["without"]: part for part in told["parts"]["left_out"]}
    assert set(found) == {"luffing.balance", "luffing.drive", "luffing.air", "luffing.slewing"}
    table = {name: re.search(rf"^\[luffing\.{name}\].*?(?=^\[)", container, re.DOTALL | re.MULTILINE)[0] for name in ("air", "slewing")}
    fewer = {"air": container.replace(table["air"], ""),
             # The wind of a crane that does not slew has no direction.
             "slewing": re.sub(r"chi_air = \{.*?\] \}\n", "", container.replace(table["slewing"], ""), flags=re.DOTALL)}
    names = ["theta_1", "A.x", "A.y", "V_AX", "V_AY"]
    runs = {}
    for name, text in {"all": container, **fewer}.items():
        (tmp_path / f"{name}.toml").write_text(text, encoding="utf-8")
        lemnis("fmu", tmp_path / f"{name}.toml", "--output", tmp_path / name)
        path = str(tmp_path / name / "ContainerInWind.fmu")
        runs[name] = fmpy.simulate_fmu(path, stop_time=told["duration"], step_size=0.1, output_interval=0.1, output=names,
                                       start_values={"step": 1e-3}, record_events=False)
    for name in fewer:
        for result in names:
            off = np.abs(runs[name][result] - runs["all"][result]).max()
            assert off == pytest.approx(found[f"luffing.{name}"]["errors"][result]["max"], rel=1e-6), (name, result)
    assert found["luffing.air"]["cost"] < 0.5 * next(row["cost"] for row in told["settings"] if row["level"] == "swing")
    # A drive whose moment is told on the bar changes nothing of the motion.
    assert all(error["max"] == 0.0 for error in found["luffing.drive"]["errors"].values())


def test_keys_are_parts_too(tmp_path):
    """Of what belongs to a cylinder's oil: each by the keys that go together, and the load's rope. The pump's limits against FMPy on
    a scene that people would write without them."""
    scene = ROOT / "models/scenes/luffing_cylinder.toml"
    lemnis("trade", scene, "--output", tmp_path, "--rounds", 1)
    told = json.loads((tmp_path / "LuffingCylinder_trade.json").read_text(encoding="utf-8"))
    found = {part["without"]: part["errors"] for part in told["parts"]["left_out"]}
    oil = {f"luffing.hydraulics.{keys}" for keys in ("p_ac, k_ac", "p_lh, i_lh, dp_lh, x_T, y_b1", "Q_Pmax, P_Pmax", "p_tank")}
    assert set(found) == oil | {"luffing.dynamics.l_R"}
    names, runs = ["theta_1", "A.x", "A.y"], {}
    text = scene.read_text(encoding="utf-8")
    for name, without in (("all", text), ("unlimited", re.sub(r"(?m)^[QP]_Pmax .*\n", "", text))):
        (tmp_path / f"{name}.toml").write_text(without, encoding="utf-8")
        lemnis("fmu", tmp_path / f"{name}.toml", "--output", tmp_path / name)
        runs[name] = fmpy.simulate_fmu(str(tmp_path / name / "LuffingCylinder.fmu"), stop_time=told["duration"], step_size=0.1,
                                       output_interval=0.1, output=names, start_values={"tol": 1e-8}, record_events=False)
    for name in names:
        off = np.abs(runs["unlimited"][name] - runs["all"][name]).max()
        assert off == pytest.approx(found["luffing.hydraulics.Q_Pmax, P_Pmax"][name]["max"], rel=1e-4), name


def test_a_part_that_gives_less_than_is_allowed_is_named(tmp_path):
    """By a choice of the level, too. In still air the load's damping alone moves the head by 0.37 m within 76 s."""
    calm = (ROOT / "models/scenes/container_in_wind.toml").read_text(encoding="utf-8")
    calm = re.sub(r"v_air = \{.*?\] \}\nchi_air = \{.*?\] \}\n", "", calm, flags=re.DOTALL).replace('c_wQ  = "1.2"\nA_Q   = "15 m2"\n', "")
    calm = calm.replace('fidelity = "swing" ', 'fidelity = "auto" ').replace("[luffing]", 'accuracy = { "A.x" = "%s" }\n\n[luffing]', 1)
    for allowed, named in (("500 mm", True), ("200 mm", False)):
        (tmp_path / "calm.toml").write_text(calm % allowed, encoding="utf-8")
        for command in ("trade", "fmu"):
            told = lemnis(command, tmp_path / "calm.toml", "--output", tmp_path)
            assert ("without luffing.air the results keep to the accuracy too" in told) == named, (command, allowed, told)


def test_short_communication_steps_are_the_longest_inner_ones(tmp_path):
    """Below all steps that are tried otherwise, too: a level always has a setting, and parts are left out of the deepest."""
    told = lemnis("trade", ROOT / "models/scenes/container_in_wind.toml", "--step", "0.001", "--rounds", 1, "--output", tmp_path)
    found = json.loads((tmp_path / "ContainerInWind_trade.json").read_text(encoding="utf-8"))
    assert [(row["level"], row["setting"]) for row in found["settings"] if row["setting"]] == [
        ("rigid", {"step": "1 ms"}), ("swing", {"step": "1 ms"})]
    assert found["parts"]["setting"] == "swing, RK4, step = 1 ms" and "nothing was measured" not in told
    off = {part["without"]: part["errors"]["A.x"]["max"] for part in found["parts"]["left_out"]}
    assert off["luffing.drive"] == 0.0 < min(off[f"luffing.{part}"] for part in ("air", "balance", "slewing"))


def test_steps_that_the_solver_refuses_are_told(tmp_path):
    """A rope on which the load is put down is too stiff for steps of 0.1 s: the other settings are compared all the same."""
    path = ROOT / "models/scenes/load_on_ground.toml"
    text = lemnis("trade", path, "--output", tmp_path, "--rounds", 1)
    found = json.loads((tmp_path / "LoadOnGround_trade.json").read_text(encoding="utf-8"))
    [refused] = found["refused"]
    assert refused["setting"] == "swing, RK4, step = 100 ms" and "too long for the motion" in refused["fault"]
    assert f"refused at {refused['setting']}: {refused['fault']}" in text
    steps = {row["setting"]["step"] for row in found["settings"] if row["level"] == "swing"}
    assert steps == {"50 ms", "20 ms", "10 ms", "5 ms", "2 ms"}
    assert any(row["front"] and row["level"] == "swing" for row in found["settings"])
    # So is an FMU with this step, at its key.
    scene = tmp_path / "coarse.toml"
    scene.write_text(path.read_text(encoding="utf-8").replace("[luffing.dynamics]", '[luffing.dynamics]\nstep = "100 ms"', 1), encoding="utf-8")
    message = lemnis("fmu", scene, "--output", tmp_path, expect=1)
    assert "too long for the motion" in message and 'step = "50 ms" runs' in message
