"""Travel of a crane on a portal in FMPy, both standards and both interfaces, and in the book."""

import numpy as np
import pytest
from fmpy import read_model_description, simulate_fmu
from fmpy.validation import validate_fmu

from conftest import ROOT, lemnis, typst, words

ENDS = {"FMI 2": ".fmi2.fmu", "FMI 3": ".fmu"}
SCENE = ROOT / "models/scenes/portal_travel.toml"
G = 9.81
# The scene's numbers, in SI; what it leaves at the usual: lever arm, friction, flanges, adhesion, safety.
V, A, SLOPE, WHEEL, BEARING, ARM, MU, FLANGE, GRIP, BRAKES, SAFETY = 26 / 60, 0.1, np.radians(0.15), 0.5, 0.12, 6e-4, 0.015, 1.5, 0.14, 85e3, 1.1
MOTORS, RATIO, ETA, RATED, INERTIA = 8, 58, 0.9, 5.5e3, 0.09
AREAS = [(34, 7), (62, 19)]
PORTAL = [(92e3 * G, 0.0, 0.0), (4e3 * G, -2.5, 3.0)]
UPPER = [(62e3 * G, -1.1), (19e3 * G, 8.5), (24e3 * G, -5.2)]
SIDE = 10.5
CORNERS = [(1, -1), (1, 1), (-1, 1), (-1, -1)]


def by_hand(psi, load):
    """What resists, motors, a stop, driven wheels, as a designer writes them down."""
    empty = sum(g for g, *_ in PORTAL + UPPER)
    weight = empty + load
    free = weight * np.cos(SLOPE) * (2 * ARM + MU * BEARING) / WHEEL
    wind = 250 * sum(area for area, _ in AREAS)
    start = FLANGE * free + weight * np.sin(SLOPE) + wind + weight / G * A
    drives = wind + weight * np.sin(SLOPE) - free
    shafts = MOTORS * INERTIA * (2 * RATIO / WHEEL) ** 2
    rate = (BRAKES - drives) / (weight / G + shafts)
    moment = sum(g * r for g, r in UPPER) + load * 25.0
    m_x = sum(g * y for g, _, y in PORTAL) + moment * np.sin(psi)
    m_y = sum(g * x for g, x, _ in PORTAL) - 250 * sum(a * h for a, h in AREAS) + moment * np.cos(psi)
    found = {"F_ta": start, "P_a": (start * V / ETA + shafts * A * V) / MOTORS, "s_br": V**2 / (2 * rate),
             "F_tb": weight / G * rate + drives}
    for corner, (front, left) in enumerate(CORNERS, 1):
        wheel = (weight / 4 + (front * m_y + left * m_x) / (2 * SIDE)) / 8
        found[f"k_st[{corner}]"] = 24 * GRIP * wheel / start
        found[f"k_br[{corner}]"] = 24 * GRIP * wheel / found["F_tb"]
    storm = SAFETY * 1100 * sum(a * h for a, h in AREAS)
    holds = empty * SIDE / 2 - (sum(g * x for g, x, _ in PORTAL) + sum(g * r for g, r in UPPER) * np.cos(psi))
    found["U[1]"] = (storm - holds) / SIDE
    return found


@pytest.fixture(scope="module")
def fmus(tmp_path_factory):
    folder = tmp_path_factory.mktemp("travel")
    lemnis("fmu", SCENE, "--output", folder)
    return {standard: str(folder / f"PortalTravel{end}") for standard, end in ENDS.items()}


@pytest.mark.parametrize("standard", ENDS)
def test_its_parameters_and_results(fmus, standard):
    assert not validate_fmu(fmus[standard])
    variables = {variable.name: variable for variable in read_model_description(fmus[standard]).modelVariables}
    assert {name: variables[name].causality for name in ("v_t", "n_dr[4]", "p_s", "k_st[1]", "F_cl", "U[4]", "s_br")} == {
        "v_t": "parameter", "n_dr[4]": "parameter", "p_s": "parameter", "k_st[1]": "output", "F_cl": "calculatedParameter", "U[4]": "output",
        "s_br": "output"}


@pytest.mark.parametrize("kind", ["CoSimulation", "ModelExchange"])
@pytest.mark.parametrize("standard", ENDS)
def test_a_crane_that_slews_with_less_and_less_load(fmus, standard, kind):
    times = np.linspace(0.0, 40.0, 41)
    inputs = np.array([(t, np.radians(9.0) * t, 156960.0 - 3e3 * t) for t in times],
                      dtype=[(name, float) for name in ("time", "psi", "Q")])
    names = list(by_hand(0.0, 0.0))
    result = simulate_fmu(fmus[standard], fmi_type=kind, stop_time=40.0, output_interval=1.0, input=inputs, output=["psi", "Q", *names])
    wanted = by_hand(result["psi"], result["Q"])
    assert np.ptp(result["psi"]) > 6.0 and np.ptp(result["Q"]) > 1e5
    for name in names:
        assert np.allclose(result[name], wanted[name], rtol=1e-11, atol=1e-7), name


@pytest.mark.parametrize("language", ["en", "zh", "bg"])
def test_the_book_has_travel_and_storm(language, tmp_path):
    lemnis("book", SCENE, "--language", language, "--format", "typ", "--output", tmp_path)
    book, known = typst(tmp_path / "PortalTravel.typ"), words(language)
    for section in ("portal_travel", "portal_motors", "portal_stop", "portal_storm", "portal_grip", "portal_tied"):
        assert known["section"][section] in book, section
    for check in ("portal_power", "portal_start", "portal_hold", "portal_stop", "portal_grip", "portal_sliding", "portal_clamps",
                  "portal_anchors"):
        assert known["check"][check] in book, check
