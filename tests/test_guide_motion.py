"""The boom on guide and link in motion: its FMUs in FMPy, both standards and both interfaces, against equations written and
solved here."""

import math

import numpy as np
import pytest
from fmpy import read_model_description
from fmpy.validation import validate_fmu

import single_boom
from conftest import ROOT
from single_boom import ENDS, G

SCENE = (ROOT / "models/scenes/ellipsograph.toml").read_text(encoding="utf-8")
C, A, Q, G_B, R_B, CHI, G_L, R_L = 16.0, 16.0, 10e3, 11e3, 14.0, math.radians(1.5), 4e3, 8.0
J_B, J_L, VISCOUS, COULOMB = 1.1e6, 0.1e6, 2e5, 5e3
G_C, R_C = 46e3, 5.0
ROPE = 15.0
MOMENT = 120e3


@pytest.fixture(scope="module", params=["rigid", "swing"])
def fmus(request, tmp_path_factory):
    folder = tmp_path_factory.mktemp(request.param)
    rope = f'l_R = "{ROPE} m"\nphi_R = "4 deg"\n'
    path = single_boom.scene(SCENE, request.param, folder, {"J_b": J_B, "J_l": J_L}, (VISCOUS, COULOMB, MOMENT), rope)
    return request.param, single_boom.packed(path, "EllipsographCrane", folder)


def head(phi):
    """With two derivatives, on its ellipse."""
    cos, sin = np.array([C + A, 0.0]) * math.cos(phi), np.array([0.0, A - C]) * math.sin(phi)
    dcos, dsin = np.array([C + A, 0.0]) * math.sin(phi), np.array([0.0, A - C]) * math.cos(phi)
    return cos + sin, dsin - dcos, -cos - sin


def rates(swings, moment):
    """Of angle, angular velocity, and load as a point in the plane: places by hand. All masses are points and bars: their velocities are what differentiating places by hand gives."""
    def of(t, y):
        phi, omega = y[:2]
        sin, cos, sin_s, cos_s = math.sin(phi), math.cos(phi), math.sin(phi + CHI), math.cos(phi + CHI)
        # Mass, velocity and its change for one radian: boom, link, counterweight behind the link (and its height's sign).
        points = [(G_B, (-R_B * sin_s, R_B * cos_s - 2 * C * cos), (-R_B * cos_s, -R_B * sin_s + 2 * C * sin)),
                  (G_L, (-R_L * sin, -R_L * cos), (-R_L * cos, R_L * sin)),
                  (G_C, (R_C * sin, R_C * cos), (R_C * cos, -R_C * sin))]
        if not swings:
            points.append((Q, *head(phi)[1:]))
        inertia = J_B + J_L + sum(m * (v[0] ** 2 + v[1] ** 2) for m, v, _ in points)
        force = moment - VISCOUS * omega - COULOMB
        for m, v, a in points:
            force -= m * G * v[1] + m * (v[0] * a[0] + v[1] * a[1]) * omega ** 2
        if not swings:
            return [omega, force / inertia]
        return single_boom.pulled(y, head(phi), (inertia, force), Q)
    return of


@pytest.mark.parametrize("standard", ENDS)
def test_what_moves_is_described(fmus, standard):
    level, paths = fmus
    assert not validate_fmu(paths[standard])
    variables = {variable.name: variable for variable in read_model_description(paths[standard]).modelVariables}
    states = {"phi", "omega"} | ({"phi_R", "omega_R"} if level == "swing" else set())
    assert states <= set(variables) and {"M_A", "M_S", "der(phi)", "der(omega)", "M_R"} <= set(variables)
    assert "As at rest" in variables["M_Q"].description and "As at rest" not in variables["M_R"].description
    assert all("In motion" in variables[name].description for name in ["M_D", "F_B.x", "F_C.y", "N_l", "F_O1.x", "F_K.y"])


def test_a_run_is_that_of_equations_solved_elsewhere(fmus):
    level, paths = fmus
    swings = level == "swing"
    runs = single_boom.runs(paths, 10.0, ["phi", "omega", "A.x", "M_R"] + (["phi_R"] if swings else []))
    first = runs["FMI 3", "CoSimulation"]
    phi = math.radians(25.0)
    start, lean = [phi, 0.0], math.radians(4.0)
    if swings:
        start += [*(head(phi)[0] + ROPE * np.array([math.sin(lean), -math.cos(lean)])), 0.0, 0.0]
    found = single_boom.solved(rates(swings, MOMENT), start, first["time"])
    assert first["phi"][-1] - first["phi"][0] > 0.1
    single_boom.agrees(runs, found, np.array([head(phi)[0] for phi in found[0]]))


def cross(a, b):
    return a[0] * b[1] - a[1] * b[0]


def test_forces_are_those_of_the_motion(fmus):
    """By Newton and Euler of the whole, about O1, with the accelerations of the equations above; the boom alone gives the link."""
    level, paths = fmus
    swings = level == "swing"
    names = ["phi", "omega", "M_D", "P_D", "F_B.x", "F_C.x", "F_C.y", "N_l", "F_O1.x", "F_O1.y", "F_K.x", "F_K.y"]
    runs = single_boom.runs(paths, 10.0, names + (single_boom.ROPE[:2] if swings else []))
    up = np.array([0.0, G])
    for key, run in runs.items():
        for row in run[1:]:
            phi, omega = row["phi"], row["omega"]
            y = single_boom.states(row, head(phi), [ROPE, 0.0] if swings else None)
            rated = rates(swings, MOMENT)(0.0, y)
            turning = rated[1]
            sin, cos, sin_s, cos_s = math.sin(phi), math.cos(phi), math.sin(phi + CHI), math.cos(phi + CHI)
            # Mass, place, travel and its change for one radian: boom, link, counterweight.
            parts = [(G_B, (R_B * cos_s, R_B * sin_s - 2 * C * sin), (-R_B * sin_s, R_B * cos_s - 2 * C * cos)),
                     (G_L, (R_L * cos, -R_L * sin), (-R_L * sin, -R_L * cos)),
                     (G_C, (-R_C * cos, R_C * sin), (R_C * sin, R_C * cos))]
            pushes = [(place, mass * (np.array(travel) * turning - np.array(place) * omega ** 2 + up))
                      for mass, place, travel in parts]
            if swings:
                pushes.append((y[2:4], Q * (np.array(rated[4:6]) + up)))
            else:
                at, travel, bend = head(phi)
                pushes.append((at, Q * (travel * turning + bend * omega ** 2 + up)))
            # Drive and friction turn the link the other way than the boom's angle.
            moment = sum(cross(place, push) for place, push in pushes) + (J_B - J_L) * turning
            foot = -2 * C * sin
            guide = (moment + MOMENT - VISCOUS * omega - COULOMB) / -foot
            whole = sum(push for _, push in pushes)
            size = math.hypot(*whole) + abs(guide)
            on_boom = pushes[0][1] + pushes[3][1] - [guide, 0.0]
            expected = {"F_B.x": guide, "F_O1.x": whole[0] - guide, "F_O1.y": whole[1], "F_C.x": on_boom[0],
                        "F_C.y": on_boom[1], "N_l": -(on_boom @ [cos, -sin]), "F_K.x": -pushes[2][1][0],
                        "F_K.y": -pushes[2][1][1]}
            for name, value in expected.items():
                assert abs(row[name] - value) < 1e-9 * size, (key, row["time"], name, row[name], value)
            assert row["M_D"] == MOMENT and math.isclose(row["P_D"], MOMENT * omega, rel_tol=1e-12)
