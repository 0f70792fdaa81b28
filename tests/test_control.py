"""Slewing by a commanded speed: the samples of its controller against a recurrence of their own, both standards and both
interfaces, a time event at every sample, the same bits for every communication step, a saved state on the way."""

import re

import numpy as np
import pytest
from fmpy import read_model_description, simulate_fmu
from fmpy.validation import validate_fmu

from conftest import ROOT, lemnis
from test_commands import ENDS, Stepped, same_bits, written

SPEED = ROOT / "models/scenes/slewing_by_speed.toml"

# A rigid shaft with viscous friction, its controller with ramp and limit; SI.
J, C, K_P, K_I, T_C, A, M_MAX = 4.0e6, 2.0e5, 6.0e6, 5.0e6, 0.05, 0.03, 150e3
SHAFT = """name  = "{name}"
title = "A rigid shaft under its controller"

[slewing]
fidelity = "rigid"
R     = "20 m"
Q     = "0 kN"
J_sl  = "4000000 kg.m2"
c_sl  = "{friction} kN.m.s"

[slewing.control]
K_psl   = "{k_p} kN.m.s"
K_isl   = "{k_i} kN.m"
{cycle}
a_sl    = "{ramp} rad/s2"
M_maxsl = "{limit} kN.m"
omega_csl = {command}
{more}
[slewing.motion]
from  = "-60 deg"
to    = "120 deg"
step  = "5 deg"
speed = "9 deg/s"
"""


def samples(count, commanded=0.1):
    """Speed, moment until then, set point and integral part at each sample: between two of them J dw/dt = M - c w."""
    omega = integral = point = 0.0
    decay = np.exp(-C * T_C / J)
    rows = []
    for _ in range(count):
        point += min(max(commanded - point, -A * T_C), A * T_C)
        error = point - omega
        asked = K_P * error + integral
        moment = min(max(asked, -M_MAX), M_MAX)
        if asked == moment or (asked > 0) != (error > 0):
            integral += K_I * T_C * error
        omega = omega * decay + moment / C * (1 - decay)
        rows.append((omega, moment, point, integral))
    return np.array(rows)


@pytest.fixture(scope="module")
def shaft(tmp_path_factory):
    text = SHAFT.format(name="Shaft", friction=C / 1e3, k_p=K_P / 1e3, k_i=K_I / 1e3, cycle=f'T_csl = "{T_C} s"', ramp=A,
                        limit=M_MAX / 1e3, command='"0.1 rad/s"', more="")
    return written(tmp_path_factory.mktemp("shaft"), "Shaft", text)


@pytest.fixture(scope="module")
def speed(tmp_path_factory):
    folder = tmp_path_factory.mktemp("speed")
    lemnis("fmu", SPEED, "--output", folder)
    return {standard: str(folder / f"SlewingBySpeed{end}") for standard, end in ENDS.items()}


NAMES = ["omega_sl", "M_sl", "omega_ssl", "M_isl"]


@pytest.mark.parametrize("standard", ENDS)
def test_speed_is_commanded_and_the_moment_a_result(shaft, standard):
    assert not validate_fmu(shaft[standard])
    variables = {v.name: v for v in read_model_description(shaft[standard]).modelVariables}
    assert [variables[name].causality for name in ("omega_csl", "M_Bsl", "M_sl")] == ["input", "input", "output"]
    assert [variables[name].variability for name in ("M_sl", "omega_ssl", "M_isl")] == ["discrete"] * 3
    fmu = Stepped(shaft[standard])
    with pytest.raises(Exception):
        fmu.set("M_sl", 1e3)
    fmu.close()


@pytest.mark.parametrize("standard", ENDS)
@pytest.mark.parametrize("step", [1, 7])
def test_samples_are_those_of_the_recurrence(shaft, standard, step):
    """Through limit and ramp, whatever the communication step; the step in time is solved in closed form here."""
    count = 140
    fmu = Stepped(shaft[standard])
    rows = np.array(fmu.run([k * T_C * step for k in range(count // step + 1)], NAMES))[1:]
    fmu.close()
    wanted = samples(count)[step - 1::step]
    assert wanted[:, 1].max() == M_MAX or step > 1
    for column, near in zip(range(4), (1e-12, 1e-5, 1e-14, 1e-5)):
        assert np.abs(rows[:, column] - wanted[:, column]).max() <= near, NAMES[column]


@pytest.mark.parametrize("standard", ENDS)
def test_model_exchange_has_an_event_at_every_sample(shaft, standard):
    """Between two samples FMPy's CVode solves with what the last one held."""
    run = simulate_fmu(shaft[standard], fmi_type="ModelExchange", stop_time=7.0, output_interval=T_C, relative_tolerance=1e-10,
                       output=NAMES[:1], record_events=False)
    assert np.abs(run["omega_sl"][1:] - samples(140)[:, 0]).max() <= 1e-8


@pytest.mark.parametrize("standard", ENDS)
def test_a_saved_state_goes_on_in_the_same_bits(shaft, standard):
    fmu = Stepped(shaft[standard])
    fmu.run([0.0, 0.33], NAMES)
    once, again = fmu.again([0.33, 0.71, 3.0], NAMES)
    fmu.close()
    assert once == again


@pytest.mark.parametrize("standard", ENDS)
def test_any_communication_step_gives_the_same_bits(speed, standard):
    found = same_bits(speed[standard], 3700, 21)
    assert found[3700] != found[0]


@pytest.mark.parametrize("standard", ENDS)
@pytest.mark.parametrize("kind", ["CoSimulation", "ModelExchange"])
def test_fmpy_runs_the_ready_scene(speed, standard, kind):
    """The crane turns by what the command is the integral of, but for what the swing at the end has led it astray."""
    names = ["psi_sl", "omega_sl", "chi_R"]
    run = simulate_fmu(speed[standard], fmi_type=kind, output_interval=0.5, stop_time=40.0, relative_tolerance=1e-9,
                       output=names, record_events=False)
    fmu = Stepped(speed["FMI 3"])
    rows = np.array(fmu.run([i / 2 for i in range(81)], names))
    fmu.close()
    for i, name in enumerate(names):
        assert np.abs(run[name] - rows[:, i]).max() <= (0.0 if kind == "CoSimulation" else 2e-6), name
    assert abs(rows[-1, 0] - np.radians(-45 + 3 * 17)) <= 5e-3


def test_the_book_has_what_runs_leave_of_the_swing(tmp_path):
    """The rope's greatest angle from the vertical once the command has ended, shaped over plain, by FMPy on both scenes."""
    text, most = SPEED.read_text(encoding="utf-8"), {}
    for name, scene in {"shaped": text, "plain": text.replace('shaped = "8.51 s", ', "")}.items():
        (tmp_path / f"{name}.toml").write_text(scene, encoding="utf-8")
        lemnis("fmu", tmp_path / f"{name}.toml", "--output", tmp_path / name)
        run = simulate_fmu(str(tmp_path / name / "SlewingBySpeed.fmu"), stop_time=60.0, output_interval=0.05, record_events=False,
                           output=["x_Q", "y_Q", "z_Q"])
        # The shaped command ends half a period later than the plain one.
        end = 40.0 + 8.51 / 2 if name == "shaped" else 40.0
        after = (run["time"] >= end) & (run["time"] <= end + 8.511)
        most[name] = np.arctan2(np.hypot(run["x_Q"], run["z_Q"]), -run["y_Q"])[after].max()
    lemnis("book", SPEED, "--format", "typ", "--output", tmp_path)
    [told] = re.findall(r"\[18\.0\],\[8\.511\],\[0\.0002\],\[([\d.]+)\]", (tmp_path / "SlewingBySpeed.typ").read_text(encoding="utf-8"))
    assert float(told) == pytest.approx(most["shaped"] / most["plain"], abs=1e-3)


def test_two_periods_are_told_apart_in_the_book(tmp_path):
    """Shaped against two swings: the formula has both periods by their numbers, and is the product of what each leaves of the load's."""
    scene = SPEED.read_text(encoding="utf-8").replace('shaped = "8.51 s"', 'shaped = ["8.51 s", "5 s"]')
    (tmp_path / "two.toml").write_text(scene, encoding="utf-8")
    lemnis("book", tmp_path / "two.toml", "--format", "typ", "--output", tmp_path)
    text = (tmp_path / "SlewingBySpeed.typ").read_text(encoding="utf-8")
    said = re.search(r"absolute value of cosine of fraction pi times T sh 1 over 2 times T R .*? times absolute value of cosine of fraction "
                     r"pi times T sh 2 over 2 times T R end of fraction equals .*?([\d.]+) times 10 to the power of minus (\d+)", text)
    length, g = 18.0, 9.81
    period = 2 * np.pi * np.sqrt(length / g)
    left = abs(np.cos(np.pi / 2 * 8.51 / period) * np.cos(np.pi / 2 * 5.0 / period))
    assert float(said[1]) * 10.0 ** -int(said[2]) == pytest.approx(left, rel=1e-4)
