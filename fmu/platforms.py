"""Builds the FMU's library for several platforms: `python3 fmu/platforms.py FOLDER [PLATFORM ...]`.

The folder then holds one folder for each platform under its name in FMI 3, as
`lemnis build --platforms FOLDER` takes it. Zig links for all of them, and for
Linux against glibc 2.17 (2012). Needs `pip install ziglang cargo-zigbuild`;
Rust's own part of a target is fetched by `rustup target add` where it is not
yet there.

`tests/test_platforms.py` builds all three and runs the one of the machine. Run
by hand, not by the tests: `tests/c/smoke.c` with the aarch64 library under
QEMU 7.2, and with the Windows library under Wine 8.0, which lacks
bcryptprimitives.dll and was given one. Not run: real Windows, real aarch64.
"""

import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
# Platform, target of Rust, glibc, name of the library.
PLATFORMS = {
    "x86_64-linux": ("x86_64-unknown-linux-gnu", ".2.17", "liblemnis_fmu.so"),
    "aarch64-linux": ("aarch64-unknown-linux-gnu", ".2.17", "liblemnis_fmu.so"),
    "x86_64-windows": ("x86_64-pc-windows-gnu", "", "lemnis_fmu.dll"),
}
# Exit code where a target of Rust is not there and cannot be fetched.
NO_TARGET = 3


class Absent(Exception):
    """A target of Rust that is not there and cannot be fetched."""


def glibc(library):
    """The versions of glibc that a library or a program, given as bytes, asks for."""
    return {tuple(map(int, version)) for version in re.findall(rb"GLIBC_(\d+)\.(\d+)", library)}


def exports():
    """The names of the functions of both standards."""
    files = sorted((ROOT / "fmu/src/abi").glob("fmi*.rs"))
    return [name for file in files for name in re.findall(r"\bfn (fmi[23][A-Z]\w+)", file.read_text(encoding="utf-8"))]


def build(platform, folder, profile="release"):
    """Puts the library of a platform into its folder of `folder`; `Absent`, where the machine cannot make it."""
    target, glibc, name = PLATFORMS[platform]
    # The tools of pip lie beside the interpreter of their environment.
    environment = dict(os.environ, PATH=f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}")
    if shutil.which("cargo-zigbuild", path=environment["PATH"]) is None:
        sys.exit("cargo-zigbuild is missing: pip install ziglang cargo-zigbuild")
    sysroot = subprocess.run(["rustc", "--print", "sysroot"], capture_output=True, text=True, check=True, cwd=ROOT).stdout
    if not Path(sysroot.strip(), "lib/rustlib", target, "lib").is_dir():
        rustup = shutil.which("rustup")
        if rustup is None or subprocess.run([rustup, "target", "add", target], cwd=ROOT).returncode != 0:
            raise Absent(f"{platform} was not built: `rustup target add {target}` failed")
    # A folder of its own: another selection of packages would disturb the workspace's build.
    built = ROOT / "target/platforms"
    command = ["cargo", "zigbuild", "--profile", profile, "--quiet", "--package", "lemnis-fmu", "--lib",
               "--target", target + glibc, "--target-dir", str(built)]
    if "windows" in target:
        # cargo-zigbuild leaves out the compiler's list of exported names, and without one the linker exports every name there is.
        built.mkdir(parents=True, exist_ok=True)
        names = built / "lemnis_fmu.def"
        names.write_text("EXPORTS\n" + "".join(f"    {name}\n" for name in exports()), encoding="utf-8")
        command += ["--config", f"target.{target}.rustflags = {json.dumps(['-C', f'link-arg={names}'])}"]
    subprocess.run(command, check=True, cwd=ROOT, env=environment)
    place = folder / platform
    place.mkdir(parents=True, exist_ok=True)
    shutil.copyfile(built / target / profile / name, place / name)
    print(f"wrote {place / name}")


if __name__ == "__main__":
    folder, *chosen = sys.argv[1:] or sys.exit(__doc__)
    for platform in chosen or PLATFORMS:
        if platform not in PLATFORMS:
            sys.exit(f"{platform} is not one of {', '.join(PLATFORMS)}")
        try:
            build(platform, Path(folder))
        except Absent as absent:
            print(absent, file=sys.stderr)
            sys.exit(NO_TARGET)
