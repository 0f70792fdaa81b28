"""The boom on guide and link in motion: its FMUs in FMPy, both standards and both interfaces, against equations written and
solved here."""

import math

import numpy as np
import pytest
from fmpy import read_model_description, simulate_fmu
from fmpy.validation import validate_fmu

from conftest import ROOT, lemnis

SCENE = (ROOT / "models/scenes/ellipsograph.toml").read_text(encoding="utf-8")
ENDS = {"FMI 2": ".fmi2.fmu", "FMI 3": ".fmu"}
G = 9.81
C, A, Q, G_B, R_B, CHI, G_L, R_L = 16.0, 16.0, 10e3, 11e3, 14.0, math.radians(1.5), 4e3, 8.0
J_B, J_L, VISCOUS, COULOMB = 1.1e6, 0.1e6, 2e5, 5e3
G_C, R_C = 46e3, 5.0
ROPE = 15.0


def scene(fidelity, folder):
    rope = f'l_R = "{ROPE} m"\nphi_R = "4 deg"\n' if fidelity == "swing" else ""
    dynamics = (f'[luffing.dynamics]\nJ_b = "{J_B} kg.m2"\nJ_l = "{J_L} kg.m2"\nc_v = "{VISCOUS / 1e3} kN.m.s"\n'
                f'M_F = "{COULOMB / 1e3} kN.m"\nM_A = "120 kN.m"\nstep = "2 ms"\n{rope}\n')
    text = SCENE.replace("[luffing.motion]", f'fidelity = "{fidelity}"\n\n[luffing.motion]', 1)
    path = folder / f"{fidelity}.toml"
    path.write_text(text.replace("[luffing.limits]", dynamics + "[luffing.limits]", 1), encoding="utf-8")
    return path


@pytest.fixture(scope="module", params=["rigid", "swing"])
def fmus(request, tmp_path_factory):
    folder = tmp_path_factory.mktemp(request.param)
    lemnis("fmu", scene(request.param, folder), "--output", folder)
    return request.param, {standard: str(folder / f"EllipsographCrane{end}") for standard, end in ENDS.items()}


def rates(swings, moment):
    """Of angle, angular velocity, and load as a point in the plane: places by hand, and the load on a rope that keeps its
    length as a constraint. All masses are points and bars: their velocities are what differentiating places by hand gives."""
    def of(t, y):
        phi, omega = y[:2]
        sin, cos, sin_s, cos_s = math.sin(phi), math.cos(phi), math.sin(phi + CHI), math.cos(phi + CHI)
        # Mass, velocity and its change for one radian: boom, link, counterweight behind the link (and its height's sign).
        points = [(G_B, (-R_B * sin_s, R_B * cos_s - 2 * C * cos), (-R_B * cos_s, -R_B * sin_s + 2 * C * sin)),
                  (G_L, (-R_L * sin, -R_L * cos), (-R_L * cos, R_L * sin)),
                  (G_C, (R_C * sin, R_C * cos), (R_C * cos, -R_C * sin))]
        head = ((C + A) * np.array([-sin, 0.0]) + (A - C) * np.array([0.0, cos]),
                (C + A) * np.array([-cos, 0.0]) + (A - C) * np.array([0.0, -sin]))
        if not swings:
            points.append((Q, *head))
        inertia = J_B + J_L + sum(m * (v[0] ** 2 + v[1] ** 2) for m, v, _ in points)
        force = moment - VISCOUS * omega - COULOMB
        for m, v, a in points:
            force -= m * G * v[1] + m * (v[0] * a[0] + v[1] * a[1]) * omega ** 2
        if not swings:
            return [omega, force / inertia]
        place, speed = np.array(y[2:4]), np.array(y[4:6])
        at = (C + A) * np.array([cos, 0.0]) + (A - C) * np.array([0.0, sin])
        line = place - at
        along, relative = line / ROPE, speed - head[0] * omega
        # d²|line|²/dt² = 0 with the tension T on both.
        weight, arm = np.array([0.0, -G]), float(head[0] @ along)
        free = along @ (weight - head[0] * force / inertia - head[1] * omega ** 2) + relative @ relative / ROPE
        tension = free / (1 / Q + arm * arm / inertia)
        return [omega, (force + arm * tension) / inertia, *speed, *(weight - along * tension / Q)]
    return of


def solved(rates, y, times, steps=250):
    """The classical method of fourth order, in so many steps from one time to the next."""
    states = [np.array(y)]
    for start, end in zip(times, times[1:]):
        y, h = states[-1], (end - start) / steps
        for _ in range(steps):
            a = np.array(rates(start, y))
            b = np.array(rates(start, y + 0.5 * h * a))
            c = np.array(rates(start, y + 0.5 * h * b))
            d = np.array(rates(start, y + h * c))
            y = y + h / 6.0 * (a + 2.0 * (b + c) + d)
        states.append(y)
    return np.array(states).T


@pytest.mark.parametrize("standard", ENDS)
def test_what_moves_is_described(fmus, standard):
    level, paths = fmus
    assert not validate_fmu(paths[standard])
    variables = {variable.name: variable for variable in read_model_description(paths[standard]).modelVariables}
    states = {"phi", "omega"} | ({"phi_R", "omega_R"} if level == "swing" else set())
    assert states <= set(variables) and {"M_A", "M_S", "der(phi)", "der(omega)", "M_R"} <= set(variables)
    assert "As at rest" in variables["M_D"].description and "As at rest" not in variables["M_R"].description


def test_a_run_is_that_of_equations_solved_elsewhere(fmus):
    level, paths = fmus
    swings, runs = level == "swing", {}
    for standard, path in paths.items():
        for kind in ("CoSimulation", "ModelExchange"):
            runs[standard, kind] = simulate_fmu(
                path, fmi_type=kind, stop_time=10.0, output_interval=0.25, relative_tolerance=1e-10, record_events=False,
                output=["phi", "omega", "A.x", "M_R"] + (["phi_R"] if swings else []))
    first = runs["FMI 3", "CoSimulation"]
    phi = math.radians(25.0)
    start, lean = [phi, 0.0], math.radians(4.0)
    if swings:
        start += [(C + A) * math.cos(phi) + ROPE * math.sin(lean), (A - C) * math.sin(phi) - ROPE * math.cos(lean), 0.0, 0.0]
    found = solved(rates(swings, 120e3), start, first["time"])
    assert first["phi"][-1] - first["phi"][0] > 0.1
    for key, run in runs.items():
        bound = 1e-7 if key[1] == "CoSimulation" else 2e-5
        assert np.max(np.abs(run["phi"] - found[0])) < bound, (key, np.max(np.abs(run["phi"] - found[0])))
        assert np.max(np.abs(run["omega"] - found[1])) < bound, key
        if swings:
            at = np.arctan2(found[2] - (C + A) * np.cos(found[0]), (A - C) * np.sin(found[0]) - found[3])
            assert np.max(np.abs(run["phi_R"] - at)) < 10 * bound, (key, np.max(np.abs(run["phi_R"] - at)))
    assert np.array_equal(first["phi"], runs["FMI 2", "CoSimulation"]["phi"])
