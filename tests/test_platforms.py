"""One FMU with the libraries of several platforms."""

import sys
import zipfile

import lief
import pytest
from fmpy import simulate_fmu
from fmpy.validation import validate_fmu

from conftest import ROOT, lemnis
from test_fmpy import TABLE

sys.path.append(str(ROOT / "fmu"))
import platforms

# FMI 2 names three platforms itself, the others go by their FMI 3 names.
FOLDERS = {
    "x86_64-linux": ("linux64", "x86_64-linux", "so"),
    "x86_64-windows": ("win64", "x86_64-windows", "dll"),
    "x86_64-darwin": ("darwin64", "x86_64-darwin", "dylib"),
    "aarch64-linux": ("aarch64-linux", "aarch64-linux", "so"),
}
NAMES = {"so": "liblemnis_fmu.so", "dll": "lemnis_fmu.dll", "dylib": "liblemnis_fmu.dylib"}


def test_where_the_libraries_lie(tmp_path):
    """Stand-ins: what is put in is what comes out, each where the standard looks for it."""
    for platform, (_, _, suffix) in FOLDERS.items():
        (tmp_path / "in" / platform).mkdir(parents=True)
        (tmp_path / "in" / platform / NAMES[suffix]).write_bytes(platform.encode())
    lemnis("fmu", "--platforms", tmp_path / "in", "--output", tmp_path)
    for column, name in enumerate(["LemniscateCrane.fmi2.fmu", "LemniscateCrane.fmu"]):
        with zipfile.ZipFile(tmp_path / name) as archive:
            binaries = {path: archive.read(path) for path in archive.namelist() if path.startswith("binaries/")}
        assert binaries == {f"binaries/{entry[column]}/LemniscateCrane.{entry[2]}": platform.encode()
                            for platform, entry in FOLDERS.items()}


@pytest.mark.parametrize(["made", "message"], [
    ([], "is empty: put one folder for each platform there"),
    (["sparc-solaris/liblemnis_fmu.so"], "sparc-solaris is not a platform of FMI 3"),
    (["linux64/liblemnis_fmu.so"], "linux64 is not a platform of FMI 3"),
    (["x86_64-linux/LemniscateCrane.so"], "liblemnis_fmu.so: No such file"),
    (["x86_64-windows/liblemnis_fmu.so"], "lemnis_fmu.dll: No such file"),
    (["x86_64-linux"], "cannot read"),
])
def test_a_folder_of_platforms_that_is_wrong(made, message, tmp_path):
    folder = tmp_path / "in"
    folder.mkdir()
    for path in made:
        (folder / path).parent.mkdir(parents=True, exist_ok=True)
        (folder / path).write_bytes(b"")
    assert message in lemnis("fmu", "--platforms", folder, "--output", tmp_path / "out", expect=3)
    assert not (tmp_path / "out").exists()


def test_a_folder_of_platforms_that_is_not_there(tmp_path):
    assert "cannot read" in lemnis("fmu", "--platforms", tmp_path / "none", "--output", tmp_path, expect=3)


@pytest.fixture(scope="module")
def libraries(tmp_path_factory):
    """Builds one platform after the other as `fmu/platforms.py` does, without optimisation: of them the form is looked at, and one
    run. Gives the folder and what was not built."""
    folder, missing = tmp_path_factory.mktemp("platforms"), {}
    for platform in platforms.PLATFORMS:
        try:
            platforms.build(platform, folder, "quick")
        except platforms.Absent as absent:
            missing[platform] = str(absent)
    return folder, missing


def exports(library):
    """What the library exports."""
    return {function.name for function in lief.parse(library).exported_functions}


@pytest.mark.skipif(sys.platform != "linux", reason="Zig as a linker is set up for Linux")
def test_libraries_of_several_platforms(libraries, tmp_path):
    folder, missing = libraries
    built = {path.parent.name: path.read_bytes() for path in folder.glob("*/*")}
    assert "x86_64-linux" in built and set(built) | set(missing) == set(platforms.PLATFORMS)
    starts = {"x86_64-linux": b"\x7fELF\x02\x01", "aarch64-linux": b"\x7fELF\x02\x01", "x86_64-windows": b"MZ"}
    machines = {"x86_64-linux": b"\x3e\x00", "aarch64-linux": b"\xb7\x00"}
    for platform, library in built.items():
        assert library.startswith(starts[platform]), platform
        assert library[18:20] == machines.get(platform, library[18:20]), platform
        # All functions of both standards, 44 and 75, and nothing else.
        assert sorted(exports(library)) == sorted(platforms.exports()), platform
        glibc = platforms.glibc(library)
        assert all(version <= (2, 17) for version in glibc) and bool(glibc) == platform.endswith("linux"), platform
    assert len(platforms.exports()) == 44 + 75

    lemnis("fmu", "--platforms", folder, "--output", tmp_path)
    for name in ("LemniscateCrane.fmu", "LemniscateCrane.fmi2.fmu"):
        assert validate_fmu(str(tmp_path / name)) == []
        result = simulate_fmu(str(tmp_path / name), output=["R"], output_interval=1.0)
        assert abs(result["R"][0] - float(TABLE[0]["R_m"])) <= 6e-5
    if missing:
        pytest.skip(f"not run: {'; '.join(missing.values())}")
