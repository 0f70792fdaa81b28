"""What Lemnis says of the moments that a luffing drive overcomes, against an oracle of the geometry alone
(`tests/oracles/luffing_resistances.py`, where each moment is found by power and by equilibrium)."""

import csv
import io

import pytest

from conftest import ROOT, lemnis

with open(ROOT / "tests/oracles/luffing_resistances.csv", encoding="utf-8") as file:
    # Own weights and load are those of the scenes in case I.
    ORACLE = [row for row in csv.DictReader(file) if row["case"] == "I"]


def table(scene):
    """Columns without their units, in SI, by the angle in degrees."""
    rows = list(csv.reader(io.StringIO(lemnis("check", ROOT / f"models/scenes/{scene}.toml", "--csv"))))
    names, units = zip(*(head[:-1].split(" [") for head in rows[0]))
    scale = [1e3 if unit.startswith("kN") else 1.0 for unit in units]
    return {float(row[0]): {name: float(x) * by for name, x, by in zip(names, row, scale) if x} for row in rows[1:]}


# Moment of the own weights left by the balance, and the drive's force that presses its ends apart.
@pytest.mark.parametrize("scene, own, force", [
    ("portal_004_new", lambda row: row["dM"], lambda row: row["F_d"]),
    ("rope_luffing", lambda row: -row["M_G"], lambda row: -row["T"]),
])
def test_own_weights_load_and_drive_at_rest_are_those_of_the_oracle(scene, own, force):
    found = table(scene)
    rows = [row for row in ORACLE if row["crane"] == scene]
    assert len(rows) >= 20
    for row in rows:
        expected = {name: float(row[name]) for name in ("own", "load", "sum", "force")}
        at = found[float(row["angle"])]
        # The greatest moments that these are small differences of.
        size = 4e6
        assert abs(own(at) - expected["own"]) <= 1e-13 * size, row["angle"]
        assert abs(-at["M_Q"] - expected["load"]) <= 1e-13 * size, row["angle"]
        rest = expected["own"] + expected["load"]
        arm = abs(expected["sum"] / expected["force"])
        assert abs(force(at) - expected["force"] / expected["sum"] * rest) <= 1e-13 * size / min(arm, 1.0), row["angle"]
