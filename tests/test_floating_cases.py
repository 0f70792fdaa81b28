"""The load cases of a floating crane in FMPy and in the book, against the independent hull of the floating crane's test: each
case with its own weights, wind, pull and open compartments."""

import math
import re

import pytest
from scipy.optimize import brentq

from conftest import lemnis, typst, words
from test_floating import SCENE, WIND, T, at, box, fmus  # noqa: F401
from test_floating import AXIS, HIGH, MASSES, RAKED, TANKS, Hull, raked

PHI_F = math.radians(20.0)
OPENINGS = [(-22.0, 8.0, 7.2), (-22.0, -8.0, 7.2)]
# Slewing angle (where the case has none, that of the FMU), reach, load, wind and pull over those at work, flooded.
FREE = math.radians(70.0)
CASES = {
    1: (0.0, 20.0, 3 * T, 1100.0, 0.0, []),
    2: (0.0, 20.0, 3 * T, 500.0, 400e3, []),
    3: (FREE, 25.0, 50 * T, 250.0, 0.0, [(box(8.0, 6.0, 4.5, -22.0, 9.0), 0.95)]),
}
LIMITS = {
    1: {"phi_k": 5.0, "phi_dk": 15.0, "K_ck": 1.0, "GM_k": 0.15},
    2: {"phi_k": 5.0, "theta_k": 3.0, "A_k": 4.57, "K_ck": 1.0},
    3: {"phi_k": 15.0, "f_k": 0.1, "A_k": 3.05, "GM_k": 0.1},
}
LEAST = ("f_k", "A_k", "K_ck", "GM_k")


def hull(case, lost=False):
    psi, reach, load, pressure, pull, flooded = CASES[case]
    hung = [] if lost else [(load, AXIS + reach * math.cos(psi), reach * math.sin(psi), HIGH)]
    chi, moment = math.radians(40.0), pull * (5.0 - 1.1)
    found = Hull(box(60.0, 24.0, 4.5), MASSES + hung, TANKS,
                 (moment * math.cos(chi), WIND * pressure / 250.0 + moment * math.sin(chi)))
    found.open = flooded
    return found


def floods(of, side):
    """Least heel at which an opening comes to the water, at the trim of least energy."""
    def over(heel, place):
        draft, x, y = of.lying(side * heel, of.trim(side * heel).x)[1]
        return place[2] - draft - x * place[0] - y * place[1]

    return min(brentq(lambda heel: over(heel, place), 0.05, 0.9, xtol=1e-9) for place in OPENINGS if side * place[1] > 0)


@pytest.mark.parametrize("case", CASES)
@pytest.mark.parametrize("standard", ["FMI 2", "FMI 3"])
def test_each_case_is_a_hull_of_its_own(fmus, standard, case):  # noqa: F811
    names = ["phi_k", "theta_k", "f_k", "f_ok", "phi_ok", "A_k", "GM_k", "phi_2k", "rho_k", "phi_dk", "K_ck", "u_k"]
    # What slews and hangs at work is of no consequence where the case says it itself.
    found = at(fmus[standard], [f"{name}[{case}]" for name in names], psi_sl=FREE, R=22.0, Q=60 * T)
    found = {name: found[f"{name}[{case}]"] for name in names}
    own, empty = hull(case), hull(case, lost=True)
    draft, along, across = own.rest()
    size = math.sqrt(1 + along**2 + across**2)
    free = min(4.5 - draft - x * along - y * across for x in (30, -30) for y in (12, -12)) / size
    high = min(z - draft - x * along - y * across for x, y, z in OPENINGS) / size
    heel, side = math.atan(across), math.copysign(1.0, across)
    opens = floods(own, side)
    end = side * min(PHI_F, opens)
    wanted = {"phi_k": heel, "theta_k": math.atan(along), "f_k": free, "f_ok": high, "phi_ok": opens,
              "A_k": own.energy(end) - own.energy(heel)}
    rest = math.atan(empty.rest()[2])
    low = empty.energy(rest)
    # The load is lost: it rolls to the other side of where it rests without it.
    back = 1.0 if heel < rest else -1.0
    far = back * min(PHI_F, floods(empty, -side))
    drives, stops = empty.energy(heel) - low, empty.energy(far) - low
    if abs(heel - rest) > 1e-3:
        wanted["phi_2k"] = brentq(lambda phi: empty.energy(phi) - low - drives, far, rest + back * 1e-4, xtol=1e-10)
    else:
        # A load over the middle hardly rolls the hull: as far beyond its rest as it was before.
        assert found["phi_2k"] == pytest.approx(2 * rest - heel, abs=1e-5)
    wanted["rho_k"] = stops / (drives + math.radians(2.13))
    struck = hull(case)
    struck.moments[1] += side * WIND
    start = heel - side * math.radians(2.0)
    high, at_rest = struck.energy(start), math.atan(struck.rest()[2])
    wanted["phi_dk"] = brentq(lambda phi: struck.energy(phi) - high, end, at_rest + side * 1e-3, xtol=1e-10)
    for name, value in wanted.items():
        assert found[name] == pytest.approx(value, rel=2e-6, abs=2e-7), name
    step = 1e-4
    upright = hull(case)
    upright.moments[1] -= upright.gravity(0.0, 0.0)[1] * upright.weight
    if not own.open:
        slope = (upright.energy(step) + upright.energy(-step) - 2 * upright.energy(0.0)) / step**2
        assert found["GM_k"] == pytest.approx(slope, rel=3e-4)
    parts = [abs(found[name]) / limit if name not in LEAST else limit / found[name]
             for name, limit in ((name, limit if name in ("f_k", "K_ck", "GM_k") else math.radians(limit)) for name, limit in LIMITS[case].items())]
    assert found["u_k"] == pytest.approx(max(*parts, 1 / found["rho_k"]), rel=1e-12)


def test_a_case_that_changes_nothing_is_that_of_the_hull(tmp_path):
    """To the last bit."""
    text = SCENE.read_text(encoding="utf-8")
    head, rest = text.split("[[hull.load_cases]]", 1)
    tail = rest[rest.index("[hull.motion]"):]
    text = head + '[[hull.load_cases]]\nname = "The same"\nphi_max = "5 deg"\n' + tail
    path = tmp_path / "same.toml"
    path.write_text(text.replace('cases = ["Accident"]', ""), encoding="utf-8")
    lemnis("fmu", path, "--output", tmp_path)
    pairs = {"phi": "phi_k", "theta": "theta_k", "f_low": "f_k", "A_res": "A_k", "phi_2": "phi_2k", "phi_dyn": "phi_dk",
             "K_c": "K_ck", "GM": "GM_k"}
    names = [*pairs, *(f"{name}[1]" for name in pairs.values())]
    found = at(str(tmp_path / "FloatingCraneStatic.fmu"), names, psi_sl=4.0, R=25.0, Q=100 * T)
    for own, case in pairs.items():
        assert found[own] == found[f"{case}[1]"], own


@pytest.mark.parametrize("language", ["en", "zh", "bg"])
def test_the_book_judges_all_cases(language, tmp_path):
    lemnis("book", SCENE, "--language", language, "--format", "typ", "--output", tmp_path)
    book = typst(tmp_path / "FloatingCraneStatic.typ")
    known = words(language)
    names = {"en": ["At work", "Out of service", "Tow", "Accident"], "zh": ["工作", "非工作", "拖航", "事故"],
             "bg": ["Работа", "Извън работа", "Буксиране", "Авария"]}[language]
    assert known["chapter"]["afloat_cases"] in book and known["afloat_cases"]["judged_title"] in book
    judged = book[book.index(known["afloat_cases"]["judged_title"]):]
    places = [judged.index(f"[{name}]") for name in names]
    assert places == sorted(places)
    assert "46 CFR 173.020" in judged and known["afloat_cases"]["to_confirm"] in judged
    start = known["text"]["governing_case"].split("#")[0]
    assert start in book


@pytest.mark.parametrize("language", ["en", "zh", "bg"])
def test_the_book_lists_the_points_of_all_sections(language, tmp_path):
    path = tmp_path / "raked.toml"
    path.write_text(raked(RAKED), encoding="utf-8")
    lemnis("book", path, "--language", language, "--format", "typ", "--output", tmp_path)
    book = typst(next(tmp_path.glob("*.typ")))
    table = book[book.index(words(language)["table"]["afloat_sections"]):]
    rows = re.findall(r"^ *\[([^\]]*)\],\s*\[([^\]]*)\],\s*\[([^\]]*)\],$", table, re.M)
    told = [tuple(float(cell.replace(",", ".").replace("−", "-")) for cell in row) for row in rows[: sum(len(points) for _, points in RAKED)]]
    assert told == [(x, y, z) for x, points in RAKED for y, z in points]
