"""What Lemnis says of the moments that a luffing drive overcomes, against an oracle of the geometry alone
(`tests/oracles/luffing_resistances.py`, where each moment is found by power and by equilibrium)."""

import csv
import io

import pytest

from conftest import ROOT, lemnis

with open(ROOT / "tests/oracles/luffing_resistances.csv", encoding="utf-8") as file:
    ORACLE = list(csv.DictReader(file))


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
    # Own weights and load are those of the scenes in case I.
    rows = [row for row in ORACLE if row["crane"] == scene and row["case"] == "I"]
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


MOMENTS = ("load", "sway", "wind", "centrifugal", "inertia", "slope", "friction", "sum")


@pytest.mark.parametrize("scene, crane", [("portal_004_drive", "portal_004_new"), ("rope_luffing_drive", "rope_luffing")])
def test_every_moment_of_every_case_is_that_of_the_oracle(scene, crane):
    found = table(scene)
    rows = [row for row in ORACLE if row["crane"] == crane]
    assert len(rows) >= 60 and {row["case"] for row in rows} == {"I", "II", "III"}
    for row in rows:
        at, case = found[float(row["angle"])], ("I", "II", "III").index(row["case"]) + 1
        expected = {name: float(row[name]) for name in ("own", *MOMENTS, "force")}
        # Own weights and balance are small differences of great moments.
        size = max(abs(x) for name, x in expected.items() if name != "force")
        assert abs(at["M_r_own"] - expected["own"]) <= 1e-12 * size, row
        for name in MOMENTS:
            assert abs(at[f"M_r_{name}[{case}]"] - expected[name]) <= 1e-12 * size, (name, row)
        assert abs(at[f"F_r[{case}]"] - expected["force"]) <= 1e-12 * abs(expected["force"]), row
