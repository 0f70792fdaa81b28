"""A luffing crane on a hull in FMPy, both standards and both interfaces, against an independent implementation: four-bar and lever by
circles, bars by Gauss points, positions by rotation matrices, derivatives by complex steps and differences in time, a box hull in
closed form, SciPy's integrator, the rope by two angles. And energy, rest, bars without weight."""

import math

import numpy as np
import pytest
from fmpy import simulate_fmu
from fmpy.validation import validate_fmu
from scipy.integrate import cumulative_simpson, solve_ivp

from conftest import ROOT, lemnis
import test_floating_motion as floating_motion
from test_floating_motion import ENDS, SECOND, turned

READY = ROOT / "models/scenes/floating_crane.toml"
G, RHO = 9.81, 1025.0
T = 1e3 * G
L, B = 40.0, 16.0
SOLIDS = [(620 * T, -1.0, 0.0, 1.9), (110 * T, 8.0, 0.0, 8.5), (200 * T, -9.0, 0.0, 0.6)]
SLEWS = [(25 * T, -5.0, 2.0, 14.5), (25 * T, -5.0, -2.0, 14.5), (30 * T, -2.0, 0.0, 19.0)]
AXIS, FOOT, ROPE, LOAD = 8.0, 14.0, 15.0, 100e3 / G
MASS = dict(m_a=1e6, J_x=4e7, J_y=1.5e8, d_z=3.6e5, d_x=6.5e6, d_y=3.6e7)
BARS = [(162e3, 9.516e5), (95.14e3, 2.012e5), (27.6e3, 1.145e5)]
STATES = ["psi_sl", "omega_sl", "h_G", "phi_x", "theta_y", "v_G", "omega_x", "omega_y", "r_x", "r_y", "r_z", "w_x", "w_y", "w_z"]
STATES += ["theta_1", "omega_1"]
OUTPUTS = STATES + ["S_R", "M_sl", "M_1", "M_sl0", "M_10", "R", "h_s", "T_m", "phi", "theta", "T", "W"]


def built(folder, name, *changes):
    return floating_motion.built(folder, name, *changes, ready=READY)


# The luffing mechanism in its plane, from the boom's foot.


def at(angle):
    return np.array([np.cos(angle), np.sin(angle)])


def along(a, b):
    return (b - a) / np.sqrt((b - a) @ (b - a))


def by(direction, angle):
    """A unit vector turned counter-clockwise."""
    c, s = np.cos(angle), np.sin(angle)
    return np.array([c * direction[0] - s * direction[1], s * direction[0] + c * direction[1]])


def meet(a, far_a, b, far_b):
    """Where two circles meet on the left of the line from the one centre to the other."""
    whole = np.sqrt((b - a) @ (b - a))
    ahead = (far_a**2 - far_b**2 + whole**2) / (2 * whole)
    side = np.sqrt(far_a**2 - ahead**2)
    to = along(a, b)
    return a + ahead * to + side * np.array([-to[1], to[0]])


def links(theta):
    """The jib's head, and every mass (kg) with its place: bars by three Gauss points, exact for squares."""
    rad = math.radians
    b, o3 = 26.3 * at(theta), np.array([-4.249827, 9.499717])
    c = meet(o3, 22.1, b, 4.1)
    back = along(b, c)
    head = b + 11.68 * by(back, -rad(177.08))
    boom, rocker = at(theta), along(o3, c)
    jib = along(c, head)
    centres = [11.725 * by(boom, rad(1)), b + 2.6 * by(back, -rad(165.55)), o3 + 11.05 * rocker]
    masses, places = [], []
    for (weight, inertia), centre, line in zip(BARS, centres, [boom, jib, rocker]):
        mass = weight / G
        half = math.sqrt(3 * inertia / mass)
        for part, share in ((-math.sqrt(0.6), 5 / 18), (0.0, 8 / 18), (math.sqrt(0.6), 5 / 18)):
            masses.append(mass * share)
            places.append(centre + part * half * line)
    m, k = 10.358 * at(rad(105.11)), 1.602 * at(theta + rad(18.94))
    end = meet(m, 0.364, k, 9.058)
    masses.append(984.8e3 / 3.0 / G)
    places.append(m + 3.0 * by(along(m, end), rad(156.81)))
    return head, np.array(masses), np.array(places)


# The independent crane. Coordinates: height of the hull's centre of gravity, heel, pitch, the rope's angles; then slewing, luffing.

HULL = sum(w for w, *_ in SOLIDS)
CENTRE = np.array([sum(w * at[i] for w, *at in SOLIDS) for i in range(3)]) / HULL


def places(z):
    """Of all masses on the hull and of the load, from the water; z has all seven coordinates."""
    h, heel, pitch, ahead, aside, psi, theta = z
    head, _, plane = links(theta)
    inside = [(x, 0 * theta, y + FOOT) for x, y in plane] + [at for _, *at in SLEWS] + [(head[0], 0 * theta, head[1] + FOOT)]
    x, y, up = np.array([list(p) for p in inside]).T
    c, s = np.cos(psi), np.sin(psi)
    hull = np.array([AXIS + x * c - y * s, x * s + y * c, up]) - CENTRE[:, None]
    out = (turned(heel, pitch) @ hull).T + np.array([0, 0, 1]) * h
    rope = ROPE * np.array([np.sin(ahead) * np.cos(aside), np.sin(aside), -np.cos(ahead) * np.cos(aside)])
    return np.concatenate([out[:-1], [out[-1] + rope]])


def masses(load=LOAD):
    return np.concatenate([links(1.0)[1], [w / G for w, *_ in SLEWS], [load]])


def water(z):
    """Potential of hull and water: a box that the water cuts at its sides alone."""
    up = turned(z[1], z[2])[2]
    a, b = -up[0] / up[2], -up[1] / up[2]
    draft = (up @ CENTRE - z[0]) / up[2]
    below = np.array([a * L**3 * B / 12, b * L * B**3 / 12, L * B / 2 * (draft**2 + a**2 * L**2 / 12 + b**2 * B**2 / 12)])
    return HULL * z[0] - RHO * G * (up @ below - up[2] * draft * L * B * draft)


def potential(z, load=LOAD):
    return water(z) + G * masses(load) @ places(z)[:, 2]


def slope(of, z):
    """By complex steps: exact to rounding."""
    step, columns = 1e-30, []
    for i in range(7):
        moved = np.asarray(z).astype(complex)
        moved[i] += 1j * step
        columns.append(np.imag(of(moved)) / step)
    return np.array(columns)


INERTIAS = np.array([HULL / G + MASS["m_a"], MASS["J_x"], MASS["J_y"]])
DAMPING = np.array([MASS["d_z"], MASS["d_x"], MASS["d_y"]])


def moving(t, y, load=LOAD):
    """Accelerations of the five free coordinates, and the moments of both drives."""
    q, v = y[:5], y[5:]
    (psi, omega, alpha), (theta, rate, change) = courses(t)
    z, dz = np.append(q, [psi, theta]), np.append(v, [omega, rate])
    ddz = np.array([0, 0, 0, 0, 0, alpha, change])
    mass = masses(load)
    travel = slope(places, z)  # 7 × masses × 3
    near = 0.02
    bend = sum(part * places(z + dz * (i * near) + ddz * (i * near) ** 2 / 2) for i, part in SECOND) / near**2
    inertia = np.einsum("imk,jmk,m->ij", travel, travel, mass)
    inertia[range(3), range(3)] += INERTIAS
    push = -slope(lambda z: potential(z, load), z) - np.einsum("imk,mk,m->i", travel, bend, mass)
    push[:3] -= DAMPING * v[:3]
    found = np.linalg.solve(inertia[:5, :5], push[:5])
    return found, inertia[5:, :5] @ found - push[5:]


LAGS = 2.0, 1.0


def after(dt, lag, speed):
    if dt <= 0:
        return np.zeros(3)
    fall = math.exp(-dt / lag)
    return speed * np.array([dt - lag * (1 - fall), 1 - fall, fall / lag])


def courses(t):
    """Slewing and luffing that follow commanded speeds with a lag: angle, rate, acceleration."""
    quick, slow = math.radians(3.0), math.radians(0.5)
    slewing = after(t - 5, LAGS[0], quick) - after(t - 35, LAGS[0], quick)
    luffing = after(t - 10, LAGS[1], slow) - after(t - 50, LAGS[1], slow)
    return slewing, luffing + np.array([math.radians(46), 0, 0])


def start(psi=0.0, theta=math.radians(46), load=LOAD):
    """At rest: Newton's method on the slope of the potential."""
    q = np.array([1.0, 0.0, 0.0, 0.0, 0.0])
    of = lambda q: slope(lambda z: potential(z, load), np.append(q, [psi, theta]))
    for _ in range(50):
        near = 1e-6
        hesse = np.array([(of(q + near * e)[:5] - of(q)[:5]) / near for e in np.eye(5)])
        q = q - np.linalg.solve(hesse, of(q)[:5])
    return q, of(q)[5:]


@pytest.fixture(scope="module")
def expected():
    """Seventy seconds, in which it slews and luffs."""
    times = np.round(np.arange(0, 70, 0.1), 10)
    found, y = [], np.concatenate([start()[0], np.zeros(5)])
    breaks = [0.0, 5.0, 10.0, 35.0, 50.0, 69.9]
    rates = lambda t, y: np.concatenate([y[5:], moving(t, y)[0]])
    for low, high in zip(breaks, breaks[1:]):
        inside = times[(times >= low) & (times <= high)]
        solved = solve_ivp(rates, (low, high), y, "DOP853", inside, rtol=1e-9, atol=1e-10)
        y = solved.y[:, -1]
        found.append(solved.y[:, :-1] if high < 69 else solved.y)
    return times, np.concatenate(found, axis=1)


@pytest.mark.parametrize("standard", ENDS)
def test_against_an_independent_crane(tmp_path, standard, expected):
    fmu = built(tmp_path, "Carries")[standard]
    assert validate_fmu(fmu) == []
    times, y = expected
    # Between breaks of the commands, where the drives' moments do not jump.
    smooth = np.all([np.abs(times - at) > 1e-6 for at in (5, 10, 35, 50)], axis=0)
    drives = np.array([moving(t, at)[1] for t, at in zip(times, y.T)]).T
    runs = {"CoSimulation": {}, "ModelExchange": {"solver": "CVode", "relative_tolerance": 1e-10}}
    for kind, options in runs.items():
        found = simulate_fmu(fmu, fmi_type=kind, stop_time=69.9, output_interval=0.1, output=OUTPUTS, **options)
        at = np.searchsorted(found["time"], times - 1e-9)
        assert np.abs(found["time"][at] - times).max() < 1e-9
        reach = {"h_G": y[0], "phi_x": y[1], "theta_y": y[2]}
        reach["r_x"] = ROPE * np.sin(y[3]) * np.cos(y[4])
        reach["r_y"] = ROPE * np.sin(y[4])
        reach["M_sl"], reach["M_1"] = drives
        for name, series in reach.items():
            off = np.abs(found[name][at] - series)[smooth].max() / np.ptp(series)
            print(standard, kind, name, off)
            assert off < 1e-6, name
        for i, name in enumerate(("psi_sl", "theta_1")):
            assert np.abs(found[name][at] - [courses(t)[i][0] for t in times]).max() < 1e-8


STILL = [('["5 s", "3 deg/s"]', '["5 s", "0 deg/s"]'), ('["10 s", "0.5 deg/s"]', '["10 s", "0 deg/s"]')]


def test_at_rest_it_is_the_static_crane(tmp_path):
    """At any slewing and luffing angle: draft, heel and trim of the equilibrium, and of the independent potential; the drives hold
    what its slope says."""
    for i, (psi, theta) in enumerate(((0, 46), (100, 60), (215, 80))):
        turn = ('theta_1 = "46 deg"', f'psi_sl = "{psi} deg"\ntheta_1 = "{theta} deg"')
        found = simulate_fmu(built(tmp_path, f"Rests{i}", *STILL, turn)["FMI 3"], stop_time=30.0, output_interval=1.0, output=OUTPUTS)
        slopes = np.tan(found["theta_y"]) / np.cos(found["phi_x"])
        for moved, rest in ((found["phi_x"], "phi"), (np.arctan(slopes), "theta"), (found["T_m"], "T")):
            assert np.abs(moved - found[rest]).max() < 1e-10, (psi, rest)
        q, holds = start(math.radians(psi), math.radians(theta))
        for name, wanted in (("h_G", q[0]), ("phi_x", q[1]), ("theta_y", q[2])):
            assert np.abs(found[name] - wanted).max() < 1e-9, (psi, name)
        for name, wanted in zip(("M_sl", "M_1"), holds):
            size = 100e3 * 30
            assert np.abs(found[name] - wanted).max() < 1e-8 * size, (psi, name, found[name][0], wanted)
            assert np.abs(found[f"{name}0"] - wanted).max() < 1e-8 * size, (psi, name)
        head = links(math.radians(theta))[0]
        assert abs(found["R"][0] - head[0]) < 1e-12 * 30 and abs(found["h_s"][0] - head[1] - FOOT) < 1e-12 * 60


def test_the_work_of_the_drives_is_what_energy_grows_by(tmp_path):
    """Kinetic energy and potential, from outside by the states alone, against the powers of both drives and of damping."""
    fmu = built(tmp_path, "Works")["FMI 3"]
    found = simulate_fmu(fmu, stop_time=70.0, output_interval=0.005, output=OUTPUTS)
    breaks = [0.0, 5.0, 10.0, 35.0, 50.0, 70.0]
    mass = masses()

    def energy(row):
        side = row["r_y"] / ROPE
        q = [row["h_G"], row["phi_x"], row["theta_y"], np.arctan2(row["r_x"], -row["r_z"]), np.arcsin(side)]
        z = np.array([*q, row["psi_sl"], row["theta_1"]])
        dz = np.array([row[name] for name in ("v_G", "omega_x", "omega_y")] + [0.0, 0.0] + [row["omega_sl"], row["omega_1"]])
        speeds = np.einsum("imk,i->mk", slope(places, z), dz)
        speeds[-1] += [row["w_x"], row["w_y"], row["w_z"]]
        return INERTIAS @ dz[:3] ** 2 / 2 + mass @ (speeds**2).sum(axis=1) / 2 + potential(z)

    power = found["M_sl"] * found["omega_sl"] + found["M_1"] * found["omega_1"]
    for damping, name in zip(DAMPING, ("v_G", "omega_x", "omega_y")):
        power = power - damping * found[name] ** 2
    worst, grown, work = 0.0, [], 0.0
    for low, high in zip(breaks, breaks[1:]):
        inside = np.flatnonzero((found["time"] > low - 1e-9) & (found["time"] < high + 1e-9))
        t, p = found["time"][inside], power[inside]
        if high < 70:
            # At a break the moment jumps, and what is told there has the command that follows.
            p[-1] = np.polyval(np.polyfit(t[-7:-1] - t[-1], p[-7:-1], 5), 0.0)
        done = work + cumulative_simpson(p, x=t, initial=0.0)
        for i in range(0, len(t), 100):
            gain = energy(found[inside[i]]) - energy(found[0])
            grown.append(gain)
            worst = max(worst, abs(gain - done[i]))
        work = done[-1]
    print(worst / np.ptp(grown))
    assert worst < 1e-6 * np.ptp(grown)


def test_bars_without_weight_are_a_head_of_given_reach(tmp_path):
    """And nothing luffs: the same motion as that of a crane that has no luffing mechanism."""
    text = READY.read_text(encoding="utf-8")
    at = text.index("[luffing.weights]")
    told = text[text.index("omega_c1 = ") : text.index("Q = {")]
    light = [(text[at:], ""), (text[text.index("[[hull.turning]]") : text.index("[hull.loss]")], ""), (told, "")]
    names = ["h_G", "phi_x", "theta_y", "r_x", "r_y", "r_z", "S_R"]
    first = simulate_fmu(built(tmp_path, "Light", *light)["FMI 3"], stop_time=60.0, output_interval=0.5, output=[*names, "R", "h_s"])
    reach, height = float(first["R"][0]), float(first["h_s"][0])
    plain = text[: text.index("[[hull.turning]]")] + text[text.index("[hull.loss]") : text.index("[luffing]")]
    for before, after in (
        (told, ""),
        ('theta_1 = "46 deg"            # the boom at the start\n', f'R = "{reach!r} m"\n'),
        ('T_1 = "1 s"                   # and luffing\n', ""),
        ('h_1 = "14 m"', f'h_s = "{height!r} m"'),
    ):
        assert before in plain, before
        plain = plain.replace(before, after)
    path = tmp_path / "Plain.toml"
    path.write_text(plain.replace('"FloatingCrane"', '"Plain"', 1), encoding="utf-8")
    lemnis("fmu", path, "--output", tmp_path)
    second = simulate_fmu(str(tmp_path / "Plain.fmu"), stop_time=60.0, output_interval=0.5, output=names)
    for name in names:
        # What rounding comes to in a minute; lengths are metres and tens of them.
        off = np.abs(first[name] - second[name]).max() / max(np.abs(second[name]).max(), 1.0)
        print(name, off)
        assert off < 1e-12, name
