"""What `release.py` does, on the program that is built already; and the workflow, which no machine here can run."""

import hashlib
import re
import shutil
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

from conftest import LEMNIS, ROOT

sys.path.append(str(ROOT))
import release

WORKFLOW = ROOT / ".github/workflows/release.yml"


@pytest.fixture(scope="module")
def archive(tmp_path_factory):
    folder = tmp_path_factory.mktemp("release")
    notices = release.third_party(folder / "THIRD_PARTY.txt")
    return release.archive([*release.backend.made(LEMNIS.parent), notices], folder)


def test_an_archive_in_an_empty_folder_checks_builds_and_simulates(archive, tmp_path):
    assert archive.name.startswith(f"lemnis-{release.VERSION}-{release.PLATFORM}.")
    program = release.installed(archive, tmp_path)
    assert {path.name for path in program.parent.iterdir()} == {
        *(path.name for path in release.backend.made()), "LICENSE-MIT", "LICENSE-APACHE", "THIRD_PARTY.txt", "README.md",
        "CHANGELOG.md", "scenes"}
    assert len(list((program.parent / "scenes").glob("*.toml"))) == len(list((ROOT / "models/scenes").glob("*.toml")))
    release.tried([program], sys.executable)
    # Without the library beside it, it makes no FMU, and the release stops.
    program.with_name(release.backend.made()[1].name).unlink()
    with pytest.raises(SystemExit, match="failed: .* build"):
        release.tried([program], sys.executable)


def test_every_crate_has_its_licence(archive, tmp_path):
    text = (release.installed(archive, tmp_path).parent / "THIRD_PARTY.txt").read_text(encoding="utf-8")
    listed = dict(re.findall(r"^([\w-]+ \d\S*): (.+)$", text.split("-" * 80)[0], re.M))
    done = subprocess.run(["cargo", "tree", "-p", "lemnis", "-p", "lemnis-python", "-e", "normal", "--prefix", "none"],
                          capture_output=True, text=True, cwd=ROOT, check=True)
    crates = {" ".join(re.match(r"(\S+) v(\S+)", line).groups()) for line in done.stdout.splitlines() if line and "(/" not in line}
    assert len(crates) > 300 and crates - set(listed) == {name for name in crates if name.startswith("lemnis")}
    for sign in ("SIL OPEN FONT LICENSE", "Apache License", "Permission is hereby granted", "CodeMirror"):
        assert sign.lower() in text.lower(), sign
    assert str(ROOT) not in text and str(Path.home()) not in text


def test_checksums_are_those_of_the_files(tmp_path):
    (tmp_path / "b").write_bytes(b"two\r\n")
    (tmp_path / "a").write_bytes(b"one")
    release.checksums(tmp_path)
    lines = (tmp_path / "SHA256SUMS").read_bytes().decode().splitlines()
    assert lines == [f"{hashlib.sha256(content).hexdigest()}  {name}" for name, content in (("a", b"one"), ("b", b"two\r\n"))]


def test_a_later_glibc_is_refused():
    release.portable("lemnis", b"\x7fELF GLIBC_2.2.5 GLIBC_2.17")
    release.portable("lemnis.dll", b"MZ GLIBC_2.35")
    with pytest.raises(SystemExit, match=r"lemnis needs glibc 2\.35, not 2\.17"):
        release.portable("lemnis", b"\x7fELF GLIBC_2.9 GLIBC_2.35 GLIBC_2.34")


def test_what_several_machines_made_is_joined(tmp_path):
    """Stand-ins. Linux has made all libraries; that of a platform made on itself is preferred."""
    made = {"x86_64-linux": ("tar.gz", ["x86_64-linux", "aarch64-linux", "x86_64-windows"]),
            "aarch64-linux": ("tar.gz", ["x86_64-linux", "aarch64-linux", "x86_64-windows"]),
            "x86_64-windows": ("zip", ["x86_64-windows"])}
    for own, (suffix, platforms) in made.items():
        folder = tmp_path / own
        folder.mkdir()
        (folder / f"lemnis-{release.VERSION}-{own}.{suffix}").write_bytes(own.encode())
        (folder / f"lemnis-{release.VERSION}-cp310-abi3-{own}.whl").write_bytes(own.encode())
        with zipfile.ZipFile(folder / "libraries.zip", "w") as libraries:
            for platform in platforms:
                libraries.writestr(f"{platform}/library", f"{platform} made on {own}")
    dist = tmp_path / "dist"
    dist.mkdir()
    release.join([tmp_path / own for own in made], dist)
    with zipfile.ZipFile(dist / "libraries.zip") as libraries:
        assert {name: libraries.read(name).decode() for name in libraries.namelist()} == {
            f"{own}/library": f"{own} made on {own}" for own in made}
    assert len(list(dist.iterdir())) == 2 * len(made) + 2
    assert len((dist / "SHA256SUMS").read_text().splitlines()) == 2 * len(made) + 1


@pytest.mark.parametrize("made", [[], ["lemnis-0.0.1-x86_64-linux.tar.gz"],
                                  [f"lemnis-{release.VERSION}-{platform}.tar.gz" for platform in ("x86_64-linux", "aarch64-linux")]])
def test_a_folder_that_no_machine_made_is_refused(made, tmp_path):
    for name in made:
        (tmp_path / name).write_bytes(b"")
    with pytest.raises(SystemExit, match=r"has not one archive of lemnis \d"):
        release.join([tmp_path], tmp_path / "dist")


def checked(*command):
    return subprocess.run([Path(sys.executable).with_name(command[0]), *command[1:]], capture_output=True, text=True)


def test_the_workflow_is_one_and_safe(tmp_path):
    for command in (["check-jsonschema", "--builtin-schema", "vendor.github-workflows"], ["zizmor", "--offline", "--pedantic"]):
        done = checked(*command, WORKFLOW)
        assert done.returncode == 0, done.stdout + done.stderr
        wrong = shutil.copy(WORKFLOW, tmp_path / "wrong.yml")
        text = WORKFLOW.read_text(encoding="utf-8")
        assert "runs-on:" in text and "persist-credentials: false" in text
        wrong.write_text(text.replace("runs-on:", "runs:").replace("persist-credentials: false", "clean: true"), encoding="utf-8")
        assert checked(*command, wrong).returncode != 0


def test_the_workflow_calls_the_script():
    text = WORKFLOW.read_text(encoding="utf-8")
    assert re.findall(r"run: python (.*)", text) == ["release.py", "release.py made/*"]
    assert all(re.fullmatch(r"actions/[a-z-]+@[0-9a-f]{40} # v\d+\.\d+\.\d+", used) for used in re.findall(r"uses: (.*)", text))
