"""The program `lemnis` as a child process: what typesets, searches or measures runs there, so that nothing of it can harm
the interpreter, and Ctrl+C ends it at once."""

from __future__ import annotations

import os
import subprocess
import tempfile
import time
from pathlib import Path
from typing import IO

from lemnis.errors import SceneError


def path() -> Path:
    """Where the program lies; the FMU's library is beside it."""
    found = Path(__file__).parent / "_program" / ("lemnis.exe" if os.name == "nt" else "lemnis")
    if not found.is_file():
        raise FileNotFoundError(f"{found} is missing: install lemnis from its wheel, or with `pip install .`")
    return found


def run(command: str, text: str, *options: str | os.PathLike[str]) -> str:
    """What a command prints that reads a scene's text.

    Raises `SceneError` where the scene is wrong, `OSError` where a file cannot be read or written, else `RuntimeError`.
    """
    with tempfile.TemporaryFile() as given, tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as told:
        given.write(text.encode())
        given.seek(0)
        child = subprocess.Popen([path(), command, *options, "-"], stdin=given, stdout=out, stderr=told)
        try:
            wait(child)
        except BaseException:
            child.kill()
            child.wait()
            raise
        printed, message = (read(file) for file in (out, told))
    if child.returncode == 0:
        return printed
    if child.returncode == 1:
        raise SceneError("scene", text, (), message)
    if child.returncode == 3:
        raise OSError(message.removeprefix("error: "))
    raise RuntimeError(message.removeprefix("error: ") or f"the program ended with {child.returncode}")


def wait(child: subprocess.Popen[bytes]) -> None:
    """Until it ends: `Popen.wait` would hold Ctrl+C back for a quarter of a second."""
    pause = 1e-3
    while child.poll() is None:
        time.sleep(pause)
        pause = min(2 * pause, 0.02)


def read(file: IO[bytes]) -> str:
    """All that was written to a file."""
    file.seek(0)
    return file.read().decode(errors="replace").strip()
