"""Reference of the stiff luffing cylinder, from equations written again by hand.

Independent of Lemnis: the linkage by intersecting circles, its first and second derivatives by
solving the loop's equations (no dual numbers), and two implicit codes of SciPy (Radau, BDF) that
must agree. Needs SciPy.

    python tests/oracles/hydraulic_cylinder.py > tests/oracles/hydraulic_cylinder.csv

Columns: time in s, angle of the boom in rad, pressures of the chambers of bore and annulus in Pa.
"""

import math
import sys

import numpy as np
from scipy.integrate import solve_ivp

X1, X2, X3, X4, X5, X6, X7 = 19.3, 6.5, 14.7, 16.0, 6.4, 5.3, 1.354
G = 9.81
BETA_0 = math.acos(X7 / X2) + math.acos(X7 / X4)
O3 = np.array([-X5, X6])
E = np.array([3.0, -1.5])
S_D, CHI_D = 7.0, math.radians(-5.0)

D_C, D_R = 0.32, 0.22
A_A, A_B = math.pi / 4 * D_C**2, math.pi / 4 * (D_C**2 - D_R**2)
SHORT, LONG, DEAD, PORT = 4.0, 9.0, 2e-3, 2e-4
LINE, VALVE = 0.01 / math.sqrt(2e5), 0.01 / math.sqrt(35e5)
LEAK, BETA, OPENING, SLOPE = 1e-12, 1.4e9, 280e5, 1e-9
W_N, ZETA, SUPPLY, VISCOUS, LAMINAR = 300.0, 0.7, 250e5, 2e4, 2e4

# The command of the valve from a time on, in s.
COMMANDS = [(0.0, 0.5), (1.2, -0.4), (1.8, 0.0)]
END = 2.5


def e(a):
    return np.array([math.cos(a), math.sin(a)])


def n(a):
    return np.array([-math.sin(a), math.cos(a)])


def mechanism(theta, load=16e3):
    """Inertia, its slope and the moment of the weights, with a load in kg, all reduced to the boom; drive's length and arm."""
    b = X1 * e(theta)
    line = b - O3
    d = math.hypot(*line)
    along = (d * d + X3 * X3 - X2 * X2) / (2 * d)
    across = math.sqrt(X3 * X3 - along * along)
    u = line / d
    c = O3 + along * u + across * np.array([-u[1], u[0]])
    t3 = math.atan2(*(c - O3)[::-1])
    be = math.atan2(*(c - b)[::-1])
    # X1 n(theta) + X2 n(be) be' = X3 n(t3) t3', and once more.
    matrix = np.column_stack([-X2 * n(be), X3 * n(t3)])
    be1, t31 = np.linalg.solve(matrix, X1 * n(theta))
    be2, t32 = np.linalg.solve(matrix, -X1 * e(theta) - X2 * e(be) * be1**2 + X3 * e(t3) * t31**2)
    inertia = slope = moment = 0.0

    def add(mass, spin, r1, r2, w1, w2):
        nonlocal inertia, slope, moment
        inertia += mass * r1 @ r1 + spin * w1**2
        slope += 2 * (mass * r1 @ r2 + spin * w1 * w2)
        moment += mass * G * r1[1]

    def turning(length, angle, w1, w2):
        return length * n(angle) * w1, length * (n(angle) * w2 - e(angle) * w1**2)

    add(20e3, 20e3 * X1**2 / 12, *turning(X1 / 2, theta, 1.0, 0.0), 1.0, 0.0)
    add(4e3, 4e3 * X3**2 / 12, *turning(X3 / 2, t3, t31, t32), t31, t32)
    # The jib as one bar from C to A; B's motion and the arms turning with be.
    b1, b2 = turning(X1, theta, 1.0, 0.0)
    c1, c2 = turning(X2, be, be1, be2)
    a1, a2 = turning(X4, be - BETA_0, be1, be2)
    ac = math.sqrt(X2**2 + X4**2 - 2 * X2 * X4 * math.cos(BETA_0))
    add(6e3, 6e3 * ac**2 / 12, b1 + (c1 + a1) / 2, b2 + (c2 + a2) / 2, be1, be2)
    add(load, 0.0, b1 + a1, b2 + a2, 0.0, 0.0)
    anchor = S_D * e(theta + CHI_D)
    length = math.hypot(*(anchor - E))
    arm = (anchor - E) @ (S_D * n(theta + CHI_D)) / length
    return inertia, slope, moment, length, arm


def root(p):
    return p / (p * p + LAMINAR**2) ** 0.25


def rates(y, command, driven=None, areas=(A_A, A_B)):
    """Of the crane, or of another mechanism as it is driven there, by a cylinder of other areas."""
    theta, w, p1, p2, pa, pb, x, v = y
    bore, annulus = areas
    inertia, slope, moment, length, arm = driven or mechanism(theta)
    if x >= 0:
        q1, q2 = VALVE * x * root(SUPPLY - p1), -VALVE * x * root(p2)
    else:
        q1, q2 = VALVE * x * root(p1), -VALVE * x * root(SUPPLY - p2)
    l1, l2 = LINE * root(p1 - pa), LINE * root(p2 - pb)
    r1, r2 = max(0.0, p1 - OPENING) * SLOPE, max(0.0, p2 - OPENING) * SLOPE
    leak = LEAK * (pa - pb)
    speed = arm * w
    va, vb = DEAD + bore * (length - SHORT), DEAD + annulus * (LONG - length)
    force = bore * pa - annulus * pb
    return [
        w,
        (force * arm - VISCOUS * w - moment - slope * w * w / 2) / inertia,
        BETA / PORT * (q1 - l1 - r1),
        BETA / PORT * (q2 - l2 - r2),
        BETA / va * (l1 - leak - bore * speed),
        BETA / vb * (l2 + leak + annulus * speed),
        v,
        W_N**2 * (command - x) - 2 * ZETA * W_N * v,
    ]


def start():
    inertia, slope, moment, length, arm = mechanism(math.radians(65))
    push = (moment / arm + A_B * 20e5) / A_A
    return [math.radians(65), 0.0, push, 20e5, push, 20e5, 0.0, 0.0]


def times():
    found = {round(0.01 * i, 3) for i in range(1, 251)}
    for at, _ in COMMANDS:
        found |= {round(at + 0.001 * i, 3) for i in range(1, 31)}
    return sorted(found)


def run(method, rtol):
    y, out = np.array(start()), {}
    ends = [at for at, _ in COMMANDS[1:]] + [END]
    atol = rtol * np.array([1e-3, 1e-3, 1e5, 1e5, 1e5, 1e5, 1e-2, 1.0])
    for (at, command), end in zip(COMMANDS, ends):
        wanted = [t for t in times() if at < t <= end]
        s = solve_ivp(lambda t, y: rates(y, command), (at, end), y, method, wanted, rtol=rtol, atol=atol)
        assert s.success, s.message
        for t, column in zip(s.t, s.y.T):
            out[t] = column
        y = s.y[:, -1]
    return out


if __name__ == "__main__":
    reference, other = run("Radau", 1e-11), run("BDF", 1e-11)
    worst = max(abs(reference[t][4:6] - other[t][4:6]).max() for t in reference)
    print(f"Radau and BDF differ by at most {worst / 1e5:.1e} bar", file=sys.stderr)
    assert worst < 10.0, worst
    print("t,theta,p_a,p_b")
    for t, y in sorted(reference.items()):
        print(f"{t:.3f},{y[0]:.15g},{y[4]:.12g},{y[5]:.12g}")
