"""Reference of eight steering cylinders under their control loop, from equations written again.

Independent of Lemnis: reads the scene's numbers, own equations, SciPy's Radau between the samples of the PLC. Needs
SciPy.

    python tests/oracles/steering_hydraulics.py > tests/oracles/steering_hydraulics.csv

The scene is models/scenes/boat_hoist_003_hydraulic.toml in its default experiment. Columns: time in s, the eight angles
in rad, the pressures of the eight bores in Pa.
"""

import math
import sys
import tomllib
from pathlib import Path

import numpy as np
from scipy.integrate import solve_ivp

SCENE = Path(__file__).resolve().parents[2] / "models/scenes/boat_hoist_003_hydraulic.toml"
UNITS = {
    "m": 1.0, "mm": 1e-3, "L": 1e-3, "L/min": 1e-3 / 60, "m/min": 1 / 60, "deg": math.pi / 180, "deg/s": math.pi / 180,
    "s": 1.0, "ms": 1e-3, "kN": 1e3, "bar": 1e5, "MPa": 1e6, "kg.m2": 1.0, "%": 0.01, "rad/s": 1.0, "1/rad": 1.0,
    "1/(rad.s)": 1.0, "m3/(s.Pa)": 1.0, "": 1.0,
}
LAMINAR, CREEP, STOP = 2e4, 1e-3, 100.0
ROWS = 10  # cycles of the PLC for each row


def si(text):
    number, _, unit = text.partition(" ")
    return float(number) * UNITS[unit]


with open(SCENE, "rb") as file:
    S = tomllib.load(file)["steering"]
X, Y = ([si(group[key]) for group in S["groups"]] for key in "xy")
MIRRORED = [group.get("cylinder") == "mirrored" for group in S["groups"]]
assert S["mode"] == "all_wheel" and max(X) == -min(X), "the turning centre lies on the line x = 0"


def of(table, *keys):
    return [si(S[table][key]) for key in keys]


R, ALPHA, L_X, L_A, BORE, ROD = of("cylinder", "R_c", "alpha", "l_x", "l_A", "D_g", "d")
L_0 = L_A + 1.5 * L_X
C = (R * math.cos(ALPHA), R * math.sin(ALPHA))
B = (C[0] + L_0 * math.sin(ALPHA), C[1] - L_0 * math.cos(ALPHA))
A_A, A_B = math.pi / 4 * BORE**2, math.pi / 4 * (BORE**2 - ROD**2)
DEAD, PORT, Q_N, DP_N, OVERLAP, DP_L, BETA = of("oil", "V_0", "V_1", "Q_N", "dp_N", "x_0", "dp_L", "beta_E")
OPENING, SLOPE, LEAK, W_N, ZETA, SUPPLY = of("oil", "p_R", "k_R", "k_L", "omega_v", "zeta_v", "p_P")
LINE, VALVE = Q_N / math.sqrt(DP_L), Q_N / math.sqrt(DP_N)
INERTIA, = of("dynamics", "J")
PERIOD, KP, KI = of("plc", "T_c", "k_P", "k_I")
STEP, = of("accuracy", "resolution")
FROM, TO, SPEED, TRAVEL = of("motion", "from", "to", "speed", "v_t")
W, X_G, Y_G = of("load", "W", "x_G", "y_G")
F_T, P_T, K_V = of("tyre", "f_t", "p_t", "k_v")
ARM, MU, D_L = of("ring", "L_max", "mu_r", "D_L")
assert Y_G == 0 and TRAVEL != 0


def wanted(group, t):
    """All axle lines meet on x = 0, where that of the first group does."""
    tan = math.tan(min(FROM + SPEED * t, TO))
    return math.atan(X[group] * tan / (X[0] + (Y[0] - Y[group]) * tan))


def resistance(group):
    load = W * (1 / len(X) + X_G * X[group] / sum(x * x for x in X))
    tyres = F_T / 3 * math.sqrt(load**3 / P_T) / K_V
    return tyres + MU / 2 * (4.4 * load * ARM + load * D_L)


def root(p):
    return p / (p * p + LAMINAR**2) ** 0.25


def rates(y, command, mirrored, resist):
    theta, w, p1, p2, pa, pb, x, v = y
    turn = -theta if mirrored else theta
    c = (math.cos(turn) * C[0] - math.sin(turn) * C[1], math.sin(turn) * C[0] + math.cos(turn) * C[1])
    line = (c[0] - B[0], c[1] - B[1])
    length = math.hypot(*line)
    arm = (c[0] * line[1] - c[1] * line[0]) / length * (-1 if mirrored else 1)
    open_ = max(0.0, abs(x) - OVERLAP) / (1 - OVERLAP)
    if x >= 0:
        q1, q2 = VALVE * open_ * root(SUPPLY - p1), -VALVE * open_ * root(p2)
    else:
        q1, q2 = -VALVE * open_ * root(p1), VALVE * open_ * root(SUPPLY - p2)
    l1, l2 = LINE * root(p1 - pa), LINE * root(p2 - pb)
    r1, r2 = max(0.0, p1 - OPENING) * SLOPE, max(0.0, p2 - OPENING) * SLOPE
    leak, speed = LEAK * (pa - pb), arm * w
    va, vb = DEAD + A_A * (length - L_X - L_A), DEAD + A_B * (2 * L_X + L_A - length)
    moment = (A_A * pa - A_B * pb) * arm - resist * w / math.sqrt(w * w + CREEP**2)
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


def simulate(group, cycles):
    mirrored, resist = MIRRORED[group], resistance(group)
    back = 20e5 * A_A / A_B
    y = np.array([wanted(group, 0.0), 0.0, 20e5, back, 20e5, back, 0.0, 0.0])
    total, out = 0.0, []
    for cycle in range(cycles):
        error = wanted(group, cycle * PERIOD) - round(y[0] / STEP) * STEP
        summed = total + error * PERIOD
        command = KP * error + KI * summed
        if abs(command) < 1:
            total = summed
        command = max(-1.0, min(1.0, command)) * (-1 if mirrored else 1)
        s = solve_ivp(lambda t, y: rates(y, command, mirrored, resist), (0, PERIOD), y, "Radau", rtol=1e-8,
                      atol=1e-8 * np.array([1e-3, 1e-3, 1e5, 1e5, 1e5, 1e5, 1e-2, 1.0]))
        assert s.success, s.message
        y = s.y[:, -1]
        out.append((y[0], y[4]))
    return out


if __name__ == "__main__":
    cycles = round((TO - FROM) / SPEED / PERIOD)
    groups = range(len(X))
    columns = []
    for group in groups:
        columns.append(simulate(group, cycles))
        print(f"group {group + 1}", file=sys.stderr)
    print("t," + ",".join(f"theta_{i + 1}" for i in groups) + "," + ",".join(f"p_A_{i + 1}" for i in groups))
    for cycle in range(ROWS - 1, cycles, ROWS):
        angles = ",".join(f"{c[cycle][0]:.9f}" for c in columns)
        print(f"{(cycle + 1) * PERIOD:.2f},{angles}," + ",".join(f"{c[cycle][1]:.0f}" for c in columns))
