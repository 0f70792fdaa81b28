"""Sets up what the tests need and passes them all: `python3 tests/run.py`.

Needs Rust (cargo, rustfmt, clippy), Python 3.11 or later with `venv`, and Chromium; on
Linux also a C compiler and valgrind. Where Chromium is missing, it is installed if the system is Debian's and may be changed.
Everything else comes from crates.io, PyPI and npm; the Python packages, Node among them, go into a
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

# Chromium under the names that distributions give it; without a window it is enough.
BROWSERS = ["chromium-headless-shell", "chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome"]
PLACES = [r"C:\Program Files\Google\Chrome\Application\chrome.exe", "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome"]
INSTALL = ["apt-get", "install", "-y", "-q", BROWSERS[0]]

# One selection of packages throughout, so that nothing is compiled twice.
STEPS = [
    ["cargo", "fmt", "--all", "--check"],
    ["cargo", "build", "--release", "--workspace", "--all-targets"],
    ["cargo", "clippy", "--release", "--workspace", "--all-targets", "--", "-D", "warnings"],
    ["cargo", "doc", "--release", "--workspace", "--no-deps"],
    # Books are typeset on one core: beside it runs the rest.
    (["cargo", "test", "--release", "--workspace", "--test", "layout", "--test", "pages"],
     ["cargo", "test", "--release", "--workspace", "--", "--skip", "books_are_laid_out", "--skip", "nothing_stands_over_the_margin",
      "--skip", "numbers_of_formulas_keep"]),
    [str(PYTHON), "python/backend.py"],
    # A file's tests share what they make, and stay together; the longest files begin (`conftest.py`).
    [str(PYTHON), "-m", "pytest", "-q", "-rs", "--durations=25", "-n", "auto", "--dist", "loadfile", "--no-loadscope-reorder", "tests"],
]


def browser():
    """Path of a Chromium, if there is one."""
    found = filter(None, map(shutil.which, BROWSERS))
    return next(found, None) or next(filter(os.path.exists, PLACES), None)


def prepare_browser():
    if browser() is not None:
        return
    if shutil.which("apt-get") and hasattr(os, "geteuid") and os.geteuid() == 0:
        run(["apt-get", "update", "-q"])
        run(INSTALL)
    if browser() is None:
        sys.exit(f"Chromium is missing: {' '.join(INSTALL)}, or install Google Chrome")


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
    prepare_browser()
    if not PYTHON.exists():
        try:
            venv.create(ENVIRONMENT, with_pip=True)
        except (subprocess.CalledProcessError, ImportError):
            sys.exit("Python cannot make a virtual environment: install python3-venv")
    run([str(PYTHON), "-m", "pip", "install", "-q", "--disable-pip-version-check", "-r", str(ROOT / "tests/requirements.txt")])


def run(*commands):
    """One command, or several side by side."""
    started = time.monotonic()
    environment = dict(os.environ, RUSTDOCFLAGS="-D warnings")
    running = []
    for command in commands:
        print("$", " ".join(command), flush=True)
        running.append(subprocess.Popen(command, cwd=ROOT, env=environment))
    failed = [" ".join(command) for command, process in zip(commands, running) if process.wait() != 0]
    if failed:
        sys.exit(f"failed: {'; '.join(failed)}")
    print(f"  {time.monotonic() - started:.0f} s", flush=True)


if __name__ == "__main__":
    prepare()
    for step in STEPS:
        run(*step if isinstance(step, tuple) else [step])
