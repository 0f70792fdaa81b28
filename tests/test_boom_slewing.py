"""Cranes that luff, slew, hoist and swing at once, some with a hoist rope that luffing draws over sheaves, by speed or by a motor
on its drum: their FMUs against points in space, each body as two of them."""

import numpy as np
import pytest
from fmpy import simulate_fmu
from scipy.integrate import solve_ivp

from conftest import ROOT
from single_boom import ENDS, G, packed

ROPE = ROOT / "models/scenes/rope_slewing.toml"
GUIDED = ROOT / "models/scenes/ellipsograph_motion.toml"
LED = ROOT / "models/scenes/led_rope.toml"
TRUNK = ROOT / "models/scenes/curved_trunk.toml"
TURNS = ('[slewing]\nJ_sl = "1500000 kg.m2"\nc_sl = "1500 kN.m.s"\nM_Fsl = "15 kN.m"\nM_sl = "120 kN.m"\nA_ws = "30 m2"\n'
         'r_ws = "7 m"\n\n[luffing.air]\nv_air = "6 m/s"\nchi_air = "60 deg"\n\n')
LOAD = 10e3
FRICTION = {"luffing": (200e3, 5e3), "slewing": (1500e3, 15e3)}
OUTPUTS = ["psi_sl", "x_Q", "y_Q", "z_Q", "l_R"]
END = 4.0
# Inertia (kg·m²) and radius (m) of a drum, its motor's moment and dry friction (N·m).
DRUM = (900.0, 0.3, 17.5e3, 1e3)
# Of the ground (rad); what slews besides the bodies weighs (N) behind the slewing axis (m).
SLOPE, UPPER, BEHIND = np.radians(2.0), 900e3, -1.5
ON_SLOPE = f'[slewing.slope]\ngamma_s = "2 deg"\nG_u = "{UPPER / 1e3} kN"\nr_u = "{BEHIND} m"\n\n'


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


def meeting(near, far, a, b):
    """Where two bars from two points meet, to the left of the line between."""
    line = far - near
    square = np.sum(line ** 2)
    part = (a * a - b * b + square) / (2 * square)
    across = np.sqrt(a * a / square - part * part)
    return near + part * line + across * np.array([-line[1], line[0]])


def turned(along, x, y):
    return np.array([along[0] * x - along[1] * y, along[1] * x + along[0] * y])


def far(a, b):
    return np.sqrt(np.sum((a - b) ** 2))


def double_link(theta):
    """With its rope over a sheave on the jib's tail to the frame."""
    foot, boom = np.array([-6.4, 5.3]), direction(theta)
    b = 19.3 * boom
    c = meeting(foot, b, 14.7, 6.5)
    rear, rocker = (c - b) / 6.5, (c - foot) / 14.7
    # At B, below the line from tail to head by 1.354 m.
    angle = np.pi - np.arcsin(1.354 / 6.5) - np.arcsin(1.354 / 16)
    head = b + 16 * turned(rear, np.cos(angle), -np.sin(angle))
    sheave = b + turned(rear, 6.2, 0.9)
    bodies = halves(20e3, 620e3, 9.65 * boom, boom)
    centre = b + 4.98 * turned(rear, np.cos(np.radians(152.2)), -np.sin(np.radians(152.2)))
    bodies += halves(6e3, 250e3, centre, (head - c) / far(head, c))
    bodies += halves(4e3, 72e3, foot + 7.35 * rocker, rocker)
    return bodies, head, (far(head, sheave) + far(sheave, np.array([-6.6, 5.4]))) / 2


def boom_with_trunk(phi):
    """The free tie is as long as what does not lie on the tail, an arc of 5 m about Z; its rope runs over the boom's head."""
    boom, foot = direction(phi), np.array([-6.0, 12.0])
    b = 21.5 * boom
    middle, front = np.array([-1.15, 0.05]), np.radians(132.0)
    away = np.sum((foot - b) ** 2)

    def left(zeta):
        """Tie less what is free and wrapped, at a contact in this direction."""
        out = np.array([np.cos(zeta), np.sin(zeta)])
        touch, tangent = middle + 5 * out, np.array([-out[1], out[0]])
        along = np.sum(touch * tangent)
        free = -along + np.sqrt(along ** 2 + away - np.sum(touch ** 2))
        return touch + free * tangent, 21.05 - free - 5 * (zeta - front)
    zeta = np.radians(180.0) + 0 * phi
    for _ in range(60):
        value = left(zeta)[1]
        zeta = zeta - value / ((left(zeta + 1e-6)[1] - value) / 1e-6)
    # Complex steps converge with the slope at the root, once.
    end = left(zeta)[0]
    reach = foot - b
    along = np.array([np.sum(end * reach), end[0] * reach[1] - end[1] * reach[0]]) / away
    head = b + 14.2 * along
    chi = np.radians(1.0)
    bodies = halves(13e3, 500e3, 9.5 * turned(boom, np.cos(chi), np.sin(chi)), boom)
    bodies += halves(6e3, 150e3, b + 1.8 * turned(along, np.cos(3 * chi), np.sin(3 * chi)), along)
    sheaves = [head, b + turned(along, -1.0, 1.5), turned(boom, 12.0, 1.2), np.array([-5.0, 11.0])]
    return bodies, head, sum(far(*pair) for pair in zip(sheaves, sheaves[1:])) / 4


# How far the foot is in front of the slewing axis, in m.
AXIS = {boom_on_a_rope: 2.0, boom_on_guide_and_link: 2.0, double_link: 5.2, boom_with_trunk: 2.0}


def places(system, start, q):
    """Masses, and their places on the ground: of luffing and slewing angles, two angles of the rope, and what the hoist paid out."""
    phi, psi, alpha, beta, paid = q
    bodies, head, led = system(phi)
    axis = AXIS[system]
    length = start[1] + paid - led + start[0]
    line = length * np.array([np.cos(beta) * np.sin(alpha), -np.cos(beta) * np.cos(alpha), np.sin(beta)])
    seen = [(mass, np.array([at[0], at[1], 0.0])) for mass, at in bodies]
    seen.append((LOAD, np.array([head[0], head[1], 0.0]) + line))
    ground = [np.array([(p[0] + axis) * np.cos(psi) - p[2] * np.sin(psi), p[1], (p[0] + axis) * np.sin(psi) + p[2] * np.cos(psi)])
              for _, p in seen]
    return np.array([mass for mass, _ in seen]), np.array(ground), line


def rates(system, start, moment, gain, falls=None, slope=0.0):
    """Of coordinates and their rates, the hoist's speed changing at a rate (m/s²), or with its drum behind so many falls, where the
    ground falls by an angle in the direction in which the crane begins."""
    weighs = G * np.array([np.sin(slope), -np.cos(slope), 0.0])
    drum = np.zeros(2)
    if falls:
        ratio = falls / DRUM[1]
        drum = np.array([DRUM[0] * ratio ** 2, -ratio * (DRUM[2] - DRUM[3])])

    def speeds(q, rate):
        return np.imag(places(system, start, q + 1e-30j * rate)[1]) / 1e-30

    def of(_, y):
        q, rate = y[:5], y[5:]
        masses, _, _ = places(system, start, q)
        jacobian = np.array([speeds(q, unit) for unit in np.eye(5)])
        bias = (speeds(q + 1e-5 * rate, rate) - speeds(q - 1e-5 * rate, rate)) / 2e-5 + jacobian[4] * gain
        free = jacobian if falls else jacobian[:4]
        inertia = np.einsum("imx,m,jmx->ij", free, masses, free)
        inertia[1, 1] += 1.5e6
        forces = -np.einsum("imx,m,mx->i", free, masses, bias - weighs)
        forces[1] -= UPPER * BEHIND * np.sin(slope) * np.sin(q[1])
        if falls:
            inertia[4, 4] += drum[0]
            forces[4] += drum[1]
        wind = 0.5 * 1.225 * 36.0 * 30.0 * 7.0 * np.sin(np.radians(60.0) - q[1])
        for i, (acting, name) in enumerate([(moment, "luffing"), (120e3 + wind, "slewing")]):
            viscous, dry = FRICTION[name]
            forces[i] += acting - viscous * rate[i] - dry
        return np.concatenate([rate, np.linalg.solve(inertia, forces), [] if falls else [gain]])
    return of


def points(system, begun, moment, falls=None, slope=0.0):
    """What the FMUs give, over their times: the hoist is at its speed after 0.4 s, or a motor turns its drum behind so many falls."""
    phi, length = begun
    start = (system(phi)[2], length)
    y = np.concatenate([[phi], np.zeros(9)])
    found = []
    for (first, last), gain in [((0.0, END), 0.0)] if falls else [((0.0, 0.4), -0.25), ((0.4, END), 0.0)]:
        times = np.round(np.arange(first, last + 1e-9, 0.1), 9)
        run = solve_ivp(rates(system, start, moment, gain, falls, slope), (first, last), y, method="DOP853", t_eval=times, rtol=1e-11, atol=1e-12)
        y = run.y[:, -1]
        found += [(t, at) for t, at in zip(run.t, run.y.T) if first == 0.0 or t > first]
    rows = []
    for _, at in found:
        line = places(system, start, at[:5])[2]
        rows.append([at[0], at[1], *line, np.linalg.norm(line)])
    return np.array(rows)


BY_SPEED = 'v_h = "-0.1 m/s"\na_h = "0.25 m/s2"\n'
BY_MOTOR = 'J_h = "900 kg.m2"\nr_h = "300 mm"\nM_Mh = "17.5 kN.m"\nM_Fh = "1 kN.m"\n'


def moving(inertias, moment, length, hoist):
    return (f'[luffing.dynamics]\n{inertias}c_v = "200 kN.m.s"\nM_F = "5 kN.m"\nM_A = "{moment / 1e3} kN.m"\nM_S = "9000 kN.m"\n'
            f'[luffing.hoisting]\nl_R = "{length} m"\n{hoist}')


def inserted(path, folder, *changes):
    """A ready scene with changes; of what stands before its limits these alone are left."""
    text = path.read_text(encoding="utf-8")
    for before, after in changes:
        assert before in text, before
        text = text.replace(before, after, 1)
    scene = folder / "scene.toml"
    scene.write_text(text, encoding="utf-8")
    return scene


ROPE_OF_TRUNK = "".join(f'[[luffing.rope.sheave]]\non = "{on}"\nx_r = "{x} m"\ny_r = "{y} m"\n' for on, x, y in [
    ("trunk", -1.0, 1.5), ("boom", 12.0, 1.2), ("frame", -5.0, 11.0)])


@pytest.fixture(scope="module", params=["rope", "rope by motor", "rope on slope", "guided", "led", "led by motor",
                                        "led by motor on slope", "trunk", "trunk on slope"])
def compared(request, tmp_path_factory):
    kind, _, leans = request.param.partition(" on ")
    kind, _, motor = kind.partition(" by ")
    slope = SLOPE if leans else 0.0
    turns = TURNS + (ON_SLOPE if leans else "")
    folder = tmp_path_factory.mktemp(kind + motor + leans)
    # The experiment ends before a motor has reeled in all of the rope.
    hoist, falls, speed = (BY_MOTOR, 2, "12 deg/s") if motor else (BY_SPEED, None, "0.8 deg/s")
    if kind == "rope":
        path = inserted(ROPE, folder, ('"0.8 deg/s"', f'"{speed}"'), ('v_h = "-0.1 m/s"      # lifts\na_h = "0.25 m/s2"\n', hoist),
                        ("[luffing.limits]", (ON_SLOPE if leans else "") + "[luffing.limits]"))
        expected = points(boom_on_a_rope, (np.radians(25.0), 12.0), 3.8e6, falls, slope)
        return packed(path, "RopeSlewing", folder), expected, 3.8e6, "phi"
    if kind == "guided":
        path = inserted(GUIDED, folder, ("[luffing.limits]", turns + "[luffing.limits]"))
        expected = points(boom_on_guide_and_link, (np.radians(25.0), 15.0), 250e3)
        return packed(path, "EllipsographMotion", folder), expected, 250e3, "phi"
    if kind == "led":
        text = LED.read_text(encoding="utf-8")
        own = text[text.index("[luffing.dynamics]"):text.index("[luffing.limits]")]
        inertias = 'J_1 = "620000 kg.m2"\nJ_2 = "250000 kg.m2"\nJ_3 = "72000 kg.m2"\n'
        path = inserted(LED, folder, ('"1 deg/s"', f'"{speed}"'), ('Q = "160 kN"', 'Q = "10 t"'), (own, moving(inertias, 1.7e6, 12.0, hoist) + turns))
        expected = points(double_link, (np.radians(60.0), 12.0), 1.7e6, falls, slope)
        return packed(path, "LedRope", folder), expected, 1.7e6, "theta_1"
    inertias = 'J_b = "500000 kg.m2"\nJ_t = "150000 kg.m2"\n'
    text = TRUNK.read_text(encoding="utf-8")
    balance = text[text.index("[luffing.balance]"):text.index("[luffing.limits]")]
    rope = '[luffing.rope]\nm_h = "4"\nh_Q = "8 m"\n' + ROPE_OF_TRUNK
    path = inserted(TRUNK, folder, ('kind = "curved_trunk"', 'kind = "curved_trunk"\nfidelity = "swing"'), (balance, rope),
                    ("[luffing.limits]", moving(inertias, 1.9e6, 8.0, hoist) + turns + "[luffing.limits]"))
    return packed(path, "CurvedTrunkCrane", folder), points(boom_with_trunk, (np.radians(42.0), 8.0), 1.9e6, slope=slope), 1.9e6, "phi"


@pytest.mark.parametrize("standard", ENDS)
@pytest.mark.parametrize("kind", ["CoSimulation", "ModelExchange"])
def test_it_moves_as_points_in_space(compared, standard, kind):
    paths, expected, moment, angle = compared
    outputs = [angle, *OUTPUTS]
    run = simulate_fmu(paths[standard], fmi_type=kind, stop_time=END, output_interval=0.1, relative_tolerance=1e-10,
                       record_events=False, start_values={"M_A": moment, "M_S": 0.0}, output=outputs)
    assert np.allclose(run["time"], np.arange(len(expected)) / 10, atol=1e-9)
    found = np.array([run[name] for name in outputs]).T
    ranges = np.ptp(expected, axis=0)
    assert np.all(ranges[:2] > 0.02) and np.all(ranges[2:] > 0.05), ranges
    assert np.max(np.abs(found - expected) / ranges) < 2e-6


def hung(system, moment, slope):
    """Rates of luffing and slewing and of their rates, the load plumb below the head, farther where luffing lets its rope out."""
    weighs = G * np.array([np.sin(slope), -np.cos(slope), 0.0])

    def of(_, y):
        q, rate = y[:2], y[2:]

        def all_places(q):
            at = np.array([q[0], q[1], 0.0 * q[0], 0.0 * q[0], 0.0 * q[0]])
            masses, ground, _ = places(system, (0.0, 20.0), at)
            return masses, ground, system(q[0])[2]

        def speeds(q, rate):
            return np.imag(all_places(q + 1e-30j * rate)[1]) / 1e-30
        masses, _, _ = all_places(q)
        jacobian = np.array([speeds(q, unit) for unit in np.eye(2)])
        bias = (speeds(q + 1e-5 * rate, rate) - speeds(q - 1e-5 * rate, rate)) / 2e-5
        inertia = np.einsum("imx,m,jmx->ij", jacobian, masses, jacobian)
        inertia[1, 1] += 1.5e6
        forces = np.einsum("imx,m,mx->i", jacobian, masses, weighs - bias)
        # The rope's length below the head is 20 m less what is led, along the plumb line and not upright to the ground.
        led = np.imag(all_places(q + 1e-30j * np.array([1.0, 0.0]))[2]) / 1e-30
        forces[0] += LOAD * led * (-G + np.cos(slope) * G)
        forces[1] -= UPPER * BEHIND * np.sin(slope) * np.sin(q[1])
        wind = 0.5 * 1.225 * 36.0 * 30.0 * 7.0 * np.sin(np.radians(60.0) - q[1])
        for i, (acting, name) in enumerate([(moment, "luffing"), (120e3 + wind, "slewing")]):
            viscous, dry = FRICTION[name]
            forces[i] += acting - viscous * rate[i] - dry
        return np.concatenate([rate, np.linalg.solve(inertia, forces)])
    return of


@pytest.mark.parametrize("standard", ENDS)
def test_a_load_that_does_not_swing_hangs_plumb_on_a_slope(tmp_path, standard):
    """Its rope is led over a sheave: what luffing lets out of it lowers the load along the plumb line."""
    text = LED.read_text(encoding="utf-8")
    own = text[text.index("[luffing.dynamics]"):text.index("[luffing.limits]")]
    inertias = 'J_1 = "620000 kg.m2"\nJ_2 = "250000 kg.m2"\nJ_3 = "72000 kg.m2"\n'
    still = moving(inertias, 1.7e6, 12.0, "").split("[luffing.hoisting]")[0]
    path = inserted(LED, tmp_path, ('fidelity = "swing"', 'fidelity = "rigid"'), ('Q = "160 kN"', 'Q = "10 t"'), (own, still + TURNS + ON_SLOPE))
    start = [np.radians(60.0), 0.0, 0.0, 0.0]
    solved = solve_ivp(hung(double_link, 1.7e6, SLOPE), (0.0, END), start, method="DOP853", t_eval=np.linspace(0.0, END, 41),
                       rtol=1e-11, atol=1e-12)
    run = simulate_fmu(packed(path, "LedRope", tmp_path)[standard], stop_time=END, output_interval=0.1, relative_tolerance=1e-10,
                       record_events=False, start_values={"M_A": 1.7e6, "M_S": 0.0}, output=["theta_1", "psi_sl"])
    for name, expected in zip(["theta_1", "psi_sl"], solved.y):
        swept = np.ptp(expected)
        assert swept > 0.02 and np.max(np.abs(run[name] - expected)) < 2e-6 * swept, name
