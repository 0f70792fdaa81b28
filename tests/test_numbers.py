"""Numbers that people read: no sign of zero, no endless digits, no NaN, and columns that stay aligned."""

import csv
import io
import json
import re
import subprocess

import pytest

from conftest import LEMNIS, ROOT, lemnis, typst

# Their levers do not keep to what their synthesis asks for.
FAILING = ("portal_004_four", "portal_004_synthesis")
READY = sorted((ROOT / "models/scenes").glob("*.toml"))

# A number, not a part of a name such as ports_001 or theta_1.
NUMBER = re.compile(r"(?<![\w.\[])[-−]?\d+(?:[.,]\d+)?(?:e-?\d+)?(?![\w\]])")


def checked(path, *options):
    """What `check` prints of a ready scene."""
    done = subprocess.run([str(LEMNIS), "check", str(path), *options], capture_output=True, text=True, encoding="utf-8")
    assert done.returncode == (4 if path.stem in FAILING else 0), done.stderr
    return done.stdout


def readable(text):
    for number in NUMBER.findall(text):
        digits = re.sub(r"\D", "", re.split("e", number)[0]).lstrip("0")
        assert len(digits) <= 17, number
        assert not re.fullmatch(r"[-−]0(?:[.,]0*)?", number), number
    assert not re.search(r"\b(?:NaN|nan|inf)\b", text)


@pytest.mark.parametrize("path", READY, ids=lambda path: path.stem)
def test_a_table_is_readable_and_aligned(path):
    text = checked(path)
    readable(text)
    blocks = [block.splitlines() for block in text.split("\n\n")]
    tables = [block for block in blocks if block[0].rstrip().endswith("]") and " [" in block[0]]
    assert tables
    for head, *rows in tables:
        assert rows and {len(row) for row in rows} == {len(head)}, head


@pytest.mark.parametrize("path", READY, ids=lambda path: path.stem)
def test_numbers_for_programs_have_no_negative_zero(path):
    for row in csv.reader(io.StringIO(checked(path, "--csv"))):
        assert not [cell for cell in row if re.fullmatch(r"-0(?:\.0*)?", cell)], row[0]
        assert not [cell for cell in row if len(re.sub(r"\D", "", cell.split("e")[0]).lstrip("0")) > 17], row[0]
    text = checked(path, "--json")
    json.loads(text)
    assert not re.search(r"-0\.0\b(?!\d)", text)


@pytest.mark.parametrize("path", READY, ids=lambda path: path.stem)
def test_books_have_no_negative_zero(path, tmp_path):
    lemnis("book", path, "--format", "typ", "--level", "full", "--output", tmp_path)
    source = typst(next(tmp_path.glob("*.typ")))
    assert not re.search(r"[-−]0(?![\d.,])", source)
