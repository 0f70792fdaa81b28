"""The drive of a crane that slews on a ring in FMPy, both standards and both interfaces, and in the book."""

import math

import numpy as np
import pytest
from fmpy import read_model_description, simulate_fmu
from fmpy.validation import validate_fmu

from conftest import ROOT, lemnis, typst, words

ENDS = {"FMI 2": ".fmi2.fmu", "FMI 3": ".fmu"}
SCENE = ROOT / "models/scenes/slewing_portal.toml"
G = 9.81
# Weights and places of the scene; its slope; wind areas with their places; cases with load, pressure, speed in 1/min.
UPPER = [(62e3 * G, -1.1), (19e3 * G, 8.5), (24e3 * G, -5.2)]
SLOPE = math.radians(0.3)
AREAS = [(38.0, -0.5), (24.0, 8.5)]
CASES = [(1.0, 250.0, 1.5), (1.25, 40.0, 0.5), (0.0, 800.0, 0.0)]
RATIO, EFFICIENCY, DRIVES, OWN, SHAFT = 640.0, 0.85, 2.0, 1.2e6, 0.9


def by_hand(psi, reach, load, case, friction):
    """Moment of slope and wind about the axis, steady moment, power, and time of a start, the wind blowing across the slope."""
    factor, pressure, speed = CASES[case]
    load, omega = factor * load, speed / 60 * 2 * np.pi
    outer = -np.sin(SLOPE) * np.sin(psi) * (sum(g * r for g, r in UPPER) + load * reach) \
        + pressure * np.cos(psi) * sum(a * r for a, r in AREAS)
    swung = np.array([outswing(omega, one, 20.0) for one in reach])
    inertia = OWN + sum(g / G * r * r for g, r in UPPER) + load / G * swung**2
    steady = friction + np.abs(outer)
    against = steady / (RATIO * DRIVES * EFFICIENCY)
    spare = 1.6 * 22e3 / (960 / 60 * 2 * np.pi) - against
    start = (SHAFT + inertia / (RATIO**2 * DRIVES * EFFICIENCY)) * omega * RATIO / spare
    return outer, steady, against * omega * RATIO, start


def outswing(omega, reach, rope):
    """Distance from the axis of a load that swings out, by bisection."""
    low, high = 0.0, math.pi / 2
    for _ in range(60):
        middle = (low + high) / 2
        out = omega**2 * (reach + rope * math.sin(middle)) * math.cos(middle) > G * math.sin(middle)
        low, high = (middle, high) if out else (low, middle)
    return reach + rope * math.sin(low)


@pytest.fixture(scope="module")
def fmus(tmp_path_factory):
    folder = tmp_path_factory.mktemp("drive")
    lemnis("fmu", SCENE, "--output", folder)
    return {standard: str(folder / f"SlewingPortal{end}") for standard, end in ENDS.items()}


@pytest.mark.parametrize("standard", ENDS)
def test_its_parameters_and_results(fmus, standard):
    assert not validate_fmu(fmus[standard])
    variables = {variable.name: variable for variable in read_model_description(fmus[standard]).modelVariables}
    assert {name: variables[name].causality for name in ("i_sl", "n_s[1]", "r_w[2]", "g", "J_0", "M_st[1]", "t_stop[2]", "F_t[1]")} == {
        "i_sl": "parameter", "n_s[1]": "parameter", "r_w[2]": "parameter", "g": "parameter", "J_0": "calculatedParameter",
        "M_st[1]": "output", "t_stop[2]": "output", "F_t[1]": "output"}


@pytest.mark.parametrize("kind", ["CoSimulation", "ModelExchange"])
@pytest.mark.parametrize("standard", ENDS)
def test_a_drive_that_slews_and_a_reach_that_changes(fmus, standard, kind):
    times = np.linspace(0.0, 40.0, 41)
    given = {"psi": np.radians(9.0) * times, "R": 8.0 + 0.3 * times, "Q": 150e3 - 1e3 * times}
    inputs = np.array(list(zip(times, *given.values())), dtype=[(name, float) for name in ("time", *given)])
    names = [f"{name}[{case}]" for name in ("M_z", "M_st", "P_M", "t_start", "M_fn", "M_fm") for case in (1, 2, 3)]
    result = simulate_fmu(fmus[standard], fmi_type=kind, stop_time=40.0, output_interval=1.0, input=inputs,
                          output=["psi", "R", "Q", *names])
    for case in range(3):
        friction = np.maximum(result[f"M_fn[{case + 1}]"], result[f"M_fm[{case + 1}]"])
        wanted = by_hand(result["psi"], result["R"], result["Q"], case, friction)
        for name, one in zip(("M_z", "M_st", "P_M", "t_start"), wanted):
            assert np.allclose(result[f"{name}[{case + 1}]"], one, rtol=1e-10, atol=1e-6), name


@pytest.mark.parametrize("language", ["en", "zh", "bg"])
def test_the_book_has_all_of_it(language, tmp_path):
    lemnis("book", SCENE, "--language", language, "--format", "typ", "--output", tmp_path)
    book = typst(tmp_path / "SlewingPortal.typ")
    known = words(language)
    for section in ("works", "mesh", "steady", "moments", "motor", "hold", "stop", "teeth"):
        assert known["section"][f"turning_{section}"] in book, section
    for check in ("heating", "overload", "start", "quick", "hold", "stop", "hard", "bending", "contact", "axis"):
        assert known["check"][f"turning_{check}"] in book, check


def test_a_curve_is_broken_where_a_brake_never_stops(tmp_path):
    text = SCENE.read_text(encoding="utf-8").replace('T_b   = "250 N.m"', 'T_b   = "1 N.m"', 1)
    (tmp_path / "crane.toml").write_text(text[:text.index("[supports.limits]")], encoding="utf-8")
    # It does not hold either.
    assert "turning_hold" in lemnis("check", tmp_path / "crane.toml", expect=4)
    lemnis("book", tmp_path / "crane.toml", "--output", tmp_path)
    lemnis("book", tmp_path / "crane.toml", "--format", "typ", "--output", tmp_path)
    source = typst(next(tmp_path.glob("*.typ")))
    assert words("en")["curve"]["turning_stop"] in source


RATED = 22e3 / (960 / 60 * 2 * np.pi)


def started(tmp_path, kind, *replaced, **keys):
    """Results of the scene over its range, with a start of a kind."""
    lines = "".join(f'{key} = "{value}"\n' for key, value in keys.items())
    text = SCENE.read_text(encoding="utf-8").replace(
        "[supports.slewing_drive.brake]", f'[supports.slewing_drive.start]\nkind = "{kind}"\n{lines}[supports.slewing_drive.brake]', 1)
    for old, new in replaced:
        assert old in text
        text = text.replace(old, new, 1)
    (tmp_path / f"{kind}.toml").write_text(text, encoding="utf-8")
    return tmp_path / f"{kind}.toml"


def outputs(path, folder, names):
    """Once round, in the FMU."""
    lemnis("fmu", path, "--output", folder)
    times = np.linspace(0.0, 60.0, 25)
    inputs = np.array([(t, math.radians(6.0) * t) for t in times], dtype=[("time", float), ("psi", float)])
    return simulate_fmu(str(folder / "SlewingPortal.fmu"), stop_time=60.0, output_interval=2.5, input=inputs, output=["psi", *names])


def hardest(found, case, torque):
    """Greatest torque of the coupling and force of a pinion, the motor giving this torque at most."""
    at = lambda name: found[f"{name}[{case}]"]
    rate = (torque - at("T_0")) / at("J_start")
    stop = 250.0 - SHAFT * at("alpha_w")
    return np.maximum(torque - SHAFT * rate, stop), (at("M_st") + at("J_c") * rate / RATIO) / (2.2 * DRIVES)


NAMES = [f"{name}[{case}]" for case in (1, 2) for name in
         ("T_0", "J_start", "J_c", "M_st", "alpha_w", "T_p", "T_c", "F_t", "Omega_c", "R_o")]


def test_a_start_along_the_slip_curve_is_that_of_an_integration_in_time(tmp_path):
    from scipy.integrate import solve_ivp

    # A gentle wind, in which the motor keeps the speed of the case.
    scene = started(tmp_path, "slip", ('p_w   = "250 Pa"', 'p_w = "60 Pa"'), ('P_N      = "22 kW"', 'P_N = "30 kW"'), lambda_bd="2.6", n_0="1000 1/min")
    rated, full = RATED * 30 / 22, 2 * np.pi * 1000 / 60
    s_k = 0.04 * (2.6 + math.sqrt(2.6**2 - 1))
    gives = lambda w: 2 * 2.6 * rated / ((1 - w / full) / s_k + s_k / (1 - w / full))
    found = outputs(scene, tmp_path, [*NAMES, *(f"{name}[{case}]" for case in (1, 2) for name in ("t_slip", "a_slip"))])
    for case, speed in ((1, 1.5), (2, 0.5)):
        goal = RATIO * speed / 60 * 2 * np.pi
        for i in range(len(found["psi"])):
            against, inertia = found[f"T_0[{case}]"][i], found[f"J_start[{case}]"][i]
            reached = lambda t, y: y[0] - goal
            reached.terminal = True
            run = solve_ivp(lambda t, y: [(gives(y[0]) - against) / inertia], [0, 300], [0.0], events=reached, rtol=1e-11, atol=1e-11)
            time = run.t_events[0][0]
            assert found[f"t_slip[{case}]"][i] == pytest.approx(time, rel=1e-8), (case, i)
            head = found[f"R_o[{case}]"][i] * found[f"Omega_c[{case}]"][i]
            assert found[f"a_slip[{case}]"][i] == pytest.approx(head / time, rel=1e-8)
        # It passes its breakdown torque on the way, but where the case is so slow that it does not.
        most = max(gives(w) for w in np.linspace(0.0, goal, 200001))
        assert found[f"T_p[{case}]"] == pytest.approx(most, rel=1e-9)
        for name, wanted in zip(("T_c", "F_t"), hardest(found, case, most)):
            assert found[f"{name}[{case}]"] == pytest.approx(wanted, rel=1e-9), name


@pytest.mark.parametrize("ramp, limit", [(2.0, 1.5), (30.0, 1.5)])
def test_an_inverter_keeps_its_ramp_as_far_as_its_torque_allows(tmp_path, ramp, limit):
    scene = started(tmp_path, "inverter", t_r=f"{ramp} s", lambda_inv=str(limit))
    found = outputs(scene, tmp_path, [*NAMES, *(f"{name}[{case}]" for case in (1, 2) for name in ("t_inv", "T_ramp"))])
    for case, speed in ((1, 1.5), (2, 0.5)):
        momentum, against = found[f"J_start[{case}]"] * RATIO * speed / 60 * 2 * np.pi, found[f"T_0[{case}]"]
        time = np.maximum(ramp, momentum / (limit * RATED - against))
        assert found[f"t_inv[{case}]"] == pytest.approx(time, rel=1e-12)
        assert found[f"T_ramp[{case}]"] == pytest.approx(against + momentum / ramp, rel=1e-12)
        torque = against + momentum / time
        assert found[f"T_p[{case}]"] == pytest.approx(torque, rel=1e-12)
        for name, wanted in zip(("T_c", "F_t"), hardest(found, case, torque)):
            assert found[f"{name}[{case}]"] == pytest.approx(wanted, rel=1e-10), name


def test_a_motor_that_is_too_slow_for_a_case_is_refused(tmp_path):
    scene = started(tmp_path, "slip", ('n_s   = "0.5 1/min"', 'n_s = "1.6 1/min"'), lambda_bd="2.6", n_0="1000 1/min")
    told = lemnis("check", scene, expect=1)
    assert "in load case 2 a motor would have to turn at 1024 1/min, which is not below n_0 = 1000 1/min" in told


STAGES, RING = [(2.8, 0.96), (4.0, 0.97), (4.7, 0.97)], (2.2 / 0.18, 0.94)


def test_torque_speed_and_power_go_on_from_shaft_to_shaft(tmp_path):
    text = SCENE.read_text(encoding="utf-8")
    stages = "".join(f'[[supports.slewing_drive.stages]]\ni_g = "{i}"\neta_g = "{eta}"\n' for i, eta in STAGES)
    for old, new in (('i_sl     = "640"\n', ""), ('eta_sl   = "85 %"\n', ""), ("[supports.slewing_drive.brake]", stages + "[supports.slewing_drive.brake]"),
                     ('r_g     = "2.2 m"\n', f'r_g = "2.2 m"\neta_r = "{RING[1]}"\n')):
        assert old in text
        text = text.replace(old, new, 1)
    (tmp_path / "staged.toml").write_text(text, encoding="utf-8")
    shafts = range(1, 4)
    cases = [f"{name}[{case}]" for name in ("M_st", "T_0", "J_start", "J_c", "t_start") for case in (1, 2)]
    names = ["n_g0", "T_g0", "P_g0", "T_gp0", *(f"{name}[{j}]" for name in ("n_g", "T_g", "P_g", "T_gp") for j in shafts)]
    found = outputs(tmp_path / "staged.toml", tmp_path, [*names, *cases])
    ratios, efficiencies = (np.cumprod([1.0, *(stage[k] for stage in STAGES)]) for k in (0, 1))
    ratio, efficiency = ratios[-1] * RING[0], efficiencies[-1] * RING[1]
    speed = ratio * 1.5 / 60
    torque = found["M_st[1]"] / (ratio * DRIVES * efficiency)
    # What accelerates all but the motor's own inertia, in the mean of a start; in the first case most is asked.
    push = np.max([found[f"T_0[{c}]"] + found[f"J_c[{c}]"] / (ratio**2 * DRIVES * efficiency) * ratio * 2 * np.pi * n / 60 / found[f"t_start[{c}]"]
                   for c, n in ((1, 1.5), (2, 0.5))], axis=0)
    for j in (0, *shafts):
        at = (lambda name: found[f"{name}0"]) if j == 0 else (lambda name: found[f"{name}[{j}]"])
        assert at("n_g") == pytest.approx(speed / ratios[j], rel=1e-12)
        assert at("T_g") == pytest.approx(torque * ratios[j] * efficiencies[j], rel=1e-12)
        assert at("P_g") == pytest.approx(2 * np.pi * speed * torque * efficiencies[j], rel=1e-12)
        assert at("T_gp") == pytest.approx(push * ratios[j] * efficiencies[j], rel=1e-11)


@pytest.mark.parametrize("language", ["en", "zh", "bg"])
def test_the_book_has_a_table_of_all_shafts(language, tmp_path):
    scene = ROOT / "models/scenes/portal_004_ring.toml"
    lemnis("book", scene, "--language", language, "--format", "typ", "--output", tmp_path)
    book = typst(next(tmp_path.glob("*.typ")))
    known = words(language)
    assert known["section"]["turning_gear"] in book and known["section"]["turning_shafts"] in book
    assert known["table"]["turning_shafts"] in book
    assert known["check"]["turning_gear"] in book


CURVE = [(400.0, 200.0), (800.0, 290.0), (1200.0, 330.0), (1500.0, 270.0), (1800.0, 120.0)]
OF_ENGINE = (('i_sl     = "640"', 'i_sl = "1000"'), ('P_N      = "22 kW"', 'P_N = "40 kW"'), ('n_N      = "960 1/min"', 'n_N = "1500 1/min"'))


def engined(tmp_path, *replaced, curve=CURVE, **keys):
    """The scene with an engine that has a curve of torque over speed."""
    points = "".join(f'[[supports.slewing_drive.start.curve]]\nn_en = "{n} 1/min"\nT_en = "{torque} N.m"\n' for n, torque in curve)
    brake = ("[supports.slewing_drive.brake]", points + "[supports.slewing_drive.brake]")
    return started(tmp_path, "engine", *OF_ENGINE, brake, *replaced, **{"n_idle": "450 1/min", "n_gov": "1800 1/min"} | keys)


OF_START = [*NAMES, *(f"{name}[{case}]" for case in (1, 2) for name in ("t_cl", "t_eng", "a_eng", "T_e_least")), "T_e_max[1]", "k_e[1]", "T_id[1]"]


def test_a_start_of_an_engine_is_that_of_an_integration_in_time(tmp_path):
    from scipy.integrate import solve_ivp

    found = outputs(engined(tmp_path), tmp_path, OF_START)
    turns = 2 * np.pi / 60
    speeds, torques = (np.array([point[k] for point in CURVE]) for k in (0, 1))
    gives = lambda n: np.interp(n, speeds, torques)
    assert found["T_e_max[1]"] == pytest.approx(330.0, rel=1e-12)
    assert found["k_e[1]"] == pytest.approx(330.0 / (40e3 / (1500 * turns)), rel=1e-12)
    assert found["T_id[1]"] == pytest.approx(gives(450.0), rel=1e-12)
    for case, goal in ((1, 1500.0), (2, 500.0)):
        inner = [n for n in speeds if 450.0 < n < goal]
        assert found[f"T_e_least[{case}]"] == pytest.approx(min(gives(n) for n in (450.0, goal, *inner)), rel=1e-12)
        for i in range(len(found["psi"])):
            against, inertia = found[f"T_0[{case}]"][i], found[f"J_start[{case}]"][i]
            # The engine idles, and its torque there turns all but its own inertia.
            clutch = (inertia - SHAFT) * 450.0 * turns / (gives(450.0) - against)
            time = clutch
            for low, high in zip((450.0, *inner), (*inner, goal)):
                reached = lambda t, y: y[0] - high
                reached.terminal = True
                run = solve_ivp(lambda t, y: [(gives(y[0]) - against) / inertia / turns], [0, 300], [low], events=reached, rtol=1e-12, atol=1e-9)
                time += run.t_events[0][0]
            assert found[f"t_cl[{case}]"][i] == pytest.approx(clutch, rel=1e-11)
            assert found[f"t_eng[{case}]"][i] == pytest.approx(time, rel=1e-8), (case, i)
            head = found[f"R_o[{case}]"][i] * found[f"Omega_c[{case}]"][i]
            assert found[f"a_eng[{case}]"][i] == pytest.approx(head / time, rel=1e-8)
        # What is behind the clutch bears its torque, or what is left of the greatest one on the way.
        most = max(gives(n) for n in (450.0, goal, *inner))
        assert found[f"T_p[{case}]"] == pytest.approx(most, rel=1e-12)
        at = lambda name: found[f"{name}[{case}]"]
        rate = np.maximum((most - at("T_0")) / at("J_start"), (gives(450.0) - at("T_0")) / (at("J_start") - SHAFT))
        coupled = np.maximum(at("T_0") + (at("J_start") - SHAFT) * rate, 250.0 - SHAFT * at("alpha_w"))
        assert at("T_c") == pytest.approx(coupled, rel=1e-11)
        assert at("F_t") == pytest.approx((at("M_st") + at("J_c") * rate / 1000.0) / (2.2 * DRIVES), rel=1e-11)


def test_a_start_of_an_engine_with_a_constant_torque_has_a_closed_form(tmp_path):
    found = outputs(engined(tmp_path, curve=[(450.0, 300.0), (1000.0, 300.0), (1800.0, 300.0)]), tmp_path, OF_START)
    for case, goal in ((1, 1500.0), (2, 500.0)):
        spare, inertia = 300.0 - found[f"T_0[{case}]"], found[f"J_start[{case}]"]
        wanted = ((inertia - SHAFT) * 450.0 + inertia * (goal - 450.0)) * 2 * np.pi / 60 / spare
        assert found[f"t_eng[{case}]"] == pytest.approx(wanted, rel=1e-12)


def test_a_steep_curve_is_integrated_as_its_logarithm(tmp_path):
    # From all that it can give to little more than what resists.
    found = outputs(engined(tmp_path, curve=[(450.0, 9e4), (1500.0, 100.0), (1800.0, 100.0)]), tmp_path, OF_START)
    spare, inertia = found["T_0[1]"], found["J_start[1]"]
    first, last = 9e4 - spare, 100.0 - spare
    assert (last > 0).all() and (first / last).min() > 1000
    wanted = found["t_cl[1]"] + inertia * 2 * np.pi / 60 * 1050.0 * np.log(first / last) / (first - last)
    assert found["t_eng[1]"] == pytest.approx(wanted, rel=1e-12)


@pytest.mark.parametrize("replaced, curve, keys, told", [
    ([], [(400.0, 20.0), (1800.0, 25.0)], {}, "the engine gives 25 N.m at most, where T_0 = "),
    ([], [(400.0, 200.0), (300.0, 250.0), (1800.0, 100.0)], {}, "n_en = 300 1/min after 400 1/min"),
    ([], [(500.0, 200.0), (1700.0, 250.0)], {}, "the torque curve goes from 500 1/min to 1700 1/min, and the engine runs from 450 1/min to 1800 1/min"),
    ([], [(400.0, 200.0)], {}, "the torque curve with one point"),
    ([], CURVE, {"n_gov": "1400 1/min"}, "n_N = 1500 1/min is not between n_idle = 450 1/min and n_gov = 1400 1/min"),
    ([], CURVE, {"n_idle": "600 1/min"}, "in load case 2 a motor would have to turn at 500 1/min, and an engine runs from n_idle = 600 1/min to n_gov = 1800 1/min"),
    ([], CURVE, {"t_r": "2 s"}, "t_r belongs to a start of kind \"inverter\""),
])
def test_what_no_engine_can_do_is_refused(tmp_path, replaced, curve, keys, told):
    assert told in lemnis("check", engined(tmp_path, *replaced, curve=curve, **keys), expect=1)


@pytest.mark.parametrize("language", ["en", "zh", "bg"])
def test_the_book_has_the_start_of_the_engine(language, tmp_path):
    lemnis("book", engined(tmp_path), "--language", language, "--format", "typ", "--output", tmp_path)
    book = typst(next(tmp_path.glob("*.typ")))
    assert words(language)["section"]["resistances_engine"] in book
    assert words(language)["input"]["case_curve"] in book
