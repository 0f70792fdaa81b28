"""Bad input and bad luck: a clear message, a known exit code, nothing lost."""

import os
import signal
import subprocess
import time

import pytest

from conftest import LEMNIS, ROOT, lemnis

DEFAULT = (ROOT / "models/scenes/lemniscate.toml").read_text(encoding="utf-8")


def test_a_scene_of_100_mb_is_refused_at_once(tmp_path):
    scene = tmp_path / "huge.toml"
    with open(scene, "w", encoding="utf-8") as file:
        file.write(DEFAULT)
        line = "# " + "x" * 1022 + "\n"
        for _ in range(100 * 1024):
            file.write(line)
    started = time.monotonic()
    message = lemnis("check", scene, expect=1)
    assert "longer than 1048576 bytes" in message and time.monotonic() - started < 2.0


@pytest.mark.parametrize("text", [
    "a = " + "[" * 100_000,
    "a = " + "{ b = " * 50_000,
    "[" + "a." * 100_000 + "b]\n",
    "a" + ".a" * 100_000 + " = 1\n",
    "[a]\n" * 100_000,
    "a = \"" + "\\" * 100_001,
])
def test_nesting_without_end_is_refused(tmp_path, text):
    scene = tmp_path / "deep.toml"
    scene.write_text(text, encoding="utf-8")
    done = subprocess.run([LEMNIS, "check", scene], capture_output=True, text=True, encoding="utf-8", timeout=60)
    assert done.returncode == 1 and done.stderr.startswith("error"), (done.returncode, done.stderr[:300])


def test_a_scene_that_is_not_text(tmp_path):
    scene = tmp_path / "binary.toml"
    scene.write_bytes(b"name = \"\xff\xfe\"\n")
    assert "is not text in UTF-8: byte 8" in lemnis("check", scene, expect=1)


def test_a_scene_that_is_not_there(tmp_path):
    assert "cannot read the scene" in lemnis("build", tmp_path / "none.toml", expect=3)


def test_a_wrong_command_line():
    assert "Usage" in lemnis("bild", expect=2)


def test_an_output_folder_that_cannot_be(tmp_path):
    """A file stands where the folder should be."""
    (tmp_path / "out").write_text("mine")
    message = lemnis("fmu", "--output", tmp_path / "out", expect=3)
    assert "cannot write" in message and "--output" in message
    assert (tmp_path / "out").read_text() == "mine"


@pytest.mark.skipif(os.name == "nt", reason="the limit is a POSIX one")
def test_a_full_disk_leaves_the_old_files_whole(tmp_path):
    """No file may grow beyond 100 kB, which is what a full disk looks like."""
    import resource

    old = b"the old FMU"
    for name in ("LemniscateCrane.fmu", "LemniscateCrane.fmi2.fmu"):
        (tmp_path / name).write_bytes(old)

    def limit():
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        resource.setrlimit(resource.RLIMIT_FSIZE, (100_000, 100_000))

    done = subprocess.run([LEMNIS, "fmu", "--output", tmp_path], capture_output=True, text=True, preexec_fn=limit)
    assert done.returncode == 3 and "cannot write" in done.stderr, done.stderr
    assert sorted(path.name for path in tmp_path.iterdir()) == ["LemniscateCrane.fmi2.fmu", "LemniscateCrane.fmu"]
    assert all(path.read_bytes() == old for path in tmp_path.iterdir())


@pytest.mark.skipif(os.name == "nt", reason="kill -9 is POSIX")
def test_a_killed_run_leaves_whole_files(tmp_path):
    """Killed at any moment: each file is the old one or the new one."""
    lemnis("fmu", "--output", tmp_path)
    new = (tmp_path / "LemniscateCrane.fmu").read_bytes()
    old = b"the old FMU"
    seen = set()
    for milliseconds in range(0, 60, 3):
        (tmp_path / "LemniscateCrane.fmu").write_bytes(old)
        process = subprocess.Popen([LEMNIS, "fmu", "--output", tmp_path], stdout=subprocess.DEVNULL)
        time.sleep(milliseconds / 1000)
        process.kill()
        process.wait()
        found = (tmp_path / "LemniscateCrane.fmu").read_bytes()
        assert found in (old, new)
        seen.add(found == new)
    assert False in seen


def test_limits_that_are_not_kept(tmp_path):
    scene = tmp_path / "strict.toml"
    scene.write_text(DEFAULT.replace('mu_min    = "30 deg"', 'mu_min    = "80 deg"'), encoding="utf-8")
    message = lemnis("check", scene, expect=4)
    assert "mu_min" in message and "at least 80 deg" in message
    # The book is made all the same, and says so.
    assert "checks failed" in lemnis("build", scene, "--output", tmp_path)


@pytest.mark.skipif(os.name == "nt", reason="pipes and /dev/full are POSIX")
def test_a_reader_that_leaves_is_no_failure_and_a_full_device_is_one():
    reader, writer = os.pipe()
    os.close(reader)
    result = subprocess.run([LEMNIS, "schema"], stdout=writer, stderr=subprocess.PIPE)
    os.close(writer)
    assert result.returncode == 0 and result.stderr == b""
    with open("/dev/full", "w") as full:
        result = subprocess.run([LEMNIS, "check"], stdout=full, stderr=subprocess.PIPE, text=True)
    assert result.returncode == 3 and "cannot write to the standard output" in result.stderr
