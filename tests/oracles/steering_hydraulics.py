"""Reference of eight steering cylinders under their control loop, from equations written again.

Independent of Lemnis: own equations, SciPy's Radau between the samples of the PLC. Needs SciPy.

    python tests/oracles/steering_hydraulics.py > tests/oracles/steering_hydraulics.csv

Columns: time in s, the eight angles in rad.
"""

import math

import numpy as np
from scipy.integrate import solve_ivp

R, ALPHA, L_X, L_A = 0.5, 0.3, 0.9, 0.4
L_0 = L_A + 1.5 * L_X
C = np.array([R * math.cos(ALPHA), R * math.sin(ALPHA)])
B = np.array([C[0] + L_0 * math.sin(ALPHA), C[1] - L_0 * math.cos(ALPHA)])
A_A, A_B = math.pi / 4 * 0.125**2, math.pi / 4 * (0.125**2 - 0.07**2)
LINE, VALVE = 1.5e-3 / math.sqrt(2e5), 1.5e-3 / math.sqrt(35e5)
DEAD, PORT, LEAK, BETA, OPENING, SLOPE = 5e-4, 1e-4, 1e-13, 1.4e9, 250e5, 1e-9
W_N, ZETA, SUPPLY, LAMINAR, CREEP, INERTIA = 300.0, 0.7, 200e5, 2e4, 1e-3, 3000.0
PERIOD, RESOLUTION, KP, KI = 0.01, math.tau / 8192, 12.0, 3.0
CYCLES = 300


def wanted(group, t):
    """Ramps to a different angle for every group, in rad; back from 2 s on."""
    final = math.radians((30, 22, -22, -30, 20, 15, -15, -20)[group])
    return final * min(1.0, t / 1.2) if t < 2.0 else final * (1 - 0.5 * min(1.0, (t - 2.0) / 0.6))


def root(p):
    return p / (p * p + LAMINAR**2) ** 0.25


def rates(y, command, mirrored, resistance):
    theta, w, p1, p2, pa, pb, x, v = y
    turn = -theta if mirrored else theta
    c = np.array([math.cos(turn) * C[0] - math.sin(turn) * C[1], math.sin(turn) * C[0] + math.cos(turn) * C[1]])
    line = c - B
    length = math.hypot(*line)
    arm = (c[0] * line[1] - c[1] * line[0]) / length * (-1 if mirrored else 1)
    if x >= 0:
        q1, q2 = VALVE * x * root(SUPPLY - p1), -VALVE * x * root(p2)
    else:
        q1, q2 = VALVE * x * root(p1), -VALVE * x * root(SUPPLY - p2)
    l1, l2 = LINE * root(p1 - pa), LINE * root(p2 - pb)
    r1, r2 = max(0.0, p1 - OPENING) * SLOPE, max(0.0, p2 - OPENING) * SLOPE
    leak, speed = LEAK * (pa - pb), arm * w
    va, vb = DEAD + A_A * (length - L_X - L_A), DEAD + A_B * (2 * L_X + L_A - length)
    moment = (A_A * pa - A_B * pb) * arm - resistance * w / math.sqrt(w * w + CREEP**2)
    return [
        w,
        moment / INERTIA,
        BETA / PORT * (q1 - l1 - r1),
        BETA / PORT * (q2 - l2 - r2),
        BETA / va * (l1 - leak - A_A * speed),
        BETA / vb * (l2 + leak + A_B * speed),
        v,
        W_N**2 * (command - x) - 2 * ZETA * W_N * v,
    ]


def simulate(group):
    mirrored, resistance = group >= 4, 8e3 + 1e3 * group
    y = np.array([0.0, 0.0, 20e5, 20e5 * A_A / A_B, 20e5, 20e5 * A_A / A_B, 0.0, 0.0])
    total, out = 0.0, []
    for cycle in range(CYCLES):
        error = wanted(group, cycle * PERIOD) - round(y[0] / RESOLUTION) * RESOLUTION
        summed = total + error * PERIOD
        command = KP * error + KI * summed
        if abs(command) < 1:
            total = summed
        command = max(-1.0, min(1.0, command)) * (-1 if mirrored else 1)
        s = solve_ivp(lambda t, y: rates(y, command, mirrored, resistance), (0, PERIOD), y, "Radau", rtol=1e-7,
                      atol=1e-7 * np.array([1e-3, 1e-3, 1e5, 1e5, 1e5, 1e5, 1e-2, 1.0]))
        assert s.success, s.message
        y = s.y[:, -1]
        out.append(y[0])
    return out


if __name__ == "__main__":
    columns = [simulate(group) for group in range(8)]
    print("t," + ",".join(f"theta_{i + 1}" for i in range(8)))
    for cycle in range(4, CYCLES, 5):
        print(f"{(cycle + 1) * PERIOD:.2f}," + ",".join(f"{c[cycle]:.9f}" for c in columns))
