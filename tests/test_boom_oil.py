"""Booms on guide and link and with a curved trunk that a cylinder with oil luffs, through FMPy in both standards and both
interfaces: against energies of the mechanism found elsewhere, with the oil of the independent cylinder, by SciPy's Radau."""

import math
import sys

import numpy as np
import pytest
from fmpy import read_model_description, simulate_fmu
from fmpy.validation import validate_fmu
from numpy.polynomial import Chebyshev
from scipy.integrate import solve_ivp

import single_boom
import test_guide_motion as guide
import test_trunk_motion as trunk
from conftest import ROOT
from single_boom import G

sys.path.insert(0, str(ROOT / "tests/oracles"))
import hydraulic_cylinder as crane  # noqa: E402

OIL = (ROOT / "tests/levels/hydraulics.toml").read_text(encoding="utf-8")
ROPE, Q, VISCOUS = 15.0, 10e3, crane.VISCOUS
D_C, D_R = 0.25, 0.12
AREAS = A_A, A_B = math.pi / 4 * D_C**2, math.pi / 4 * (D_C**2 - D_R**2)
# Away from the end stops, which the reference has not.
START = {"guide": math.radians(30.0), "trunk": math.radians(50.0)}
# Of the valve, each until the next.
COMMANDS = [(0.0, 0.2), (1.0, 0.4), (2.0, 0.1)]
STOP = 3.0


def drawn(anchor, length, angle):
    """Length of a line from the frame to an anchor at a distance and an angle, by the boom's angle, and its derivative."""
    def of(phi):
        turned, sense = angle(phi)
        at = length * np.array([math.cos(turned), math.sin(turned)])
        line, way = at - anchor, sense * np.array([-at[1], at[0]])
        long = math.hypot(*line)
        return long, line @ way / long
    return of


def guided(swings):
    """Twice the kinetic energy over ω², and the potential energy, by places of boom and link; no counterweight."""
    c = guide.C

    def parts(phi):
        boom = np.array([guide.R_B * math.cos(phi + guide.CHI), guide.R_B * math.sin(phi + guide.CHI) - 2 * c * math.sin(phi)])
        by = np.array([-guide.R_B * math.sin(phi + guide.CHI), guide.R_B * math.cos(phi + guide.CHI) - 2 * c * math.cos(phi)])
        link = guide.R_L * np.array([math.cos(phi), -math.sin(phi)])
        turned = guide.R_L * np.array([-math.sin(phi), -math.cos(phi)])
        return [(guide.G_B, boom, by), (guide.G_L, link, turned), (0.0 if swings else Q, *guide.head(phi)[:2])]

    def inertia(phi):
        return guide.J_B + guide.J_L + sum(mass * way @ way for mass, _, way in parts(phi))

    def height(phi):
        return G * sum(mass * at[1] for mass, at, _ in parts(phi))
    fitted = lambda of: Chebyshev.interpolate(np.vectorize(of), 48, domain=np.radians([20.0, 77.0]))
    return fitted(inertia), fitted(height)


def trunked(swings):
    """The same of boom and trunk: without the counterweight that the forms of a run under a moment have."""
    inertia, height = trunk.ENERGIES[0.0 if swings else Q]
    raised = Chebyshev.interpolate(lambda phi: G * trunk.G_C * trunk.R_C * np.sin(phi), 48, domain=trunk.RANGE)
    return inertia - trunk.G_C * trunk.R_C ** 2, height + raised


# Ready scene, name of the FMU, keys of its drive, inertias, what it has over its angle, its head, and its cylinder's line.
BOOMS = {
    "guide": ("ellipsograph", "EllipsographCrane", 'E_x = "5 m"\nE_y = "3 m"\ns_d = "5 m"\nchi_d = "0 deg"\n',
              {"J_b": guide.J_B, "J_l": guide.J_L}, guided, guide.head, drawn(np.array([5.0, 3.0]), 5.0, lambda phi: (-phi, -1.0))),
    "trunk": ("curved_trunk", "CurvedTrunkCrane", 'E_x = "3 m"\nE_y = "-1.5 m"\ns_d = "6 m"\nchi_d = "-5 deg"\n',
              {"J_b": trunk.J_B, "J_t": trunk.J_T}, trunked, trunk.HEAD,
              drawn(np.array([3.0, -1.5]), 6.0, lambda phi: (phi - math.radians(5.0), 1.0))),
}


@pytest.fixture(scope="module", params=[(name, swings) for name in BOOMS for swings in (False, True)],
                ids=lambda param: f"{param[0]} {'swing' if param[1] else 'rigid'}")
def case(request, tmp_path_factory):
    name, swings = request.param
    ready, model, drive, inertias, *_ = BOOMS[name]
    folder = tmp_path_factory.mktemp(name)
    text = (ROOT / f"models/scenes/{ready}.toml").read_text(encoding="utf-8")
    text = without(without(text, "[luffing.balance]"), "[luffing.drive]").replace("[luffing]\n", '[luffing]\nfidelity = "hydraulic"\n', 1)
    bodies = "".join(f'{key} = "{value} kg.m2"\n' for key, value in inertias.items())
    rope = f'l_R = "{ROPE} m"\nphi_R = "4 deg"\n' if swings else ""
    oil = OIL
    for key, value in {"l_min": f"{crane.SHORT} m", "l_max": f"{crane.LONG} m", "tol": "1e-9", "u_v": "0"}.items():
        oil = "".join(f'{key} = "{value}"\n' if line.split("=")[0].strip() == key else line for line in oil.splitlines(keepends=True))
    text = text.split("[luffing.limits]")[0]
    text += (f'\n[luffing.drive]\nkind = "cylinder"\n{drive}D_c = "{D_C} m"\nd_r = "{D_R} m"\n'
             f'[luffing.dynamics]\n{bodies}c_v = "{VISCOUS / 1e3} kN.m.s"\n{rope}\n{oil}')
    path = folder / "scene.toml"
    path.write_text(text, encoding="utf-8")
    return name, swings, single_boom.packed(path, model, folder)


def without(text, table):
    head, found, tail = text.partition(f"\n{table}")
    return head + tail[tail.index("\n["):] if found else text


def test_it_is_valid(case):
    _, swings, paths = case
    for path in paths.values():
        assert not validate_fmu(path)
        names = {variable.name for variable in read_model_description(path).modelVariables}
        assert {"p_A", "p_B", "F_c", "u_v", "p_P"} <= names and ("phi_R" in names) == swings and "M_A" not in names


def rates(boom, swings):
    *_, forms, head, line = BOOMS[boom]
    inertia, height = forms(swings)
    slope, weight = inertia.deriv(), height.deriv()

    def of(_, y, command):
        phi, omega = y[:2]
        long, arm = line(phi)
        driven = (inertia(phi), slope(phi), weight(phi), long, arm)
        oil = crane.rates(y[:8], command, driven, AREAS)
        if not swings:
            return oil
        force = (A_A * y[4] - A_B * y[5]) * arm - VISCOUS * omega - weight(phi) - slope(phi) * omega ** 2 / 2
        bar = single_boom.pulled([phi, omega, *y[8:]], head(phi), (inertia(phi), force), Q)
        return [*bar[:2], *oil[2:], *bar[2:]]
    return of


STATES = ["phi", "omega", "p_1", "p_2", "p_A", "p_B", "x_v", "v_v"]
SIZES = np.array([1.0, 0.1, *[1e7] * 4, 1.0, 100.0])


def test_a_run_is_that_of_equations_solved_elsewhere(case):
    name, swings, paths = case
    outputs = [*STATES, "F_c", "F_d", "M_D", *(["phi_R", "omega_R", "l_R"] if swings else [])]
    told = np.array([row for (at, command), (end, _) in zip(COMMANDS, [*COMMANDS[1:], (STOP, 0.0)])
                     for row in ((at, command), (end, command))], dtype=[("time", float), ("u_v", float)])
    runs = {(standard, kind): simulate_fmu(path, fmi_type=kind, stop_time=STOP, output_interval=0.01, relative_tolerance=1e-9, input=told,
                                           start_values={"p_P": crane.SUPPLY, "phi": START[name]}, output=outputs, record_events=False)
            for standard, path in paths.items() for kind in ("CoSimulation", "ModelExchange")}
    first = runs["FMI 3", "CoSimulation"]
    law, head, size = rates(name, swings), BOOMS[name][5], SIZES
    y = [float(first[state][0]) for state in STATES]
    if swings:
        row = {key: float(first[key][0]) for key in outputs}
        y += single_boom.states(row, head(row["phi"]), (ROPE, 0.0))[2:]
        size = np.array([*SIZES, 10.0, 10.0, 1.0, 1.0])
    times, found = first["time"], [np.array(y)]
    for (begin, command), (end, _) in zip(COMMANDS, [*COMMANDS[1:], (STOP, 0.0)]):
        within = times[(times > begin + 1e-9) & (times < end + 1e-9)]
        part = solve_ivp(law, (begin, within[-1]), found[-1], method="Radau", t_eval=within, args=(command,), rtol=1e-10,
                         atol=1e-10 * size, max_step=0.02)
        assert part.success
        found += list(part.y.T)
    found = np.array(found).T
    assert np.ptp(first["phi"]) > 0.02 and np.ptp(first["p_A"]) > 5e4
    ranges = dict(zip(STATES, np.ptp(found[:8], axis=1)))
    for (standard, kind), run in runs.items():
        bound = 2e-6 if kind == "CoSimulation" else 2e-4
        for i, state in enumerate(STATES[:6]):
            off = np.max(np.abs(run[state] - found[i]))
            assert off <= bound * ranges[state], (standard, kind, state, off / ranges[state])
        force = A_A * found[4] - A_B * found[5]
        assert np.max(np.abs(run["F_c"] - force)) <= bound * np.max(np.abs(force)), (standard, kind)
        assert np.array_equal(run["F_c"], run["F_d"])
        arm = np.array([BOOMS[name][6](phi)[1] for phi in run["phi"]])
        assert np.allclose(run["M_D"], run["F_c"] * arm, rtol=1e-10)
        if swings:
            at = np.array([math.atan2(x - head(phi)[0][0], head(phi)[0][1] - y) for phi, x, y in zip(found[0], found[8], found[9])])
            assert np.max(np.abs(run["phi_R"] - at)) <= 10 * bound, (standard, kind)
    assert np.array_equal(runs["FMI 3", "CoSimulation"]["phi"], runs["FMI 2", "CoSimulation"]["phi"])
