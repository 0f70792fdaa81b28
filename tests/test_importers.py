"""The FMUs in the importers of others; `docs/importers.md` says what came out.

`LEMNIS_WRITE=1` with the README's test command writes that page, otherwise a
stale page fails.
"""

import json
import os
import signal
import subprocess
import sys
import tomllib
import zipfile
from importlib.metadata import version

import pytest
from fmpy.validation import validate_fmu

from conftest import ROOT, lemnis
from importers import DRIVERS
from test_fmpy import compare_with_table

PAGE = ROOT / "docs/importers.md"
FILES = {"2.0": "LemniscateCrane.fmi2.fmu", "3.0": "LemniscateCrane.fmu"}
RUNS = [(importer, interface, standard) for importer, interface in DRIVERS for standard in FILES
        if (importer, standard) != ("libcosimpy", "3.0")]
THE_MODEL = "366 values of Table 1; every number bit for bit the model's"


class Measured:
    """What each importer makes of the crane, found out once."""

    def __init__(self, out, folder):
        self.out, self.folder, self.results = out, folder, {}
        self.model = json.loads(lemnis("check", "--json"))["variables"]

    def result(self, importer, interface, standard):
        key = (importer, interface, standard)
        if key not in self.results:
            fmu = str(self.out / FILES[standard])
            measure = {"FMPy validate": self.validate, "fmutool -check": self.check, "fmi-rs": self.fmi_rs}
            self.results[key] = measure.get(importer, self.drive)(fmu, *key)
        return self.results[key]

    def start(self, fmu, importer, interface):
        """The importer at work, in a process and a folder of its own."""
        angles, result = json.dumps(self.model["theta_1"]["values"]), self.folder / "result.json"
        result.unlink(missing_ok=True)
        command = [sys.executable, str(ROOT / "tests/importers.py"), importer, interface, fmu, angles, str(result)]
        environment = dict(os.environ, TMPDIR=str(self.folder))
        return subprocess.run(command, capture_output=True, text=True, errors="replace", env=environment, timeout=300), result

    def drive(self, fmu, importer, interface, standard):
        done, result = self.start(fmu, importer, interface)
        assert done.returncode == 0, f"{importer} {standard} {interface}: {done.stderr[-3000:]}"
        rows = json.loads(result.read_text())
        compare_with_table(rows)
        for i, row in enumerate(rows):
            for name, value in row.items():
                expected = self.model[name]["values"][i]
                assert expected is None or value == expected, f"{importer}: {name} in step {i}: {value}, {expected}"
        return THE_MODEL

    def validate(self, fmu, *_):
        assert validate_fmu(fmu) == []
        return "no problems found"

    def check(self, fmu, *_):
        done = subprocess.run([sys.executable, "-m", "fmu_manipulation_toolbox", "-input", fmu, "-check", "-summary"],
                              capture_output=True, text=True, encoding="utf-8")
        said = done.stdout + done.stderr
        assert done.returncode == 0 and "No semantic error" in said and "seems to be compliant" in said, said
        assert "ERROR" not in said and "WARNING" not in said, said
        return "compliant, no semantic error"

    def fmi_rs(self, _fmu, _importer, interface, standard):
        # The same build and the same selection of packages as in the steps of run.py.
        name = f"fmi{standard[0]}_{'co_simulation' if interface == 'CS' else 'model_exchange'}"
        done = subprocess.run(["cargo", "test", "--release", "--workspace", "--test", "fmi_rs", "--", "--exact", name],
                              capture_output=True, text=True, encoding="utf-8", cwd=ROOT)
        assert done.returncode == 0 and f"test {name} ... ok" in done.stdout, done.stdout + done.stderr
        return "every variable bit for bit the model's"


ALL = [
    *[(importer, interface, standard) for standard in FILES
      for importer, interface in [("FMPy validate", "both"), ("fmutool -check", "both")]],
    *RUNS,
    *[("fmi-rs", interface, standard) for interface in ("CS", "ME") for standard in FILES],
]


@pytest.fixture(scope="module")
def measured(out, tmp_path_factory):
    return Measured(out, tmp_path_factory.mktemp("importers"))


@pytest.mark.parametrize(["importer", "interface", "standard"], ALL)
def test_the_crane_works_in(importer, interface, standard, measured):
    assert measured.result(importer, interface, standard)


def test_libcosim_does_not_read_fmi_3(measured, tmp_path):
    """It crashes on opening ours, and on the smallest FMI 3.0 file there can be: not for what is in ours."""
    smallest = tmp_path / "smallest.fmu"
    with zipfile.ZipFile(smallest, "w") as archive:
        archive.writestr("modelDescription.xml", """<?xml version="1.0" encoding="UTF-8"?>
            <fmiModelDescription fmiVersion="3.0" modelName="a" instantiationToken="a">
              <CoSimulation modelIdentifier="a"/>
              <ModelVariables>
                <Float64 name="time" valueReference="0" causality="independent" variability="continuous"/>
              </ModelVariables>
              <ModelStructure/>
            </fmiModelDescription>""")
    for fmu in (str(measured.out / FILES["3.0"]), str(smallest)):
        done, result = measured.start(fmu, "libcosimpy", "CS")
        assert done.returncode == -signal.SIGSEGV and not result.exists(), f"{fmu}: put it into RUNS if it works now"


def test_the_table_of_importers_is_up_to_date(measured):
    versions = {"FMPy validate": "FMPy", "fmutool -check": "fmu-manipulation-toolbox"}
    locked = tomllib.loads((ROOT / "Cargo.lock").read_text(encoding="utf-8"))["package"]
    [fmi_rs] = [package["version"] for package in locked if package["name"] == "fmi-rs"]
    rows = []
    for importer, interface, standard in ALL:
        number = fmi_rs if importer == "fmi-rs" else version(versions.get(importer, importer))
        rows.append((importer, number, standard, interface, measured.result(importer, interface, standard)))
    rows.append(("libcosimpy", version("libcosimpy"), "3.0", "CS", "crashes on opening any FMI 3.0 file"))
    page = (
        "# Importers\n\n"
        "What the FMUs of the default crane do in the importers of others: Co-Simulation (CS) and Model Exchange\n"
        "(ME). Written by the test command from what it measured; [Li2022, Table 1] within 0.6 of the last\n"
        "printed digit, the model's values from `lemnis check --json`.\n\n"
        "| importer | version | FMI | interface | result |\n|---|---|---|---|---|\n"
        + "".join(f"| {' | '.join(row)} |\n" for row in sorted(rows, key=lambda row: (row[0].lower(), row[2], row[3])))
        + "\nNot among them, because a test command cannot rely on installing them: OMSimulator, whose package downloads\n"
        "the program while it is installed; PyFMI and FMI++, to be built from source against libraries in C and C++;\n"
        "the crates fmi and fmi-sim, which need libclang.\n"
    )
    if "LEMNIS_WRITE" in os.environ:
        PAGE.write_text(page, encoding="utf-8")
    assert PAGE.read_text(encoding="utf-8") == page, "docs/importers.md is stale: LEMNIS_WRITE=1 python3 tests/run.py"
