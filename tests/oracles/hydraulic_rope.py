"""Reference of a luffing cylinder whose load hangs on a rope that is reeled and goes slack, from equations
written again by hand; once in the plane and once on a crane that slews.

Independent of Lemnis: every bar is three points with masses (1, 4, 1)/6, the linkage is solved by intersecting
circles and its loop's equations, and the load is a point in a space that stands still, on a rope whose force
is the multiplier of its length. Events are those of SciPy, whose implicit codes (Radau, BDF) must agree. Needs
SciPy.

    python tests/oracles/hydraulic_rope.py > tests/oracles/hydraulic_rope.csv

Columns: case, time in s, angle of the boom and of slewing in rad, pressures of the chambers of bore and annulus
in Pa, load from the head in m (forward, up, left of the frame that slews), 1 for a taut rope.
"""

import math
import sys

import numpy as np
from scipy.integrate import solve_ivp

from hydraulic_cylinder import (A_A, A_B, BETA, BETA_0, CHI_D, COMMANDS, DEAD, E, G, LEAK, LINE, LONG, O3, OPENING, PORT,
                                S_D, SHORT, SLOPE, SUPPLY, VALVE, VISCOUS, W_N, X1, X2, X3, X4, ZETA, e, n, root)

LOAD, X8, REST = 16e3, 5.2, 5e6
END = 2.5
# Angles of the rope at the start, in the plane and from it; its length; speed of the rope; moment on slewing.
CASES = {
    "plane": (math.radians(115), 0.0, 6.0, -0.3, None),
    "slewing": (0.4, math.radians(-125), 6.0, 0.25, 8e5),
}


def mechanism(theta):
    """Reduced inertia with its slope and the weights' moment, that about the slewing axis with its slope, the
    head with two derivatives, length and arm of the drive."""
    b = [X1 * e(theta), X1 * n(theta), -X1 * e(theta)]
    line = b[0] - O3
    d = math.hypot(*line)
    along = (d * d + X3 * X3 - X2 * X2) / (2 * d)
    u = line / d
    c = O3 + along * u + math.sqrt(X3 * X3 - along * along) * np.array([-u[1], u[0]])
    t3, be = math.atan2(*(c - O3)[::-1]), math.atan2(*(c - b[0])[::-1])
    matrix = np.column_stack([-X2 * n(be), X3 * n(t3)])
    be1, t31 = np.linalg.solve(matrix, X1 * n(theta))
    be2, t32 = np.linalg.solve(matrix, -X1 * e(theta) - X2 * e(be) * be1**2 + X3 * e(t3) * t31**2)
    jib = lambda r, a: [b[0] + r * e(a), b[1] + r * n(a) * be1, b[2] + r * (n(a) * be2 - e(a) * be1**2)]
    c, head = jib(X2, be), jib(X4, be - BETA_0)
    still = np.zeros(2)
    inertia = slope = moment = turn_slope = 0.0
    turn = REST
    for mass, p, r in ((20e3, [still] * 3, b), (6e3, c, head), (4e3, [O3, still, still], c)):
        middle = [(x + y) / 2 for x, y in zip(p, r)]
        for part, (at, v, a) in ((1, p), (4, middle), (1, r)):
            m = mass * part / 6
            inertia += m * v @ v
            slope += 2 * m * v @ a
            moment += m * G * v[1]
            turn += m * (at[0] + X8) ** 2
            turn_slope += 2 * m * (at[0] + X8) * v[0]
    anchor = S_D * e(theta + CHI_D)
    length = math.hypot(*(anchor - E))
    arm = (anchor - E) @ (S_D * n(theta + CHI_D)) / length
    return inertia, slope, moment, turn, turn_slope, head, length, arm


def head_in_space(head, psi, omega, turning):
    """Place and velocity, how it moves with each joint, and its acceleration at constant rates."""
    c, s = math.cos(psi), math.sin(psi)
    out, left = np.array([c, 0, s]), np.array([-s, 0, c])
    up = np.array([0.0, 1.0, 0.0])
    (x, y), (x1, y1), (x2, y2) = head
    reach = x + X8
    by = [x1 * out + y1 * up, reach * left]
    bend = (x2 * out + y2 * up) * omega**2 + 2 * x1 * omega * turning * left - reach * turning**2 * out
    return reach * out + y * up, omega * by[0] + turning * by[1], by, bend


def parts(y):
    return y[:8], y[8], y[9], y[10:13], y[13:16], y[16]


def solve(y, hoist, slewing, taut):
    """Accelerations of both joints and of the load, pull of the rope, and the mechanism."""
    (theta, w, *oil), psi, turning, place, speed, rope = parts(y)
    found = inertia, slope, moment, turn, turn_slope, head, length, arm = mechanism(theta)
    at, velocity, by, bend = head_in_space(head, psi, w, turning)
    force = [(A_A * oil[2] - A_B * oil[3]) * arm - VISCOUS * w - moment - slope * w * w / 2 + turn_slope * turning**2 / 2,
             (slewing or 0.0) - turn_slope * w * turning]
    ease = [1 / inertia, 0.0 if slewing is None else 1 / turn]
    gravity = np.array([0.0, -G, 0.0])
    away = place - at
    distance = np.linalg.norm(away)
    along = away / distance
    pull = 0.0
    if taut:
        rate = speed - velocity
        across = rate @ rate - (along @ rate) ** 2
        # along (load's - head's acceleration) + across / distance = 0
        need = along @ (gravity - bend) + across / distance - sum(force[i] * ease[i] * (along @ by[i]) for i in (0, 1))
        pull = need / (1 / LOAD + sum(ease[i] * (along @ by[i]) ** 2 for i in (0, 1)))
    joints = [(force[i] + pull * (along @ by[i])) * ease[i] for i in (0, 1)]
    return joints, gravity - pull / LOAD * along, pull, (found, at, velocity, by, along, distance, ease)


def rates(y, command, hoist, slewing, taut):
    (theta, w, p1, p2, pa, pb, x, v), psi, turning, place, speed, rope = parts(y)
    joints, load, _, (found, *_) = solve(y, hoist, slewing, taut)
    length, arm = found[-2:]
    if x >= 0:
        q1, q2 = VALVE * x * root(SUPPLY - p1), -VALVE * x * root(p2)
    else:
        q1, q2 = VALVE * x * root(p1), -VALVE * x * root(SUPPLY - p2)
    l1, l2 = LINE * root(p1 - pa), LINE * root(p2 - pb)
    r1, r2 = max(0.0, p1 - OPENING) * SLOPE, max(0.0, p2 - OPENING) * SLOPE
    leak, moved = LEAK * (pa - pb), arm * w
    return np.array([
        w, joints[0], BETA / PORT * (q1 - l1 - r1), BETA / PORT * (q2 - l2 - r2),
        BETA / (DEAD + A_A * (length - SHORT)) * (l1 - leak - A_A * moved),
        BETA / (DEAD + A_B * (LONG - length)) * (l2 + leak + A_B * moved),
        v, W_N**2 * (command - x) - 2 * ZETA * W_N * v,
        turning, joints[1], *speed, *load, hoist,
    ])


def start(phi, chi, rope):
    theta = math.radians(65)
    _, _, moment, *_, head, length, arm = mechanism(theta)
    # The oil carries the crane with its load hanging.
    push = ((moment + LOAD * G * head[1][1]) / arm + A_B * 20e5) / A_A
    place, *_ = head_in_space(head, 0.0, 0.0, 0.0)
    away = rope * np.array([math.cos(chi) * math.sin(phi), -math.cos(chi) * math.cos(phi), math.sin(chi)])
    return np.array([theta, 0, push, 20e5, push, 20e5, 0, 0, 0, 0, *(place + away), 0, 0, 0, rope], float)


def blow(y, hoist, slewing):
    """The rope catches the load: a plastic blow along it."""
    _, _, _, (_, at, velocity, by, along, distance, ease) = solve(y, hoist, slewing, False)
    excess = along @ (y[13:16] - velocity) - hoist
    push = excess / (1 / LOAD + sum(ease[i] * (along @ by[i]) ** 2 for i in (0, 1)))
    y[1] += push * (along @ by[0]) * ease[0]
    y[9] += push * (along @ by[1]) * ease[1]
    y[13:16] -= push / LOAD * along
    y[10:13] = at + along * y[16]


def speed_along_rope(y, hoist, slewing):
    """A rope that starts to move takes its load along at once."""
    _, _, _, (_, at, velocity, by, along, *_) = solve(y, hoist, slewing, True)
    y[13:16] -= along * (along @ (y[13:16] - velocity) - hoist)


def run(method, rtol, case):
    phi, chi, rope, hoist, slewing = CASES[case]
    y, since, out, events = start(phi, chi, rope), 0.0, {}, []
    speed_along_rope(y, hoist, slewing)
    taut = solve(y, hoist, slewing, True)[2] >= 0
    atol = rtol * np.array([1e-3, 1e-3, 1e5, 1e5, 1e5, 1e5, 1e-2, 1.0, *[1e-3] * 9])
    ends = [at for at, _ in COMMANDS[1:]] + [END]
    for (at, command), end in zip(COMMANDS, ends):
        while at < end:
            now = taut

            def edge(t, y):
                _, _, pull, (*_, distance, _) = solve(y, hoist, slewing, now)
                # What has just been let go is as far as the rope is long.
                return pull if now else y[16] - distance if t > since + 1e-3 else 1.0

            edge.terminal, edge.direction = True, -1
            wanted = [t for t in (round(0.02 * i, 3) for i in range(1, 126)) if at < t <= end]
            s = solve_ivp(lambda t, y: rates(y, command, hoist, slewing, now), (at, end), y, method, wanted,
                          rtol=rtol, atol=atol, events=edge)
            assert s.success, s.message
            for t, column in zip(s.t, np.reshape(s.y, (len(y), -1)).T):
                out[t] = (column, now)
            if s.status == 1:
                at, y = s.t_events[0][0], s.y_events[0][0].copy()
                if not taut:
                    blow(y, hoist, slewing)
                taut = not taut
                since = at
                events.append((at, taut))
            else:
                # The last of the wanted times is the end.
                at, y = end, s.y[:, -1].copy()
    return out, events


def row(y, taut):
    _, _, _, (_, at, *_) = solve(y, 0.0, None, taut)
    x, up, z = y[10:13] - at
    c, s = math.cos(y[8]), math.sin(y[8])
    return [y[0], y[8], y[4], y[5], x * c + z * s, up, z * c - x * s]


if __name__ == "__main__":
    print("case,t,theta,psi,p_a,p_b,x,y,z,taut")
    for case in CASES:
        (reference, events), (other, same) = run("Radau", 1e-11, case), run("BDF", 1e-11, case)
        assert [taut for _, taut in events] == [taut for _, taut in same]
        rows = {t: np.array(row(*at)) for t, at in reference.items()}
        apart = np.max([abs(rows[t] - row(*other[t])) for t in rows], axis=0)
        print(f"{case}: events {events}, Radau and BDF differ by {apart}", file=sys.stderr)
        assert max(apart[2:4]) < 100.0 and max(*apart[:2], *apart[4:]) < 1e-8
        for t, at in sorted(reference.items()):
            numbers = ",".join(f"{x:.14g}" for x in row(*at))
            print(f"{case},{t:.3f},{numbers},{int(at[1])}")
