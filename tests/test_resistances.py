"""What Lemnis says of the moments that a luffing drive overcomes, against an oracle of the geometry alone
(`tests/oracles/luffing_resistances.py`, where each moment is found by power and by equilibrium)."""

import csv
import io
import json
from functools import cached_property
from math import pi, radians, sqrt

import numpy as np
import pytest

from conftest import ROOT, lemnis
from oracles import luffing_resistances as oracle

with open(ROOT / "tests/oracles/luffing_resistances.csv", encoding="utf-8") as file:
    ORACLE = list(csv.DictReader(file))


def table(scene):
    """Columns without their units, in SI, by the angle in degrees; of a ready scene by its name."""
    path = ROOT / f"models/scenes/{scene}.toml" if isinstance(scene, str) else scene
    rows = list(csv.reader(io.StringIO(lemnis("check", path, "--csv"))))
    names, units = zip(*(head[:-1].split(" [") for head in rows[0]))
    scale = [1e3 if unit.startswith("kN") else 1.0 for unit in units]
    return {float(row[0]): {name: float(x) * by for name, x, by in zip(names, row, scale) if x} for row in rows[1:]}


# Moment of the own weights left by the balance, and the drive's force that presses its ends apart.
@pytest.mark.parametrize("scene, own, force", [
    ("portal_004_new", lambda row: row["dM"], lambda row: row["F_d"]),
    ("rope_luffing", lambda row: -row["M_G"], lambda row: -row["T"]),
])
def test_own_weights_load_and_drive_at_rest_are_those_of_the_oracle(scene, own, force):
    found = table(scene)
    # Own weights and load are those of the scenes in case I.
    rows = [row for row in ORACLE if row["crane"] == scene and row["case"] == "I"]
    assert len(rows) >= 20
    for row in rows:
        expected = {name: float(row[name]) for name in ("own", "load", "sum", "force")}
        at = found[float(row["angle"])]
        # The greatest moments that these are small differences of.
        size = 4e6
        assert abs(own(at) - expected["own"]) <= 1e-13 * size, row["angle"]
        assert abs(-at["M_Q"] - expected["load"]) <= 1e-13 * size, row["angle"]
        rest = expected["own"] + expected["load"]
        arm = abs(expected["sum"] / expected["force"])
        assert abs(force(at) - expected["force"] / expected["sum"] * rest) <= 1e-13 * size / min(arm, 1.0), row["angle"]


MOMENTS = ("load", "sway", "wind", "centrifugal", "inertia", "slope", "friction", "sum")


@pytest.mark.parametrize("scene, crane", [("portal_004_drive", "portal_004_new"), ("rope_luffing_drive", "rope_luffing")])
def test_every_moment_of_every_case_is_that_of_the_oracle(scene, crane):
    found = table(scene)
    rows = [row for row in ORACLE if row["crane"] == crane]
    assert len(rows) >= 60 and {row["case"] for row in rows} == {"I", "II", "III"}
    for row in rows:
        at, case = found[float(row["angle"])], ("I", "II", "III").index(row["case"]) + 1
        expected = {name: float(row[name]) for name in ("own", *MOMENTS, "force")}
        # Own weights and balance are small differences of great moments.
        size = max(abs(x) for name, x in expected.items() if name != "force")
        assert abs(at["M_r_own"] - expected["own"]) <= 1e-12 * size, row
        for name in MOMENTS:
            assert abs(at[f"M_r_{name}[{case}]"] - expected[name]) <= 1e-12 * size, (name, row)
        assert abs(at[f"F_r[{case}]"] - expected["force"]) <= 1e-12 * abs(expected["force"]), row


# Of the ready scenes: P_N, n_N in 1/s, k_a, J_M, l_M, eta_M; each brake's delay and torque; safety in each case.
MOTORS = {
    "portal_004_drive": (oracle.DoubleLink(), (7500, 970 / 60, 1.7, 0.7, 0.0031, 0.85), [(0.2, 50), (1.2, 60)]),
    "rope_luffing_drive": (oracle.RopeBoom(), (11000, 970 / 60, 1.7, 1.0, 0.0031, 0.85), [(0.3, 200)]),
}
SAFETY = {"I": 1.25, "II": 1.25, "III": 1.15}


class Place:
    """What the oracle knows of a case at an angle: the travel of the drive and of the head for one radian, the bodies'
    inertia, and moments: all that holds, inertia, friction."""

    def __init__(self, crane, case, phi):
        power, _, stroke = oracle.resistances(crane, case, oracle.mpf(phi))
        self.at, self.stroke = (crane, case, oracle.mpf(phi)), float(stroke)
        self.slowing, self.friction = float(power[5]), float(power[7])
        self.holds = float(sum(power)) - self.slowing - self.friction

    @cached_property
    def inertia(self):
        """By which the moment of inertia falls for each unit of the luffing angle's acceleration."""
        crane, case, phi = self.at
        more = oracle.resistances(crane, (*case[:6], str(oracle.mpf(case[6]) + 1)), phi)[0]
        return (self.slowing - float(more[5])) * self.stroke

    @cached_property
    def head(self):
        crane, _, phi = self.at
        return float(oracle.first(lambda x: oracle.re(crane.hangs(x)[0]), phi))


def through(force, speed, eta):
    """A force of the drive as the motor feels it."""
    return force / eta if force * speed > 0 else force * eta if force * speed < 0 else force


def both_ways(place, v, eta):
    """Power of the motor on the way there and on the way back, where friction alone is the other way round."""
    forces = [-(place.holds + place.slowing + sign * place.friction) / place.stroke for sign in (1, -1)]
    return [through(force, way, eta) * way for force, way in zip(forces, (v, -v))]


def stopped(brakes, inertia, speed, against):
    """Time, angle and last deceleration: where the integral of the torques has used up the momentum."""
    acts = lambda t: against + sum(torque for delay, torque in brakes if t >= delay)
    ends = [0.0, *(delay for delay, _ in brakes), 1e3]
    momentum, angle = inertia * speed, 0.0
    for start, end in zip(ends, ends[1:]):
        torque = acts(start)
        if torque * (end - start) >= momentum:
            rest = momentum / torque
            return start + rest, angle + momentum / inertia * rest / 2, torque / inertia
        angle += (momentum - torque * (end - start) / 2) / inertia * (end - start)
        momentum -= torque * (end - start)
    raise AssertionError("does not stop")


@pytest.mark.parametrize("scene", MOTORS)
def test_motor_and_brakes_are_those_of_the_oracle(scene):
    crane, (p_n, n_n, k_a, j_m, l_m, eta), brakes = MOTORS[scene]
    found = table(scene)
    arm = l_m / (2 * pi)
    for degrees in [float(x) for x in crane.turned[::6]]:
        at = found[degrees]
        for number, (name, case) in enumerate(oracle.CASES.items(), 1):
            place, v = Place(crane, case, radians(degrees)), float(case[5])
            got = lambda id: at[f"{id}[{number}]"]
            force = -(place.holds + place.slowing + place.friction) / place.stroke
            expected = {"T_M": through(force, v, eta) * arm}
            hold = -place.holds / place.stroke * arm
            expected |= {"T_H": hold, "T_K": SAFETY[name] * abs(hold) * eta}
            if v:
                there, back = both_ways(place, v, eta)
                steady = through(-(place.holds + place.friction) / place.stroke, v, eta) * arm * (1 if v > 0 else -1)
                reduced, speed = place.inertia * (arm / place.stroke) ** 2, abs(v) / arm
                start = (j_m + reduced / eta) * speed / (k_a * p_n / (2 * pi * n_n) - steady)
                time, angle, slows = stopped(brakes, j_m + reduced * eta, speed, steady)
                head = abs(place.head / place.stroke)
                expected |= {"P_M": there / 1e3, "P_c": sqrt((there**2 + back**2) / 2) / 1e3, "T_0": steady,
                             "t_start": start, "a_start": head * abs(v) / start, "t_stop": time,
                             "s_stop": angle * arm * 1e3, "a_stop": head * arm * slows}
            for id, value in expected.items():
                # Balanced moments are small differences of great ones.
                assert abs(got(id) - value) <= 1e-9 * max(abs(value), 1.0), (degrees, name, id, got(id), value)


@pytest.mark.parametrize("scene", MOTORS)
def test_heating_is_the_root_mean_square_in_time_of_the_way_there_and_back(scene):
    crane, (*_, eta), _ = MOTORS[scene]
    case = oracle.CASES["I"]
    v = float(case[5])
    summary = json.loads(lemnis("check", ROOT / f"models/scenes/{scene}.toml", "--json"))["summary"]
    nodes, weights = np.polynomial.legendre.leggauss(7)
    ends = [radians(x) for x in ((44, 82) if crane.name.startswith("portal") else (25, 78))]
    # The power has a kink where its sign changes: each piece between kinks has a rule of its own.
    grid = np.linspace(*ends, 40)
    signs = [[p > 0 for p in both_ways(Place(crane, case, phi), v, 1.0)] for phi in grid]
    kinks = set()
    for way in (0, 1):
        for a, b, one, other in zip(grid, grid[1:], signs, signs[1:]):
            if one[way] != other[way]:
                for _ in range(22):
                    middle = (a + b) / 2
                    if (both_ways(Place(crane, case, middle), v, 1.0)[way] > 0) == one[way]:
                        a = middle
                    else:
                        b = middle
                kinks.add(a)
    places = [ends[0], *sorted(kinks), ends[1]]
    places = np.concatenate([np.linspace(a, b, 6)[:-1] for a, b in zip(places, places[1:])] + [ends[1:]])
    work = time = 0.0
    for a, b in zip(places, places[1:]):
        for x, w in zip(nodes, weights):
            place = Place(crane, case, (a + b) / 2 + (b - a) / 2 * x)
            slowness = abs(place.stroke / v) * w * (b - a) / 2
            time += slowness
            work += slowness * sum(p**2 for p in both_ways(place, v, eta)) / 2
    assert summary["t_luff"]["value"] == pytest.approx(time, rel=1e-9)
    assert summary["P_rms"]["value"] == pytest.approx(sqrt(work / time), rel=1e-6)


def test_a_stop_in_closed_form_is_near_that_of_the_moving_mechanism():
    """With moments and inertia as they change on the way: the mechanism's own equation, stepped in small steps."""
    scene, case = "portal_004_drive", oracle.CASES["II"]
    crane, (_, _, _, j_m, l_m, eta), brakes = MOTORS[scene]
    arm, v, degrees = l_m / (2 * pi), float(case[5]), 62.0
    at, start = table(scene)[degrees], Place(crane, (*case[:6], "0"), radians(degrees))

    def slowing(drive, place, t, speed):
        """Of the shaft, whose drive has gone that far."""
        steady = through(-(place.holds + place.friction) / place.stroke, v, eta) * arm
        torque = steady + sum(torque for delay, torque in brakes if t >= delay)
        return torque / (j_m + place.inertia * (arm / place.stroke) ** 2 * eta)

    # The mechanism hardly turns in a stop: its moments are taken at three places and between them by a parabola.
    far = [0.0, 0.02, 0.04]
    places = [Place(crane, (*case[:6], "0"), radians(degrees) + x / start.stroke) for x in far]
    drive, t, speed, step = 0.0, 0.0, abs(v) / arm, 1e-4
    while speed > 0:
        between = Place.__new__(Place)
        for name in ("holds", "friction", "stroke", "inertia"):
            setattr(between, name, float(np.polyval(np.polyfit(far, [getattr(p, name) for p in places], 2), drive)))
        speed -= step * slowing(drive, between, t, speed)
        drive, t = drive + step * speed * arm, t + step
    assert at["t_stop[2]"] == pytest.approx(t, rel=0.02)
    assert at["s_stop[2]"] == pytest.approx(drive * 1e3, rel=0.02)


def scene_of(tmp_path, name, *changes):
    """A ready scene with some of its text changed."""
    text = (ROOT / f"models/scenes/{name}.toml").read_text(encoding="utf-8")
    for old, new in changes:
        assert text.count(old) == 1, old
        text = text.replace(old, new)
    path = tmp_path / "scene.toml"
    path.write_text(text, encoding="utf-8")
    return path


@pytest.mark.parametrize("arm", [11.05, 8.4])
def test_unbalanced_moments_are_the_travels_of_their_forces(tmp_path, arm):
    """Of the publication's eight each force times the travel of its point, which the oracle finds by differences; the rocker
    by half at the jib's tail, and as it is."""
    scene = scene_of(tmp_path, "portal_004_drive", ('s_3   = "11.05 m"', f's_3 = "{arm} m"'), ('s_w = "11.05 m"', 's_w = "9 m"'),
                     ('dM_max    = "100 kN.m"', 'dM_max = "300 kN.m"'))
    found, crane = table(scene), oracle.DoubleLink()
    boom, jib, rocker, _ = crane.bodies
    place = lambda body, at: lambda x: crane.placed(x)[body][0] + at * crane.placed(x)[body][1]
    travel = lambda f, phi: oracle.first(f, oracle.mpf(phi))
    up, out = lambda f: lambda x: oracle.im(f(x)), lambda f: lambda x: oracle.re(f(x))
    tail = place(2, crane.rocker)
    for degrees in [float(x) for x in crane.turned[::3]]:
        at, phi = found[degrees], radians(degrees)
        weigh = lambda weight, f: -float(weight * travel(up(f), phi))
        g = oracle.G
        expected = {
            "M_u_tie": weigh(rocker.mass * g / 2, tail),
            "M_x_tie": weigh(rocker.mass * g, place(2, oracle.mpf(arm))),
            "M_u_trunk": weigh(jib.mass * g, place(1, jib.centre)),
            "M_u_boom": weigh(boom.mass * g, place(0, boom.centre)),
        }
        expected |= {"M_x_trunk": expected["M_u_trunk"], "M_x_boom": expected["M_u_boom"]}
        for number, case in enumerate(oracle.CASES.values(), 1):
            share, sway, pressure = (oracle.mpf(x) for x in case[:3])
            push = lambda area, f: float(pressure * area * travel(out(f), phi))
            head = place(1, crane.head)
            one = {
                "M_u_load": weigh(share * crane.load, head),
                "M_u_rope": float(share * crane.load * oracle.tan(oracle.rad(sway)) * travel(out(head), phi)),
                "M_u_tie_wind": push(rocker.area / 2, tail),
                "M_x_tie_wind": push(rocker.area, place(2, oracle.mpf(9))),
                "M_u_trunk_wind": push(jib.area, place(1, jib.middle)),
                "M_u_boom_wind": push(boom.area, place(0, boom.middle)),
            }
            one |= {"M_x_trunk_wind": one["M_u_trunk_wind"], "M_x_boom_wind": one["M_u_boom_wind"]}
            expected |= {f"{name}[{number}]": value for name, value in one.items()}
        for name, value in expected.items():
            assert abs(at[name] - value) <= 1e-12 * max(abs(value), 1e3), (degrees, name, at[name], value)


def test_coefficients_are_those_of_the_greatest_moments(tmp_path):
    path = ROOT / "models/scenes/portal_004_drive.toml"
    found, crane = json.loads(lemnis("check", path, "--json")), oracle.DoubleLink()
    phi = [radians(x) for x in range(44, 83)]
    hangs = lambda x: crane.hangs(x)[0]
    rise = max(abs(float(oracle.first(lambda x: oracle.im(hangs(x)), oracle.mpf(x)))) for x in phi)
    reach = max(float(oracle.re(hangs(oracle.mpf(x)))) for x in phi)
    # Both are greatest at an end of the range.
    assert found["summary"]["C_Q"]["value"] == pytest.approx(rise / reach, rel=1e-11)
    at = table("portal_004_drive")
    own, alone = ([abs(row[name]) for row in at.values()] for name in ("dM", "M_G"))
    assert found["summary"]["C_G"]["value"] == pytest.approx(max(own) / max(alone), rel=1e-11)


MOTOR = 'n_N      = "970 1/min"'
FASTER = [(MOTOR, 'n_N = "1460 1/min"'), ('P_N      = "7.5 kW"', 'P_N = "30 kW"')]


def start(kind, **keys):
    lines = "".join(f'{key} = "{value}"\n' for key, value in keys.items())
    return ("[cases.brake]               # soft", f'[cases.start]\nkind = "{kind}"\n{lines}\n[cases.brake]')


def test_a_start_along_the_slip_curve_is_that_of_the_integral_and_of_its_closed_form(tmp_path):
    mp = oracle.mp
    scene = scene_of(tmp_path, "portal_004_drive", *FASTER, start("slip", lambda_bd="2.6", n_0="1500 1/min"))
    found, rated = table(scene), 30e3 / (2 * pi * 1460 / 60)
    slip_n = 1 - 1460 / 1500
    s_k = slip_n * (2.6 + sqrt(2.6**2 - 1))
    signs = set()
    for degrees, at in found.items():
        for number, v in ((1, -0.05), (2, 0.06)):
            s_f, t_0, inertia = 1 - abs(v) / 0.0031 / (1500 / 60), at[f"T_0[{number}]"], at[f"J_start[{number}]"]
            torque = lambda s: 2 * 2.6 * rated / (s / s_k + s_k / s)
            ends = [s_f, s_k, 1] if s_f < s_k else [s_f, 1]
            integral = mp.quad(lambda s: 1 / (torque(s) - t_0), ends)
            time = float(integral) * inertia * 2 * pi * 1500 / 60
            # Partial fractions of (s² + s_k²) / (2 T_k s_k s − T_0 (s² + s_k²)).
            w = mp.mpf(t_0) / (2.6 * rated)
            root = mp.sqrt(1 - w * w)
            low, high = s_k * (1 - root) / w, s_k * (1 + root) / w
            part = lambda s: s + ((high**2 + s_k**2) * mp.log(abs(s - high)) - (low**2 + s_k**2) * mp.log(abs(s - low))) / (high - low)
            closed = -float((part(mp.mpf(1)) - part(mp.mpf(s_f))) / t_0) * inertia * 2 * pi * 1500 / 60
            assert closed == pytest.approx(time, rel=1e-12)
            assert at[f"t_slip[{number}]"] == pytest.approx(time, rel=1e-11), (degrees, number)
            assert at[f"s_f[{number}]"] == pytest.approx(s_f, rel=1e-12)
            signs.add(t_0 > 0)
    assert signs == {True, False}


def test_a_start_along_the_slip_curve_is_that_of_an_integration_in_time(tmp_path):
    from scipy.integrate import solve_ivp

    scene = scene_of(tmp_path, "portal_004_drive", *FASTER, start("slip", lambda_bd="2.6", n_0="1500 1/min"))
    at, rated = table(scene)[62.0], 30e3 / (2 * pi * 1460 / 60)
    s_k, full = (1 - 1460 / 1500) * (2.6 + sqrt(2.6**2 - 1)), 2 * pi * 1500 / 60

    def speeds_up(t, y):
        slip = 1 - y[0] / full
        return [(2 * 2.6 * rated / (slip / s_k + s_k / slip) - at["T_0[2]"]) / at["J_start[2]"]]

    reached = lambda t, y: y[0] - 2 * pi * 0.06 / 0.0031
    reached.terminal = True
    run = solve_ivp(speeds_up, [0, 100], [0.0], events=reached, rtol=1e-11, atol=1e-11)
    assert at["t_slip[2]"] == pytest.approx(run.t_events[0][0], rel=1e-9)


def test_a_start_of_an_inertia_alone_has_a_closed_form():
    """That which the book prints of the integral."""
    mp = oracle.mp
    for s_k, s_f in ((0.1, 0.02), (0.3, 0.4), (0.05, 0.9)):
        integral = mp.quad(lambda s: (s / s_k + s_k / s) / 2, [s_f, 1])
        assert float(integral) == pytest.approx(((1 - s_f**2) / (2 * s_k) + s_k * float(mp.log(1 / s_f))) / 2, rel=1e-13)


def test_an_inverter_keeps_its_ramp_as_far_as_its_torque_allows(tmp_path):
    rated, seen = 30e3 / (2 * pi * 1460 / 60), set()
    for ramp, limit in ((0.02, 1.5), (4.0, 1.5)):
        found = table(scene_of(tmp_path, "portal_004_drive", *FASTER, start("inverter", t_r=f"{ramp} s", lambda_inv=limit)))
        for at in found.values():
            for number, v in ((1, 0.05), (2, 0.06)):
                momentum, t_0 = at[f"J_start[{number}]"] * 2 * pi * v / 0.0031, at[f"T_0[{number}]"]
                time = max(ramp, momentum / (limit * rated - t_0))
                seen.add(time > ramp)
                assert at[f"t_inv[{number}]"] == pytest.approx(time, rel=1e-12)
                assert at[f"T_ramp[{number}]"] == pytest.approx(t_0 + momentum / ramp, rel=1e-9)
    assert seen == {True, False}


def test_a_start_of_an_engine_is_that_of_an_integration_in_time(tmp_path):
    from scipy.integrate import solve_ivp

    curve = [(700.0, 220.0), (1000.0, 300.0), (1460.0, 200.0), (1700.0, 90.0)]
    points = "".join(f'[[cases.start.curve]]\nn_en = "{n} 1/min"\nT_en = "{torque} N.m"\n' for n, torque in curve)
    old, new = start("engine", n_idle="800 1/min", n_gov="1700 1/min")
    scene = scene_of(tmp_path, "portal_004_drive", *FASTER, (old, new.replace("[cases.brake]", points + "[cases.brake]")))
    found, turns = table(scene), 2 * pi / 60
    speeds, torques = ([point[k] for point in curve] for k in (0, 1))
    gives = lambda n: float(np.interp(n, speeds, torques))
    for degrees, at in found.items():
        for number, v in ((1, 0.05), (2, 0.06)):
            goal = v / 0.0031 * 60
            against, inertia = at[f"T_0[{number}]"], at[f"J_start[{number}]"]
            time = (inertia - 0.7) * 800.0 * turns / (gives(800.0) - against)
            inner = [n for n in speeds if 800.0 < n < goal]
            for low, high in zip((800.0, *inner), (*inner, goal)):
                reached = lambda t, y: y[0] - high
                reached.terminal = True
                run = solve_ivp(lambda t, y: [(gives(y[0]) - against) / inertia / turns], [0, 300], [low], events=reached, rtol=1e-12, atol=1e-9)
                time += run.t_events[0][0]
            assert at[f"t_eng[{number}]"] == pytest.approx(time, rel=1e-8), (degrees, number)


def test_a_standard_gives_a_part_of_the_wind_at_work_for_the_motors_heating(tmp_path):
    scene = scene_of(tmp_path, "portal_004_drive", ('p_w     = "-75 Pa"            # wind, from the front\n', ""),
                     ("[[cases.case]]\nname    = \"I\"\n", "standard = \"GB/T 3811\"\n\n[[cases.case]]\nname    = \"I\"\n"))
    at = table(scene)[62.0]
    # 0.6 of case II's 250 Pa; the moment is proportional to the pressure.
    assert at["M_r_wind[1]"] == pytest.approx(0.6 * at["M_r_wind[2]"], rel=1e-12)
