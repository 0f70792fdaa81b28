"""The FMU's library from C, under valgrind: no error, no leak."""

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from fmpy import extract, read_model_description

from conftest import ROOT
from test_fmpy import TABLE

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="the C test is for Linux, where valgrind is")


@pytest.fixture(scope="module")
def smoke(tmp_path_factory):
    program = tmp_path_factory.mktemp("c") / "smoke"
    for tool in ("cc", "valgrind"):
        assert shutil.which(tool), f"{tool} is missing: apt-get install gcc valgrind"
    subprocess.run(["cc", "-std=c11", "-O1", "-g", "-Wall", "-Wextra", "-Werror", "-o", str(program),
                    str(ROOT / "tests/c/smoke.c"), "-ldl"], check=True)
    return program


VALGRIND = ["valgrind", "--quiet", "--error-exitcode=99", "--leak-check=full", "--show-leak-kinds=all",
            "--errors-for-leak-kinds=all"]


def test_smoke(smoke, fmu, tmp_path):
    description = read_model_description(fmu)
    references = {v.name: str(v.valueReference) for v in description.modelVariables}
    folder = Path(extract(fmu, unzipdir=str(tmp_path / "fmu")))
    fmi2 = description.fmiVersion == "2.0"
    resources = (folder / "resources").as_uri() if fmi2 else f"{folder}/resources/"
    [library] = folder.glob("binaries/*/*.so")
    command = [*VALGRIND, str(smoke), "fmi2" if fmi2 else "fmi3", str(library),
               description.guid, resources, references["theta_1"], references["R"]]
    done = subprocess.run(command, capture_output=True, text=True, timeout=300)
    assert done.returncode == 0 and done.stderr == "", done.stderr
    assert TABLE[0]["theta1_deg"] == "60" and abs(float(done.stdout) - float(TABLE[0]["R_m"])) <= 6e-5


def test_random_calls_touch_no_memory_that_is_not_theirs():
    """The same random calls as in fmu/tests/random_calls.rs, fewer, with every access checked."""
    built = subprocess.run(["cargo", "test", "--release", "--workspace", "--test", "random_calls", "--no-run",
                            "--message-format=json"], capture_output=True, text=True, cwd=ROOT, check=True)
    messages = [json.loads(line) for line in built.stdout.splitlines()]
    [program] = [m["executable"] for m in messages if m.get("target", {}).get("name") == "random_calls" and m.get("executable")]
    # The test harness keeps what its threads need until the process ends: only what is lost is a leak here.
    command = [*VALGRIND[:-2], "--errors-for-leak-kinds=definite", program, "no_host_can_break_an_instance"]
    done = subprocess.run(command, capture_output=True, text=True, timeout=300, env=dict(os.environ, LEMNIS_CALLS="100000"))
    assert done.returncode == 0 and "1 passed" in done.stdout, done.stdout + done.stderr
