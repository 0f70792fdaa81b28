"""Commanded places of continuous controllers, in FMPy: a rigid shaft in closed form, the limit of samples that are written here, and
on a crane that luffs, slews and lifts the limit of its own sampled controllers; both standards and both interfaces, exact derivatives,
a saved state, the same bits for every communication step, the book."""

import numpy as np
import pytest
from fmpy import read_model_description, simulate_fmu
from fmpy.validation import validate_fmu
from scipy.linalg import expm
from scipy.optimize import brentq

from conftest import lemnis, words
from test_commands import ENDS, Stepped, same_bits, written
from test_control import SHAFT
from test_control_continuous import A, FINE, J, KINDS, told
from test_crane_continuous import FREE, put
from test_crane_control import TEXT

# From rest at nought; SI. The speed is that from which it stops below 2 a/K_x² = 0.015 rad where K_x is 2/s, and above
# v_max²/(2 a) = 0.06 rad the greatest.
K_P, K_I, MOST = 4e7, 1e8, 0.06
CASES = {
    "settles": dict(near=0.4, command=0.05),
    "stops": dict(near=2.0, command=0.5),
    "back": dict(near=2.0, command=-0.3, friction=4e6, start=0.2),
    "limited": dict(near=2.0, command=0.5, limit=90e3),
    "turned": dict(near=1.0, command=[(0.0, 0.4), (5.0, -0.1), (13.0, 0.02)]),
    "led": dict(near=1.5, command=[(0.0, 0.0), (4.0, 0.2), (6.0, 0.05), (8.0, 0.05), (14.0, 0.1)], between="linear"),
}


def shaft(folder, name, near, command, between="steps", friction=0.0, limit=1e6, start=0.0, more=FINE):
    command = told(command, between, "rad") if isinstance(command, list) else f'"{command} rad"'
    text = SHAFT.format(name=name, k_p=K_P / 1e3, k_i=K_I / 1e3, cycle="", ramp=A, limit=limit / 1e3, friction=friction / 1e3,
                        command="0", more=more)
    place = f'psi_csl = {command}\nK_psisl = "{near} 1/s"\nomega_maxsl = "{MOST} rad/s"'
    text = put(text, r"^omega_csl = 0$", place)
    return written(folder, name, put(text, r"^J_sl .*?$", f'J_sl = "{J} kg.m2"\npsi_sl = "{start} rad"'))


def settled(times, near, command):
    """Angle, speed and set point: the set point rises with A until it meets K_x e, then it is that; each a linear system."""
    def solved(matrix, y, t):
        return expm(matrix * t) @ y

    # Angle, speed, integral of the error, set point, one.
    ramp = np.zeros((5, 5))
    ramp[0, 1], ramp[1, [1, 2, 3]], ramp[2, [1, 3]], ramp[3, 4] = 1.0, [-K_P / J, K_I / J, K_P / J], [-1.0, 1.0], A
    start = np.array([0.0, 0.0, 0.0, 0.0, 1.0])
    left = lambda y: near * (command - y[0]) - y[3]
    meets = brentq(lambda t: left(solved(ramp, start, t)), 0.0, 5.0, xtol=1e-15)
    follows = ramp.copy()
    follows[3] = [0.0, -near, 0.0, 0.0, 0.0]
    at = solved(ramp, start, meets)
    return np.array([(solved(ramp, start, t) if t < meets else solved(follows, at, t - meets))[[0, 1, 3]] for t in times])


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("standard", ENDS)
def test_a_short_way_in_closed_form(tmp_path, standard, kind):
    path = shaft(tmp_path, "Short", **CASES["settles"])[standard]
    assert not validate_fmu(path)
    names = ["psi_sl", "omega_sl", "omega_rsl"]
    run = simulate_fmu(path, fmi_type=kind, stop_time=12.0, output_interval=0.1, relative_tolerance=1e-12, output=names, record_events=False)
    wanted = settled(run["time"], **CASES["settles"])
    apart = [np.abs(run[name] - wanted[:, i]).max() for i, name in enumerate(names)]
    print(standard, kind, apart)
    assert wanted[:, 2].max() > 0.015 and max(apart) <= 1e-9


def samples(cycle, times, near, command, between="steps", friction=0.0, limit=1e6, start=0.0):
    """The same under a controller with samples; between two of them J dw/dt = M - c w in closed form."""
    rows = command if isinstance(command, list) else [(0.0, command)]
    asked = np.array(rows).T
    place, speed, point, integral, found = start, 0.0, 0.0, 0.0, []
    decay = np.exp(-friction * cycle / J)
    mean = (1 - decay) / friction * J if friction else cycle
    every = round((times[1] - times[0]) / cycle)
    for k in range(round(times[-1] / cycle) + 1):
        if k % every == 0:
            found.append((place, speed))
        t = k * cycle
        goal = np.interp(t, *asked) if between == "linear" else asked[1][np.searchsorted(asked[0], t + 1e-9, side="right") - 1]
        left = goal - place
        wanted = np.sign(left) * min(near * abs(left), MOST, (2 * A * abs(left)) ** 0.5)
        point += min(max(wanted - point, -A * cycle), A * cycle)
        error = point - speed
        moment = min(max(K_P * error + integral, -limit), limit)
        if moment == K_P * error + integral or (moment > 0) != (error > 0):
            integral += K_I * cycle * error
        if friction:
            rest = moment / friction
            place += rest * cycle + (speed - rest) * mean
            speed = rest + (speed - rest) * decay
        else:
            place += speed * cycle + moment / J * cycle**2 / 2
            speed += moment / J * cycle
    return np.array(found)


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("case", CASES)
def test_any_way_is_the_limit_of_samples(tmp_path, case, kind):
    """Ever shorter cycles, and what they tend to: the error goes with the cycle, but for where in a cycle an event comes."""
    path = shaft(tmp_path, case.title(), **CASES[case])["FMI 3"]
    times = np.arange(0.0, 16.01, 0.1)
    run = simulate_fmu(path, fmi_type=kind, stop_time=16.0, output_interval=0.1, relative_tolerance=1e-12, output=["psi_sl", "omega_sl"],
                       record_events=False)
    found = np.array([run["psi_sl"], run["omega_sl"]]).T
    once, twice, thrice = (samples(cycle, times, **CASES[case]) for cycle in (4e-4, 2e-4, 1e-4))
    ranges = np.ptp(found, axis=0)
    off = [(np.abs(rows - found).max(axis=0) / ranges).max() for rows in (once, twice, thrice)]
    limit = (np.abs(2 * thrice - twice - found).max(axis=0) / ranges).max()
    print(case, kind, off, limit)
    assert off[0] <= 1e-3 and 3.5 < off[0] / off[2] < 4.5, off
    assert limit <= (2e-5 if case == "led" else 1e-5)


def test_it_arrives_and_stays(tmp_path):
    for case in ("settles", "stops", "back", "limited"):
        (tmp_path / case).mkdir()
        fmu = Stepped(shaft(tmp_path / case, case.title(), **CASES[case])["FMI 3"])
        rows = np.array(fmu.run([0.0, 60.0, 80.0, 90.0], ["psi_sl", "omega_sl", "omega_rsl"]))
        fmu.close()
        assert np.abs(rows[1:, 0] - CASES[case]["command"]).max() <= 1e-9, (case, rows)
        assert np.abs(rows[1:, 1:]).max() <= 1e-10, (case, rows)


def test_derivatives_are_those_of_the_law(tmp_path):
    """The set point follows K_x e: its rate is −K_x v; on the ramp it is the ramp."""
    fmu = Stepped(shaft(tmp_path, "Short", **CASES["settles"])["FMI 3"])
    seen = {}
    for end in (0.1, 6.0):
        fmu.run([0.0, end] if not seen else [0.1, end], ["omega_sl"])
        for known in ("omega_sl", "psi_sl", "K_psisl", "a_sl"):
            seen[end, known] = fmu.slave.getDirectionalDerivative([fmu.references["der(omega_rsl)"]], [fmu.references[known]], [1.0])[0]
        seen[end] = fmu.get(["der(omega_rsl)", "omega_sl"])
    fmu.close()
    assert seen[0.1][0] == A and [seen[0.1, known] for known in ("omega_sl", "psi_sl", "K_psisl", "a_sl")] == [0.0, 0.0, 0.0, 1.0]
    rate, speed = seen[6.0]
    assert rate == pytest.approx(-0.4 * speed, rel=1e-14) and speed > 1e-4
    assert [seen[6.0, known] for known in ("omega_sl", "psi_sl", "a_sl")] == [-0.4, 0.0, 0.0]
    assert seen[6.0, "K_psisl"] == pytest.approx(-speed, rel=1e-14)


@pytest.mark.parametrize("standard", ENDS)
@pytest.mark.parametrize("case", ["turned", "led"])
def test_any_communication_step_gives_the_same_bits(tmp_path, standard, case):
    found = same_bits(shaft(tmp_path, case.title(), **CASES[case])[standard], 1600, 9)
    assert found[1600] != found[0]


def test_a_saved_state_goes_on_in_the_same_bits(tmp_path):
    fmu = Stepped(shaft(tmp_path, "Turned", **CASES["turned"])["FMI 3"])
    names = ["psi_sl", "omega_sl", "omega_rsl", "M_sl"]
    fmu.run([0.0, 0.7], names)
    once, again = fmu.again([0.7, 6.1, 13.0], names)
    fmu.close()
    assert once == again


def to_places(cycle=None, **keys):
    """The ready scene with places commanded of all drives, its samples a cycle (s) apart, or continuous."""
    rows = {"theta_cA": [(0.0, "44 deg"), (1.0, "46 deg"), (13.0, "45 deg"), (20.0, "45 deg")],
            "l_ch": [(0.0, "18 m"), (2.0, "15.5 m"), (14.0, "16 m"), (20.0, "16 m")],
            "psi_csl": [(0.0, "0 deg"), (0.5, "20 deg"), (12.0, "9 deg"), (20.0, "9 deg")]}
    told = {name: '{ between = "steps", over = [' + ", ".join(f'["{t} s", "{v}"]' for t, v in own) + "] }" for name, own in rows.items()}
    text = put(TEXT, r"^theta_cA *= \{.*?^\] \}", f"theta_cA = {told['theta_cA']}")
    text = put(text, r"^v_ch *= \{.*?^\] \}", f"l_ch = {told['l_ch']}\nK_lh = \"0.6 1/s\"\nv_maxh = \"0.5 m/s\"")
    text = put(text, r"^omega_csl *= \{.*?^\] \}", f"psi_csl = {told['psi_csl']}\nK_psisl = \"0.5 1/s\"\nomega_maxsl = \"3 deg/s\"")
    for name in ("T_cA", "T_ch", "T_csl"):
        text = put(text, rf"^{name} *=.*?\n", "" if cycle is None else f'{name} = "{cycle} s"\n')
    for name, value in keys.items():
        text = put(text, rf"^{name} +=.*?$", f"{name} = {value}" if value else "")
    return text


SEEN = ["theta_1", "omega_1", "psi_sl", "omega_sl", "l_R", "v_R", "x_Q", "y_Q", "z_Q"]


def test_sampled_controllers_of_a_crane_tend_to_it_at_first_order(tmp_path):
    """Of all drives at once, with friction that sticks."""
    last = {}
    for cycle in (None, 0.02, 2e-3, 2e-4):
        (tmp_path / f"{cycle}").mkdir()
        fmu = Stepped(written(tmp_path / f"{cycle}", "PortalBySpeed", to_places(cycle, **FREE))["FMI 3"])
        last[cycle] = np.array(fmu.run([0.5 * i for i in range(41)], SEEN))
        fmu.close()
    scale = np.ptp(last[None], axis=0)
    off = np.array([(np.abs(last[cycle] - last[None]) / scale).max(axis=0) for cycle in (0.02, 2e-3, 2e-4)])
    orders = -np.diff(np.log10(off), axis=0)
    print(off, orders)
    assert scale[0] > 0.02 and scale[2] > 0.2 and scale[4] > 1.5
    assert np.abs(orders - 1.0).max() <= 0.15


@pytest.mark.parametrize("standard", ENDS)
def test_a_crane_goes_to_its_places_in_both_interfaces(tmp_path, standard):
    path = written(tmp_path, "PortalBySpeed", to_places())[standard]
    assert not validate_fmu(path)
    runs = [simulate_fmu(path, fmi_type=kind, stop_time=20.0, output_interval=0.5, relative_tolerance=1e-10, output=SEEN,
                         record_events=False) for kind in KINDS]
    apart = {name: np.abs(runs[0][name] - runs[1][name]).max() / np.ptp(runs[0][name]) for name in SEEN}
    print(standard, apart)
    assert max(apart.values()) <= 2e-6, apart


@pytest.mark.parametrize("standard", ENDS)
def test_any_communication_step_gives_the_same_bits_of_a_crane(tmp_path, standard):
    found = same_bits(written(tmp_path, "PortalBySpeed", to_places())[standard], 1200, 7)
    assert found[1200] != found[0]


def test_places_are_inputs_that_act_at_events(tmp_path):
    path = shaft(tmp_path, "Short", **CASES["settles"])["FMI 3"]
    variables = {v.name: v for v in read_model_description(path).modelVariables}
    assert (variables["psi_csl"].causality, variables["psi_csl"].variability) == ("input", "discrete")
    assert "omega_csl" not in variables and "T_csl" not in variables and "omega_ssl" not in variables


@pytest.mark.parametrize("language", ["en", "zh", "bg"])
def test_the_book_has_the_law(tmp_path, language):
    known = words(language)
    (tmp_path / "scene.toml").write_text(to_places(), encoding="utf-8")
    lemnis("book", tmp_path / "scene.toml", "--format", "typ", "--language", language, "--output", tmp_path)
    [page] = tmp_path.glob("*.typ")
    text = page.read_text(encoding="utf-8")
    for told in (known["assumption"]["control_to_place"], known["assumption"]["control_continuous"], known["section"]["motion_regulation"]):
        assert told in text, told
    for symbol in ("e_(theta A)", 'omega_"w A"', "e_(l h)", 'v_"w h"', 'e_(psi "sl")', 'omega_"w sl"'):
        assert symbol in text, symbol
