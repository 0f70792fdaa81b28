"""The rope of a drive in motion: FMUs of the boom with a curved trunk, hung on a tackle whose drum a motor's shaft turns, in
FMPy, both standards and both interfaces, against the energies of `test_trunk_motion.py` and the rope's length by its anchors."""

import math
import subprocess
import sys

import numpy as np
import pytest
from fmpy import read_model_description, simulate_fmu
from fmpy.validation import validate_fmu

import single_boom
from single_boom import ENDS, G
from test_trunk_motion import (COULOMB, ENERGIES, G_C, HEAD, J_B, J_T, Q, R_C, ROPE, SCENE, START, VISCOUS, fitted)

# The tackle: anchors, falls, drum, efficiency; of the motor's shaft inertia and the tackle's travel for one turn.
E, S_D, M_R, ETA = np.array([-3.7, 8.2]), 5.5, 6.0, 0.9
J_M, L_M = 0.7, 0.012
DRIVE = f"""[luffing.drive]
kind = "rope"
E_x = "{E[0]} m"
E_y = "{E[1]} m"
s_d = "{S_D} m"
chi_d = "0 deg"
m_r = "{M_R}"
r_tr = "350 mm"
eta_d = "{ETA}"

"""
MOTOR = f"""
[cases]
[[cases.case]]
name = "I"
k_Q = "1"
alpha_s = "0 deg"
v_s = "-50 mm/s"
[cases.motor]
P_N = "450 kW"
n_N = "970 1/min"
lambda_M = "2.5"
k_a = "1.7"
J_M = "{J_M} kg.m2"
l_M = "{L_M * 1e3} mm"
eta_M = "0.85"
heating = "I"
""" + "".join(f'[[cases.body]]\non = "{name}"\nJ_s = "0 kg.m2"\n' for name in ("boom", "trunk"))
# Raises the boom, which has no balance.
MOMENT = 1.9e6


def long(phi):
    return math.sqrt(S_D ** 2 + E @ E - 2 * S_D * (E[0] * math.cos(phi) + E[1] * math.sin(phi)))


LONG = fitted(long)
TRAVEL, BEND = LONG.deriv(), LONG.deriv(2)


def turning(phi):
    """The shaft's turn for one radian of the boom, and its change."""
    return np.array([TRAVEL(phi), BEND(phi)]) * 2 * math.pi / L_M


def hung(load):
    """Inertia of the bodies alone and with the shaft, and height of their weights in J: without the counterweight."""
    inertia, height = ENERGIES[load]
    bodies = fitted(lambda phi: inertia(phi) - G_C * R_C ** 2)
    whole = fitted(lambda phi: bodies(phi) + J_M * turning(phi)[0] ** 2)
    return bodies, whole, fitted(lambda phi: height(phi) + G * G_C * R_C * math.sin(phi))


HUNG = {load: hung(load) for load in (0.0, Q)}


def rates(swings):
    """As in `test_trunk_motion.py`, with the shaft."""
    return single_boom.rates(HUNG[0.0 if swings else Q][1:], HEAD, (MOMENT, VISCOUS, COULOMB), Q, swings)


def text(motor=MOTOR):
    cut = SCENE.index("[luffing.balance]")
    # The experiment ends before the boom comes to its stop.
    return SCENE[:cut].replace('"0.8 deg/s"', '"5 deg/s"') + DRIVE + "[luffing.limits]\n" + motor


@pytest.fixture(scope="module", params=["rigid", "swing"])
def shaftless(request, tmp_path_factory):
    folder = tmp_path_factory.mktemp(request.param)
    path = single_boom.scene(text(""), request.param, folder, {"J_b": J_B, "J_t": J_T}, (VISCOUS, COULOMB, MOMENT),
                             f'l_R = "{ROPE} m"\n')
    return single_boom.packed(path, "CurvedTrunkCrane", folder)


@pytest.fixture(scope="module", params=["rigid", "swing"])
def fmus(request, tmp_path_factory):
    folder = tmp_path_factory.mktemp(request.param)
    rope = f'l_R = "{ROPE} m"\nphi_R = "4 deg"\n'
    path = single_boom.scene(text(), request.param, folder, {"J_b": J_B, "J_t": J_T}, (VISCOUS, COULOMB, MOMENT), rope)
    return request.param, single_boom.packed(path, "CurvedTrunkCrane", folder)


@pytest.mark.parametrize("standard", ENDS)
def test_what_pulls_is_described(fmus, standard):
    _, paths = fmus
    assert not validate_fmu(paths[standard])
    variables = {variable.name: variable for variable in read_model_description(paths[standard]).modelVariables}
    assert {"S_l", "S_lm", "S_lm.out", "S_lm.in", "z.tackle", "T_d"} <= set(variables)
    assert all("As at rest" in variables[name].description for name in ["S_l", "T_d.in"])
    assert all("In motion" in variables[name].description for name in ["F_d", "S_lm", "S_lm.out", "S_lm.in"])


def begun(swings):
    if not swings:
        return [START, 0.0]
    return [START, 0.0, *(HEAD(START)[0] + hanging()), 0.0, 0.0]


def hanging():
    angle = math.radians(4.0) - math.pi / 2
    return ROPE * np.array([math.cos(angle), math.sin(angle)])


def test_a_run_is_that_of_equations_solved_elsewhere(fmus):
    """And its pull is that of what accelerates the bodies: M_D less the shaft's part, over the arm and the falls."""
    level, paths = fmus
    swings = level == "swing"
    names = ["phi", "omega", "A.x", "M_D", "F_d", "v_d", "S_lm", "S_lm.out", "S_lm.in"]
    runs = single_boom.runs(paths, 6.0, names + (single_boom.ROPE[:2] if swings else []))
    first = runs["FMI 3", "CoSimulation"]
    found = single_boom.solved(rates(swings), begun(swings), first["time"], steps=100)
    assert first["phi"][-1] - first["phi"][0] > 0.1
    heads = np.array([HEAD(phi)[0] for phi in found[0]])
    single_boom.agrees(runs, found, heads)
    for key, run in runs.items():
        for row in run[1:]:
            phi, omega = row["phi"], row["omega"]
            y = single_boom.states(row, HEAD(phi), [ROPE, 0.0] if swings else None)
            turns = rates(swings)(0.0, y)[1]
            turn, change = turning(phi)
            lags = J_M * turn * (turn * turns + change * omega ** 2)
            left = MOMENT - lags
            size = abs(MOMENT) + abs(lags)
            pull = -left / TRAVEL(phi) / M_R
            assert pull > 0.0 and abs(row["M_D"] - left) < 1e-9 * size, (key, row["time"], row["M_D"], left)
            for name, value in {"S_lm": pull, "S_lm.out": pull * ETA, "S_lm.in": pull / ETA}.items():
                assert abs(row[name] - value) < 1e-9 * size, (key, row["time"], name, row[name], value)
            assert abs(row["F_d"] * row["v_d"] - left * omega) < 1e-12 * size * abs(omega)


def test_work_is_energy(fmus):
    """What the rope gives and friction takes is what boom, trunk and load have more, without the shaft."""
    level, paths = fmus
    swings = level == "swing"
    names = ["phi", "omega", "F_d", "v_d"] + (single_boom.ROPE[:2] if swings else [])
    run = simulate_fmu(paths["FMI 3"], fmi_type="CoSimulation", stop_time=6.0, output_interval=0.01, output=names)
    inertia, _, height = HUNG[0.0 if swings else Q]

    def energy(row):
        own = 0.5 * inertia(row["phi"]) * row["omega"] ** 2 + height(row["phi"])
        if not swings:
            return own
        *_, y, v_x, v_y = single_boom.states(row, HEAD(row["phi"]), [ROPE, 0.0])
        return own + Q * (0.5 * (v_x ** 2 + v_y ** 2) + G * y)
    power = run["F_d"] * run["v_d"] - (VISCOUS * run["omega"] + COULOMB) * run["omega"]
    work = np.sum((power[:-2:2] + 4 * power[1:-1:2] + power[2::2]) * 0.01 / 3)
    gained = energy(run[-1]) - energy(run[0])
    assert abs(work) > 1e4 and abs(gained - work) < 1e-8 * np.sum(np.abs(power)) * 0.01


@pytest.mark.parametrize("kind", ["CoSimulation", "ModelExchange"])
@pytest.mark.parametrize("standard", ENDS)
def test_a_rope_on_no_motor_s_shaft_ends_the_run_where_it_would_have_to_push(shaftless, standard, kind):
    """By a drive that lowers the boom faster than it falls, with a message; in a process of its own, as there."""
    paths = shaftless
    run = (
        "import sys\nfrom fmpy import simulate_fmu\n"
        "simulate_fmu(sys.argv[1], fmi_type=sys.argv[2], stop_time=2.0, start_values={'M_A': -1e7},\n"
        "             logger=lambda *line: print(line[-1]), debug_logging=True)"
    )
    done = subprocess.run([sys.executable, "-c", run, paths[standard], kind], capture_output=True, text=True)
    assert done.returncode != 0 and "FMICallException" in done.stderr, done.stderr
    assert "the luffing rope is slack, it would have to push with" in done.stdout, done.stdout
    assert "[cases.motor]" in done.stdout
