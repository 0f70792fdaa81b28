"""Wind on all that slews, in FMPy: gusts and a turning wind against SciPy, with a load that swings in the same wind, and beside a
support that has the areas; derivatives, levels and the book."""

import math

import numpy as np
import pytest
from fmpy import read_model_description, simulate_fmu
from fmpy.validation import validate_fmu
from scipy.integrate import solve_ivp

import test_slewing_engine as engine
from conftest import ROOT, lemnis, typst, words

ENDS = {"FMI 2": ".fmi2.fmu", "FMI 3": ".fmu"}
KINDS = ("CoSimulation", "ModelExchange")
SCENE = (ROOT / "models/scenes/slewing_swing.toml").read_text("utf-8")
AREA, PLACE, RHO = 140.0, 5.5, 1.225
STRUCTURE = [line for line in SCENE.splitlines() if line.startswith(("A_ws", "r_ws"))]
LOAD = [line for line in SCENE.splitlines() if line.startswith(("Q_air", "d_Q", "c_wQ", "A_Q"))]
TIMES = [0.0, 6.0, 9.0, 14.0, 20.0]
SPEEDS, TO = [4.0, 4.0, 22.0, -9.0, 12.0], [30.0, 30.0, 80.0, 120.0, 160.0]


def scene(*changes):
    text = SCENE
    for old, new in changes:
        assert text.count(old) == 1, old
        text = text.replace(old, new)
    return text


def rigid(*changes):
    return scene(('fidelity = "swing"', 'fidelity = "rigid"'), ('l_R   = "18 m"                  # from head to load\n', ""),
                 *((line + "\n", "") for line in LOAD), *changes)


def built(folder, text):
    (folder / "wind.toml").write_text(text, encoding="utf-8")
    lemnis("fmu", folder / "wind.toml", "--output", folder)
    return {standard: str(folder / f"SlewingSwing{end}") for standard, end in ENDS.items()}


def inputs():
    rows = [(t, v, math.radians(chi)) for t, v, chi in zip(TIMES, SPEEDS, TO)]
    return np.array(rows, dtype=[("time", float), ("v_air", float), ("chi_air", float)])


def moment(t, psi):
    v, chi = np.interp(t, TIMES, SPEEDS), math.radians(np.interp(t, TIMES, TO))
    return 0.5 * RHO * v * abs(v) * AREA * PLACE * math.sin(chi - psi)


def test_gusts_from_many_sides_against_scipy(tmp_path):
    """A drive that turns it all the time, so that friction has one sign; the wind is told by the scene, straight from time to time."""
    def over(values, unit):
        return "{ between = \"linear\", over = [" + ", ".join(f'["{t} s", "{v} {unit}"]' for t, v in zip(TIMES, values)) + "] }"
    paths = built(tmp_path, rigid(('v_air = "8 m/s" ', f"v_air = {over(SPEEDS, 'm/s')} "), ('chi_air = "30 deg"', f"chi_air = {over(TO, 'deg')}"),
                                  ('M_sl  = "300 kN.m"', 'M_sl  = "420 kN.m"'),
                                  ('[slewing.limits]', '[slewing.dynamics]\nstep = "5 ms"\n[slewing.limits]')))
    slope, whole = math.sin(math.radians(0.5)), 9e6 + 16e3 * 625.0
    lean = 16e3 * 9.81 * 25.0 - 180e3 * 9.81 * 1.2

    def rate(t, y):
        return [y[1], (420e3 - 600e3 * y[1] - 40e3 - lean * slope * math.sin(y[0]) + moment(t, y[0])) / whole]

    # From one break of the wind to the next, so that no step has a kink within it.
    y, at, wanted = [math.radians(-60.0), 0.0], 0.0, {0.0: math.radians(-60.0)}
    for start, end in zip(TIMES, TIMES[1:]):
        grid = np.arange(start, end + 1e-9, 0.5)
        run = solve_ivp(rate, (start, end), y, method="DOP853", t_eval=grid, rtol=1e-13, atol=1e-13)
        wanted.update(zip(np.round(run.t, 6), run.y[0]))
        assert (run.y[1][1:] > 0.0).all()
        y = run.y[:, -1]
    calm = solve_ivp(lambda t, y: [y[1], rate(0.0, y)[1] - (moment(0.0, y[0])) / whole], (0.0, 20.0), [math.radians(-60.0), 0.0], rtol=1e-9)
    assert abs(calm.y[0][-1] - y[0]) > 0.1, "the wind matters"
    for standard, path in paths.items():
        assert not validate_fmu(path)
        for kind, within in zip(KINDS, (5e-11, 2e-7)):
            run = simulate_fmu(path, fmi_type=kind, stop_time=20.0, output_interval=0.5, relative_tolerance=1e-11, output=["psi_sl", "M_ws"],
                               record_events=False)
            for t, psi, found in run:
                assert abs(psi - wanted[round(t, 6)]) <= within, (standard, kind, t, psi - wanted[round(t, 6)])
                assert abs(found - moment(t, psi)) <= 1e-6 * 5e5, (standard, kind, t)


@pytest.mark.parametrize("kind", KINDS)
def test_wind_and_a_drive_that_gives_the_same_are_one(tmp_path, kind):
    """A load that swings in still air of its own table's absence: the wind's moment as that of the drive, for a crane that does not turn far."""
    windy = built(tmp_path, scene(*((line + "\n", "") for line in LOAD), ('v_air = "8 m/s" ', 'v_air = "20 m/s" ')))
    alone = tmp_path / "alone"
    alone.mkdir()
    calm = built(alone, scene(*((line + "\n", "") for line in STRUCTURE + LOAD),
                              ('[slewing.air]                   # around the load, and the wind on all\n', ""),
                              ('v_air = "8 m/s"                 # an input, as is its direction\n', ""), ('chi_air = "30 deg"\n', "")))
    names = ["psi_sl", "x_Q", "z_Q", "S_R", "M_ws"]
    first = simulate_fmu(windy["FMI 3"], fmi_type=kind, stop_time=12.0, output_interval=0.01, relative_tolerance=1e-11, output=names, record_events=False)
    drive = np.array([(t, 300e3 + m) for t, m in zip(first["time"], first["M_ws"])], dtype=[("time", float), ("M_sl", float)])
    # In Model Exchange, as an input is straight between its points there.
    second = simulate_fmu(calm["FMI 3"], fmi_type="ModelExchange", stop_time=12.0, output_interval=0.01, input=drive, relative_tolerance=1e-11,
                          output=names[:4], record_events=False)
    assert np.abs(first["M_ws"]).max() > 1e5 and np.ptp(first["z_Q"]) > 0.5
    for name, size in zip(names, (1.0, 1.0, 1.0, 16e3 * 9.81)):
        # The moment is straight between two points here: (10 ms)² of its second derivative.
        assert np.abs(first[name] - second[name]).max() <= 2e-5 * size, name


@pytest.mark.parametrize("fidelity", ["rigid", "swing"])
def test_beside_a_support_the_areas_are_its_own(tmp_path, fidelity):
    """Area and place are the sum and the centre of those of the support; the motion is that of slewing alone with them."""
    air = '[slewing.air]\nv_air = "28 m/s"\nchi_air = "70 deg"\n'
    text = engine.SCENE.read_text("utf-8").replace('fidelity = "rigid"\n', f'fidelity = "{fidelity}"\n')
    rope = 'l_R = "18 m"\n' if fidelity == "swing" else ""
    beside = text.replace("c_sl  =", rope + "c_sl  =") + air
    own = engine.by_itself(text, rope + engine.EXPOSED) + air
    paths = [engine.built(tmp_path, told, name) for told, name in ((beside, "SlewingEngine"), (own, "ByHand"))]
    names = ["psi_sl", "omega_sl", "omega_d", "psi_slip", "M_ws"]
    for standard in ENDS:
        assert not validate_fmu(paths[0][standard])
        variables = {variable.name: variable for variable in read_model_description(paths[0][standard]).modelVariables}
        assert float(variables["A_ws"].start) == pytest.approx(engine.AREA, rel=1e-12)
        assert float(variables["r_ws"].start) == pytest.approx(engine.AHEAD, rel=1e-12)
        for kind in KINDS:
            one, other = (simulate_fmu(of[standard], fmi_type=kind, stop_time=28.0, output_interval=0.25, relative_tolerance=1e-10, output=names,
                                       record_events=False) for of in paths)
            assert np.abs(one["M_ws"]).max() > 1e4
            for name in names:
                assert np.abs(one[name] - other[name]).max() <= 1e-10 * np.abs(other[name]).max(), name


@pytest.mark.parametrize("language", ["en", "zh", "bg"])
def test_the_book_has_the_wind_and_says_what_it_leaves_out(tmp_path, language):
    known = words(language)
    bare = scene(*((line + "\n", "") for line in STRUCTURE))
    for text, there, absent in [(rigid(), "wind_on_load", "wind_on_structure"), (SCENE, None, "wind_on_load"), (bare, "wind_on_structure", "wind_on_load")]:
        (tmp_path / "wind.toml").write_text(text.replace("[project]", f'[book]\nlanguage = "{language}"\n[project]'), encoding="utf-8")
        lemnis("book", tmp_path / "wind.toml", "--format", "typ", "--output", tmp_path)
        book = typst(tmp_path / "SlewingSwing.typ")
        assert (known["section"]["slewing_wind"] in book) == (text is not bare)
        assert there is None or known["uncovered"][there] in book
        assert known["uncovered"][absent] not in book
