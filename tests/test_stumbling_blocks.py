"""What importers trip over, each a test; the rest of them are in `fmu/tests/abi.rs` and `tests/c/smoke.c`."""

import os
import re
import subprocess
import sys
import tomllib
import xml.etree.ElementTree as ElementTree
import zipfile
from concurrent.futures import ThreadPoolExecutor
from math import radians
from pathlib import Path

import pytest
from fmpy.fmi1 import FMICallException
from fmpy.fmi2 import FMU2Model, FMU2Slave
from fmpy.fmi3 import FMU3Model, FMU3Slave

from conftest import ROOT
from test_fmpy import Slave


@pytest.fixture
def slave(fmu, tmp_path):
    slave = Slave(fmu, str(tmp_path / "unzipped"))
    yield slave
    slave.fmu.freeInstance()


def test_every_way_to_name_the_resources(fmu, slave):
    """FMI 2: a URI with one or three slashes, with or without one at its end. FMI 3: a path. Or nothing at all."""
    folder = Path(slave.fmu.unzipDirectory, "resources").as_posix()
    fmu2 = isinstance(slave.fmu, FMU2Slave)
    places = [f"file://{folder}", f"file:{folder}", f"file://localhost{folder}", folder] if fmu2 else [folder]
    for place in [None, *places, *[f"{place}/" for place in places]]:
        where = place.encode() if place else None
        if fmu2:
            component = slave.fmu.fmi2Instantiate(b"again", 1, slave.fmu.guid.encode(), where, None, 0, 0)
            free = slave.fmu.fmi2FreeInstance
        else:
            component = slave.fmu.fmi3InstantiateModelExchange(
                b"again", slave.fmu.guid.encode(), where, False, False, None, slave.fmu.logMessage)
            free = slave.fmu.fmi3FreeInstance
        assert component, place
        free(component)


@pytest.mark.parametrize("kind", ["CoSimulation", "ModelExchange"])
def test_reset_from_every_state(fmu, tmp_path, kind):
    """As instantiated again: the same run gives the same bits."""
    crane = Slave(fmu, str(tmp_path / "unzipped"))
    fmu2 = isinstance(crane.fmu, FMU2Slave)
    if kind == "ModelExchange":
        crane.fmu.freeInstance()
        crane.fmu = (FMU2Model if fmu2 else FMU3Model)(
            guid=crane.fmu.guid, unzipDirectory=crane.fmu.unzipDirectory, modelIdentifier=crane.fmu.modelIdentifier,
            instanceName="test")
        crane.fmu.instantiate()
        crane.initialize()
        crane.set, crane.get = (crane.fmu.setReal, crane.fmu.getReal) if fmu2 else (crane.fmu.setFloat64, crane.fmu.getFloat64)
    model = crane.fmu

    def to_instantiated():
        pass

    def to_initialization():
        to_instantiated()
        if fmu2:
            model.setupExperiment(startTime=0.0)
        model.enterInitializationMode()

    def to_first_mode():
        to_initialization()
        crane.write("theta_1", radians(75))
        model.exitInitializationMode()

    def to_running():
        to_first_mode()
        if kind == "ModelExchange":
            (model.newDiscreteStates if fmu2 else model.updateDiscreteStates)()
            model.enterContinuousTimeMode()
            model.setTime(1.0)
        else:
            crane.step(0.0, 1.0)

    def to_error():
        to_running()
        crane.write("theta_1", radians(45))  # the linkage closes from 48.96 deg
        with pytest.raises(FMICallException):
            crane.step(1.0, 1.0) if kind == "CoSimulation" else crane.read("R")

    def to_terminated():
        to_running()
        model.terminate()

    model.reset()
    values = []
    for way in (to_instantiated, to_initialization, to_first_mode, to_running, to_error, to_terminated):
        way()
        model.reset()
        to_running()
        values.append((crane.read("theta_1"), crane.read("R"), crane.read("M_Q")))
        model.reset()
    assert values[0][0] == radians(75) and set(values) == {values[0]}
    model.freeInstance()


@pytest.mark.parametrize("kind", ["CoSimulation", "ModelExchange"])
def test_no_importer_loops_on_a_configuration_out_of_reach(fmu, kind, tmp_path):
    """FMPy asks after fmi2Discard whether to end, and else steps for ever: here it ends, with the message."""
    code = f"""
import numpy, fmpy
signal = numpy.array([(0.0, 1.2), (10.0, 0.7)], dtype=[("time", float), ("theta_1", float)])
fmpy.simulate_fmu({fmu!r}, fmi_type={kind!r}, input=signal, stop_time=10.0, output=["R"], output_interval=0.5)
"""
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=60, cwd=tmp_path)
    assert done.returncode == 1 and "FMICallException" in done.stderr, done.stderr
    assert "theta_1" in done.stdout, done.stdout


def test_many_instances_from_many_threads(fmu, tmp_path):
    """No two disturb each other, and one instance may be called from one thread after the other."""
    cranes = [Slave(fmu, str(tmp_path / "unzipped")) for _ in range(8)]

    def run(crane, angle, steps):
        for step in steps:
            crane.write("theta_1", radians(angle + step / 10))
            crane.step(float(step), 1.0)
        return [crane.read(name) for name in ("R", "M_Q", "theta_3")]

    with ThreadPoolExecutor(len(cranes)) as pool:
        first = list(pool.map(lambda i: run(cranes[i], 65 + i, range(0, 200)), range(8)))
        # Each goes on in another thread, most likely.
        second = list(pool.map(lambda i: run(cranes[i], 65 + i, range(200, 400)), reversed(range(8))))[::-1]
    alone = Slave(fmu, str(tmp_path / "unzipped"))
    for i in range(8):
        alone.fmu.reset()
        alone.initialize()
        assert run(alone, 65 + i, range(0, 200)) == first[i] and run(alone, 65 + i, range(200, 400)) == second[i]
    for crane in [*cranes, alone]:
        crane.fmu.freeInstance()


def test_the_description_keeps_the_rules_beyond_the_schema(fmu):
    with zipfile.ZipFile(fmu) as archive:
        root = ElementTree.fromstring(archive.read("modelDescription.xml"))
    fmi2 = root.get("fmiVersion") == "2.0"
    if fmi2:
        variables = [{**v.attrib, **v[0].attrib} for v in root.find("ModelVariables")]
    else:
        # A string's start value is an element of its own.
        variables = [{**v.attrib, **{"start": start.get("value") for start in v.iter("Start")}}
                     for v in root.find("ModelVariables")]

    # Exactly one independent variable, unique references and names, and names that are structured ones.
    assert [v["name"] for v in variables if v["causality"] == "independent"] == ["time"]
    for key in ("name", "valueReference"):
        values = [v[key] for v in variables]
        assert len(set(values)) == len(values), key
    name = r"[A-Za-z_]\w*(\[\d+(,\d+)*\])?"
    for variable in variables:
        assert re.fullmatch(rf"{name}(\.{name})*", variable["name"]), variable["name"]

    # Every unit and display unit is defined.
    units = {unit.get("name"): {d.get("name") for d in unit.iter("DisplayUnit")} for unit in root.iter("Unit")}
    for variable in variables:
        if "unit" in variable:
            assert variable["unit"] in units, variable
        if "displayUnit" in variable:
            assert variable["displayUnit"] in units[variable["unit"]], variable

    # A start value where one is due, and nowhere else.
    for variable in variables:
        due = variable["causality"] in ("input", "parameter", "structuralParameter") or variable.get("initial") == "exact" \
            or variable.get("variability") == "constant"
        assert ("start" in variable) == due, variable
        # Inputs and the independent variable have no `initial`.
        assert variable["causality"] not in ("input", "independent") or "initial" not in variable, variable

    # InitialUnknowns: the outputs and the calculated parameters, whose values initialization gives, and no others.
    expected = {v["name"] for v in variables
                if v["causality"] in ("output", "calculatedParameter") and v.get("variability") != "constant"}
    outputs = {v["name"] for v in variables if v["causality"] == "output"}
    structure = root.find("ModelStructure")
    if fmi2:
        def listed(place):
            return [variables[int(unknown.get("index")) - 1]["name"] for unknown in structure.find(place)]
        found, found_outputs = listed("InitialUnknowns"), listed("Outputs")
    else:
        names = {v["valueReference"]: v["name"] for v in variables}
        found = [names[unknown.get("valueReference")] for unknown in structure.findall("InitialUnknown")]
        found_outputs = [names[output.get("valueReference")] for output in structure.findall("Output")]
    assert len(found) == len(set(found)) and set(found) == expected
    assert len(found_outputs) == len(set(found_outputs)) and set(found_outputs) == outputs

    # Dependencies, where given, are of known variables, with as many kinds. `dependencies=""` means none.
    known = {str(i + 1) for i in range(len(variables))} if fmi2 else {v["valueReference"] for v in variables}
    for unknown in structure.iter():
        if unknown.get("dependencies") is not None:
            dependencies, kinds = unknown.get("dependencies").split(), unknown.get("dependenciesKind")
            assert set(dependencies) <= known, unknown.attrib
            assert kinds is None or len(kinds.split()) == len(dependencies), unknown.attrib

    # What FMPy does not read, or what nobody needs.
    assert root.find("VendorAnnotations") is None
    for interface in [*root.iter("CoSimulation"), *root.iter("ModelExchange")]:
        assert interface.get("needsExecutionTool", "false") == "false"


def test_the_archive_is_one_that_everyone_opens(out):
    tokens = []
    for name, folder in [("LemniscateCrane.fmu", "x86_64-linux"), ("LemniscateCrane.fmi2.fmu", "linux64")]:
        with zipfile.ZipFile(out / name) as archive:
            for entry in archive.infolist():
                assert entry.compress_type in (zipfile.ZIP_DEFLATED, zipfile.ZIP_STORED), entry
                assert "\\" not in entry.filename and not entry.filename.startswith("/") and ".." not in entry.filename
            root = ElementTree.fromstring(archive.read("modelDescription.xml"))
            binaries = [path.split("/")[1] for path in archive.namelist() if path.startswith("binaries/")]
            if sys.platform == "linux" and os.uname().machine == "x86_64":
                assert binaries == [folder]
            tokens.append(root.get("guid") or root.get("instantiationToken"))
    assert tokens[0] == tokens[1]


def test_panics_unwind():
    """A panic that aborts could not become a status: the simulator would go down with the FMU."""
    profiles = tomllib.loads((ROOT / "Cargo.toml").read_text(encoding="utf-8"))["profile"]
    assert all(profile.get("panic", "unwind") == "unwind" for profile in profiles.values())
