"""A floating crane in motion in FMPy, both standards and both interfaces, against an independent implementation: positions
by rotation matrices, energies of a box hull and its tanks in closed form, derivatives by complex steps, SciPy's integrator, and
the rope by two angles instead of a constraint. And against closed forms of small motions."""

import math
import re

import numpy as np
import pytest
from fmpy import simulate_fmu
from fmpy.validation import validate_fmu
from scipy.integrate import solve_ivp

from conftest import ROOT, lemnis

READY = ROOT / "models/scenes/floating_motion.toml"
ENDS = {"FMI 2": ".fmi2.fmu", "FMI 3": ".fmu"}
G, RHO = 9.81, 1025.0
T = 1e3 * G
L, B = 60.0, 24.0
SOLIDS = [(1450 * T, -0.8, 0.0, 2.6), (620 * T, 12.0, 0.0, 13.5), (480 * T, -13.5, 0.0, 0.8)]
TANKS = [(12.0, 8.0, 1.6, -8.0, side * 7.5, 0.2) for side in (1, -1)]
WIND = 250.0 * (150.0 * (3.3 - 1.1) + 240.0 * (19.0 - 1.1))
REACH, AXIS, HIGH, ROPE = 25.0, 12.0, 38.0, 20.0
MASS = dict(m_a=2.6e6, J_x=3.4e8, J_y=1.3e9, d_z=1.5e6, d_x=2e7, d_y=1.5e8)
LAG, QUICK = 2.0, math.radians(3.0)
OUTPUTS = ["psi_sl", "h_G", "phi_x", "theta_y", "r_x", "r_y", "r_z", "S_R", "T_m", "f_m", "phi", "theta", "T"]


def changed(folder, name, *changes, ready=READY):
    text = ready.read_text(encoding="utf-8")
    for before, after in changes:
        assert before in text, before
        text = text.replace(before, after)
    path = folder / f"{name}.toml"
    path.write_text(re.sub(r'(?m)^name +=.*', f'name = "{name}"', text, count=1), encoding="utf-8")
    return path


def built(folder, name, *changes, ready=READY):
    lemnis("fmu", changed(folder, name, *changes, ready=ready), "--output", folder)
    return {standard: str(folder / f"{name}{end}") for standard, end in ENDS.items()}


# The independent crane. Coordinates: height of the centre of gravity, heel, pitch, and the rope's angles along and across.


def weights():
    solids = SOLIDS + [(RHO * G * l * b * h, x, y, z + h / 2) for l, b, h, x, y, z in TANKS]
    whole = sum(w for w, *_ in solids)
    return whole, np.array([sum(w * at[i] for w, *at in solids) for i in range(3)]) / whole


WHOLE, CENTRE = weights()


def turned(heel, pitch):
    """Of the hull: heel about the long axis lowers the left side, pitch the bow."""
    c, s, k, n = np.cos(heel), np.sin(heel), np.cos(pitch), np.sin(pitch)
    roll = np.array([[1, 0, 0], [0, c, s], [0, -s, c]])
    return np.array([[k, 0, n], [0, 1, 0], [-n, 0, k]]) @ roll


def head(q, psi):
    at = np.array([AXIS + REACH * np.cos(psi), REACH * np.sin(psi), HIGH]) - CENTRE
    return np.array([0, 0, q[0]]) + turned(q[1], q[2]) @ at


def load(q, psi):
    along, across = q[3], q[4]
    return head(q, psi) + ROPE * np.array([np.sin(along) * np.cos(across), np.sin(across), -np.cos(along) * np.cos(across)])


def potential(q, psi, mass):
    """Weights, liquids that stand level, the wind as a weight aside, displaced water, load."""
    up = turned(q[1], q[2])[2]
    a, b = -up[0] / up[2], -up[1] / up[2]
    moment = sum(w * np.array(at) for w, *at in SOLIDS) + np.array([0, WIND, 0])
    for l, w, h, x, y, z in TANKS:
        volume = l * w * h
        lean = np.array([x * volume + a * w * l**3 / 12, y * volume + b * l * w**3 / 12, 0])
        lean[2] = z * volume + l * w / 2 * (h**2 + a**2 * l**2 / 12 + b**2 * w**2 / 12)
        moment = moment + RHO * G * lean
    own = WHOLE * q[0] + up @ (moment - WHOLE * CENTRE)
    draft = (up @ CENTRE - q[0]) / up[2]
    volume = L * B * draft
    below = np.array([a * L**3 * B / 12, b * L * B**3 / 12, L * B / 2 * (draft**2 + a**2 * L**2 / 12 + b**2 * B**2 / 12)])
    water = up @ below - up[2] * draft * volume
    return own - RHO * G * water + mass * G * load(q, psi)[2]


def slope(of, q):
    """By complex steps: exact to rounding."""
    step = 1e-30
    columns = []
    for i in range(5):
        moved = q.astype(complex)
        moved[i] += 1j * step
        columns.append(np.imag(of(moved)) / step)
    return np.array(columns).T


# A second derivative by nine places, to the eighth order.
PARTS = [-205 / 72, 8 / 5, -1 / 5, 8 / 315, -1 / 560]
SECOND = [(i, PARTS[abs(i)]) for i in range(-4, 5)]


def rates(t, y, course, mass):
    q, v = y[:5], y[5:]
    psi, omega, alpha = course(t)
    inertias = np.array([WHOLE / G + MASS["m_a"], MASS["J_x"], MASS["J_y"], 0, 0])
    damping = np.array([MASS["d_z"], MASS["d_x"], MASS["d_y"], 0, 0])
    along = slope(lambda q: load(q, psi), q)
    # What the load accelerates with where no coordinate does: by differences in time.
    near = 0.02
    bend = sum(
        part * load(q + v * (i * near), psi + omega * (i * near) + alpha * (i * near) ** 2 / 2) for i, part in SECOND
    ) / near**2
    matrix = np.diag(inertias) + mass * along.T @ along
    forces = -slope(lambda q: potential(q, psi, mass), q) - damping * v - mass * along.T @ bend
    return np.concatenate([v, np.linalg.solve(matrix, forces)])


def course(t, begins=5.0, ends=35.0):
    """Slewing that follows a commanded speed with a lag."""
    def after(dt):
        fall = math.exp(-dt / LAG)
        return np.array([QUICK * (dt - LAG * (1 - fall)), QUICK * (1 - fall), QUICK * fall / LAG])

    at = after(t - begins) if t > begins else np.zeros(3)
    return at - (after(t - ends) if t > ends else np.zeros(3))


def start(mass=980e3 / G):
    """At rest: Newton's method on the slope of the potential."""
    q = np.array([2.5, 0.0, 0.0, 0.0, 0.0])
    for _ in range(50):
        gradient = slope(lambda q: potential(q, 0.0, mass), q)
        near = 1e-6
        hesse = np.array([(slope(lambda q: potential(q, 0.0, mass), q + near * e) - gradient) / near for e in np.eye(5)])
        q = q - np.linalg.solve(hesse, gradient)
    return q


@pytest.fixture(scope="module")
def expected():
    """Two minutes of slewing, up to the loss of the load."""
    mass, q = 980e3 / G, start()
    times = np.round(np.arange(0, 120, 0.1), 10)
    found, y = [], np.concatenate([q, np.zeros(5)])
    for low, high in ((0.0, 5.0), (5.0, 35.0), (35.0, 119.9)):
        inside = times[(times >= low) & (times <= high)]
        solved = solve_ivp(rates, (low, high), y, "DOP853", inside, rtol=1e-9, atol=1e-10, args=(course, mass))
        y = solved.y[:, -1]
        found.append(solved.y[:, :-1] if high < 119 else solved.y)
    return times, np.concatenate(found, axis=1)


@pytest.mark.parametrize("standard", ENDS)
def test_against_an_independent_crane(tmp_path, standard, expected):
    fmu = built(tmp_path, "Sways")[standard]
    assert validate_fmu(fmu) == []
    times, y = expected
    runs = {"CoSimulation": {}, "ModelExchange": {"solver": "CVode", "relative_tolerance": 1e-10}}
    for kind, options in runs.items():
        found = simulate_fmu(fmu, fmi_type=kind, stop_time=119.9, output_interval=0.1, output=OUTPUTS, **options)
        at = np.searchsorted(found["time"], times - 1e-9)
        assert np.abs(found["time"][at] - times).max() < 1e-9
        reach = {"h_G": y[0], "phi_x": y[1], "theta_y": y[2]}
        reach["r_x"] = ROPE * np.sin(y[3]) * np.cos(y[4])
        reach["r_y"] = ROPE * np.sin(y[4])
        for name, series in reach.items():
            off = np.abs(found[name][at] - series).max() / np.ptp(series)
            print(standard, kind, name, off)
            assert off < 1e-6, name
        psi = np.array([course(t)[0] for t in times])
        assert np.abs(found["psi_sl"][at] - psi).max() < 1e-8


DAMAGE = """
[[hull.flooded]]
mu_f = "0.9"
l_f = "10 m"
b_f = "8 m"
d_f = "4.5 m"
x_f = "-20 m"
y_f = "-7 m"
[hull.tow]
F_p = "300 kN"
chi_p = "20 deg"
z_p = "5 m"
z_lp = "1 m"
"""


def test_at_rest_it_is_the_static_crane(tmp_path):
    """Before it slews nothing moves, at any angle, for a hull of sections and one with a flooded compartment under tow too: draft,
    heel and trim of the equilibrium."""
    still = ('["5 s", "3 deg/s"], ["35 s", "0 deg/s"]', '["5 s", "0 deg/s"], ["35 s", "0 deg/s"]')
    sections = "".join(
        f'\n[[hull.sections]]\nx_h = "{x} m"\npoints = ["{bottom} m, 0 m", "{top} m, 2 m", "{top} m, 4.5 m"]\n'
        for x, bottom, top in ((-30, 8, 11), (-20, 11, 12), (20, 11, 12), (30, 7, 9.5))
    )
    box = ('L     = "60 m"                # a box, whose middle is the origin\nB     = "24 m"\nD     = "4.5 m"\n', "")
    for i, psi in enumerate((0, 100, 215)):
        turn = ('l_R   = "20 m"', f'psi_sl = "{psi} deg"\nl_R = "20 m"')
        shapes = (("Box", []), ("Sections", [box, ("[hull.pedestal]", sections + "\n[hull.pedestal]")]),
                  ("Damaged", [("[hull.pedestal]", DAMAGE + "\n[hull.pedestal]")]))
        for name, shape in shapes:
            fmu = built(tmp_path, f"{name}{i}", still, turn, *shape)["FMI 3"]
            found = simulate_fmu(fmu, stop_time=60.0, output_interval=1.0, output=OUTPUTS)
            slopes = np.tan(found["theta_y"]) / np.cos(found["phi_x"])
            for moved, rest in ((found["phi_x"], "phi"), (np.arctan(slopes), "theta"), (found["T_m"], "T")):
                assert np.abs(moved - found[rest]).max() < 1e-10, (name, psi, rest)
            assert np.abs(found["S_R"] - 980e3).max() < 1e-10 * 980e3 and np.abs(found["r_x"]).max() < 1e-9


# No load, no tanks, no wind: heave, heel and pitch do not meddle where they are small.
BARE = [
    ('T_sl = "2 s" ', 'step = "20 ms"\nT_sl = "2 s" '),
    ('["0 s", "980 kN"], ["120 s", "0 kN"]', '["0 s", "0 kN"], ["120 s", "0 kN"]'),
    ('["5 s", "3 deg/s"]', '["5 s", "0 deg/s"]'),
    ('p_w   = "250 Pa"', 'p_w   = "0 Pa"'),
    ('x_m = "-0.8 m"', 'x_m = "0 m"'),
    ('x_m = "12 m"', 'x_m = "0 m"'),
    ('x_m = "-13.5 m"', 'x_m = "0 m"'),
    ('d_z = "1500 kN.s/m"', 'd_z = "0 kN.s/m"'),
    ('d_x = "20000 kN.m.s"', 'd_x = "0 kN.m.s"'),
    ('d_y = "150000 kN.m.s"', 'd_y = "0 kN.m.s"'),
]


def bare(folder, name):
    text = READY.read_text(encoding="utf-8")
    first = text.index("[[hull.tanks]]")
    tanks = text[first : text.index("[hull.pedestal]")]
    return built(folder, name, *BARE, (tanks, ""))["FMI 3"]


def test_small_motions_have_the_periods_of_closed_form(tmp_path):
    """Heave by ρ g A, heel by W GM, pitch by W GM_L, each over what moves; GM of a box: T/2 + B²/(12 T) − z_G."""
    fmu = bare(tmp_path, "Bare")
    whole = sum(w for w, *_ in SOLIDS)
    draft = whole / (RHO * G * L * B)
    high = sum(w * z for w, _, _, z in SOLIDS) / whole
    metacentric = [draft / 2 + side**2 / (12 * draft) - high for side in (B, L)]
    squares = {
        "h_G": RHO * G * L * B / (whole / G + MASS["m_a"]),
        "phi_x": whole * metacentric[0] / MASS["J_x"],
        "theta_y": whole * metacentric[1] / MASS["J_y"],
    }
    rest = simulate_fmu(fmu, stop_time=0.1, output_interval=0.1, output=list(squares))
    for name, square in squares.items():
        away = 1e-5
        found = simulate_fmu(
            fmu, stop_time=60.0, output_interval=0.05, output=list(squares), start_values={name: rest[name][0] + away}
        )
        moved = found[name] - rest[name][0]
        off = np.abs(moved - away * np.cos(math.sqrt(square) * found["time"])).max() / away
        print(name, 2 * math.pi / math.sqrt(square), off)
        assert off < 1e-5, name


def test_a_lost_load_rolls_as_far_as_the_areas_say(tmp_path):
    """Without damping, from rest at the side: the areas under the levers let the hull sink and rise as it heels, the motion has
    to move it; a percent apart."""
    undamped = [(f'{key} = "{value}', f'{key} = "0') for key, value in (("d_z", "1500"), ("d_x", "20000"), ("d_y", "150000"))]
    turn = ('l_R   = "20 m"', 'psi_sl = "90 deg"\nl_R = "20 m"')
    lost = ('["120 s", "0 kN"]', '["1 s", "0 kN"]')
    path = changed(tmp_path, "Lost", *undamped, turn, lost, ('["5 s", "3 deg/s"]', '["5 s", "0 deg/s"]'))
    lemnis("fmu", path, "--output", tmp_path)
    found = simulate_fmu(str(tmp_path / "Lost.fmu"), stop_time=20.0, output_interval=0.01, output=["phi_x", "phi_2", "phi_Q0"])
    before = found[found["time"] < 0.95]
    swing, told = found["phi_x"].min() - before["phi_Q0"][0], before["phi_2"][0] - before["phi_Q0"][0]
    print(swing, told)
    assert told < 0 and abs(swing / told - 1) < 0.02


def test_a_rope_that_would_push_ends_the_run(tmp_path):
    """Slewing thrown about faster than the load can follow: the call fails with a message, and no number is given."""
    text = READY.read_text(encoding="utf-8")
    told = text[text.index("omega_csl = {") : text.index("[hull.dynamics]")]
    fmu = built(tmp_path, "Slack", ('T_sl = "2 s"', 'T_sl = "0.1 s"'), (told, 'omega_csl = "0 deg/s"\nQ = "980 kN"\n\n'))["FMI 3"]
    signal = np.array([(0.0, 0.0), (1.0, 8.0), (20.0, 8.0)], dtype=[("time", float), ("omega_csl", float)])
    assert len(simulate_fmu(fmu, stop_time=5.0, output_interval=0.1)) == 51
    with pytest.raises(Exception, match="fmi3DoStep"):
        simulate_fmu(fmu, stop_time=20.0, output_interval=0.1, input=signal)
