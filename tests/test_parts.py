"""Only what the scene requires: with every part that leaves a crane, whatever can be counted falls."""

import re
import shutil
import subprocess
import sys

import pytest

from conftest import ROOT

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="instructions are counted on Linux, where valgrind is")

COLUMNS = ["crane", "asked for", "states", "variables", "saved", "xml", "instructions"]


@pytest.fixture(scope="module")
def tables():
    """The benchmark's tables, each a list of rows; times are left out."""
    assert shutil.which("valgrind"), "valgrind is missing: apt-get install valgrind"
    done = subprocess.run(["cargo", "bench", "--workspace", "--bench", "levels"], cwd=ROOT, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    found = re.sub(r"\A.*?\n", "", done.stdout[done.stdout.index("crane "):], count=1).strip().split("\n\n")
    rows = [[re.match(r"(.+?) {2,}(\w+) +(\d+) +(\d+) +(\d+) +(\d+) +(\d+) +\d+$", line) for line in table.splitlines()]
            for table in found]
    return [[dict(zip(COLUMNS, [*row.groups()[:2], *map(int, row.groups()[2:])])) for row in table] for table in rows]


def test_every_part_that_leaves_takes_its_cost_along(tables):
    chains = [table for table in tables if len({row["crane"] for row in table}) > 1]
    assert [len(chain) >= 3 for chain in chains] == [True, True]
    for chain in chains:
        for whole, part in zip(chain, chain[1:]):
            for column in ("variables", "xml", "instructions"):
                assert part[column] < whole[column], (column, whole, part)
            # A balance has no state of its own, and the levels rigid and swing are saved with as many numbers.
            assert part["states"] <= whole["states"] and part["saved"] <= whole["saved"]
        assert chain[0]["states"] >= 10 and chain[-1]["states"] == 0


def test_what_is_not_asked_for_costs_nothing(tables):
    same = [table for table in tables if len({row["crane"] for row in table}) == 1]
    assert [len(table) for table in same] == [4, 4, 2]
    for table in same:
        for more, less in zip(table, table[1:]):
            assert less["instructions"] < more["instructions"], (more, less)
    # A crane with weights, load and drive, none of which is asked for, takes the steps of one without.
    static, kinematic = [{row["asked for"]: row["instructions"] for row in table} for table in same[1:]]
    for what in ("reach", "nothing"):
        assert static[what] == pytest.approx(kinematic[what], rel=0.01)
