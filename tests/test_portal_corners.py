"""Corner loads of a crane on a portal in FMPy, both standards and both interfaces, and in the book."""

import math

import numpy as np
import pytest
from fmpy import read_model_description, simulate_fmu
from fmpy.validation import validate_fmu

from conftest import ROOT, lemnis, typst, words

ENDS = {"FMI 2": ".fmi2.fmu", "FMI 3": ".fmu"}
SCENE = ROOT / "models/scenes/portal_corner_loads.toml"
G = 9.81
BASE = GAUGE = 10.5
# Weights and places of the scene: portal, upper works; the wind blows to the left.
PORTAL = [(78e3 * G, 0.0, 0.0), (4e3 * G, -2.5, 3.0)]
UPPER = [(62e3 * G, -1.1), (19e3 * G, 8.5), (24e3 * G, -5.2)]
# Where a hopper stands that is put on the portal.
HOPPER = (3.5, -2.0)
WIND = 250.0 * (34.0 * 7.0 + 62.0 * 19.0)
SIDES = [(1, -1), (1, 1), (-1, 1), (-1, -1)]


def by_hand(psi, reach, load, hopper=0.0):
    """Weight, moments, corner loads of rigid and hinged portal, as the textbook has them; with a hopper of a weight."""
    weight = sum(g for g, *_ in PORTAL + UPPER) + load + hopper
    moment = sum(g * r for g, r in UPPER) + load * reach
    m_x = sum(g * y for g, _, y in PORTAL) + hopper * HOPPER[1] + WIND + moment * np.sin(psi)
    m_y = sum(g * x for g, x, _ in PORTAL) + hopper * HOPPER[0] + moment * np.cos(psi)
    rigid = [weight / 4 + front * m_y / (2 * BASE) + left * m_x / (2 * GAUGE) for front, left in SIDES]
    hinged = [weight * (0.5 + front * m_y / (weight * BASE)) * (0.5 + left * m_x / (weight * GAUGE)) for front, left in SIDES]
    return weight, m_x, m_y, np.array(rigid), np.array(hinged)


@pytest.fixture(scope="module")
def fmus(tmp_path_factory):
    folder = tmp_path_factory.mktemp("portal")
    lemnis("fmu", SCENE, "--output", folder)
    return {standard: str(folder / f"PortalCornerLoads{end}") for standard, end in ENDS.items()}


@pytest.mark.parametrize("standard", ENDS)
def test_its_inputs_and_results(fmus, standard):
    assert not validate_fmu(fmus[standard])
    description = read_model_description(fmus[standard])
    variables = {variable.name: variable for variable in description.modelVariables}
    assert {name: variables[name].causality for name in ("psi", "R", "Q", "a", "n_w[1]", "N[1]", "N_r[4]", "N_h[2]", "N_cir")} == {
        "psi": "input", "R": "input", "Q": "input", "a": "parameter", "n_w[1]": "parameter", "N[1]": "output", "N_r[4]": "output",
        "N_h[2]": "output", "N_cir": "output"}
    assert variables["lifts"].type == "Boolean" and variables["leg"].type == "Enumeration"
    assert int(description.numberOfEventIndicators) == 1


@pytest.mark.parametrize("kind", ["CoSimulation", "ModelExchange"])
@pytest.mark.parametrize("standard", ENDS)
def test_corner_loads_of_a_crane_that_slews_and_luffs(fmus, standard, kind):
    times = np.linspace(0.0, 40.0, 41)
    given = {"psi": np.radians(9.0) * times, "R": 9.0 + 0.4 * times, "Q": 160e3 - 1e3 * times}
    inputs = np.array(list(zip(times, *given.values())), dtype=[(name, float) for name in ("time", *given)])
    corners = [f"{name}[{corner}]" for name in ("N_r", "N_h") for corner in range(1, 5)]
    result = simulate_fmu(fmus[standard], fmi_type=kind, stop_time=40.0, output_interval=1.0, input=inputs,
                          output=["psi", "R", "Q", "V", "M_x", "M_y", *corners])
    weight, m_x, m_y, rigid, hinged = by_hand(result["psi"], result["R"], result["Q"])
    assert np.ptp(result["psi"]) > 6.0
    for name, wanted in [("V", weight), ("M_x", m_x), ("M_y", m_y), *zip(corners, [*rigid, *hinged])]:
        assert np.allclose(result[name], wanted, rtol=0.0, atol=1e-12 * BASE * weight.max()), name


@pytest.mark.parametrize("standard", ENDS)
def test_a_leg_lifts_at_an_event(fmus, standard):
    """The load grows by 10 kN/s over corner 2 until that across is free, just where the textbook's form is zero."""
    psi, reach = math.radians(45.0), 25.0
    times = np.array([0.0, 100.0])
    inputs = np.array([(t, 10e3 * t, reach, psi) for t in times], dtype=[(name, float) for name in ("time", "Q", "R", "psi")])
    result = simulate_fmu(fmus[standard], fmi_type="ModelExchange", stop_time=60.0, output_interval=0.5, input=inputs,
                          relative_tolerance=1e-9, record_events=True, output=["Q", "lifts", "leg", "N_r[4]", "N_4[4]"])
    low, high = (by_hand(psi, reach, load)[3][3] for load in (0.0, 600e3))
    free = 600e3 * low / (low - high)
    first = result["time"][np.argmax(result["lifts"])]
    assert -1e-6 <= first - free / 10e3 <= 1e-3
    lifted = result["lifts"].astype(bool)
    bears = result["N_4[4]"] > 1.0
    assert lifted[-1] and set(result["leg"][lifted]) == {5} and set(result["leg"][bears]) == {1} and not lifted[bears].any()
    assert not result["N_r[4]"][lifted].any() and (result["N_4[4]"][lifted] < 1e-6).all()


@pytest.mark.parametrize("language", ["en", "zh", "bg"])
def test_the_book_has_both_portals(language, tmp_path):
    lemnis("book", SCENE, "--language", language, "--format", "typ", "--output", tmp_path)
    book = typst(tmp_path / "PortalCornerLoads.typ")
    known = words(language)
    for section in ("portal_circle", "portal_four", "portal_rigid", "portal_hinged", "portal_tipping"):
        assert known["section"][section] in book, section
    for check in ("portal_wheel", "portal_lift", "portal_tipping", "portal_springs", "portal_circle", "portal_peak"):
        assert known["check"][check] in book, check
    # The greatest corner loads over the circle, with four digits.
    around = np.radians(np.arange(0.0, 360.0, 0.01))
    _, _, _, rigid, hinged = by_hand(around, 25.0, 16e3 * G)
    for loads in (rigid, hinged):
        text = f"{loads.max() / 1e3:.1f}"
        assert (text.replace(".", ",") if language == "bg" else text) in book, text


@pytest.fixture(scope="module")
def with_hopper(tmp_path_factory):
    """The same crane with a hopper."""
    folder = tmp_path_factory.mktemp("hopper")
    table = '[supports.hopper]\nG_h0 = "120 kN"\nx_h = "3.5 m"\ny_h = "-2 m"\nQ_h = { input = "150 kN" }\nQ_hf = "400 kN"\n\n'
    text = SCENE.read_text("utf-8").replace("PortalCornerLoads", "WithHopper", 1)
    assert "[supports.wind]" in text
    (folder / "hopper.toml").write_text(text.replace("[supports.wind]", table + "[supports.wind]", 1), encoding="utf-8")
    lemnis("fmu", folder / "hopper.toml", "--output", folder)
    return folder


@pytest.mark.parametrize("kind", ["CoSimulation", "ModelExchange"])
@pytest.mark.parametrize("standard", ENDS)
def test_a_hopper_is_filled_while_it_slews(with_hopper, standard, kind):
    path = str(with_hopper / f"WithHopper{ENDS[standard]}")
    variables = {variable.name: variable for variable in read_model_description(path).modelVariables}
    assert {name: variables[name].causality for name in ("Q_h", "Q_hf", "G_h0", "V_h", "u_h")} == {
        "Q_h": "input", "Q_hf": "parameter", "G_h0": "parameter", "V_h": "output", "u_h": "output"}
    times = np.linspace(0.0, 40.0, 41)
    given = {"psi": np.radians(9.0) * times, "R": 9.0 + 0.4 * times, "Q": 160e3 - 1e3 * times, "Q_h": 1e4 * times}
    inputs = np.array(list(zip(times, *given.values())), dtype=[(name, float) for name in ("time", *given)])
    corners = [f"{name}[{corner}]" for name in ("N_r", "N_h") for corner in range(1, 5)]
    result = simulate_fmu(path, fmi_type=kind, stop_time=40.0, output_interval=1.0, input=inputs,
                          output=[*given, "V", "M_x", "M_y", "V_h", "u_h", *corners])
    hopper = 120e3 + result["Q_h"]
    weight, m_x, m_y, rigid, hinged = by_hand(result["psi"], result["R"], result["Q"], hopper)
    assert np.ptp(result["Q_h"]) > 3e5 and rigid.min() > 0
    wanted = [("V", weight), ("M_x", m_x), ("M_y", m_y), ("V_h", hopper), *zip(corners, [*rigid, *hinged])]
    for name, by in wanted:
        assert np.allclose(result[name], by, rtol=0.0, atol=1e-12 * BASE * weight.max()), name
    assert np.allclose(result["u_h"], result["Q_h"] / 400e3, rtol=1e-14)


@pytest.mark.parametrize("language", ["en", "zh", "bg"])
def test_the_book_tells_of_the_hopper(with_hopper, language, tmp_path):
    lemnis("book", with_hopper / "hopper.toml", "--language", language, "--format", "typ", "--output", tmp_path)
    book = typst(tmp_path / "WithHopper.typ")
    known = words(language)
    for said in (known["section"]["portal_hopper"], known["purpose"]["portal_hopper"], known["input"]["portal_hopper"]):
        assert said in book, said
