"""The FMUs as a stranger uses them: from Python, with FMPy."""

import csv
import json
import math
import shutil
import subprocess
import sys
import zipfile
from pathlib import Path

import numpy as np
import pytest
from fmpy import extract, read_model_description, simulate_fmu
from fmpy.fmi1 import FMICallException
from fmpy.fmi2 import FMU2Slave, fmi2CallbackFunctions, fmi2CallbackLoggerTYPE
from fmpy.fmi3 import FMU3Slave
from fmpy.ssp.simulation import simulate_ssp
from fmpy.validation import validate_fmu

from conftest import ROOT, lemnis

TABLE = list(csv.DictReader(open(ROOT / "tests/oracles/lemniscate_table1.csv")))
# Column of the oracle, variable of the FMU, display units in an SI unit.
COLUMNS = [
    ("theta3_deg", "theta_3", 180 / math.pi),
    ("R_m", "R", 1),
    ("M_Q_kNm", "M_Q", 1e-3),
    ("alpha_deg", "alpha", 180 / math.pi),
    ("Y_A_m", "A.y", 1),
    ("alpha1_deg", "alpha_1", 180 / math.pi),
]


def compare_with_table(values):
    """All 366 values within 0.6 of the last printed unit; returns the largest deviation."""
    compared, worst = 0, 0.0
    for printed, computed in zip(TABLE, values, strict=True):
        for column, name, factor in COLUMNS:
            text = printed[column]
            last = 10.0 ** -len(text.partition(".")[2])
            deviation = abs(computed[name] * factor - float(text)) / last
            assert deviation <= 0.6, f"{name} at {printed['theta1_deg']} deg: {deviation} units"
            worst, compared = max(worst, deviation), compared + 1
    assert compared == 366
    return worst


class Slave:
    """An instance in Co-Simulation, the same for both standards."""

    def __init__(self, path, folder):
        self.messages = []
        description = read_model_description(path)
        self.references = {v.name: v.valueReference for v in description.modelVariables}
        fmi3 = description.fmiVersion.startswith("3")
        if not Path(folder).exists():  # never under a library that is loaded
            extract(path, unzipdir=folder)
        kind = FMU3Slave if fmi3 else FMU2Slave
        self.fmu = kind(
            guid=description.guid if not fmi3 else description.instantiationToken,
            unzipDirectory=folder,
            modelIdentifier=description.coSimulation.modelIdentifier,
            instanceName="test",
        )
        self.fmu.instantiate(**self.listener(fmi3))
        self.initialize()
        self.set = self.fmu.setFloat64 if fmi3 else self.fmu.setReal
        self.get = self.fmu.getFloat64 if fmi3 else self.fmu.getReal

    def listener(self, fmi3):
        """Arguments with which the FMU's messages come into `messages`."""
        if fmi3:
            return {"logMessage": lambda _, status, category, message: self.messages.append(message.decode("utf-8"))}
        # FMPy's own functions, but for the logger; the format has no conversions but doubled percent signs.
        callbacks = fmi2CallbackFunctions()
        callbacks.logger = fmi2CallbackLoggerTYPE(
            lambda _, instance, status, category, message: self.messages.append(message.decode("utf-8").replace("%%", "%")))
        return {"callbacks": callbacks}

    def initialize(self):
        if hasattr(self.fmu, "setupExperiment"):
            self.fmu.setupExperiment(startTime=0.0)
        self.fmu.enterInitializationMode()
        self.fmu.exitInitializationMode()

    def write(self, name, value):
        self.set([self.references[name]], [value])

    def read(self, name):
        return self.get([self.references[name]])[0]

    def step(self, time, size):
        self.fmu.doStep(currentCommunicationPoint=time, communicationStepSize=size)


@pytest.fixture
def slave(fmu, tmp_path):
    slave = Slave(fmu, str(tmp_path / "unzipped"))
    yield slave
    slave.fmu.terminate()
    slave.fmu.freeInstance()


def test_validate_reports_nothing(fmu):
    assert validate_fmu(fmu) == []


def test_validate_from_the_command_line(fmu):
    done = subprocess.run([sys.executable, "-m", "fmpy", "validate", fmu], capture_output=True, text=True)
    assert done.returncode == 0 and "No problems found" in done.stdout, done.stdout + done.stderr


def test_table_1_step_by_step(slave, capsys):
    """[Li2022, Table 1] with theta_1 as an input, one communication step for each row."""
    values = []
    for i, row in enumerate(TABLE):
        slave.write("theta_1", math.radians(float(row["theta1_deg"])))
        slave.step(float(i), 1.0)
        values.append({name: slave.read(name) for _, name, _ in COLUMNS})
    worst = compare_with_table(values)
    with capsys.disabled():
        print(f"\n  366 values of Table 1 through FMPy, largest deviation {worst:.3f} of the last printed unit")


@pytest.mark.parametrize("interface", ["CoSimulation", "ModelExchange"])
def test_default_experiment_is_the_working_range(fmu, interface):
    """Left alone, the crane luffs through its working range: Table 1 once more."""
    names = [name for _, name, _ in COLUMNS] + ["theta_1"]
    result = simulate_fmu(fmu, fmi_type=interface, output=names, output_interval=1.0)
    assert result["time"][0] == 0.0 and math.isclose(result["time"][-1], 60.0, rel_tol=1e-12)
    assert np.allclose(np.degrees(result["theta_1"]), np.arange(60, 121), atol=1e-9)
    compare_with_table(result)


@pytest.mark.parametrize("interface", ["CoSimulation", "ModelExchange"])
def test_simulate_with_an_input_signal(fmu, interface):
    signal = np.array([(0.0, math.radians(70), 1e5), (10.0, math.radians(110), 1e5)],
                      dtype=[("time", float), ("theta_1", float), ("Q", float)])
    result = simulate_fmu(fmu, fmi_type=interface, input=signal, stop_time=10.0, output=["R", "M_Q", "theta_1"],
                          output_interval=0.5)
    reach = {float(row["theta1_deg"]): float(row["R_m"]) for row in TABLE}
    assert abs(result["R"][0] - reach[70]) < 6e-5
    # In Co-Simulation FMPy holds an input over the step: the last one was set half a second before the end.
    last = 108 if interface == "CoSimulation" else 110
    assert math.isclose(math.degrees(result["theta_1"][-1]), last) and abs(result["R"][-1] - reach[last]) < 6e-5
    moment = {float(row["theta1_deg"]): float(row["M_Q_kNm"]) for row in TABLE}
    # The moment is proportional to the load: 100 kN instead of 160.
    assert abs(result["M_Q"][0] * 1.6 - moment[70] * 1e3) < 0.1


def test_vectors_are_their_parts(out):
    """FMI 3 has arrays: a point or a force as one variable, besides its parts."""
    fmu = str(out / "LemniscateCrane.fmu")
    vectors = [v.name for v in read_model_description(fmu).modelVariables if v.dimensions]
    assert {"A", "B", "C", "P", "F_B", "F_C"} <= set(vectors)
    parts = [f"{name}.{axis}" for name in vectors for axis in "xy"]
    result = simulate_fmu(fmu, output=vectors + parts, output_interval=1.0)
    for name in vectors:
        assert np.array_equal(result[name], np.column_stack([result[f"{name}.x"], result[f"{name}.y"]])), name


def test_simulate_from_the_command_line(fmu, tmp_path):
    target = tmp_path / "result.csv"
    command = [sys.executable, "-m", "fmpy", "simulate", fmu, "--output-file", str(target)]
    done = subprocess.run(command, capture_output=True, text=True, cwd=tmp_path)
    assert done.returncode == 0, done.stdout + done.stderr
    rows = list(csv.DictReader(open(target)))
    assert len(rows) >= 61 and float(rows[-1]["time"]) >= 59.999


def test_parameters_change_the_crane(fmu):
    """A rocker longer by 0.1 m, against the closed form of the law of cosines."""
    x1, x2, x3, x4, x5, x6, x7 = 19.3, 6.5, 14.8, 16.0, 6.4, 5.3, 1.354
    result = simulate_fmu(fmu, start_values={"X_3": x3, "theta_1": math.radians(80)}, stop_time=1.0,
                          output=["theta_3", "A.y"], fmi_type="CoSimulation")
    x56, theta_0, theta_1 = math.hypot(x5, x6), math.atan2(x6, x5), math.radians(80)
    l2 = x56**2 + x1**2 - 2 * x56 * x1 * math.cos(math.pi - theta_1 - theta_0)
    length = math.sqrt(l2)
    theta_3 = (math.acos((x3**2 + l2 - x2**2) / (2 * x3 * length))
               + math.acos((x56**2 + l2 - x1**2) / (2 * x56 * length)) - theta_0)
    assert abs(result["theta_3"][-1] - theta_3) < 1e-12
    c = (-x5 + x3 * math.cos(theta_3), x6 + x3 * math.sin(theta_3))
    b = (x1 * math.cos(theta_1), x1 * math.sin(theta_1))
    alpha = math.atan2(c[1] - b[1], c[0] - b[0]) - math.acos(x7 / x2) - math.acos(x7 / x4)
    assert abs(result["A.y"][-1] - (b[1] + x4 * math.sin(alpha))) < 1e-11


def test_out_of_reach_is_an_error_and_the_instance_survives(slave):
    slave.write("theta_1", math.radians(75))
    slave.step(0.0, 1.0)
    before = slave.read("R")
    slave.write("theta_1", math.radians(45))  # the linkage closes from 48.96 deg
    with pytest.raises(FMICallException):
        slave.step(1.0, 1.0)
    slave.fmu.reset()
    slave.initialize()
    slave.write("theta_1", math.radians(75))
    slave.step(0.0, 1.0)
    assert slave.read("R") == before


def test_the_fmu_has_the_bits_of_the_model(slave):
    """`lemnis check --json` prints the values of the model, whose bits the book has too (`models/tests/recorder.rs`)."""
    printed = json.loads(lemnis("check", "--json"))["variables"]
    for i, theta in enumerate(printed["theta_1"]["values"]):
        slave.write("theta_1", theta)
        slave.step(float(i), 1.0)
        for name, variable in printed.items():
            if name == "P.at_infinity" or variable["values"][i] is None:
                continue
            assert slave.read(name) == variable["values"][i], f"{name} at {theta}"


def test_the_same_scene_gives_the_same_bytes(out, tmp_path):
    lemnis("build", "--output", tmp_path)
    for name in ("LemniscateCrane.fmu", "LemniscateCrane.fmi2.fmu", "LemniscateCrane.pdf"):
        assert (tmp_path / name).read_bytes() == (out / name).read_bytes(), name


def test_the_fmu_holds_scene_and_book(fmu, out):
    with zipfile.ZipFile(fmu) as archive:
        names = archive.namelist()
        assert archive.read("resources/scene.toml") == (ROOT / "models/scenes/lemniscate.toml").read_bytes()
        assert archive.read("documentation/LemniscateCrane.pdf") == (out / "LemniscateCrane.pdf").read_bytes()
        assert not any("\\" in name for name in names)


def test_an_fmu_unpacked_elsewhere_still_finds_its_scene(out, tmp_path):
    """A path with spaces, percent signs and letters beyond ASCII."""
    place = tmp_path / "крановe 100 % 起重机"
    place.mkdir()
    for name in ("LemniscateCrane.fmu", "LemniscateCrane.fmi2.fmu"):
        copy = place / name
        shutil.copy(out / name, copy)
        result = simulate_fmu(str(copy), output=["R"], output_interval=1.0)
        assert abs(result["R"][0] - 29.9766) < 6e-5


def test_kinematic_scene_has_no_forces(tmp_path):
    """Only what the scene names is modelled."""
    text = (ROOT / "models/scenes/lemniscate.toml").read_text(encoding="utf-8")
    bare = text[: text.index("[luffing.weights]")].replace('Q = "160 kN"', "")
    scene = tmp_path / "bare.toml"
    scene.write_text(bare, encoding="utf-8")
    lemnis("fmu", scene, "--output", tmp_path)
    names = {v.name for v in read_model_description(str(tmp_path / "LemniscateCrane.fmu")).modelVariables}
    assert {"theta_1", "R", "V_AX"} <= names
    assert not {"Q", "M_Q", "M_D", "F_B.x", "G_1", "F_d", "L_d"} & names
    assert Path(tmp_path / "LemniscateCrane.fmi2.fmu").stat().st_size > 0


@pytest.mark.parametrize("end", [".fmu", ".fmi2.fmu"], ids=["FMI 3.0", "FMI 2.0"])
@pytest.mark.parametrize("scene, angle", [("lemniscate", "theta_1"), ("rope_luffing", "phi"), ("rope_compensation", "phi"), ("ellipsograph", "phi"), ("curved_trunk", "phi"), ("portal_004_tail", "theta_1")])
def test_every_input_may_be_zero(scene, angle, end, tmp_path):
    """A system of FMUs in which all connected inputs are zero in the first step, as FMPy's own systems do it."""
    text = (ROOT / f"models/scenes/{scene}.toml").read_text(encoding="utf-8")
    name = next(line.split('"')[1] for line in text.splitlines() if line.startswith("name"))
    for alone in (False, True):
        folder = tmp_path / str(alone)
        folder.mkdir()
        own = text.replace("[luffing.motion]", '[luffing.motion]\ninput = "s"') if alone else text
        (folder / "crane.toml").write_text(own, encoding="utf-8")
        lemnis("fmu", folder / "crane.toml", "--output", folder)
        path = folder / f"{name}{end}"
        assert validate_fmu(str(path)) == []
        variables = {v.name: v for v in read_model_description(str(path)).modelVariables}
        inputs = [v for v in variables.values() if v.causality == "input"]
        assert (angle in [v.name for v in inputs]) != alone and variables["s"].start in ("0", "0.0")
        slave = Slave(str(path), str(folder / "unpacked"))

        def step(at, zero):
            slave.set([v.valueReference for v in zero], [0.0] * len(zero))
            slave.fmu.doStep(currentCommunicationPoint=at, communicationStepSize=0.1)

        if not alone:
            # The angle of zero is none of this mechanism's, and the part of the range set after it counts.
            zero = [v for v in inputs if v.name != "s"] + [variables["s"]]
            slave.set([v.valueReference for v in zero], [0.0] * len(zero))
            slave.set([variables["s"].valueReference], [0.0])
        step(0.0, inputs if alone else [variables["s"]])
        start = slave.get([variables[angle].valueReference])[0]
        slave.set([variables["s"].valueReference], [1.0])
        slave.fmu.doStep(currentCommunicationPoint=0.1, communicationStepSize=0.1)
        end_angle, part = slave.get([variables[n].valueReference for n in (angle, "s")])
        table = {row.partition("=")[0].strip(): row.split('"')[1] for row in text.splitlines()
                 if row.partition("=")[0].strip() in ("from", "to")}
        expected = [math.radians(float(table[key].split()[0])) for key in ("from", "to")]
        assert [start, end_angle] == pytest.approx(expected, abs=1e-15) and part == 1.0


SYSTEM = """<?xml version="1.0" encoding="UTF-8"?>
<ssd:SystemStructureDescription xmlns:ssd="http://ssp-standard.org/SSP1/SystemStructureDescription"
    xmlns:ssc="http://ssp-standard.org/SSP1/SystemStructureCommon" version="1.0" name="Yard">
  <ssd:System name="Yard">
    <ssd:Connectors><ssd:Connector name="part" kind="input"><ssc:Real/></ssd:Connector></ssd:Connectors>
    <ssd:Elements>
      <ssd:Component name="crane" type="application/x-fmu-sharedlibrary" source="resources/crane.fmu">
        <ssd:Connectors>
          <ssd:Connector name="s" kind="input"><ssc:Real/></ssd:Connector>
          <ssd:Connector name="theta_1" kind="output"><ssc:Real unit="rad"/></ssd:Connector>
          <ssd:Connector name="M_Q" kind="output"><ssc:Real unit="N.m"/></ssd:Connector>
        </ssd:Connectors>
      </ssd:Component>
    </ssd:Elements>
    <ssd:Connections>
      <ssd:Connection startConnector="part" endElement="crane" endConnector="s"/>
    </ssd:Connections>
  </ssd:System>
</ssd:SystemStructureDescription>
"""


def test_a_system_of_fmus(tmp_path):
    """An SSP package in FMPy, which holds all connected inputs at zero in the first step."""
    text = (ROOT / "models/scenes/lemniscate.toml").read_text(encoding="utf-8")
    (tmp_path / "crane.toml").write_text(text.replace("[luffing.motion]", '[luffing.motion]\ninput = "s"'), encoding="utf-8")
    lemnis("fmu", tmp_path / "crane.toml", "--output", tmp_path)
    with zipfile.ZipFile(tmp_path / "yard.ssp", "w") as package:
        package.writestr("SystemStructure.ssd", SYSTEM)
        package.write(tmp_path / "LemniscateCrane.fmi2.fmu", "resources/crane.fmu")
    run = simulate_ssp(str(tmp_path / "yard.ssp"), stop_time=1.0, step_size=0.01, input={"part": lambda time: time + 0.01})
    theta, part = np.degrees(run["crane.theta_1"]), run["crane.s"]
    # From 60 to 120 deg; what was read in a step came of the part set before it.
    assert theta[0] == pytest.approx(60.0, abs=1e-12) and part[1] > 0.0
    assert theta[1:] == pytest.approx(60.0 + 60.0 * part[:-1], abs=1e-9)
    assert abs(run["crane.M_Q"]).max() > 1e4
