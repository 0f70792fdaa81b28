"""A grab unloader in FMPy, both standards and both interfaces, in all four schemes against ropes by hand, and in the book."""

import math
import re
import tomllib

import numpy as np
import pytest
from fmpy import read_model_description, simulate_fmu
from fmpy.validation import validate_fmu
from scipy.integrate import solve_ivp

from conftest import ROOT, lemnis, typst, words

ENDS = {"FMI 2": ".fmi2.fmu", "FMI 3": ".fmu"}
SCENE = ROOT / "models/scenes/grab_unloader.toml"
G = 9.81
GRAB, LOAD, TROLLEY, AUXILIARY = 12e3, 16e3, 12e3, 5e3
DRUM, SLACK, RING, ETA = 1.4, 20e3, 4.0, 0.93
SCHEMES = ["planetary", "simple", "auxiliary_trolley", "middle_drum"]
INPUTS = ["v_t", "a_t", "v_h", "v_c", "k_q", "lambda_c"]


def by_hand(scheme, v_t, a_t, v_h, v_c, k_q, share):
    """What the ropes and drums of a scheme do: each rope's pull on trolley and grab, its length by the places of both."""
    mass = GRAB + k_q * LOAD
    weight = mass * G
    way = np.sign(v_t) if v_t else np.sign(a_t)
    force = way * (0.008 * (weight + TROLLEY * G) + 10e3 + weight * (1 - 0.98**2)) + (mass + TROLLEY) * a_t
    found = {"W": weight, "F_r": force}
    if scheme == "planetary":
        sea, land = (weight + force) / 2, (weight - force) / 2
        shares = [(1 - share) * sea, (1 - share) * land, share * sea, share * land]
        speeds = [v_h + v_t, v_h - v_t, v_h + v_c + v_t, v_h + v_c - v_t]
        forces = shares
        grab = [(1 - share) * weight * v_h, share * weight * (v_h + v_c)]
        drive = force
    else:
        # The grab's ropes pull the trolley to the land as strongly as they bear the grab.
        pull = force + weight
        sea, land = (SLACK + pull, SLACK) if pull >= 0 else (SLACK, SLACK - pull)
        back = v_t if scheme == "simple" else 0.0
        speeds = [v_h - back, v_h + v_c - back, v_t]
        # At the trolley's drive: its ropes' pull, and what goes round another trolley or over the drum itself.
        drive = pull
        if scheme == "auxiliary_trolley":
            own = way * 0.008 * AUXILIARY * G + AUXILIARY * a_t / 2
            drive = pull + (own - 2 * weight) / 2
            found |= {"v_aux": v_t / 2, "d_l": 0.0, "F_ra": own, "T_aux": 2 * weight - own}
        elif scheme == "middle_drum":
            drive = pull - weight
        forces = [(1 - share) * weight, share * weight, drive]
        shares = [*forces[:2], max(sea, land)]
        grab = [forces[0] * speeds[0], forces[1] * speeds[1]]
    found |= {"T_1": sea, "T_2": land, "F_t": sea - land, "F_d": drive}
    for name, power in zip(("P_h", "P_c", "P_t"), (*grab, drive * v_t)):
        found[name] = power * ETA if power < 0 else power / ETA
    for i, (speed, pull, force) in enumerate(zip(speeds, shares, forces), 1):
        found |= {f"v_r[{i}]": speed, f"n_d[{i}]": speed / (math.pi * DRUM), f"S_r[{i}]": pull, f"F_i[{i}]": force,
                  f"M_d[{i}]": force * DRUM / 2, f"P_d[{i}]": force * speed}
        if scheme == "planetary":
            lifts = v_h + (v_c if i > 2 else 0.0)
            sun, torque = (1 + RING) * lifts / (math.pi * DRUM), force * DRUM / 2
            ring = ((1 + RING) * found[f"n_d[{i}]"] - sun) / RING
            found |= {f"n_s[{i}]": sun, f"n_r[{i}]": ring, f"T_s[{i}]": torque / (1 + RING), f"T_r[{i}]": RING * torque / (1 + RING),
                      f"P_s[{i}]": force * lifts, f"P_r[{i}]": force * (v_t if i % 2 else -v_t)}
    if scheme == "planetary":
        found["P_circ"] = min(sea, land) * abs(v_t)
    return found


def written(folder, scheme):
    text = SCENE.read_text(encoding="utf-8").replace('"GrabUnloader"', f'"Grab_{scheme}"')
    if scheme != "planetary":
        lines = text.replace('"planetary" ', f'"{scheme}" ').splitlines()
        lines = [line for line in lines if not line.startswith(("k   ", "k_b"))]
        at = next(i for i, line in enumerate(lines) if "closing, land side" in line)
        del lines[at:at + 3]
        own = ['T_0 = "20 kN"'] + ['G_a = "5 t"', 'F_ba = "300 kN"', 'z_a = "4"'] * (scheme == "auxiliary_trolley")
        at = next(i for i, line in enumerate(lines) if line.startswith("eta_d"))
        text = "\n".join([*lines[:at], *own, *lines[at:]])
    path = folder / f"Grab_{scheme}.toml"
    path.write_text(text, encoding="utf-8")
    return path


@pytest.fixture(scope="module")
def fmus(tmp_path_factory):
    folder = tmp_path_factory.mktemp("unloader")
    for scheme in SCHEMES:
        lemnis("fmu", written(folder, scheme), "--output", folder)
    return {(scheme, standard): str(folder / f"Grab_{scheme}{end}") for scheme in SCHEMES for standard, end in ENDS.items()}


@pytest.mark.parametrize("standard", ENDS)
def test_its_inputs_and_results(fmus, standard):
    for scheme in SCHEMES:
        path = fmus[scheme, standard]
        assert not validate_fmu(path)
        description = read_model_description(path)
        variables = {variable.name: variable for variable in description.modelVariables}
        assert {variables[name].causality for name in INPUTS} == {"input"}
        assert {variables[name].causality for name in ("n_d[1]", "S_r[3]", "T_1", "P_t")} == {"output"}
        assert {variables[name].causality for name in ("nu_p[8]", "k_p", "q_cyc")} == {"calculatedParameter"}
        assert {variables[name].causality for name in ("G_g", "d_d[2]", "t_p[1]", "a_tp[3]")} == {"parameter"}
        assert variables["slack"].type == "Boolean"
        assert ("n_s[4]" in variables) == (scheme == "planetary") == ("n_d[4]" in variables)
        assert ("v_aux" in variables) == (scheme == "auxiliary_trolley")
        assert int(description.numberOfEventIndicators) == 1


@pytest.mark.parametrize("kind", ["CoSimulation", "ModelExchange"])
@pytest.mark.parametrize("standard", ENDS)
@pytest.mark.parametrize("scheme", SCHEMES)
def test_a_course_of_all_commands(fmus, scheme, standard, kind):
    times = np.linspace(0.0, 20.0, 41)
    # Through every mode, both ways, with nothing at exactly zero but where that is meant.
    given = {"v_t": 4.0 * np.sin(0.5 * times + 0.3), "a_t": 0.6 * np.cos(0.5 * times + 0.3), "v_h": 2.5 * np.cos(0.7 * times),
             "v_c": 1.2 * np.sin(0.9 * times), "k_q": 0.5 + 0.5 * np.sin(0.4 * times), "lambda_c": 0.5 + 0.4 * np.cos(0.3 * times)}
    inputs = np.array(list(zip(times, *given.values())), dtype=[(name, float) for name in ("time", *given)])
    names = list(by_hand(scheme, 1.0, 0.1, 1.0, 0.1, 1.0, 0.5))
    result = simulate_fmu(fmus[scheme, standard], fmi_type=kind, stop_time=20.0, output_interval=0.5, input=inputs,
                          output=[*INPUTS, *names])
    assert np.ptp(result["v_t"]) > 6.0
    for row in result:
        wanted = by_hand(scheme, *(float(row[name]) for name in INPUTS))
        for name in names:
            size = 1e6 if name.startswith(("P", "T", "F", "S", "M", "W")) else 10.0
            assert abs(row[name] - wanted[name]) <= 1e-12 * size, (name, row["time"])


@pytest.mark.parametrize("standard", ENDS)
@pytest.mark.parametrize("scheme", ["planetary", "simple", "auxiliary_trolley"])
def test_the_grab_keeps_its_height_on_the_way(fmus, scheme, standard):
    """The trolley goes 15 m to the sea and back, the grab at rest on its ropes: what the drums wind, summed over the time, is
    what the places of trolley and grab leave of the ropes. The trolley's speed is straight between the samples, so that the
    trapezoid rule is exact."""
    times = np.linspace(0.0, 20.0, 81)
    speed = np.interp(times, [0.0, 2.5, 7.5, 10.0, 12.5, 17.5, 20.0], [0.0, 2.0, 2.0, 0.0, -2.0, -2.0, 0.0])
    inputs = np.array(list(zip(times, speed)), dtype=[("time", float), ("v_t", float)])
    drums = ["n_d[1]", "n_d[2]"]
    result = simulate_fmu(fmus[scheme, standard], fmi_type="CoSimulation", stop_time=20.0, output_interval=0.25, step_size=0.25,
                          input=inputs, start_values={"v_h": 0.0}, output=["v_t", *drums])
    steps = np.diff(result["time"])

    def whole(name):
        values = result[name]
        return np.concatenate([[0.0], np.cumsum(steps * (values[1:] + values[:-1]) / 2)])

    place = whole("v_t")
    assert 14.0 < place.max() < 16.0 and abs(place[-1]) < 0.1
    lengths = {"planetary": [60.0 - place, 10.0 + place], "simple": [10.0 + place] * 2,
               "auxiliary_trolley": [60.0 - place / 2 + place - place / 2] * 2}[scheme]
    for drum, length in zip(drums, lengths):
        wound = math.pi * DRUM * whole(drum)
        assert np.abs(wound + length - length[0]).max() <= 1e-11, drum


@pytest.mark.parametrize("standard", ENDS)
def test_a_rope_gets_slack_at_an_event(fmus, standard):
    """The empty grab's trolley is told to speed up more and more: slack where what it asks for is the grab's weight."""
    weight = GRAB * G
    rest = 0.008 * (weight + TROLLEY * G) + 10e3 + weight * (1 - 0.98**2)
    free = (weight - rest) / (GRAB + TROLLEY)
    inputs = np.array([(t, t, 2.0, 0.0) for t in (0.0, 10.0)], dtype=[(name, float) for name in ("time", "a_t", "v_t", "k_q")])
    result = simulate_fmu(fmus["planetary", standard], fmi_type="ModelExchange", stop_time=8.0, output_interval=0.25, input=inputs,
                          relative_tolerance=1e-9, record_events=True, output=["a_t", "slack", "T_2"])
    assert 3.0 < free < 5.0
    first = result["time"][np.argmax(result["slack"])]
    assert -1e-6 <= first - free <= 1e-3
    assert not result["slack"][result["T_2"] > 1.0].any() and result["slack"][result["T_2"] < -1.0].all()


@pytest.mark.parametrize("scheme", SCHEMES)
def test_the_cycle_by_hand(scheme, tmp_path):
    """Load spectrum, root mean squares, cyclic duration factors and rope safety of the scene, phase by phase."""
    path = written(tmp_path, scheme)
    path.write_text(path.read_text(encoding="utf-8").split("[grab_unloader.limits]")[0], encoding="utf-8")
    phases = tomllib.loads(path.read_text(encoding="utf-8"))["grab_unloader"]["phases"]
    number = lambda phase, name: float(str(phase.get(name, "0")).split()[0])
    spectrum, powers, turning, safety, lasts = 0.0, np.zeros(3), np.zeros(3), math.inf, 0.0
    for phase in phases:
        share = number({"lambda_p": "50 %", **phase}, "lambda_p") / 100
        told = [number(phase, name) for name in ("v_tp", "a_tp", "v_hp", "v_cp")]
        found = by_hand(scheme, *told, number(phase, "k_qp") / 100, share)
        time = number(phase, "t_p")
        lasts += time
        spectrum += time * (found["W"] / (28e3 * G)) ** 3
        powers += time * np.array([found[name] ** 2 for name in ("P_h", "P_c", "P_t")])
        # The differentials' suns turn with hoisting and closing; else the motors turn as their drums do.
        speeds = [told[2], told[2] + told[3], told[0]] if scheme == "planetary" else [found[f"v_r[{i}]"] for i in (1, 2, 3)]
        turning += time * (np.array(speeds) != 0.0)
        pulls = [(850e3, found[f"S_r[{i}]"]) for i in range(1, 5) if f"S_r[{i}]" in found] + [(4 * 300e3, found.get("T_aux", 0.0))]
        safety = min(safety, *(breaks / pull for breaks, pull in pulls if pull > 0))
    printed = lemnis("check", path)
    wanted = {"k_p": spectrum / lasts, "nu_min": safety, "q_cyc": LOAD / lasts * 3.6}
    wanted |= dict(zip(("P_h_rms", "P_c_rms", "P_t_rms"), np.sqrt(powers / lasts) / 1e3))
    wanted |= dict(zip(("ED_h", "ED_c", "ED_t"), turning / lasts * 100))
    assert 0.0 < min(turning) and max(turning) <= lasts
    for name, value in wanted.items():
        line = next(line for line in printed.splitlines() if line.split()[:1] == [name])
        assert float(line.split()[1]) == pytest.approx(value, rel=1e-5), name


@pytest.mark.parametrize("language", ["en", "zh", "bg"])
def test_the_book_has_speeds_tensions_and_powers(language, tmp_path):
    lemnis("book", SCENE, "--language", language, "--format", "typ", "--output", tmp_path)
    book = typst(tmp_path / "GrabUnloader.typ")
    known = words(language)
    for section in ("modes", "phases", "duty", "trolley", "ropes", "drums", "planetary", "motors", "lifted"):
        assert known["section"][f"unloader_{section}"] in book, section
    for check in ("slack", "ropes", "rate", "hoisting", "closing", "travelling", "power", "torque"):
        assert known["check"][f"unloader_{check}"] in book, check
    for curve in ("speeds", "pulls", "powers", "suns", "rings", "circulating"):
        assert known["curve"][f"unloader_{curve}"] in book, curve
    # 28 t, of which the trolley at 0.6 m/s² asks for 48.02 kN; 80.67 kN in a rope; 850 kN over half of 28 t; 1152 t/h.
    for value in ("274.7", "48.02", "80.67", "6.189", "1152"):
        assert (value.replace(".", ",") if language == "bg" else value) in book, value


SWAY = ROOT / "models/scenes/grab_sway.toml"
# Of that scene, to the land side: ropes, speed, acceleration, way, feedback; hoisting with its end.
ROPES, V_M, A_M, S_M, FED, HOIST, RAISED = 24.0, 4.0, 0.7, 45.0, 0.3, 1.6, 8.0
PERIOD = 2 * math.pi * math.sqrt(ROPES / G)


def swings(times, rates, fed, ropes=ROPES, phi=0.0):
    """The grab as a point, by SciPy: sway, its rate, trolley's place and speed; from the equation in the plane, nothing small."""
    found, state, now = [], np.array([phi, 0.0, 25.0, 0.0]), 0.0
    breaks = sorted({*(time for time, _ in rates), RAISED, times[-1]})
    length = lambda t: ropes - HOIST * min(t, RAISED)
    for stop in breaks:
        if stop <= now:
            continue
        told = next((rate for time, rate in reversed(rates) if time <= now + 1e-12), 0.0)
        hoist = HOIST if now < RAISED - 1e-12 else 0.0

        def f(t, y):
            l = length(t)
            # Faster by 2 ζ √(g l) φ than it is told: by the product's rule.
            a = told + 2 * fed * math.sqrt(G * l) * y[1] - fed * math.sqrt(G / l) * hoist * y[0]
            return [y[1], (2 * hoist * y[1] - G * math.sin(y[0]) - a * math.cos(y[0])) / l, y[3], a]

        inside = [min(t, stop) for t in times if now + 1e-12 < t <= stop + 1e-12]
        solved = solve_ivp(f, (now, stop), state, method="DOP853", rtol=1e-11, atol=1e-13, t_eval=sorted({*inside, stop}))
        found += list(solved.y.T[:len(inside)])
        state, now = solved.y[:, -1], stop
    return np.array(found)


@pytest.mark.parametrize("kind", ["CoSimulation", "ModelExchange"])
@pytest.mark.parametrize("standard", ENDS)
def test_the_grab_sways(tmp_path, standard, kind):
    # Steps of a 500th of the period: the equations are looked at, not the solver's usual step.
    text = SWAY.read_text(encoding="utf-8").replace("[grab_unloader.way]", '[grab_unloader.dynamics]\nstep = "0.02 s"\n\n[grab_unloader.way]')
    (tmp_path / "GrabSway.toml").write_text(text, encoding="utf-8")
    lemnis("fmu", tmp_path / "GrabSway.toml", "--output", tmp_path)
    path = str(tmp_path / f"GrabSway{ENDS[standard]}")
    assert not validate_fmu(path)
    variables = {variable.name: variable for variable in read_model_description(path).modelVariables}
    assert variables["zeta_f"].causality == "parameter" and variables["v_t"].causality != "input"
    rates = [(0.0, -0.7), (5.7143, 0.0), (11.25, 0.7), (16.9643, 0.0)]
    for fed in (FED, 0.0):
        result = simulate_fmu(path, fmi_type=kind, stop_time=30.0, output_interval=0.25, relative_tolerance=1e-10, record_events=False,
                              start_values={"zeta_f": fed}, output=["phi_R", "omega_R", "x_t", "v_t", "l_R", "x_L", "y_Q"])
        wanted = swings(result["time"][1:], rates, fed)
        for i, name in enumerate(("phi_R", "omega_R", "x_t", "v_t")):
            assert np.abs(result[name][1:] - wanted[:, i]).max() < 2e-6, name
        assert np.abs(result["x_L"] - result["x_t"] - result["l_R"] * np.sin(result["phi_R"])).max() < 1e-12
        assert np.abs(result["y_Q"] + result["l_R"] * np.cos(result["phi_R"])).max() < 1e-12
        assert np.ptp(result["phi_R"]) > 0.15
        if fed:
            assert np.abs(result["phi_R"][-8:]).max() < 0.02


@pytest.mark.parametrize("language", ["en", "zh", "bg"])
def test_the_book_has_ways_beside_each_other(language, tmp_path):
    lemnis("book", SWAY, "--language", language, "--format", "typ", "--output", tmp_path)
    book = typst(tmp_path / "GrabSway.typ")
    known = words(language)
    for section in ("on_way", "ways", "programme", "swung"):
        assert known["section"][f"unloader_{section}"] in book, section
    for curve in ("path", "sway"):
        assert known["curve"][f"unloader_{curve}"] in book, curve
    start = [(0.0, -A_M), (V_M / A_M, 0.0)]
    plain = [(shift + time, sign * rate) for shift, sign in ((0.0, 1), (S_M / V_M, -1)) for time, rate in start]
    hold = V_M / A_M - PERIOD / 3
    ends = np.cumsum([0, PERIOD / 6, PERIOD / 6, hold, PERIOD / 6, PERIOD / 6])
    sixths = [(shift + float(t), -sign * A_M * on) for shift, sign in ((0.0, 1), (S_M / V_M, -1)) for t, on in zip(ends, (1, 0, 1, 0, 1, 0))]
    for number, rates, fed in ((1, plain, 0.0), (2, plain, FED), (3, sixths, 0.0)):
        end = rates[-1][0] + (PERIOD if fed else 0.0)
        times = np.concatenate([np.linspace(0, end, 401)[1:], end + np.linspace(0, PERIOD, 401)[1:]])
        own, longer = (np.degrees(np.abs(swings(times, rates, fed, ropes)[:, 0])) for ropes in (ROPES, 1.1 * ROPES))
        row = [end, own[:400].max(), own[400:].max(), longer[400:].max()]
        cells = f"[{number}]," + "".join(f"[{value:.2f}]," for value in row)
        assert (re.sub(r"(\d)\.(\d)", r"\1,\2", cells) if language == "bg" else cells) in book, cells
