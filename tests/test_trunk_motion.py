"""The boom with a curved trunk in motion: its FMUs in FMPy, both standards and both interfaces, against energies of a pose that
is found and solved here: the closure by bisection over the point of contact, everything else by differentiating places."""

import math
import subprocess
import sys

import numpy as np
import pytest
from fmpy import read_model_description, simulate_fmu
from fmpy.validation import validate_fmu
from numpy.polynomial import Chebyshev

import single_boom
from conftest import ROOT
from single_boom import ENDS, G

SCENE = (ROOT / "models/scenes/curved_trunk.toml").read_text(encoding="utf-8")
B, A, L_T, O3, Q = 21.5, 14.2, 21.05, np.array([-6.0, 12.0]), 10e3
Z, RHO, ZETA = np.array([-1.15, 0.05]), 5.0, np.radians([132.0, 232.0])
G_B, R_B, CHI_B, G_T, R_T, CHI_T = 13e3, 9.5, math.radians(1.0), 6e3, 1.8, math.radians(3.0)
G_C, R_C = 40e3, 5.8
J_B, J_T, VISCOUS, COULOMB = 0.5e6, 0.18e6, 2e5, 5e3
ROPE, MOMENT, START = 15.0, 250e3, math.radians(42.0)
RANGE = np.radians([40.0, 82.0])


def contact(phi):
    """Direction from Z to where the tie leaves the tail, in the trunk's frame: its end, unrolled, is as far from B as O3 is."""
    distance = np.hypot(*(O3 - B * np.array([math.cos(phi), math.sin(phi)])))

    def apart(zeta):
        along = np.array([-math.sin(zeta), math.cos(zeta)])
        end = Z + RHO * np.array([math.cos(zeta), math.sin(zeta)]) + along * (L_T - RHO * (zeta - ZETA[0]))
        return np.hypot(*end) - distance, end
    low, high = ZETA
    first = apart(low)[0]
    for _ in range(60):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if apart(middle)[0] * first > 0 else (low, middle)
    return low, apart(low)[1]


def trunk(phi):
    """Its line's angle."""
    way = O3 - B * np.array([math.cos(phi), math.sin(phi)])
    _, end = contact(phi)
    return math.remainder(math.atan2(way[1], way[0]) - math.atan2(end[1], end[0]), math.tau)


def tie(phi):
    """Its direction towards O3, and its arm about B."""
    zeta, _ = contact(phi)
    turned = zeta + trunk(phi)
    along = np.array([-math.sin(turned), math.cos(turned)])
    alpha = trunk(phi)
    at = np.array([[math.cos(alpha), -math.sin(alpha)], [math.sin(alpha), math.cos(alpha)]]) @ (
        Z + RHO * np.array([math.cos(zeta), math.sin(zeta)]))
    return along, cross(at, along)


def cross(a, b):
    return a[0] * b[1] - a[1] * b[0]


# The angle of the trunk over that of the boom, to be differentiated.
ALPHA = Chebyshev.interpolate(np.vectorize(trunk), 48, domain=RANGE)


def fitted(of):
    return Chebyshev.interpolate(np.vectorize(of), 48, domain=RANGE)


def polar(length, angle):
    return length * np.array([math.cos(angle), math.sin(angle)])


def point(long, angle):
    """A point of the trunk, at a distance and an angle from its line: with two derivatives."""
    places = [fitted(lambda phi, i=i: (polar(B, phi) + polar(long, trunk(phi) + angle))[i]) for i in (0, 1)]
    ways = [[place.deriv(order) if order else place for place in places] for order in (0, 1, 2)]
    return lambda phi: [np.array([part(phi) for part in way]) for way in ways]


HEAD, CENTRE = point(A, 0.0), point(R_T, CHI_T)
TURN, CHANGE = ALPHA.deriv(), ALPHA.deriv(2)


def energies(load):
    """Twice the kinetic energy over ω², and the potential energy, with a load fixed to the head."""
    parts = [(G_T, CENTRE), (load, HEAD)]

    def inertia(phi):
        still = J_B + G_B * R_B ** 2 + G_C * R_C ** 2 + J_T * TURN(phi) ** 2
        return still + sum(mass * at(phi)[1] @ at(phi)[1] for mass, at in parts)

    def height(phi):
        still = G_B * R_B * math.sin(phi + CHI_B) - G_C * R_C * math.sin(phi)
        return G * (still + sum(mass * at(phi)[0][1] for mass, at in parts))
    return fitted(inertia), fitted(height)


ENERGIES = {load: energies(load) for load in (0.0, Q)}


def rates(swings, moment):
    """Of angle, angular velocity, and load as a point in the plane: from the energies, by Lagrange."""
    return single_boom.rates(ENERGIES[0.0 if swings else Q], HEAD, (moment, VISCOUS, COULOMB), Q, swings)


@pytest.fixture(scope="module", params=["rigid", "swing"])
def fmus(request, tmp_path_factory):
    folder = tmp_path_factory.mktemp(request.param)
    rope = f'l_R = "{ROPE} m"\nphi_R = "4 deg"\n'
    path = single_boom.scene(SCENE, request.param, folder, {"J_b": J_B, "J_t": J_T}, (VISCOUS, COULOMB, MOMENT), rope)
    return request.param, single_boom.packed(path, "CurvedTrunkCrane", folder)


@pytest.mark.parametrize("standard", ENDS)
def test_what_moves_is_described(fmus, standard):
    level, paths = fmus
    assert not validate_fmu(paths[standard])
    variables = {variable.name: variable for variable in read_model_description(paths[standard]).modelVariables}
    states = {"phi", "omega"} | ({"phi_R", "omega_R"} if level == "swing" else set())
    assert states <= set(variables) and {"M_A", "M_S", "der(phi)", "der(omega)", "M_R", "z.tie"} <= set(variables)
    assert "As at rest" in variables["M_Q"].description and "As at rest" not in variables["M_R"].description
    assert all("In motion" in variables[name].description for name in ["M_D", "N_t", "q_t", "p_t", "F_B.x", "F_O1.y", "F_K.x"])


def begun(swings):
    if not swings:
        return [START, 0.0]
    return [START, 0.0, *(HEAD(START)[0] + polar(ROPE, math.radians(4.0) - math.pi / 2)), 0.0, 0.0]


def test_a_run_is_that_of_equations_solved_elsewhere(fmus):
    level, paths = fmus
    swings = level == "swing"
    runs = single_boom.runs(paths, 6.0, ["phi", "omega", "A.x", "A.y", "M_R"] + (["phi_R"] if swings else []))
    first = runs["FMI 3", "CoSimulation"]
    found = single_boom.solved(rates(swings, MOMENT), begun(swings), first["time"], steps=100)
    assert first["phi"][-1] - first["phi"][0] > 0.1
    heads = np.array([HEAD(phi)[0] for phi in found[0]])
    single_boom.agrees(runs, found, heads)
    assert np.max(np.abs(first["A.x"] - heads[:, 0])) < 1e-5 and np.max(np.abs(first["A.y"] - heads[:, 1])) < 1e-5


def test_forces_are_those_of_the_motion(fmus):
    """By Newton and Euler: the trunk about B gives the tie, its forces the boom's on it, the boom's equilibrium the frame."""
    level, paths = fmus
    swings = level == "swing"
    names = ["phi", "omega", "M_D", "P_D", "N_t", "q_t", "p_t", "F_B.x", "F_B.y", "F_O1.x", "F_O1.y", "F_K.x", "F_K.y", "z.tie"]
    runs = single_boom.runs(paths, 6.0, names + (single_boom.ROPE[:2] if swings else []))
    up = np.array([0.0, G])
    for key, run in runs.items():
        for row in run[1:]:
            phi, omega = row["phi"], row["omega"]
            y = single_boom.states(row, HEAD(phi), [ROPE, 0.0] if swings else None)
            rated = rates(swings, MOMENT)(0.0, y)
            turning = rated[1]

            def pushed(mass, place):
                _, travel, bend = place
                return mass * (travel * turning + bend * omega ** 2 + up)

            def about_foot(length, angle):
                place = polar(length, angle)
                return [place, np.array([-place[1], place[0]]), -place]
            joint, front = polar(B, phi), polar(A, trunk(phi))
            own = pushed(G_T, CENTRE(phi))
            load = Q * (np.array(rated[4:6]) + up) if swings else pushed(Q, HEAD(phi))
            boom, weight = pushed(G_B, about_foot(R_B, phi + CHI_B)), pushed(G_C, about_foot(R_C, phi + math.pi))
            spin = J_T * (TURN(phi) * turning + CHANGE(phi) * omega ** 2)
            moment = cross(CENTRE(phi)[0] - joint, own) + cross(front, load) + spin
            along, arm = tie(phi)
            pull = moment / arm
            on_trunk = own + load - along * pull
            whole = on_trunk + boom + weight
            size = abs(pull) + math.hypot(*whole)
            expected = {"N_t": pull, "z.tie": pull, "F_B.x": on_trunk[0], "F_B.y": on_trunk[1], "F_O1.x": whole[0],
                        "F_O1.y": whole[1], "F_K.x": -weight[0], "F_K.y": -weight[1]}
            for name, value in expected.items():
                assert abs(row[name] - value) < 1e-9 * size, (key, row["time"], name, row[name], value)
            assert abs(row["q_t"] - pull / RHO) < 1e-9 * size and abs(row["p_t"] - pull / RHO / 0.06) < 2e-8 * size
            assert row["M_D"] == MOMENT and math.isclose(row["P_D"], MOMENT * omega, rel_tol=1e-12)


def test_work_is_energy(fmus):
    """What the drive gives and friction takes is what boom, trunk, counterweight and load have more, by their energies."""
    level, paths = fmus
    swings = level == "swing"
    names = ["phi", "omega", "P_D"] + (single_boom.ROPE[:2] if swings else [])
    run = simulate_fmu(paths["FMI 3"], fmi_type="CoSimulation", stop_time=6.0, output_interval=0.01, output=names)
    inertia, height = ENERGIES[0.0 if swings else Q]

    def energy(row):
        own = 0.5 * inertia(row["phi"]) * row["omega"] ** 2 + height(row["phi"])
        if not swings:
            return own
        *_, y, v_x, v_y = single_boom.states(row, HEAD(row["phi"]), [ROPE, 0.0])
        return own + Q * (0.5 * (v_x ** 2 + v_y ** 2) + G * y)
    power = run["P_D"] - (VISCOUS * run["omega"] + COULOMB) * run["omega"]
    work = np.sum((power[:-2:2] + 4 * power[1:-1:2] + power[2::2]) * 0.01 / 3)
    gained = energy(run[-1]) - energy(run[0])
    assert abs(work) > 1e4 and abs(gained - work) < 1e-8 * np.sum(np.abs(power)) * 0.01


@pytest.mark.parametrize("kind", ["CoSimulation", "ModelExchange"])
@pytest.mark.parametrize("standard", ENDS)
def test_a_tie_that_would_have_to_push_ends_the_run(fmus, standard, kind):
    """By the drive that jerks the boom, with a message. In a process of its own: FMPy keeps the pointer to a logger that it was
    given for FMUs that come later in the same process, when the logger is gone."""
    _, paths = fmus
    run = (
        "import sys\nfrom fmpy import simulate_fmu\n"
        "simulate_fmu(sys.argv[1], fmi_type=sys.argv[2], stop_time=2.0, start_values={'M_A': float(sys.argv[3])},\n"
        "             logger=lambda *line: print(line[-1]), debug_logging=True)"
    )
    done = subprocess.run([sys.executable, "-c", run, paths[standard], kind, str(SLACKENS)], capture_output=True, text=True)
    assert done.returncode != 0 and "FMICallException" in done.stderr, done.stderr
    assert "the tie is slack" in done.stdout, done.stdout


# A moment that raises the boom faster than the trunk falls.
SLACKENS = 1e8
