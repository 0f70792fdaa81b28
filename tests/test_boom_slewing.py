"""Single booms that luff, slew, hoist and swing at once: their FMUs against points in space, each body as two of them."""

import numpy as np
import pytest
from fmpy import simulate_fmu
from scipy.integrate import solve_ivp

from conftest import ROOT
from single_boom import ENDS, G, packed

ROPE = ROOT / "models/scenes/rope_slewing.toml"
GUIDED = ROOT / "models/scenes/ellipsograph_motion.toml"
TURNS = ('[slewing]\nJ_sl = "1500000 kg.m2"\nc_sl = "1500 kN.m.s"\nM_Fsl = "15 kN.m"\nM_sl = "120 kN.m"\nA_ws = "30 m2"\n'
         'r_ws = "7 m"\n\n[luffing.air]\nv_air = "6 m/s"\nchi_air = "60 deg"\n\n')
AXIS, LOAD = 2.0, 10e3
FRICTION = {"luffing": (200e3, 5e3), "slewing": (1500e3, 15e3)}
OUTPUTS = ["phi", "psi_sl", "x_Q", "y_Q", "z_Q", "l_R"]
END = 4.0


def halves(mass, inertia, centre, along):
    """Two masses of a slender body."""
    apart = np.sqrt(inertia / mass) * along
    return [(mass / 2, centre + apart), (mass / 2, centre - apart)]


def direction(angle):
    return np.array([np.cos(angle), np.sin(angle)])


def boom_on_a_rope(phi):
    """Masses with their places forward and up of the foot, the head, and the rope that luffing takes from it."""
    along, chi = direction(phi), direction(phi + np.radians(1.0))
    head = 33.0 * along + 0.4 * np.array([-along[1], along[0]])
    return halves(9e3, 9e5, 15.0 * chi, along), head, np.sqrt(np.sum((head - np.array([-2.0, 12.0])) ** 2)) / 2


def boom_on_guide_and_link(phi):
    along, link = direction(phi), direction(-phi)
    joint = 16.0 * link
    boom = halves(11e3, 9e5, joint - 16.0 * along + 14.0 * direction(phi + np.radians(1.5)), along)
    return boom + halves(4e3, 1e5, 8.0 * link, link) + [(46e3, -5.0 * link)], joint + 16.0 * along, 0.0


def places(system, start, q):
    """Masses, and their places on the ground: of luffing and slewing angles, two angles of the rope, and what the hoist paid out."""
    phi, psi, alpha, beta, paid = q
    bodies, head, led = system(phi)
    length = start[1] + paid - led + start[0]
    line = length * np.array([np.cos(beta) * np.sin(alpha), -np.cos(beta) * np.cos(alpha), np.sin(beta)])
    seen = [(mass, np.array([at[0], at[1], 0.0])) for mass, at in bodies]
    seen.append((LOAD, np.array([head[0], head[1], 0.0]) + line))
    turned = [np.array([(p[0] + AXIS) * np.cos(psi) - p[2] * np.sin(psi), p[1], (p[0] + AXIS) * np.sin(psi) + p[2] * np.cos(psi)])
              for _, p in seen]
    return np.array([mass for mass, _ in seen]), np.array(turned), line


def rates(system, start, moment, gain):
    """Of coordinates and their rates, the hoist's speed changing at a rate (m/s²)."""
    def speeds(q, rate):
        return np.imag(places(system, start, q + 1e-30j * rate)[1]) / 1e-30

    def of(_, y):
        q, rate = y[:5], y[5:]
        masses, _, _ = places(system, start, q)
        jacobian = np.array([speeds(q, unit) for unit in np.eye(5)])
        bias = (speeds(q + 1e-5 * rate, rate) - speeds(q - 1e-5 * rate, rate)) / 2e-5 + jacobian[4] * gain
        free = jacobian[:4]
        inertia = np.einsum("imx,m,jmx->ij", free, masses, free)
        inertia[1, 1] += 1.5e6
        forces = -np.einsum("imx,m,mx->i", free, masses, bias + np.array([0.0, G, 0.0]))
        wind = 0.5 * 1.225 * 36.0 * 30.0 * 7.0 * np.sin(np.radians(60.0) - q[1])
        for i, (acting, name) in enumerate([(moment, "luffing"), (120e3 + wind, "slewing")]):
            viscous, dry = FRICTION[name]
            forces[i] += acting - viscous * rate[i] - dry
        return np.concatenate([rate, np.linalg.solve(inertia, forces), [gain]])
    return of


def points(system, begun, moment):
    """What the FMUs give, over their times: the hoist is at its speed after 0.4 s."""
    phi, length = begun
    start = (system(phi)[2], length)
    y = np.concatenate([[phi], np.zeros(9)])
    found = []
    for (first, last), gain in [((0.0, 0.4), -0.25), ((0.4, END), 0.0)]:
        times = np.round(np.arange(first, last + 1e-9, 0.1), 9)
        run = solve_ivp(rates(system, start, moment, gain), (first, last), y, method="DOP853", t_eval=times, rtol=1e-11, atol=1e-12)
        y = run.y[:, -1]
        found += [(t, at) for t, at in zip(run.t, run.y.T) if first == 0.0 or t > first]
    rows = []
    for _, at in found:
        line = places(system, start, at[:5])[2]
        rows.append([at[0], at[1], *line, np.linalg.norm(line)])
    return np.array(rows)


@pytest.fixture(scope="module", params=["rope", "guided"])
def compared(request, tmp_path_factory):
    folder = tmp_path_factory.mktemp(request.param)
    if request.param == "rope":
        return packed(ROPE, "RopeSlewing", folder), points(boom_on_a_rope, (np.radians(25.0), 12.0), 3.8e6), 3.8e6
    text = GUIDED.read_text(encoding="utf-8").replace("[luffing.limits]", TURNS + "[luffing.limits]", 1)
    path = folder / "scene.toml"
    path.write_text(text, encoding="utf-8")
    expected = points(boom_on_guide_and_link, (np.radians(25.0), 15.0), 250e3)
    return packed(path, "EllipsographMotion", folder), expected, 250e3


@pytest.mark.parametrize("standard", ENDS)
@pytest.mark.parametrize("kind", ["CoSimulation", "ModelExchange"])
def test_it_moves_as_points_in_space(compared, standard, kind):
    paths, expected, moment = compared
    run = simulate_fmu(paths[standard], fmi_type=kind, stop_time=END, output_interval=0.1, relative_tolerance=1e-10,
                       record_events=False, start_values={"M_A": moment, "M_S": 0.0}, output=OUTPUTS)
    assert np.allclose(run["time"], np.arange(len(expected)) / 10, atol=1e-9)
    found = np.array([run[name] for name in OUTPUTS]).T
    ranges = np.ptp(expected, axis=0)
    assert np.all(ranges[:2] > 0.02) and np.all(ranges[2:] > 0.05), ranges
    assert np.max(np.abs(found - expected) / ranges) < 2e-6
