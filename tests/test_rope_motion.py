"""The boom on a luffing rope in motion: its FMUs in FMPy, both standards and both interfaces, against equations written and
solved here; its tackle slack and caught, its energy from outside."""

import math

import numpy as np
import pytest
from fmpy import read_model_description, simulate_fmu
from fmpy.validation import validate_fmu

import single_boom
from conftest import ROOT
from single_boom import ENDS, G

SCENE = (ROOT / "models/scenes/rope_luffing.toml").read_text(encoding="utf-8")
LENGTH, OFFSET, Q, G_B, R_B, CHI = 33.0, 0.4, 10e3, 9e3, 15.0, math.radians(1.0)
SHEAVE, FALLS = np.array([-2.0, 12.0]), 2.0
J_B, VISCOUS, COULOMB = 0.9e6, 2e5, 5e3
ROPE = 12.0
START = math.radians(25.0)
MOMENT = 4.0e6


def packed(fidelity, folder, more=""):
    rope = f'l_R = "{ROPE} m"\nphi_R = "4 deg"\n{more}'
    path = single_boom.scene(SCENE, fidelity, folder, {"J_b": J_B}, (VISCOUS, COULOMB, MOMENT), rope)
    return single_boom.packed(path, "RopeLuffing", folder)


@pytest.fixture(scope="module", params=["rigid", "swing"])
def fmus(request, tmp_path_factory):
    return request.param, packed(request.param, tmp_path_factory.mktemp(request.param))


def turned(radius, angle):
    """A point that turns about the foot, with two derivatives."""
    place = radius * np.array([math.cos(angle), math.sin(angle)])
    return place, np.array([-place[1], place[0]]), -place


def head(phi):
    return turned(math.hypot(LENGTH, OFFSET), phi + math.atan2(OFFSET, LENGTH))


def below(phi):
    """Rope that the stretch between head and sheave takes from the load, with two derivatives, by the law of cosines."""
    radius, far = math.hypot(LENGTH, OFFSET), float(np.hypot(*SHEAVE))
    angle = phi + math.atan2(OFFSET, LENGTH) - math.atan2(SHEAVE[1], SHEAVE[0])
    between = math.sqrt(radius ** 2 + far ** 2 - 2 * radius * far * math.cos(angle))
    first = radius * far * math.sin(angle) / between
    second = (radius * far * math.cos(angle) - first ** 2) / between
    return np.array([between, first, second]) / FALLS


def rates(swings, moment):
    """Of angle, angular velocity, and load as a point in the plane, on a rope whose length at the head is a constraint."""
    def of(t, y):
        phi, omega = y[:2]
        inertia = J_B + G_B * R_B ** 2
        force = moment - VISCOUS * omega - COULOMB - G_B * G * R_B * math.cos(phi + CHI)
        a, da, dda = head(phi)
        _, led, bent = below(phi)
        if not swings:
            v, w = da + np.array([0.0, led]), dda + np.array([0.0, bent])
            force -= Q * G * v[1] + Q * float(v @ w) * omega ** 2
            return [omega, force / (inertia + Q * float(v @ v))]
        return single_boom.pulled(y, (a, da, dda), (inertia, force), Q, (led, bent))
    return of


@pytest.mark.parametrize("standard", ENDS)
def test_what_moves_is_described(fmus, standard):
    level, paths = fmus
    assert not validate_fmu(paths[standard])
    variables = {variable.name: variable for variable in read_model_description(paths[standard]).modelVariables}
    states = {"phi", "omega"} | ({"phi_R", "omega_R", "l_R"} if level == "swing" else set())
    assert states <= set(variables) and {"M_A", "M_S", "der(phi)", "der(omega)", "M_R", "T_dyn"} <= set(variables)
    assert "As at rest" in variables["T"].description and "As at rest" not in variables["T_dyn"].description
    assert all("with the inertia" in variables[name].description for name in ["F_O1.x", "F_O1.y", "N_b", "S_h"])


def test_a_run_is_that_of_equations_solved_elsewhere(fmus):
    level, paths = fmus
    swings = level == "swing"
    output = ["phi", "omega", "A.x", "T_dyn", "h_T"] + (["phi_R", "l_R", "v_Q"] if swings else [])
    runs = single_boom.runs(paths, 4.0, output)
    first = runs["FMI 3", "CoSimulation"]
    start, lean = [START, 0.0], math.radians(4.0)
    if swings:
        start += [*(head(START)[0] + ROPE * np.array([math.sin(lean), -math.cos(lean)])), 0.0, 0.0]
    found = single_boom.solved(rates(swings, MOMENT), start, first["time"])
    assert 0.1 < first["phi"][-1] - first["phi"][0] < 0.9
    heads = np.array([head(phi)[0] for phi in found[0]])
    for key, bound in single_boom.agrees(runs, found, heads).items():
        run = runs[key]
        # Behind the first row the boom rises.
        assert np.allclose(run["T_dyn"][1:] * run["h_T"][1:], MOMENT, rtol=1e-12)
        if swings:
            long = np.hypot(found[2] - heads[:, 0], found[3] - heads[:, 1])
            assert np.max(np.abs(run["l_R"] - long)) < 10 * bound * ROPE, key
            assert np.ptp(long) > 1.0
            speed = np.array([-below(phi)[1] * omega for phi, omega in zip(found[0], found[1])])
            assert np.max(np.abs(run["v_Q"] - speed)) < 10 * bound * ROPE, key


def test_forces_are_those_of_the_motion(fmus):
    """The whole crane by Newton, with the accelerations of the equations above: tackle, hoist rope, weights and foot give it
    the change of its momentum."""
    level, paths = fmus
    swings = level == "swing"
    names = ["phi", "omega", "F_O1.x", "F_O1.y", "N_b", "S_h", "M_Rc", "M_Rv", "M_Rs", "T_dyn"]
    runs = single_boom.runs(paths, 4.0, names + (single_boom.ROPE + ["F_A.x", "F_A.y"] if swings else []))
    for key, run in runs.items():
        for row in run[1:]:
            phi, omega = row["phi"], row["omega"]
            places = head(phi)
            led = below(phi)
            y = single_boom.states(row, places, [row["l_R"], led[1]] if swings else None)
            rated = rates(swings, MOMENT)(0.0, y)
            centre, travel, bend = turned(R_B, phi + CHI)
            up = np.array([0.0, G])
            boom = G_B * (travel * rated[1] + bend * omega ** 2 + up)
            down = np.array([0.0, 1.0])
            load = np.array(rated[4:6]) if swings else ((places[1] + down * led[1]) * rated[1]
                                                        + (places[2] + down * led[2]) * omega ** 2)
            on_load = Q * (load + up)
            tension = math.hypot(*on_load) if swings else on_load[1]
            to_sheave = SHEAVE - places[0]
            point = turned(30.0, phi + math.radians(1.5))[0]
            to_frame = np.array([-4.5, 13.0]) - point
            arm = (point[0] * to_frame[1] - point[1] * to_frame[0]) / math.hypot(*to_frame)
            frame = tension / FALLS * to_sheave / math.hypot(*to_sheave) + MOMENT / arm * to_frame / math.hypot(*to_frame)
            foot = boom + on_load - frame
            size = math.hypot(*foot) + math.hypot(*frame)
            assert np.allclose([row["F_O1.x"], row["F_O1.y"]], foot, rtol=0, atol=1e-9 * size), (key, row["time"])
            along = foot @ [math.cos(phi), math.sin(phi)]
            assert abs(row["N_b"] + along) < 1e-9 * size and abs(row["S_h"] - tension / FALLS) < 1e-9 * size
            assert [row["M_Rc"], row["M_Rs"]] == [-COULOMB, 0.0] and math.isclose(row["M_Rv"], -VISCOUS * omega)
            if swings:
                assert np.allclose([row["F_A.x"], row["F_A.y"]], -on_load, rtol=0, atol=1e-9 * size)
    # The inertia that forces of rest leave out counts.
    first = runs["FMI 3", "CoSimulation"][1:]
    assert np.max(np.abs(first["S_h"] - Q * G / FALLS)) > 0.01 * Q * G


# Raised fast, stopped by a brake that stands while the boom goes on, the load lifted all the while.
STOP, BRAKE, LIFT = 2.0, 5e6, -0.4


def emergency(path, kind, h):
    times = [0.0, 0.5, 0.5, STOP, STOP, 6.0]
    commands = [(5e6, 0.0, 0.0)] * 2 + [(5e6, 0.0, LIFT)] * 2 + [(0.0, BRAKE, LIFT)] * 2
    rows = [(time, *row) for time, row in zip(times, commands)]
    signals = np.array(rows, dtype=[(name, float) for name in ("time", "M_A", "M_S", "v_h")])
    swings = ["phi_R", "omega_R", "s_Q", "v_Q", "v_R", "S_R"]
    return simulate_fmu(path, fmi_type=kind, stop_time=6.0, output_interval=h, input=signals, relative_tolerance=1e-10,
                        output=["phi", "omega", "M_R", "T_dyn", "W_blow", *swings])


def test_a_tackle_goes_slack_and_its_brake_catches_the_boom(tmp_path):
    """The energy of boom and load, of what motor, brake, friction, hoist and blows give and take, to 1e-6 of what goes through."""
    path = packed("swing", tmp_path, 'a_h = "0.5 m/s2"\n')["FMI 3"]
    run = emergency(path, "ModelExchange", 1e-3)
    time, phi, omega = run["time"], run["phi"], run["omega"]
    motor = np.where(time < STOP, 5e6, 0.0)
    for i in np.flatnonzero(np.diff(time) == 0.0):
        motor[i] = motor[i - 1]
    slack = (run["T_dyn"] == 0.0) & (time >= STOP)
    assert slack.any() and omega[slack][0] > 0.05
    caught = np.flatnonzero(slack)[-1] + 1
    assert omega[caught] < 0.0 and run["T_dyn"].min() == 0.0
    begun = phi[np.flatnonzero(slack)[0]]
    assert abs(phi[caught] - begun) < 1e-5 and phi.max() > begun + 0.01
    places = np.array([head(p)[:2] for p in phi])
    out = np.array([np.sin(run["phi_R"]), -np.cos(run["phi_R"])]).T
    across = np.array([np.cos(run["phi_R"]), np.sin(run["phi_R"])]).T
    distance = run["s_Q"]
    velocity = places[:, 1] * omega[:, None] + out * run["v_Q"][:, None] + across * (distance * run["omega_R"])[:, None]
    height = places[:, 0, 1] + out[:, 1] * distance
    energy = (0.5 * (J_B + G_B * R_B ** 2) * omega ** 2 + G_B * G * R_B * np.sin(phi + CHI)
              + 0.5 * Q * np.sum(velocity ** 2, axis=1) + Q * G * height)
    power = (motor + run["M_R"]) * omega - run["S_R"] * run["v_R"]
    work = np.concatenate([[0.0], np.cumsum(np.diff(time) * (power[1:] + power[:-1]) / 2)])
    left = energy - energy[0] + run["W_blow"] - work
    through = np.sum(np.abs(np.diff(work)))
    print(np.abs(left).max() / through, through, np.ptp(energy), run["W_blow"][-1])
    assert np.abs(left).max() <= 1e-6 * through


@pytest.mark.parametrize("standard", ENDS)
def test_both_interfaces_see_the_same_events(standard, tmp_path):
    path = packed("swing", tmp_path, 'a_h = "0.5 m/s2"\n')[standard]
    inside, outside = (emergency(path, kind, 0.02) for kind in ("CoSimulation", "ModelExchange"))
    for name, bound in [("phi", 2e-6), ("omega", 2e-5), ("T_dyn", 20.0)]:
        other = {round(float(time), 6): value for time, value in zip(outside["time"], outside[name])}
        apart = [abs(value - other[round(float(time), 6)]) for time, value in zip(inside["time"], inside[name])
                 if abs(time - STOP) > 1e-3 and abs(time - 0.5) > 1e-3]
        assert max(apart) < bound, (name, max(apart))
