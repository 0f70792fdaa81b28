"""Makes a release of this machine's platform in `target/dist` and tries it out: `python3 release.py`.

There are then the archive and the wheel, each with the program and the FMU's library, `libraries.zip` with that library for
every platform that the machine can make (`lemnis build --platforms`), and SHA256SUMS. On Linux Zig links all of it against
glibc 2.17 (2012), and what asks for a later one is refused. Archive, wheel and libraries are then installed in an empty
folder or environment, where the scene is checked and built, and FMPy must have the program's own results.

`python3 release.py FOLDER ...` joins what several machines have made. Needs Rust and Python 3.11 or later; the rest comes
from PyPI. Run on Linux on x86-64 alone; on Windows, macOS and ARM it is untested.
"""

import csv
import hashlib
import json
import os
import platform
import re
import shutil
import subprocess
import sys
import tempfile
import tomllib
import venv
import zipfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent
sys.path[:0] = [str(ROOT / "fmu"), str(ROOT / "python")]
import backend
import platforms

VERSION = tomllib.loads((ROOT / "Cargo.toml").read_text(encoding="utf-8"))["workspace"]["package"]["version"]
MACHINE = {"AMD64": "x86_64", "arm64": "aarch64"}.get(platform.machine(), platform.machine())
LINUX, WINDOWS = sys.platform == "linux", os.name == "nt"
PLATFORM = f"{MACHINE}-{'windows' if WINDOWS else sys.platform}"
# Folders of their own, since all is compiled anew for the older glibc, and maturin brings another linker than Cargo has.
PORTABLE, MODULE = ROOT / "target/portable", ROOT / "target/module"
# Packages in the versions that the tests and the package's build have.
PINNED = {line.split("==")[0]: line for line in (ROOT / "tests/requirements.txt").read_text(encoding="utf-8").splitlines()}
MATURIN = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["build-system"]["requires"]
FIRST_REACH = "import sys, fmpy; print(fmpy.simulate_fmu(sys.argv[1], output=['R'], output_interval=1.0)['R'][0])"


def run(*command, cwd=ROOT, tools=sys.executable):
    """What a command prints; ends where it fails. The tools of an environment lie beside its interpreter."""
    path = f"{Path(tools).parent}{os.pathsep}{os.environ['PATH']}"
    print("$", *command, flush=True, file=sys.stderr)
    done = subprocess.run([*map(str, command)], cwd=cwd, env=dict(os.environ, PATH=path), stdout=subprocess.PIPE)
    if done.returncode != 0:
        sys.exit(f"failed: {' '.join(map(str, command))}")
    return done.stdout.decode()


def environment(folder, *packages):
    """The interpreter of an empty environment with packages in it."""
    venv.create(folder, with_pip=True, clear=True)
    python = folder / ("Scripts/python.exe" if WINDOWS else "bin/python")
    run(python, "-m", "pip", "install", "-q", "--disable-pip-version-check", *packages)
    return python


def host():
    """This machine as a target of Rust, and what Zig adds to it for an older glibc."""
    if LINUX:
        return platforms.PLATFORMS[PLATFORM][:2]
    return re.search(r"^host: (.*)$", run("rustc", "-vV"), re.M)[1], ""


def compiled(tools):
    """The program and the FMU's library for as many machines as possible."""
    target, glibc = host()
    run("cargo", "zigbuild" if LINUX else "build", "--release", "--locked", "--workspace", "--bin", "lemnis",
        "--target", target + glibc, "--target-dir", PORTABLE, tools=tools)
    return backend.made(PORTABLE / target / "release")


def third_party(path):
    """Writes each crate that the program and the module are made of, with its licence, then the texts that lie in the crates."""
    metadata = json.loads(run("cargo", "metadata", "--format-version", "1", "--locked", "--filter-platform", host()[0]))
    needs = {node["id"]: [need["pkg"] for need in node["deps"] if any(kind["kind"] is None for kind in need["dep_kinds"])]
             for node in metadata["resolve"]["nodes"]}
    used, found = set(), {package["id"] for package in metadata["packages"] if package["name"] in ("lemnis", "lemnis-python")}
    while found:
        used |= found
        found = {need for one in found for need in needs[one]} - used
    listed, texts = ["Lemnis is made of these crates and of Rust's standard library (MIT OR Apache-2.0).\n"], {}
    for package in metadata["packages"]:
        if package["id"] not in used or package["source"] is None:
            continue
        name = f"{package['name']} {package['version']}"
        listed.append(f"{name}: {package['license'] or 'see its text below'}")
        for file in sorted(Path(package["manifest_path"]).parent.rglob("*")):
            if re.match(r"(un)?licen[cs]e|copying|copyright|notice", file.name, re.I) and file.suffix != ".rs" and file.is_file():
                texts.setdefault(file.read_text(encoding="utf-8", errors="replace").strip(), {})[name] = None
    parts = [f"{', '.join(crates)}\n\n{text}" for text, crates in texts.items()]
    for other in ("report/typeset/fonts/OFL.txt", "serve/page/dist/THIRD_PARTY.txt"):
        parts.append((ROOT / other).read_text(encoding="utf-8").strip())
    path.write_text(f"\n\n{'-' * 80}\n".join(["\n".join(listed), *parts]) + "\n", encoding="utf-8")
    return path


def archive(files, dist):
    """The archive: a folder with the files, licences and scenes."""
    name = f"lemnis-{VERSION}-{PLATFORM}"
    with tempfile.TemporaryDirectory() as folder:
        shutil.copytree(ROOT / "models/scenes", Path(folder, name, "scenes"))
        for path in [*files, *(ROOT / name for name in ("LICENSE-MIT", "LICENSE-APACHE", "README.md", "CHANGELOG.md"))]:
            shutil.copy2(path, Path(folder, name))
        return Path(shutil.make_archive(str(dist / name), "zip" if WINDOWS else "gztar", folder, name))


def wheel(files, tools, dist):
    """The wheel, with the files in it; maturin compiles the module."""
    backend.program(*files)
    run("maturin", "build", "--release", "--locked", "--target", host()[0], "--target-dir", MODULE, "--out", dist,
        *["--zig"] * LINUX, tools=tools)
    return next(dist.glob("*.whl"))


def libraries(own, tools, dist):
    """The FMU's library: this platform's own, and on Linux, where Zig is set up, that of all others."""
    with tempfile.TemporaryDirectory() as folder:
        for name in (name for name in platforms.PLATFORMS if LINUX and name != PLATFORM):
            done = subprocess.run([tools, ROOT / "fmu/platforms.py", folder, name])
            if done.returncode not in (0, platforms.NO_TARGET):
                sys.exit(f"failed: fmu/platforms.py for {name}")
        Path(folder, PLATFORM).mkdir()
        shutil.copy2(own, Path(folder, PLATFORM))
        return Path(shutil.make_archive(str(dist / "libraries"), "zip", folder))


def portable(path, content):
    """Ends where a program or library for Linux asks for a glibc later than 2.17."""
    later = sorted(version for version in platforms.glibc(content) if version > (2, 17))
    if content.startswith(b"\x7fELF") and later:
        sys.exit(f"{path} needs glibc {'.'.join(map(str, later[-1]))}, not 2.17: it is not linked by Zig")


def checksums(dist):
    sums = [f"{hashlib.sha256(path.read_bytes()).hexdigest()}  {path.name}\n" for path in sorted(dist.iterdir())]
    (dist / "SHA256SUMS").write_text("".join(sums), encoding="utf-8", newline="\n")


def tried(command, python, *options):
    """Checks and builds the embedded crane in an empty folder; FMPy must have the program's own reach, the book must be there."""
    with tempfile.TemporaryDirectory() as folder:
        reach = float(next(csv.DictReader(run(*command, "check", "--csv", cwd=folder).splitlines()))["R [m]"])
        run(*command, "build", *options, cwd=folder)
        for name in ("LemniscateCrane.fmu", "LemniscateCrane.fmi2.fmu"):
            simulated = float(run(python, "-c", FIRST_REACH, Path(folder, "out", name), cwd=folder))
            if abs(simulated - reach) > 1e-9:
                sys.exit(f"{name}: R = {simulated} m where the program has {reach} m")
        if not Path(folder, "out/LemniscateCrane.pdf").read_bytes().startswith(b"%PDF"):
            sys.exit(f"{' '.join(map(str, command))} build made no book")


def installed(packed, folder):
    """The program of an archive, unpacked in a folder."""
    shutil.unpack_archive(packed, folder)
    return next(Path(folder).glob(f"*/{backend.made()[0].name}"))


def join(folders, dist):
    """Puts what several machines have made into one folder. Of a library that several have made, its own platform's is taken."""
    together = {}
    for folder in map(Path, folders):
        whole = [*folder.glob(f"lemnis-{VERSION}-*")]
        own, *more = [path.name.split("-", 2)[2].split(".")[0] for path in whole if path.suffix != ".whl"] or [None]
        if own is None or more:
            sys.exit(f"{folder} has not one archive of lemnis {VERSION}: give each folder target/dist that a machine has made")
        for path in whole:
            shutil.copy2(path, dist)
        with zipfile.ZipFile(folder / "libraries.zip") as made:
            together |= {name: made.read(name) for name in made.namelist()
                         if name not in together or name.startswith(f"{own}/")}
    with zipfile.ZipFile(dist / "libraries.zip", "w", zipfile.ZIP_DEFLATED) as packed:
        for name in sorted(together):
            packed.writestr(name, together[name])
    checksums(dist)


def release(dist):
    tools = environment(ROOT / "target/tools", *MATURIN, *(PINNED[name] for name in ("FMPy", "cargo-zigbuild", "ziglang")))
    program, library = compiled(tools)
    files = [program, library, third_party(PORTABLE / "THIRD_PARTY.txt")]
    packed, made, several = archive(files, dist), wheel(files, tools, dist), libraries(library, tools, dist)
    for path in (made, several):
        with zipfile.ZipFile(path) as inside:
            for name in inside.namelist():
                portable(f"{path.name}: {name}", inside.read(name))
    with tempfile.TemporaryDirectory() as folder:
        unpacked = installed(packed, folder)
        portable(unpacked, unpacked.read_bytes())
        tried([unpacked], tools)
        shutil.unpack_archive(several, Path(folder, "libraries"))
        tried([unpacked], tools, "--platforms", Path(folder, "libraries"))
        python = environment(Path(folder, "empty"), made, PINNED["FMPy"])
        tried([python.parent / "lemnis"], python)
    checksums(dist)
    print((dist / "SHA256SUMS").read_text(encoding="utf-8"), end="")


if __name__ == "__main__":
    dist = ROOT / "target/dist"
    shutil.rmtree(dist, ignore_errors=True)
    dist.mkdir(parents=True)
    join(sys.argv[1:], dist) if sys.argv[1:] else release(dist)
