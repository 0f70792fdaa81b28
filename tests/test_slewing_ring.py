"""The slewing ring of a portal crane in FMPy, both standards and both interfaces, and in the book."""

import math

import numpy as np
import pytest
from fmpy import read_model_description, simulate_fmu
from fmpy.validation import validate_fmu

from conftest import ROOT, lemnis, typst, words

ENDS = {"FMI 2": ".fmi2.fmu", "FMI 3": ".fmu"}
SCENE = ROOT / "models/scenes/slewing_portal.toml"
G = 9.81
# Weights, places and heights of the scene; its slope and height of suspension; wind areas with their heights.
UPPER = [(62e3 * G, -1.1, 3.5), (19e3 * G, 8.5, 14.0), (24e3 * G, -5.2, 6.0)]
SLOPE, HIGH = math.radians(0.3), 22.0
AREAS = [(38.0, 4.0), (24.0, 13.0)]
CASES = [(1.0, 250.0), (1.25, 40.0), (0.0, 800.0)]
DIAMETER, COUNT = 4.0, 120


def by_hand(psi, reach, load, case):
    """Vertical force, horizontal force and moment, in directions that do not slew; the wind blows across the slope."""
    factor, pressure = CASES[case]
    load = factor * load
    weight = sum(g for g, *_ in UPPER) + load
    own = sum(g * r for g, r, _ in UPPER) + load * reach
    lean = sum(g * h for g, _, h in UPPER) + load * HIGH
    wind = pressure * sum(a for a, _ in AREAS), pressure * sum(a * h for a, h in AREAS)
    m_x = own * math.cos(SLOPE) * np.cos(psi) + lean * math.sin(SLOPE)
    m_y = own * math.cos(SLOPE) * np.sin(psi) + wind[1]
    return weight * math.cos(SLOPE), np.hypot(weight * math.sin(SLOPE), wind[0]) + 0 * psi, np.hypot(m_x, m_y)


def spread(force, moment):
    """On rollers of line contact, held down: the fall of the approach by halving, until both sums are in proportion."""
    cosines = np.cos(2 * np.pi * np.arange(COUNT) / COUNT)

    def over(fall):
        approach = 1 - fall[:, None] * (1 - cosines)
        return np.sign(approach) * np.abs(approach) ** (10 / 9)

    def sums(fall):
        forces = over(fall)
        return forces.sum(axis=1), (forces * cosines).sum(axis=1) * DIAMETER / 2

    low, high = np.zeros(len(moment)), np.full(len(moment), 1.2)
    for _ in range(80):
        middle = (low + high) / 2
        whole, turn = sums(middle)
        small = turn * force < whole * moment
        low, high = np.where(small, middle, low), np.where(small, high, middle)
    whole, turn = sums(low)
    most = (force * DIAMETER / 2 + moment) / (whole * DIAMETER / 2 + turn)
    return over(low) * most[:, None]


@pytest.fixture(scope="module")
def fmus(tmp_path_factory):
    folder = tmp_path_factory.mktemp("ring")
    lemnis("fmu", SCENE, "--output", folder)
    return {standard: str(folder / f"SlewingPortal{end}") for standard, end in ENDS.items()}


@pytest.mark.parametrize("standard", ENDS)
def test_its_inputs_and_results(fmus, standard):
    assert not validate_fmu(fmus[standard])
    description = read_model_description(fmus[standard])
    variables = {variable.name: variable for variable in description.modelVariables}
    names = ("psi", "R", "Q", "D", "p_w[1]", "k_Q[2]", "V[1]", "M[3]", "P_max[2]", "sigma_H[1]", "S_0[2]", "M_fn[1]", "c_P")
    assert {name: variables[name].causality for name in names} == {
        "psi": "input", "R": "input", "Q": "input", "D": "parameter", "p_w[1]": "parameter", "k_Q[2]": "parameter", "V[1]": "output",
        "M[3]": "output", "P_max[2]": "output", "sigma_H[1]": "output", "S_0[2]": "output", "M_fn[1]": "output", "c_P": "calculatedParameter"}
    assert variables["lifts"].type == "Boolean" and "z" not in variables
    assert int(description.numberOfEventIndicators) == 1


@pytest.mark.parametrize("kind", ["CoSimulation", "ModelExchange"])
@pytest.mark.parametrize("standard", ENDS)
def test_loads_of_a_crane_that_slews_and_luffs(fmus, standard, kind):
    times = np.linspace(0.0, 40.0, 41)
    given = {"psi": np.radians(9.0) * times, "R": 9.0 + 0.4 * times, "Q": 160e3 - 1e3 * times}
    inputs = np.array(list(zip(times, *given.values())), dtype=[(name, float) for name in ("time", *given)])
    names = [f"{name}[{case}]" for name in "VHM" for case in (1, 2, 3)]
    forces = [f"P_max[{case}]" for case in (1, 2, 3)]
    result = simulate_fmu(fmus[standard], fmi_type=kind, stop_time=40.0, output_interval=1.0, input=inputs,
                          output=["psi", "R", "Q", *names, *forces])
    assert np.ptp(result["psi"]) > 6.0
    for case in range(3):
        wanted = by_hand(result["psi"], result["R"], result["Q"], case)
        for name, one in zip("VHM", wanted):
            assert np.allclose(result[f"{name}[{case + 1}]"], one, rtol=1e-12, atol=1e-9), name
        force, _, moment = wanted
        assert np.allclose(result[f"P_max[{case + 1}]"], spread(force, moment).max(axis=1), rtol=1e-10), case


@pytest.mark.parametrize("standard", ENDS)
def test_the_far_side_lifts_at_an_event(fmus, standard):
    """The load goes out until one of the cases would lift the ring behind, and back in: two events."""
    times = np.array([0.0, 30.0, 60.0])
    inputs = np.array([(t, r, 50e3, 0.0) for t, r in zip(times, (5.0, 30.0, 5.0))],
                      dtype=[(name, float) for name in ("time", "R", "Q", "psi")])
    result = simulate_fmu(fmus[standard], fmi_type="ModelExchange", stop_time=60.0, output_interval=0.25, input=inputs,
                          relative_tolerance=1e-9, record_events=True, output=["R", "lifts", "q_far[1]", "q_far[2]", "q_far[3]"])
    far = np.min([result[f"q_far[{case}]"] for case in (1, 2, 3)], axis=0)
    lifts = result["lifts"].astype(bool)
    clear = np.abs(far) > 1e-6
    assert (lifts == (far < 0))[clear].all() and lifts.any() and not lifts.all()


@pytest.mark.parametrize("standard", ENDS)
def test_bolts_and_life_by_springs(fmus, standard):
    """Pulls on bolts as those of equal springs at their places, whose least sum of squares holds force and moment; the life of
    rollers."""
    psi = np.radians(np.arange(0.0, 360.0, 7.0))
    inputs = np.array(list(zip(np.arange(len(psi), dtype=float), psi)), dtype=[("time", float), ("psi", float)])
    names = [f"{name}[{case}]" for name in ("F_b", "S_b", "F_k", "S_h", "L_10") for case in (1, 2, 3)]
    result = simulate_fmu(fmus[standard], stop_time=len(psi) - 1.0, output_interval=1.0, input=inputs, output=["psi", *names])
    around = 2 * np.pi * np.arange(96) / 96
    places = np.array([np.ones(96), 2.15 * np.cos(around), 2.15 * np.sin(around)])
    for case in range(3):
        force, across, moment = by_hand(result["psi"], 25.0, 16e3 * G, case)
        pulls, *_ = np.linalg.lstsq(places, np.array([-force * np.ones_like(moment), moment, 0 * moment]), rcond=None)
        pull = pulls.max(axis=0)
        most = 340e3 + 0.2 * np.maximum(pull, 0)
        wanted = {"F_b": pull, "S_b": 525e3 / most, "F_k": 340e3 - 0.8 * pull, "S_h": 0.15 * (96 * 340e3 + force) / across,
                  "L_10": (9000e3 / (force + 2 * moment / DIAMETER + 0.75 * across)) ** (10 / 3)}
        for name, one in wanted.items():
            assert np.allclose(result[f"{name}[{case + 1}]"], one, rtol=1e-10, atol=1e-6), name


@pytest.mark.parametrize("language", ["en", "zh", "bg"])
def test_the_book_has_all_of_it(language, tmp_path):
    lemnis("book", SCENE, "--language", language, "--format", "typ", "--output", tmp_path)
    book = typst(tmp_path / "SlewingPortal.typ")
    known = words(language)
    for section in ("upper_weights", "upper_loads", *(f"ring_{name}" for name in ("alone", "hardness", "elements", "contact", "static", "friction", "bolts", "life"))):
        assert known["section"][section] in book, section
    for check in ("force", "contact", "use", "safety", "bolts", "joint", "slip", "life", "sum", "turn", "pulls"):
        assert known["check"][f"ring_{check}"] in book, check
    assert known["curve"]["ring_capacity"] in book
    # The greatest moment of all cases over the circle, with four digits.
    around = np.radians(np.arange(0.0, 360.0, 0.01))
    most = max(by_hand(around, 25.0, 16e3 * G, case)[2].max() for case in range(3))
    text = f"{most / 1e3:.0f}"
    assert f"{text} thin" in book, text
