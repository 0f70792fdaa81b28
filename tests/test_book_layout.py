"""One system of units in a book, and one acceleration of free fall."""

import re

import pytest

from conftest import ROOT, lemnis, typst

SCENES = sorted(path.stem for path in (ROOT / "models/scenes").glob("*.toml"))
# Each would stand beside MPa, r/min or kN.
OTHERS = {"bar", "kPa", "N/mm²", "1/min", "rpm", "kgf", "Hz"}


@pytest.mark.parametrize("language", ["en", "zh", "bg"])
@pytest.mark.parametrize("name", SCENES)
def test_a_book_has_one_system_of_units_and_one_free_fall(name, language, tmp_path):
    lemnis("book", ROOT / f"models/scenes/{name}.toml", "--format", "typ", "--language", language, "--output", tmp_path)
    [path] = tmp_path.glob("*.typ")
    source = typst(path).split("#let column-head")[1]
    units = set(re.findall(r'thin ?"([^"]+)"', source))
    # With the heads of columns and the units of the notation.
    units |= set(re.findall(r"(?:\]\[|, \[)([^\[\]\s]{1,12})\]", source))
    assert {"m", "t"} & units and not units & OTHERS, units & OTHERS
    falls = set(re.findall(r'\b(9[.,]8(?:1|07|0665)?)"? thin"m/s²"', source))
    assert len(falls) <= 1, falls
    if "motion" in name:
        assert falls
