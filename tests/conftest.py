"""The program's results for the default scene, made once for all tests."""

import os
import re
import subprocess
import tomllib
from contextlib import closing
from pathlib import Path

import pypdfium2
import pytest

ROOT = Path(__file__).resolve().parent.parent
LEMNIS = ROOT / "target/release" / ("lemnis.exe" if os.name == "nt" else "lemnis")


def lemnis(*arguments, expect=0):
    """Runs the program and returns what it prints."""
    done = subprocess.run([str(LEMNIS), *map(str, arguments)], capture_output=True, text=True, encoding="utf-8")
    assert done.returncode == expect, done.stderr
    return done.stdout if expect == 0 else done.stderr


def typst(path):
    """A book's Typst source, in its equations every number apart from its unit: `"19.3 m"` as `19.3 thin"m"`."""
    def number(text):
        return text if text.isdecimal() or "." in text else f'"{text}"'

    def apart(quantity):
        digits, unit, degree = quantity.groups()
        return number(digits) + (f' thin"{unit}"' if unit else f'"{degree}"' if degree else "")

    def equation(found):
        return re.sub(r'"(\d[\d.,]*)(?:\u2006([^"]+)|(°[^"]*))?"', apart, found[0]).replace('"slash', '" slash')

    return re.sub(r"\$[^$]+\$", equation, path.read_text(encoding="utf-8"))


def words(language):
    """The words of a language, in groups, from the files of all components."""
    groups = {}
    for path in (ROOT / "templates/words" / language).glob("*.toml"):
        for group, some in tomllib.loads(path.read_text(encoding="utf-8")).items():
            groups.setdefault(group, {}).update(some)
    return groups


def text_of(path):
    """The text of every page of a PDF, with single spaces."""
    with closing(pypdfium2.PdfDocument(path)) as document:
        # PDFium has U+FFFE for a hyphen at the end of a line.
        return [" ".join(page.get_textpage().get_text_range().replace("\ufffe", "-").split()) for page in document]


# Files that take long, the longest first: at the end one process would wait for another.
LONG = ["platforms", "ready_books", "oil_parts", "trade", "book", "synth"]


def pytest_collection_modifyitems(items):
    names = [f"test_{name}.py" for name in LONG]
    items.sort(key=lambda item: names.index(item.path.name) if item.path.name in names else len(names))


@pytest.fixture(scope="session")
def out(tmp_path_factory):
    folder = tmp_path_factory.mktemp("out")
    lemnis("build", "--output", folder)
    lemnis("book", "--format", "typ", "--level", "full", "--output", folder)
    return folder


@pytest.fixture(params=["LemniscateCrane.fmu", "LemniscateCrane.fmi2.fmu"], ids=["FMI 3.0", "FMI 2.0"])
def fmu(request, out):
    return str(out / request.param)
