"""Strength of luffing drives against an oracle of statics (`tests/oracles/drive_strength.py`), under the forces of the
oracle of the moments (`tests/oracles/luffing_resistances.py`)."""

import csv
import io
import json

import pytest
from mpmath import diff, mpf, pi

from conftest import ROOT, lemnis
from oracles import drive_strength as strength
from oracles import luffing_resistances as resistances
from oracles.luffing_resistances import rad

UNITS = {"kN": 3, "MPa": 6, "mm": -3, "kN.m": 3}
STEEL = [mpf(x) for x in ("210e9", "355e6")]
# O1, B, C, O3, K, L, M of the portal crane; O1 of the boom.
SIZES = {
    "portal_004_drive": [(0.3, 0.4), (0.2, 0.2), (0.2, 0.2), (0.25, 0.25), (0.22, 0.25), (0.22, 0.25), (0.28, 0.3)],
    "rope_luffing_drive": [(0.12, 0.1)],
}


def table(path):
    """Columns in SI by the angle in degrees."""
    rows = list(csv.reader(io.StringIO(lemnis("check", path, "--csv"))))
    names, units = zip(*(head[:-1].split(" [") for head in rows[0]))
    scale = [10.0 ** UNITS.get(unit, 0) for unit in units]
    return {float(row[0]): {name: float(x) * by for name, x, by in zip(names, row, scale) if x} for row in rows[1:]}


def ready(scene):
    return table(ROOT / f"models/scenes/{scene}.toml")


def summary(scene):
    return json.loads(lemnis("check", ROOT / f"models/scenes/{scene}.toml", "--json"))["summary"]


def near(found, expected, what, within=1e-12):
    assert abs(found - expected) <= within * max(abs(expected), 1e-30), (what, found, expected)


def mm(text):
    return [mpf(x) / 1000 for x in text.split()]


def pins(scene, forces):
    all_pins = [strength.pin(mpf(str(d)), mpf(str(b)), f) for (d, b), f in zip(SIZES[scene], forces)]
    return [max(column) for column in zip(*all_pins)]


def rack(length, push):
    return strength.buckling(*STEEL, 4, 1, length, mpf("0.0238"), mpf("0.0404"), push)


def toothed(force, sector=None):
    width, module, pinion = mm("220 20 200")
    return strength.teeth(mpf("1.5"), mpf("2.8"), width, module, rad(20), mpf("206e9"), mpf("0.3"), pinion, force, sector)


def test_rack_and_pins_of_the_portal_crane_are_those_of_the_oracle():
    found, crane = ready("portal_004_drive"), resistances.DoubleLink()
    for degrees in (44, 50, 58, 66, 74, 82):
        at = found[float(degrees)]
        for number, case in enumerate(resistances.CASES.values(), 1):
            power, _, stroke = resistances.resistances(crane, case, rad(degrees))
            force, length = -sum(power) / stroke, crane.driven(rad(degrees))
            # The force is a small difference of great moments.
            within = 1e-12 * float(max(abs(x) for x in power) / abs(sum(power)))
            lam, use = rack(length, force)
            bending, contact = toothed(force)
            pressure, shear = pins("portal_004_drive", crane.carried)
            near(at["lambda_k"], lam, "lambda_k")
            expected = {"u_k": use, "sigma_F": bending, "sigma_H": contact}
            for id, value in expected.items():
                near(at[f"{id}[{number}]"], value, (degrees, number, id), within)
            near(at[f"p_b[{number}]"], pressure, (degrees, number, "p_b"))
            near(at[f"tau_p[{number}]"], shear, (degrees, number, "tau_p"))


def test_rope_and_pin_of_the_boom_are_those_of_the_oracle():
    found, crane = ready("rope_luffing_drive"), resistances.RopeBoom()
    slack = False
    for degrees in (25, 37, 51, 65, 77):
        at = found[float(degrees)]
        for number, case in enumerate(resistances.CASES.values(), 1):
            power, _, stroke = resistances.resistances(crane, case, rad(degrees))
            pull, use = strength.rope(8, mpf("0.93"), mpf(252000), mpf("5.6"), -sum(power) / stroke)
            within = 1e-12 * float(max(abs(x) for x in power) / abs(sum(power)))
            near(at[f"S_w[{number}]"], pull, (degrees, number), within)
            near(at[f"u_w[{number}]"], use, (degrees, number), within)
            pressure, shear = pins("rope_luffing_drive", crane.carried)
            near(at[f"p_b[{number}]"], pressure, (degrees, number))
            near(at[f"tau_p[{number}]"], shear, (degrees, number))
            slack |= pull < 0
    told = summary("rope_luffing_drive")
    near(told["h_tr"]["value"], mpf(20), "h_tr")
    near(told["h_sh"]["value"], mpf("22.5"), "h_sh")
    assert told["S_w_min"]["value"] < 0
    assert slack, "empty, with the storm from the front, the boom falls back"


def test_the_screw_at_rest_is_that_of_the_oracle():
    found, crane = ready("portal_004_screw"), resistances.DoubleLink()
    d_2, lead, core, overlap, pitch, nut = mm("112 14 104 7 14 250")
    for degrees in (44, 52, 62, 72, 82):
        at, rest = found[float(degrees)], ("1", "0", "0", "0", "0", "0", "0")
        power, _, stroke = resistances.resistances(crane, rest, rad(degrees))
        force, length = -sum(power) / stroke, crane.driven(rad(degrees))
        # As the balance's own moments, of which these are small differences.
        within = 1e-13 * float(4e6 / abs(sum(power)))
        near(at["F_r[1]"], force, degrees, within)
        near(at["F_d"], force, degrees, within)
        lam, use = strength.buckling(*STEEL, mpf("2.5"), 1, length - mpf("2.5"), *strength.round_bar(core), force)
        near(at["lambda_k"], lam, degrees)
        near(at["u_k[1]"], use, degrees, within)
        pressure, torque, stress = strength.screw(d_2, lead, mpf("0.12"), rad(15), core, overlap, pitch, nut, force)
        for id, value in {"p_n": pressure, "T_n": torque, "sigma_v": stress}.items():
            near(at[f"{id}[1]"], value, (degrees, id), within)


def test_the_parabola_touches_the_hyperbola():
    for e, yields in ((STEEL), (mpf("70e9"), mpf("250e6"))):
        meets, _ = strength.johnson(e, yields)
        below, above = (diff(lambda x: strength.critical(e, yields, x), meets, direction=side) for side in (-1, 1))
        assert abs(strength.critical(e, yields, meets) / yields - 0.5) < 1e-30
        assert abs(below / above - 1) < 1e-12


DRIVE = (ROOT / "models/scenes/portal_004_drive.toml").read_text(encoding="utf-8")


def cut(text, *tables):
    """Without these tables."""
    parts = text.split("\n[")
    return "\n[".join(part for part in parts if not part.startswith(tables))


def other(folder, old, new, *tables):
    """The portal crane with another drive; without teeth and their limits where those tables go."""
    text = cut(DRIVE, *tables)
    for line in old:
        assert line in text, line
        text = text.replace(line, "")
    kind = 'kind   = "rack"\n'
    assert kind in text
    path = folder / "other.toml"
    path.write_text(text.replace(kind, new), encoding="utf-8")
    return path


TEETH = ('sigma_F_max = "250 MPa"       # root of the teeth\n', 'sigma_H_max = "1150 MPa"      # their flanks\n')
PINION = ('r_z    = "200 mm"             # pitch radius of the pinion\n', 'eta_d  = "0.97"               # pinion and rack\n')
PROFILE = ('A_k     = "0.0238 m2"\n', 'i_min   = "40.4 mm"\n')


def test_a_cylinder_is_pressed_on_bore_or_annulus_and_buckles_as_its_rod(tmp_path):
    kind = 'kind = "cylinder"\nD_c = "200 mm"\nd_r = "160 mm"\n'
    found = table(other(tmp_path, (*TEETH, *PINION, *PROFILE), kind, "cases.teeth"))
    bore, rod = mm("200 160")
    signs, kinds = set(), set()
    for at in found.values():
        for number in (1, 2, 3):
            force = mpf(at[f"F_r[{number}]"])
            near(at[f"p_C[{number}]"], strength.cylinder(bore, rod, force), number)
            lam, use = strength.buckling(*STEEL, 4, 1, mpf(at["L_d"]), *strength.round_bar(rod), force)
            near(at["lambda_k"], lam, "lambda_k")
            near(at[f"u_k[{number}]"], use, number)
            signs.add(force > 0)
            kinds.add(lam > strength.johnson(*STEEL)[0])
    # Both senses of the force, and at the ends of the stroke an elastic bar and a stouter one.
    ends = [found[x]["lambda_k"] for x in (44.0, 82.0)]
    assert signs == {True, False}
    assert ends[0] > ends[1] and kinds == {True, False}, ends


def test_teeth_of_a_sector_are_curved_themselves(tmp_path):
    lines = dict.fromkeys(line + "\n" for line in DRIVE.splitlines() if line.startswith(("E_x ", "E_y ", "s_d ", "chi_d ", "K_b ")))
    kind = 'kind = "sector"\nr_s = "4 m"\ndelta_s = "200 deg"\n'
    found = table(other(tmp_path, lines, kind, "cases.buckling", "cases.motor", "cases.brake", "cases.second_brake"))
    for at in found.values():
        for number in (1, 2, 3):
            bending, contact = toothed(mpf(at[f"F_r[{number}]"]), mpf(4))
            near(at[f"sigma_F[{number}]"], bending, number)
            near(at[f"sigma_H[{number}]"], contact, number)


def degrees_of(place):
    return float(place * 180 / pi)


@pytest.mark.parametrize("scene, results", [
    ("portal_004_drive", ("u_k", "sigma_F", "sigma_H", "p_b", "tau_p")),
    ("rope_luffing_drive", ("u_w", "p_b", "tau_p")),
    ("portal_004_screw", ("u_k", "p_n", "sigma_v")),
])
def test_the_governing_case_and_position_are_those_of_the_table(scene, results):
    found = ready(scene)
    told = summary(scene)
    for id in results:
        most, at = max((value, degrees) for degrees, row in found.items() for name, value in row.items() if name.split("[")[0] == id)
        governing = told[f"{id}_max"]
        (place,) = governing["at"].values()
        assert most * (1 - 1e-12) <= governing["value"] <= most * 1.01, (id, most, governing)
        assert abs(degrees_of(place) - at) <= 1, (id, at, governing)
