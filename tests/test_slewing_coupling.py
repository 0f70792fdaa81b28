"""A slewing drive behind a coupling that slips, in FMPy: both standards and both interfaces against closed forms, against SciPy,
and with the energy of all that turns counted from outside."""

import math

import numpy as np
import pytest
from fmpy import read_model_description, simulate_fmu
from fmpy.validation import validate_fmu
from scipy.integrate import solve_ivp

from conftest import ROOT, lemnis

ENDS = {"FMI 2": ".fmi2.fmu", "FMI 3": ".fmu"}
KINDS = ("CoSimulation", "ModelExchange")
READY = ROOT / "models/scenes/slewing_coupling.toml"
J_D, LIMIT, DRY = 740e3, 320e3, 40e3
J = 9e6 + 16e3 * 625.0
PLAIN = """name = "Plain"
title = "Plain"
[slewing]
fidelity = "rigid"
R = "25 m"
Q = "16 t"
J_sl = "9000000 kg.m2"
M_Fsl = "40 kN.m"
{drive}
[slewing.coupling]
J_d = "740000 kg.m2"
M_lim = "320 kN.m"
[slewing.motion]
from = "-60 deg"
to = "60 deg"
step = "5 deg"
speed = "9 deg/s"
"""


def over(name, told):
    rows = ", ".join(f'["{t} s", "{value} kN.m"]' for t, value in told)
    return f'{name} = {{ between = "steps", over = [{rows}] }}'


def built(folder, text):
    (folder / "scene.toml").write_text(text, encoding="utf-8")
    lemnis("fmu", folder / "scene.toml", "--output", folder)
    return {standard: str(folder / f"Plain{end}") for standard, end in ENDS.items()}


class Pieces:
    """Two sides, each under a constant acceleration, from one known time to the next."""

    def __init__(self):
        self.rows = [(0.0, 0.0, 0.0, 0.0, 0.0, (0.0, 0.0), 0.0)]

    def state(self, time):
        start, psi, omega, omega_d, heat, (a, a_d), limit = next(row for row in reversed(self.rows) if row[0] <= time)
        t = time - start
        apart = (omega_d - omega) * t + 0.5 * (a_d - a) * t * t
        return (psi + omega * t + 0.5 * a * t * t, omega + a * t, omega_d + a_d * t, heat + limit * apart)

    def then(self, time, accelerations, limit):
        self.rows.append((time, *self.state(time), accelerations, limit))
        return self.state(time)


def closed():
    """On at 500 kN·m, which slips; 200 kN·m from 1 s, under which both sides meet; a brake of 600 kN·m from 8 s, which
    slips backward, stops its own side and then the crane."""
    run = Pieces()
    run.then(0.0, ((LIMIT - DRY) / J, (500e3 - LIMIT) / J_D), LIMIT)
    _, omega, omega_d, _ = run.then(1.0, ((LIMIT - DRY) / J, (200e3 - LIMIT) / J_D), LIMIT)
    meet = 1.0 + (omega_d - omega) / ((LIMIT - DRY) / J + (LIMIT - 200e3) / J_D)
    both = (200e3 - DRY) / (J + J_D)
    run.then(meet, (both, both), 0.0)
    slows, slows_d = (-LIMIT - DRY) / J, (LIMIT - 600e3) / J_D
    _, omega, omega_d, _ = run.then(8.0, (slows, slows_d), -LIMIT)
    rest_d, rest = 8.0 - omega_d / slows_d, 8.0 - omega / slows
    assert meet < 8.0 < rest_d < rest
    run.then(rest_d, (slows, 0.0), -LIMIT)
    run.then(rest, (0.0, 0.0), 0.0)
    return run, (meet, rest_d, rest)


@pytest.fixture(scope="module")
def plain(tmp_path_factory):
    drive = "\n".join([over("M_sl", [(0, 500), (1, 200), (8, 0), (30, 0)]), over("M_Bsl", [(0, 0), (8, 600)])])
    return built(tmp_path_factory.mktemp("plain"), PLAIN.format(drive=drive))


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("standard", ENDS)
def test_a_start_and_a_stop_in_closed_form(plain, standard, kind):
    run, ends = closed()
    assert not validate_fmu(plain[standard])
    names = ["psi_sl", "omega_sl", "omega_d", "W_slip"]
    found = simulate_fmu(plain[standard], fmi_type=kind, stop_time=30.0, output_interval=0.25, relative_tolerance=1e-10,
                         output=[*names, "M_cd"], record_events=False)
    expected = np.array([run.state(t) for t in found["time"]])
    apart = np.abs(np.array([[row[name] for name in names] for row in found]) - expected)
    sizes = np.abs(expected).max(axis=0)
    assert (apart.max(axis=0) <= 1e-9 * sizes).all(), (apart.max(axis=0) / sizes, ends)
    assert found["omega_sl"][-1] == 0.0 and found["omega_d"][-1] == 0.0
    slipping = [(t < ends[0] and t > 0.0) or 8.0 < t < ends[2] for t in found["time"]]
    for t, moment, slips in zip(found["time"], found["M_cd"], slipping):
        if t in (0.0, 8.0):
            continue
        stuck = 200e3 - J_D * (200e3 - DRY) / (J + J_D) if t < 8.0 else 0.0
        wanted = (LIMIT if t < 8.0 else -LIMIT) if slips else stuck
        assert abs(moment - wanted) <= 1e-9 * LIMIT, (t, moment, wanted)


def slewed(told, end):
    """Two shafts with viscous and dry friction on a slope, from one change to the next, by SciPy: who sticks is a guess that
    must hold."""
    lean, c = (-1.2 * 180e3 * 9.81 + 16e3 * 9.81 * 25.0) * math.sin(math.radians(0.5)), 600e3
    times = sorted({t for t, *_ in told} | {end})

    def given(t):
        return [row for row in told if row[0] <= t + 1e-12][-1][1:]

    def outer(psi, omega):
        return -lean * math.sin(psi) - c * omega - DRY * math.copysign(1.0, omega if omega else 1.0)

    def rates(t, y, slip, moment, brake):
        psi, omega, omega_d, _ = y
        if slip == 0:
            a = (moment + outer(psi, omega) - brake * math.copysign(1.0, omega)) / (J + J_D)
            return [omega, a, a, 0.0]
        a_d = (moment - slip * LIMIT - brake * math.copysign(1.0, omega_d)) / J_D
        return [omega, (slip * LIMIT + outer(psi, omega)) / J, a_d, slip * LIMIT * (omega_d - omega)]

    def through(t, y, moment, brake):
        return moment - brake * math.copysign(1.0, y[1] or 1.0) - J_D * rates(t, y, 0, moment, brake)[1]

    pieces, y, t = [], np.array([math.radians(-60.0), 0.0, 0.0, 0.0]), 0.0
    for stop in times[1:]:
        moment, brake = given(t)
        if y[1] == y[2]:
            passed = through(t, y, moment, brake)
            slip = int(passed > LIMIT) - int(passed < -LIMIT)
        while t < stop - 1e-12:
            def crosses(t, y):
                if slip == 0:
                    return LIMIT - abs(through(t, y, moment, brake))
                return slip * (y[2] - y[1]) if t > since + 1e-9 else 1.0

            since = t
            crosses.terminal, crosses.direction = True, -1
            found = solve_ivp(lambda t, y: rates(t, y, slip, moment, brake), (t, stop), y, method="DOP853", events=crosses,
                              dense_output=True, rtol=1e-12, atol=1e-12)
            pieces.append((t, found.t[-1], found.sol))
            t, y = found.t[-1], found.y[:, -1].copy()
            if found.status == 1:
                if slip:
                    y[2] = y[1]
                passed = through(t, y, moment, brake)
                slip = 0 if slip else int(math.copysign(1, passed))
    return lambda at: next(sol(at) for start, last, sol in pieces if start <= at <= last + 1e-12)


def test_friction_a_slope_and_moments_from_outside(tmp_path):
    """The moment rises beyond the limit, falls, and turns round while the crane still turns."""
    text = READY.read_text(encoding="utf-8")
    start, stop = text.index("# Drive: on at once"), text.index("[slewing.coupling]")
    (tmp_path / "open.toml").write_text(text[:start] + text[stop:], encoding="utf-8")
    lemnis("fmu", tmp_path / "open.toml", "--output", tmp_path)
    told = [(0.0, 400e3, 0.0), (1.0, 250e3, 0.0), (6.0, 150e3, 30e3), (11.0, -420e3, 0.0), (11.3, -100e3, 0.0)]
    state = slewed(told, 14.0)
    steps = [told[0]] + [row for a, b in zip(told, told[1:]) for row in ((b[0], *a[1:]), b)] + [(14.0, *told[-1][1:])]
    inputs = np.array(steps, dtype=[("time", float), ("M_sl", float), ("M_Bsl", float)])
    names = ["psi_sl", "omega_sl", "omega_d", "W_slip"]
    sizes = [1.0, 0.1, 0.1, 1e4]
    for end in ENDS.values():
        path = str(tmp_path / f"SlewingCoupling{end}")
        for kind in KINDS:
            found = simulate_fmu(path, fmi_type=kind, stop_time=14.0, output_interval=0.1, input=inputs,
                                 relative_tolerance=1e-10, output=names, record_events=False)
            expected = np.array([state(t) for t in found["time"]])
            assert expected[-1, 1] > 0.0 and expected[-1, 3] > 1e4, "it slips, and turns one way"
            apart = np.abs(np.array([[row[name] for name in names] for row in found]) - expected) / sizes
            assert apart.max() <= 1e-7, (end, kind, apart.max(axis=0))


@pytest.mark.parametrize("kind", KINDS)
def test_what_the_drive_gives_is_stored_or_taken(tmp_path, kind):
    """The ready scene: work of the drive and what brake, friction and slope take by the trapezium of what the FMU shows; motion
    and heat as it has them."""
    lemnis("fmu", READY, "--output", tmp_path)
    path = str(tmp_path / "SlewingCoupling.fmu")
    assert {v.name: v.causality for v in read_model_description(path).modelVariables if v.name in ("W_slip", "J_d", "M_sl")} == {
        "W_slip": "output", "J_d": "parameter", "M_sl": "output"}
    names = ["psi_sl", "omega_sl", "omega_d", "W_slip", "E_sl", "E_d", "M_sl", "M_Bsl"]
    run = simulate_fmu(path, fmi_type=kind, stop_time=34.0, output_interval=1e-3, relative_tolerance=1e-9, output=names,
                       record_events=False)
    told = {"M_sl": [(0.0, 380e3), (1.5, 260e3), (10.0, 140e3), (20.0, 0.0)], "M_Bsl": [(0.0, 0.0), (20.0, 600e3)]}
    middle = 0.5 * (run["time"][1:] + run["time"][:-1])

    def held(name):
        times, values = zip(*told[name])
        return np.array(values)[np.searchsorted(times, middle, side="right") - 1]

    def integral(values):
        return 0.5 * (values[1:] + values[:-1]) * np.diff(run["time"])

    turned = integral(run["omega_d"])
    given = (held("M_sl") * turned).sum()
    braked = (held("M_Bsl") * np.abs(turned)).sum()
    rubbed = (DRY * integral(np.abs(run["omega_sl"])) + 600e3 * integral(run["omega_sl"] ** 2)).sum()
    lean = (-1.2 * 180e3 * 9.81 + 16e3 * 9.81 * 25.0) * math.sin(math.radians(0.5))
    raised = -lean * (math.cos(run["psi_sl"][-1]) - math.cos(run["psi_sl"][0]))
    stored = run["E_sl"][-1] + run["E_d"][-1]
    left = given - braked - rubbed - raised - stored - run["W_slip"][-1]
    assert run["W_slip"][-1] > 1e4 and stored < 1e-9, "it slipped, and rests"
    assert abs(left) <= 1e-6 * given, (left, given, braked, rubbed, raised, run["W_slip"][-1])
