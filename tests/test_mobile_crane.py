"""A mobile crane in FMPy, both standards and both interfaces; its load chart as CSV and in the book."""

import csv
import math

import numpy as np
import pytest
from fmpy import extract, instantiate_fmu, read_model_description, simulate_fmu
from fmpy.validation import validate_fmu

from conftest import ROOT, lemnis, typst, words

ENDS = {"FMI 2": ".fmi2.fmu", "FMI 3": ".fmu"}
SCENE = ROOT / "models/scenes/mobile_crane.toml"
G = 9.81


@pytest.fixture(scope="module")
def fmus(tmp_path_factory):
    folder = tmp_path_factory.mktemp("mobile")
    lemnis("fmu", SCENE, "--output", folder)
    return {standard: str(folder / f"MobileCrane{end}") for standard, end in ENDS.items()}


@pytest.fixture(scope="module")
def chart():
    rows = list(csv.DictReader(lemnis("check", SCENE, "--chart").splitlines()))
    return {(float(row["l [m]"]), float(row["R [m]"])): row for row in rows}


@pytest.mark.parametrize("standard", ENDS)
def test_what_a_load_limiter_needs(fmus, standard):
    assert not validate_fmu(fmus[standard])
    description = read_model_description(fmus[standard])
    variables = {variable.name: variable for variable in description.modelVariables}
    assert {name: variables[name].causality for name in ("psi", "R", "l", "Q", "G_h", "P", "eta", "a", "N[1]")} == {
        "psi": "input", "R": "input", "l": "input", "Q": "input", "G_h": "parameter", "P": "output", "eta": "output",
        "a": "output", "N[1]": "output"}
    assert variables["governs"].type == "Enumeration"
    assert variables["stops"].type == variables["warns"].type == "Boolean"
    assert int(description.numberOfEventIndicators) == 2


@pytest.mark.parametrize("kind", ["CoSimulation", "ModelExchange"])
@pytest.mark.parametrize("standard", ENDS)
def test_the_limiter_stops_at_the_chart(fmus, chart, standard, kind):
    """The load grows by 1 kN/s at 17.7 m and 8 m: it warns at 0.9 of the chart's load, hook block included, and stops at all of it."""
    rated = 1e3 * float(chart[17.7, 8.0]["Q_rat [kN]"])
    hook = 280 * G
    times = np.array([0.0, 100.0])
    inputs = np.array([(t, 1e3 * t, 8.0, 17.7, math.radians(80.0)) for t in times],
                      dtype=[(name, float) for name in ("time", "Q", "R", "l", "psi")])
    result = simulate_fmu(fmus[standard], fmi_type=kind, stop_time=100.0, output_interval=0.5, input=inputs,
                          relative_tolerance=1e-9, record_events=kind == "ModelExchange",
                          output=["Q", "eta_ch", "warns", "stops", "V", "N[1]", "N[2]", "N[3]", "N[4]", "x_V", "y_V"])
    for name, part in (("warns", 0.9), ("stops", 1.0)):
        first = result["time"][np.argmax(result[name])]
        wanted = (part * rated - hook) / 1e3
        # An event is where it falls; in Co-Simulation the load of a step is that of its start.
        late = 1e-3 if kind == "ModelExchange" else 1.0
        assert -1e-6 <= first - wanted <= late, (name, first, wanted)
    forces = np.array([result[f"N[{i}]"] for i in range(1, 5)])
    weight = (14200 + 2600 + 4100 + 3200 + 2400 + 1100 + 850 + 900 + 280) * G + result["Q"]
    assert np.allclose(forces.sum(axis=0), weight * math.cos(math.radians(0.5)), rtol=1e-12, atol=0.0)
    for place, values in (("x_V", [2.2, 2.2, -2.9, -2.9]), ("y_V", [-3.0, 3.0, 3.0, -3.0])):
        assert np.allclose(np.array(values) @ forces, result[place] * forces.sum(axis=0), rtol=0.0, atol=1e-6)


def test_the_chart_in_both_ways(fmus, chart):
    """What the FMU reads from its chart is what the CSV has, at each cell and between them."""
    assert len(chart) > 80 and {row["decides"] for row in chart.values()} == {"boom", "stability"}
    for length, reach in [(10.4, 5.0), (17.7, 8.0), (17.7, 13.0), (32.3, 30.0)]:
        for aside in (0.0, -0.4):
            result = simulate_fmu(fmus["FMI 3"], start_values={"l": length, "R": reach + aside, "Q": 1e3}, stop_time=0.1,
                                  output_interval=0.1, output=["Q_ch", "Q_rat"])
            assert result["Q_ch"][0] == pytest.approx(1e3 * float(chart[length, reach]["Q_rat [kN]"]), rel=1e-13)
            assert result["Q_ch"][0] <= result["Q_rat"][0] * (1 + 1e-12)
    told = lemnis("check", ROOT / "models/scenes/slewing.toml", "--chart", expect=1)
    assert "no load chart" in told and "[supports.chart]" in told


@pytest.mark.parametrize("language", ["en", "zh", "bg"])
def test_the_book_has_the_chart(language, chart, tmp_path):
    lemnis("book", SCENE, "--language", language, "--format", "typ", "--output", tmp_path)
    book = typst(tmp_path / "MobileCrane.typ")
    known = words(language)
    at = book.index(f'= 8 {known["chapter"]["charts"]}')
    here = book[at:]
    for mark in ("boom", "stability"):
        assert f'#super[{known["mark"][mark]}]' in here and known["governs"][mark] in here
    # The greatest load of the chart, with four digits.
    text = "245.2" if language != "bg" else "245,2"
    assert float(chart[10.4, 3.0]["Q_rat [kN]"]) == pytest.approx(245.25) and f"[{text}#super" in here
    usual = known["text"]["usual_unconfirmed"]
    assert book.count(usual) == 5, "impact, pressure of the wind, area of the load, part left behind, warning"


@pytest.mark.parametrize("standard", ENDS)
def test_what_governs_changes_at_events(fmus, standard):
    """The reach grows by 0.1 m/s: from one limit to the next between two steps of the importer, who is asked for an event."""
    times = np.array([0.0, 100.0])
    inputs = np.array([(t, 10e3, 4.0 + 0.1 * t, 17.7, math.radians(80.0)) for t in times],
                      dtype=[(name, float) for name in ("time", "Q", "R", "l", "psi")])
    at_reaches = {}
    for kind in ("CoSimulation", "ModelExchange"):
        result = simulate_fmu(fmus[standard], fmi_type=kind, stop_time=100.0, output_interval=0.5, input=inputs,
                              record_events=False, output=["R", "governs"])
        at_reaches[kind] = {round(float(row["R"]), 9): int(row["governs"]) for row in result}
    assert len(set(at_reaches["ModelExchange"].values())) > 1
    # In Co-Simulation the reach of a step is that of its start.
    shared = at_reaches["CoSimulation"].keys() & at_reaches["ModelExchange"].keys()
    assert len(shared) > 150
    assert all(at_reaches["CoSimulation"][reach] == at_reaches["ModelExchange"][reach] for reach in shared)


@pytest.mark.parametrize("standard", ENDS)
def test_what_governs_is_held_between_events(fmus, standard, tmp_path):
    description = read_model_description(fmus[standard])
    reference = {variable.name: variable.valueReference for variable in description.modelVariables}
    folder = extract(fmus[standard], tmp_path)
    fmu = instantiate_fmu(folder, description, "ModelExchange")
    if standard == "FMI 2":
        fmu.setupExperiment()
        fmu.enterInitializationMode()
        get, put = fmu.getInteger, fmu.setReal
    else:
        fmu.enterInitializationMode()
        get, put = fmu.getInt64, fmu.setFloat64
    governs = lambda: get([reference["governs"]])[0]
    reach = lambda value: put([reference["R"]], [value])
    put([reference["l"], reference["Q"]], [17.7, 10e3])
    reach(4.0)
    fmu.exitInitializationMode()
    seen = [governs()]
    fmu.enterContinuousTimeMode()
    for step in range(1, 120):
        reach(4.0 + 0.1 * step)
        held = governs()
        assert held == seen[-1]
        asked = fmu.completedIntegratorStep()[0]
        if asked:
            fmu.enterEventMode()
            assert governs() != held
            seen.append(governs())
            fmu.enterContinuousTimeMode()
            assert not fmu.completedIntegratorStep()[0]
    assert len(seen) > 1
    fmu.terminate()
    fmu.freeInstance()
