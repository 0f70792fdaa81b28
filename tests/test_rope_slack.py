"""The rope of a drive that goes slack in motion and is caught: FMUs of the boom with a curved trunk, hung on a tackle whose drum a
motor's shaft turns, in FMPy, both standards and both interfaces, against pieces that SciPy solves between events of its own: of the
energies of `test_trunk_motion.py`, the rope's length by its anchors, and momentum at every blow. Nothing of the product is in it."""

import math
import re

import numpy as np
import pytest
from fmpy import read_model_description, simulate_fmu
from fmpy.validation import validate_fmu
from scipy.integrate import solve_ivp

from conftest import lemnis, words
from single_boom import ENDS, G
from test_commands import Stepped, course, written
from test_rope_drive import BEND, HUNG, J_M, L_M, TRAVEL, text
from test_trunk_motion import COULOMB, HEAD, J_B, J_T, Q, ROPE, START, VISCOUS

ARM = L_M / (2 * math.pi)
# Of drum and shaft, as the tackle feels it.
DRUM = J_M / ARM ** 2

# Moments of the motor and of the brake at the link, by the time from which they are: raised, let go by a motor that pays out faster than
# the boom falls; then reeled in and caught in motion, or the drum braked and the boom caught at rest.
REELED = [(0.0, 2.4e6, 0.0), (1.5, -3e6, 0.0), (1.8, 3.4e6, 0.0), (3.2, 1.7e6, 0.0)]
BRAKED = [(0.0, 2.4e6, 0.0), (1.5, -3e6, 0.0), (1.7, 0.0, 6e6)]
# A brake on a boom that rises: without its load on a rope slack begins as the pull falls to nothing, at no command's time.
PAUSED = {level: [(0.0, 3.4e6, 0.0), (1.2, 0.0, brake), (2.6, 2.2e6, 2e5)] for level, brake in (("rigid", 8e5), ("swing", 2.6e6))}
RUNS = {"reeled": (lambda _: REELED, 4.0), "braked": (lambda _: BRAKED, 3.0), "paused": (PAUSED.get, 4.0)}


class Crane:
    """What the boom, its load and the drum do between events, by Lagrange."""

    def __init__(self, swings):
        self.swings = swings
        self.bodies, self.whole, self.height = HUNG[0.0 if swings else Q]

    def load(self, y):
        """Place and speed of the load on its rope, in the plane."""
        at, travel, bend = HEAD(y[0])
        place, speed = np.array(y[-4:-2]), np.array(y[-2:])
        line = place - at
        long = float(np.hypot(*line))
        return place, speed, line / long, long, speed - travel * y[1], travel, bend

    def accelerations(self, y, inertia, force, free=True):
        """Of the bar, and of the load: under a force on the bar, a bar that does not move where it is not free."""
        if not self.swings:
            return (force / inertia if free else 0.0), []
        _, _, along, long, relative, travel, bend = self.load(y)
        ease = 1.0 / inertia if free else 0.0
        weight, arm = np.array([0.0, -G]), float(travel @ along)
        out = along @ (weight - bend * y[1] ** 2) + relative @ relative / long - arm * force * ease
        tension = out / (1 / Q + arm * arm * ease)
        assert tension > 0.0
        alpha = (force + arm * tension) * ease
        return alpha, list(weight - along * tension / Q)

    def force(self, y, inertia, moment):
        slope, weight = inertia.deriv(), self.height.deriv()
        return moment - VISCOUS * y[1] - 0.5 * slope(y[0]) * y[1] ** 2 - weight(y[0])

    def holds(self, y):
        """Moment on the bar at rest of weights and load, which drive, friction and stop must be against."""
        held = self.height.deriv()(y[0])
        if self.swings:
            _, _, along, long, relative, travel, _ = self.load(y)
            held -= float(travel @ along) * Q * (along @ np.array([0.0, -G]) + relative @ relative / long)
        return held


class Taut:
    def __init__(self, crane, y, moment, brake, way=None):
        self.crane, self.moment, self.brake = crane, moment, brake
        if way is None:
            way = np.sign(y[1])
            if way == 0.0:
                need = crane.holds(y) - moment
                way = 0.0 if abs(need) <= brake + COULOMB else -np.sign(need)
        self.way = way
        self.events = [self.rest, self.pull]

    def rates(self, _, y):
        crane = self.crane
        moment = self.moment - self.way * (COULOMB + self.brake)
        alpha, load = crane.accelerations(y, crane.whole(y[0]), crane.force(y, crane.whole, moment), self.way != 0.0)
        return [y[1], alpha, 0.0, 0.0, *(list(y[-2:]) + load if crane.swings else [])]

    def pull(self, _, y):
        """Of the tackle: what is left of the moment by inertia of shaft and drum, over its travel."""
        travel, bend = TRAVEL(y[0]), BEND(y[0])
        if self.way == 0.0:
            hold = self.crane.holds(y)
            side = -np.sign(travel)
            return min(side * self.moment + self.brake, side * hold + COULOMB)
        alpha = self.rates(0.0, y)[1]
        return -(self.moment - self.way * self.brake) / travel + DRUM * (travel * alpha + bend * y[1] ** 2)

    def rest(self, _, y):
        return self.way * y[1] if self.way else self.brake + COULOMB - abs(self.crane.holds(y) - self.moment)

    def after(self, which, y):
        if which == 0:
            return None, [y[0], 0.0, *y[2:]] if self.way else y
        return "slack", [y[0], y[1], 0.0, TRAVEL(y[0]) * y[1], *y[4:]]


class Slack:
    def __init__(self, crane, y, moment, brake):
        self.crane, self.moment, self.brake = crane, moment, brake
        self.way = np.sign(y[1])
        if self.way == 0.0:
            need = crane.holds(y)
            self.way = 0.0 if abs(need) <= COULOMB else -np.sign(need)
        self.turns = np.sign(y[3])
        pays = moment * np.sign(TRAVEL(y[0]))
        if self.turns == 0.0:
            self.turns = 0.0 if abs(pays) <= brake else np.sign(pays)
        self.events = [self.rest, self.stop, self.room]

    def rates(self, _, y):
        crane, travel = self.crane, TRAVEL(y[0])
        force = crane.force(y, crane.bodies, -self.way * COULOMB)
        alpha, load = crane.accelerations(y, crane.bodies(y[0]), force, self.way != 0.0)
        gains = (self.moment / travel - self.turns * self.brake / abs(travel)) / DRUM if self.turns else 0.0
        return [y[1], alpha, y[3] - travel * y[1], gains, *(list(y[-2:]) + load if crane.swings else [])]

    def rest(self, _, y):
        return self.way * y[1] if self.way else 1.0

    def stop(self, _, y):
        return self.turns * y[3] if self.turns else 1.0

    def room(self, t, y):
        return y[2]

    def after(self, which, y):
        y = list(y)
        if which == 0:
            y[1] = 0.0
        if which == 1:
            y[3] = 0.0
        return ("taut", self.caught(y)) if which == 2 else ("slack", y)

    def caught(self, y):
        """Momentum of bar, load and drum under impulses of tackle and load's rope: as unknown as the changes of speed."""
        travel, crane = TRAVEL(y[0]), self.crane
        size = 6 if crane.swings else 3
        a, b = np.zeros((size, size)), np.zeros(size)
        # Bar, drum and impulse of the tackle; the load's speed and its rope's impulse.
        a[0, 0], a[0, 2] = crane.bodies(y[0]), travel
        a[1, 1], a[1, 2] = 1.0, -1.0 / DRUM
        a[2, 0], a[2, 1], b[2] = travel, -1.0, y[3] - travel * y[1]
        if crane.swings:
            *_, along, _, relative, arm, _ = crane.load(y)
            a[0, 5] = -float(arm @ along)
            a[3, 3] = a[4, 4] = Q
            a[3, 5], a[4, 5] = along
            a[5, 3:5], a[5, 0], b[5] = along, -float(arm @ along), -relative @ along
        change = np.linalg.solve(a, b)
        assert change[2] > 0.0 and (not crane.swings or change[5] > 0.0)
        y = [y[0], y[1] + change[0], 0.0, 0.0, *y[4:]]
        if crane.swings:
            y[-2:] = np.array(y[-2:]) + change[3:5]
        return y


def solved(crane, plan, times):
    """States at times, and what happened when: by pieces, each to its own event."""
    place = [*(HEAD(START)[0] - [0.0, ROPE]), 0.0, 0.0] if crane.swings else []
    y, mode, t, happened, found = [START, 0.0, 0.0, 0.0, *place], "taut", 0.0, [], {}
    ends = [at for at, *_ in plan[1:]] + [times[-1]]
    for (_, moment, brake), end in zip(plan, ends):
        while t < end:
            piece = Taut(crane, y, moment, brake) if mode == "taut" else Slack(crane, y, moment, brake)
            if mode == "taut" and piece.pull(t, y) < 0.0:
                mode, y = piece.after(1, y)
                happened.append((t, mode))
                continue
            begun, events = t, []
            for event in piece.events:
                # What begins at zero is looked at a little later.
                at = (lambda event: lambda t, y: event(t, y) if t > begun + 1e-7 else 1.0)(event)
                at.terminal, at.direction = True, -1
                events.append(at)
            run = solve_ivp(piece.rates, (t, end), y, method="DOP853", rtol=1e-12, atol=1e-13, max_step=0.02, events=events,
                            dense_output=True)
            assert run.status >= 0, run.message
            found |= {at: run.sol(at) for at in times if t <= at <= run.t[-1]}
            t, y = run.t[-1], list(run.y[:, -1])
            if run.status == 1:
                which = next(i for i, at in enumerate(run.t_events) if len(at))
                following, y = piece.after(which, y)
                if following not in (None, mode):
                    mode = following
                    happened.append((t, mode))
    return np.array([found[at] for at in times]), happened


def scene(swings, plan, more=""):
    """The boom on its tackle, told over time."""
    level = "swing" if swings else "rigid"
    moments = course([(t, m) for t, m, _ in plan], "steps")
    brakes = course([(t, b) for t, _, b in plan], "steps")
    rope = f'l_R = "{ROPE} m"\n' if swings else ""
    dynamics = (f'[luffing.dynamics]\nJ_b = "{J_B} kg.m2"\nJ_t = "{J_T} kg.m2"\nc_v = "{VISCOUS / 1e3} kN.m.s"\n'
                f'M_F = "{COULOMB / 1e3} kN.m"\nM_A = {moments}\nM_S = {brakes}\nstep = "1 ms"\n{rope}{more}\n')
    told = text().replace("[luffing]\n", f'[luffing]\nfidelity = "{level}"\n', 1)
    return told.replace("[luffing.limits]", dynamics + "[luffing.limits]", 1)


@pytest.fixture(scope="module", params=[(level, plan) for level in ("rigid", "swing") for plan in RUNS], ids="-".join)
def case(request, tmp_path_factory):
    level, name = request.param
    plan, stop = RUNS[name]
    plan = plan(level)
    crane = Crane(level == "swing")
    times = [round(0.05 * i, 10) for i in range(round(stop / 0.05) + 1)]
    told = re.sub(r'^name\s*=.*$', 'name = "SlackRope"', scene(crane.swings, plan), count=1, flags=re.M)
    paths = written(tmp_path_factory.mktemp(f"{level}_{name}"), "SlackRope", told)
    found, happened = solved(crane, plan, times)
    return crane, paths, times, found, happened


def outputs(crane):
    return ["phi", "omega", "delta_l", "v_tl"] + (["phi_R"] if crane.swings else [])


def apart(crane, run, found):
    """How far a run is from what was solved, over what each quantity comes to at most."""
    far = [np.max(np.abs(run[name] - found[:, i])) / np.max(np.abs(found[:, i])) for i, name in enumerate(outputs(crane)[:4])]
    if crane.swings:
        heads = np.array([HEAD(phi)[0] for phi in found[:, 0]])
        at = np.arctan2(found[:, -4] - heads[:, 0], heads[:, 1] - found[:, -3])
        far.append(np.max(np.abs(run["phi_R"] - at)))
    return max(far)


def test_a_run_is_that_of_pieces_solved_elsewhere(case):
    crane, paths, times, found, happened = case
    assert [mode for _, mode in happened[:2]] == ["slack", "taut"], happened
    assert np.max(found[:, 2]) > 0.01
    runs = {}
    for standard, path in paths.items():
        assert not validate_fmu(path)
        fmu = Stepped(path)
        runs[standard] = np.array(fmu.run(times, outputs(crane)))
        fmu.close()
    rows = {name: runs["FMI 3"][:, i] for i, name in enumerate(outputs(crane))}
    # A blow within a communication step is at its own time, so that every time is one between events.
    assert apart(crane, rows, found) < 1e-8, apart(crane, rows, found)
    assert np.array_equal(runs["FMI 2"], runs["FMI 3"])


@pytest.mark.parametrize("standard", ENDS)
def test_an_importer_that_solves_it_finds_the_same(case, standard):
    crane, paths, times, found, _ = case
    run = simulate_fmu(paths[standard], fmi_type="ModelExchange", stop_time=times[-1], output_interval=0.05,
                       relative_tolerance=1e-10, record_events=False, output=outputs(crane))
    assert apart(crane, run, found) < 5e-5, apart(crane, run, found)


STEP = 0.001


def stepped(path, names, stop):
    """An FMU's variables at every millisecond."""
    fmu = Stepped(path)
    rows = np.array(fmu.run([round(STEP * i, 10) for i in range(round(stop / STEP) + 1)], names))
    fmu.close()
    return dict(zip(names, rows.T))


def energy(crane, at, i, stiffness=0.0):
    """Of bodies, drum and load, with what its rope is stretched by."""
    phi, omega = at["phi"][i], at["omega"][i]
    slack = at["delta_l"][i] != 0.0 or at["v_tl"][i] != 0.0
    drum = 0.5 * DRUM * (at["v_tl"][i] if slack else TRAVEL(phi) * omega) ** 2
    own = 0.5 * crane.bodies(phi) * omega ** 2 + crane.height(phi) + drum
    if not crane.swings:
        return own
    head, swing, far = HEAD(phi), at["phi_R"][i], at["s_Q"][i]
    along, across = np.array([math.sin(swing), -math.cos(swing)]), np.array([math.cos(swing), math.sin(swing)])
    speed = head[1] * omega + across * far * at["omega_R"][i] + along * at["v_Q"][i]
    stretch = max(far - at["l_R"][i], 0.0)
    return own + Q * (0.5 * speed @ speed + G * (head[0] + along * far)[1]) + 0.5 * stiffness * stretch ** 2


POWERS = ["phi", "omega", "delta_l", "v_tl", "M_R", "P_Ml", "P_bl", "W_blow"]
LOAD = ["phi_R", "omega_R", "l_R", "s_Q", "v_Q"]


def closes(crane, at, stiffness=0.0, lost=0.0):
    """What the motor gives is what the bodies and the drum have more, friction, brakes and rope take, and blows have taken."""
    power = at["P_Ml"] - at["P_bl"] + at["M_R"] * at["omega"] - lost
    assert at["W_blow"][-1] > 1e3 and np.max(at["P_bl"]) >= 0.0
    # Between commands and blows the trapezoids are exact to the square of their width.
    work = np.sum(0.5 * (power[1:] + power[:-1])) * STEP
    gained = energy(crane, at, -1, stiffness) - energy(crane, at, 0, stiffness) + at["W_blow"][-1]
    assert abs(work - gained) < 3e-3 * np.sum(np.abs(power)) * STEP, (work, gained)


def test_its_energy_closes(case, tmp_path):
    crane, paths, times, *_ = case
    closes(crane, stepped(paths["FMI 3"], POWERS + (LOAD if crane.swings else []), times[-1]))


# Beside it: a load's rope that gives way; ground, above where the load would hang, that it is lifted from and meets as the boom falls; a continuous controller in the motor's place, which
# then lowers faster than the boom falls.
STIFFNESS = 1.2e6
HOISTING = f'[luffing.hoisting]\nl_R = "{ROPE} m"\nc_R = "{STIFFNESS / 1e3} kN/m"\nd_R = "20 kN.s/m"\n\n'
ABOVE = 0.03
CONTROL = ('[luffing.control]\nK_pA = "40000 kN.m.s"\nK_iA = "40 MN.m"\na_A = "0.7 rad/s2"\nM_maxA = "3500 kN.m"\nomega_cA = '
           + course([(0.0, 2.0), (1.2, -20.0), (1.7, 0.0), (2.4, 1.0)], "steps", "deg/s", 1.0) + "\n\n")


@pytest.mark.parametrize("beside", ["elastic", "ground", "controlled"])
def test_its_energy_closes_beside(beside, tmp_path):
    crane = Crane(True)
    told = re.sub(r'^name\s*=.*$', 'name = "SlackRope"', scene(True, BRAKED), count=1, flags=re.M)
    names, stiffness = POWERS + LOAD, 0.0
    if beside == "controlled":
        told = re.sub(r"^M_[AS] = .*\n", "", told, flags=re.M).replace("[luffing.limits]", CONTROL + "[luffing.limits]", 1)
    else:
        # A rope that meets ground gives way.
        told = told.replace(f'l_R = "{ROPE} m"\n', "", 1)
        stiffness, names = STIFFNESS, [*names, "S_R"]
        more = HOISTING
        if beside == "ground":
            height = HEAD(START)[0][1] - ROPE - Q * G / STIFFNESS + ABOVE
            more, names = f'{HOISTING}[luffing.ground]\ny_G = "{height:.9f} m"\n\n', [*names, "N_G"]
        told = told.replace("[luffing.limits]", more + "[luffing.limits]", 1)
    path = written(tmp_path, "SlackRope", told)["FMI 3"]
    at = stepped(path, names, 3.0)
    assert np.max(at["delta_l"]) > 0.01
    if beside == "ground":
        off = np.flatnonzero(at["N_G"] == 0.0)
        assert at["N_G"][0] > 0.0 and off.size and np.max(at["N_G"][off[0]:]) > 0.0
    # By the rope's damping, and what is left in one that has let go; its hoist rests.
    lost = (at["S_R"] - stiffness * np.maximum(at["s_Q"] - at["l_R"], 0.0)) * at["v_Q"] if stiffness else 0.0
    closes(crane, at, stiffness, lost)


def test_a_book_tells_it(tmp_path):
    """Its account of energy closes, and events are named in every language."""
    path = tmp_path / "slack.toml"
    path.write_text(scene(True, BRAKED), encoding="utf-8")
    assert "identities that hold" in lemnis("check", path)
    for language in ("en", "zh", "bg"):
        events = words(language)["event"]
        assert events["tackle_slack"] and events["tackle_taut"]


def test_what_may_go_slack_is_described(case):
    crane, paths, *_ = case
    for path in paths.values():
        variables = {variable.name: variable for variable in read_model_description(path).modelVariables}
        assert {"delta_l", "v_tl", "der(delta_l)", "der(v_tl)", "P_Ml", "P_bl", "z.tackle"} <= set(variables)
        assert "z.pull" not in variables
