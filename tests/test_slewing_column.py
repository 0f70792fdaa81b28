"""A crane's column in FMPy, both standards and both interfaces, and in the book."""

import math

import numpy as np
import pytest
from fmpy import read_model_description, simulate_fmu
from fmpy.validation import validate_fmu

from conftest import ROOT, lemnis, typst, words

ENDS = {"FMI 2": ".fmi2.fmu", "FMI 3": ".fmu"}
SCENE = ROOT / "models/scenes/slewing_column.toml"
G = 9.81
# Weights, places and heights of the scene; its slope and height of suspension; wind areas with their heights.
UPPER = [(28e3 * G, -0.6, 2.5), (8e3 * G, 7.0, 10.0), (16e3 * G, -4.4, 2.0)]
SLOPE, HIGH = math.radians(0.3), 18.0
AREAS = [(20.0, 3.0), (12.0, 9.0)]
CASES = [(1.0, 250.0), (1.25, 40.0), (0.0, 800.0)]
HEIGHT = 6.5


def by_hand(psi, reach, load, case):
    """Weight on the pivot, forces on upper and foot bearing, friction moment, in directions that do not slew: moments about
    the foot give the upper bearing, those about the upper one the foot."""
    factor, pressure = CASES[case]
    load = factor * load
    weight = (sum(g for g, *_ in UPPER) + load) * math.cos(SLOPE)
    own = (sum(g * r for g, r, _ in UPPER) + load * reach) * math.cos(SLOPE)

    def moment(up):
        lean = sum(g * (h + up) for g, _, h in UPPER) + load * (HIGH + up)
        wind = pressure * sum(a * (h + up) for a, h in AREAS)
        return np.hypot(own * np.cos(psi) + lean * math.sin(SLOPE), own * np.sin(psi) + wind)

    upper, foot = moment(HEIGHT) / HEIGHT, moment(0.0) / HEIGHT
    pivot = (0.2**3 - 0.05**3) / (0.2**2 - 0.05**2) * 2 / 3
    return weight + 0 * psi, upper, foot, 0.1 * (upper * 0.8 + foot * 0.21 + weight * pivot)


@pytest.fixture(scope="module")
def fmus(tmp_path_factory):
    folder = tmp_path_factory.mktemp("column")
    lemnis("fmu", SCENE, "--output", folder)
    return {standard: str(folder / f"SlewingColumn{end}") for standard, end in ENDS.items()}


@pytest.mark.parametrize("standard", ENDS)
def test_its_inputs_and_results(fmus, standard):
    assert not validate_fmu(fmus[standard])
    variables = {variable.name: variable for variable in read_model_description(fmus[standard]).modelVariables}
    names = ("psi", "R", "Q", "h_uf", "r_d", "p_w[1]", "V[1]", "H_u[3]", "H_f[2]", "M_fb[1]", "p_p[2]", "R_p")
    assert {name: variables[name].causality for name in names} == {
        "psi": "input", "R": "input", "Q": "input", "h_uf": "parameter", "r_d": "parameter", "p_w[1]": "parameter", "V[1]": "output",
        "H_u[3]": "output", "H_f[2]": "output", "M_fb[1]": "output", "p_p[2]": "output", "R_p": "calculatedParameter"}


@pytest.mark.parametrize("kind", ["CoSimulation", "ModelExchange"])
@pytest.mark.parametrize("standard", ENDS)
def test_bearings_of_a_crane_that_slews_and_luffs(fmus, standard, kind):
    times = np.linspace(0.0, 40.0, 41)
    given = {"psi": np.radians(9.0) * times, "R": 8.0 + 0.3 * times, "Q": 50e3 - 1e3 * times}
    inputs = np.array(list(zip(times, *given.values())), dtype=[(name, float) for name in ("time", *given)])
    names = [f"{name}[{case}]" for name in ("V", "H_u", "H_f", "M_fb") for case in (1, 2, 3)]
    result = simulate_fmu(fmus[standard], fmi_type=kind, stop_time=40.0, output_interval=1.0, input=inputs,
                          output=["psi", "R", "Q", *names, "G_d", "M_d"])
    assert np.ptp(result["psi"]) > 6.0
    for case in range(3):
        wanted = by_hand(result["psi"], result["R"], result["Q"], case)
        for name, one in zip(("V", "H_u", "H_f", "M_fb"), wanted):
            assert np.allclose(result[f"{name}[{case + 1}]"], one, rtol=1e-12, atol=1e-8), name
    # With the counterweight the moment without load is minus that with it.
    own = sum(g * r for g, r, _ in UPPER) - result["G_d"] * 4.4
    assert np.allclose(own + result["Q"] * result["R"], -own, atol=1e-7)
    assert np.allclose(result["M_d"], -own, atol=1e-7)


@pytest.mark.parametrize("language", ["en", "zh", "bg"])
def test_the_book_has_all_of_it(language, tmp_path):
    lemnis("book", SCENE, "--language", language, "--format", "typ", "--output", tmp_path)
    book = typst(tmp_path / "SlewingColumn.typ")
    known = words(language)
    for section in ("upper_weights", "upper_loads", *(f"column_{name}" for name in ("counterweight", "pivot", "forces", "pressure", "friction"))):
        assert known["section"][section] in book, section
    for check in ("upper", "foot", "upper_pressure", "foot_pressure", "pivot_pressure", "rest"):
        assert known["check"][f"column_{check}"] in book, check
    # The greatest force on the upper bearing of all cases over the circle, with four digits.
    around = np.radians(np.arange(0.0, 360.0, 0.01))
    most = max(by_hand(around, 20.0, 5e3 * G, case)[1].max() for case in range(3))
    assert f"{most / 1e3:.1f}" in book.replace(",", ".")
