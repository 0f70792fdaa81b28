"""Sets up what the tests need and passes them all: `python3 tests/run.py`.

Needs Rust (cargo, rustfmt, clippy) and Python 3.11 or later with `venv`; on
Linux also a C compiler and valgrind. Everything else comes from crates.io and PyPI; the Python packages go into a
virtual environment of their own, `.venv`.
"""

import os
import shutil
import subprocess
import sys
import time
import venv
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
ENVIRONMENT = ROOT / ".venv"
PYTHON = ENVIRONMENT / ("Scripts/python.exe" if os.name == "nt" else "bin/python")

# One selection of packages throughout, so that nothing is compiled twice.
STEPS = [
    ["cargo", "fmt", "--all", "--check"],
    ["cargo", "build", "--release", "--workspace", "--all-targets"],
    ["cargo", "clippy", "--release", "--workspace", "--all-targets", "--", "-D", "warnings"],
    ["cargo", "doc", "--release", "--workspace", "--no-deps"],
    ["cargo", "test", "--release", "--workspace"],
    [str(PYTHON), "python/backend.py"],
    [str(PYTHON), "-m", "pytest", "-q", "-rs", "tests"],
]


def prepare():
    if sys.version_info < (3, 11):
        sys.exit(f"Python 3.11 or later is needed, this is {sys.version.split()[0]}")
    tools = [("cargo", "https://rustup.rs"), ("rustfmt", "rustup component add rustfmt"),
             ("cargo-clippy", "rustup component add clippy")]
    if sys.platform == "linux":
        tools += [("cc", "apt-get install gcc libc6-dev"), ("valgrind", "apt-get install valgrind")]
    for tool, where in tools:
        if shutil.which(tool) is None:
            sys.exit(f"{tool} is missing: {where}")
    if not PYTHON.exists():
        try:
            venv.create(ENVIRONMENT, with_pip=True)
        except (subprocess.CalledProcessError, ImportError):
            sys.exit("Python cannot make a virtual environment: install python3-venv")
    run([str(PYTHON), "-m", "pip", "install", "-q", "--disable-pip-version-check", "-r", str(ROOT / "tests/requirements.txt")])


def run(command):
    started = time.monotonic()
    print("$", " ".join(command), flush=True)
    environment = dict(os.environ, RUSTDOCFLAGS="-D warnings")
    if subprocess.run(command, cwd=ROOT, env=environment).returncode != 0:
        sys.exit(f"failed: {' '.join(command)}")
    print(f"  {time.monotonic() - started:.0f} s", flush=True)


if __name__ == "__main__":
    prepare()
    for step in STEPS:
        run(step)
