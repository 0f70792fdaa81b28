"""Builds the wheel: the program `lemnis` and the FMU's library with Cargo, then all the rest with maturin.

The program is compiled as the README's first command compiles it, so that Typst is compiled once for both; maturin compiles
the module, which has no Typst. For tests, `python python/backend.py` puts what `cargo build --release --workspace` has made
into the package where it lies, and tells the environment that runs it where that is.
"""

import os
import shutil
import subprocess
import sys
import sysconfig
from pathlib import Path

try:
    import maturin
    from maturin import *  # noqa: F403  The hooks of PEP 517 that need nothing more.
except ImportError:
    maturin = None

ROOT = Path(__file__).resolve().parent.parent
PACKAGE = ROOT / "python/lemnis"
RELEASE = Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target")) / "release"
LIBRARY = {"win32": "{}.dll", "darwin": "lib{}.dylib"}.get(sys.platform, "lib{}.so")


def made(release=RELEASE):
    """The program and the FMU's library, where Cargo puts them: it keeps the copies in deps/ up to date whatever is built."""
    return release / ("lemnis.exe" if os.name == "nt" else "lemnis"), release / "deps" / LIBRARY.format("lemnis_fmu")


def program(*files):
    """Puts the program, the FMU's library and what else is given into the package."""
    folder = PACKAGE / "_program"
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir()
    for path in files:
        shutil.copy2(path, folder)


def in_place():
    """The package where it lies, complete."""
    program(*made())
    module = PACKAGE / ("_lemnis.pyd" if os.name == "nt" else "_lemnis.abi3.so")
    # A module that another process has loaded stays as it is for that one.
    module.unlink(missing_ok=True)
    shutil.copy2(RELEASE / "deps" / LIBRARY.format("_lemnis"), module)
    Path(sysconfig.get_path("purelib"), "lemnis.pth").write_text(f"{PACKAGE.parent}\n", encoding="utf-8")


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    subprocess.run(["cargo", "build", "--release", "--workspace", "--bin", "lemnis"], cwd=ROOT, check=True)
    program(*made())
    return maturin.build_wheel(wheel_directory, config_settings, metadata_directory)


if __name__ == "__main__":
    in_place()
