"""Derivatives of rates and results of the steered groups by every state, input and parameter, with 200 digits.

Independent of Lemnis: the scene's numbers read anew, the cylinder's length and arm from two points, the oil written
again by hand, all in mpmath with 200 digits; then central differences of these.

    python tests/oracles/steering_derivatives.py > tests/oracles/steering_derivatives.csv

The scene is models/scenes/boat_hoist_003_hydraulic.toml; a case names the group, from 1. Columns: case, unknown, known,
value of the unknown, derivative. A derivative that is not listed is zero.
"""

import tomllib
from pathlib import Path

from mpmath import cos, mp, mpf, pi, sin, sqrt

mp.dps = 200
STEP = mpf(10) ** -40
SCENE = Path(__file__).resolve().parents[2] / "models/scenes/boat_hoist_003_hydraulic.toml"
UNITS = {
    "m": 1.0, "mm": 1e-3, "L": 1e-3, "L/min": 1e-3 / 60, "m/min": 1 / 60, "deg": float(pi / 180), "kN": 1e3, "bar": 1e5,
    "MPa": 1e6, "kg.m2": 1.0, "rad/s": 1.0, "m3/(s.Pa)": 1.0, "%": 0.01, "": 1.0,
}
LAMINAR, CREEP, STOP = mpf(20000), mpf(10) ** -3, mpf(100)


def si(text):
    """As the double that a program reads."""
    number, _, unit = text.partition(" ")
    value = float(number)
    return mpf(value / 6e4 if unit == "L/min" else value / 60 if unit == "m/min" else value * UNITS[unit])


with open(SCENE, "rb") as file:
    S = tomllib.load(file)["steering"]
MIRRORED = [group.get("cylinder") == "mirrored" for group in S["groups"]]
RANGE = [mpf(float(S["range"][end].split()[0]) * float(pi / 180)) for end in ("min", "max")]
X = [si(group["x"]) for group in S["groups"]]
W, X_G = si(S["load"]["W"]), si(S["load"]["x_G"])
GIVEN = {
    table: {key: si(S[table][key]) for key in keys}
    for table, keys in {
        "cylinder": ("R_c", "alpha", "l_x", "l_A", "D_g", "d"),
        "oil": ("V_0", "V_1", "Q_N", "dp_N", "x_0", "dp_L", "beta_E", "p_R", "k_R", "k_L", "omega_v", "zeta_v", "p_P"),
        "dynamics": ("J",),
        "tyre": ("f_t", "p_t", "k_v"),
        "ring": ("L_max", "mu_r", "D_L"),
    }.items()
}
PARAMETERS = {key: value for table in GIVEN.values() for key, value in table.items()}

PORTS = {"x_v": "0.3", "v_v": "5", "p_1": "120e5", "p_2": "25e5", "p_A": "90e5", "p_B": "60e5"}
OPEN = {"x_v": "-0.6", "v_v": "-20", "p_1": "340e5", "p_2": "350e5", "p_A": "290e5", "p_B": "190e5"}
CLOSED = {**PORTS, "x_v": "0.02", "v_v": "-3"}
# Group, states, travel speed; the load is that of the scene unless given.
CASES = {
    "lengthening": (1, {"theta": "0.2", "omega_g": "0.03", **PORTS}, "0.5"),
    "shortening": (6, {"theta": "-0.4", "omega_g": "-0.02", **OPEN}, "0.5"),
    "standing": (3, {"theta": "0.3", "omega_g": "0.0004", **PORTS}, "0"),
    "overlap": (8, {"theta": "-0.1", "omega_g": "-0.001", **CLOSED}, "-0.3"),
    "low stop": (2, {"theta": "-0.9953", "omega_g": "-0.003", **PORTS}, "0.5"),
    "high stop": (5, {"theta": "0.9951", "omega_g": "0.002", **OPEN}, "0"),
}


def load(group):
    """As the program shares the weight, read from its FMU's start values: a rigid frame over equal springs."""
    return W * (1 / mpf(len(X)) + X_G * X[group] / sum(x * x for x in X))


def root(p):
    return p / sqrt(sqrt(p * p + LAMINAR**2))


def group(p, mirrored, travels):
    sense = -1 if mirrored else 1
    theta, w = p["theta"], p["omega_g"]
    straight = p["l_A"] + mpf(3) / 2 * p["l_x"]
    foot = (p["R_c"] * cos(p["alpha"]) + straight * sin(p["alpha"]), p["R_c"] * sin(p["alpha"]) - straight * cos(p["alpha"]))

    def length(angle):
        turned = p["alpha"] + sense * angle
        return sqrt((p["R_c"] * cos(turned) - foot[0]) ** 2 + (p["R_c"] * sin(turned) - foot[1]) ** 2)

    l = length(theta)
    # The arm is the length's derivative; by the law of cosines l l' = r |ob| sin(...), here from two points.
    turned = p["alpha"] + sense * theta
    arm = sense * p["R_c"] * (foot[0] * sin(turned) - foot[1] * cos(turned)) / l
    a_a, a_b = pi / 4 * p["D_g"] ** 2, pi / 4 * (p["D_g"] ** 2 - p["d"] ** 2)
    line, valve = p["Q_N"] / sqrt(p["dp_L"]), p["Q_N"] / sqrt(p["dp_N"])
    x = p["x_v"]
    opening = max(mpf(0), abs(x) - p["x_0"]) / (1 - p["x_0"])
    pump = valve * opening * root(p["p_P"] - (p["p_1"] if x >= 0 else p["p_2"]))
    tank = valve * opening * root(p["p_2"] if x >= 0 else p["p_1"])
    q_1, q_2 = (pump, -tank) if x >= 0 else (-tank, pump)
    line_1, line_2 = line * root(p["p_1"] - p["p_A"]), line * root(p["p_2"] - p["p_B"])
    relief = [p["k_R"] * max(mpf(0), p[key] - p["p_R"]) for key in ("p_1", "p_2")]
    leak = p["k_L"] * (p["p_A"] - p["p_B"])
    short, long = p["l_x"] + p["l_A"], 2 * p["l_x"] + p["l_A"]
    v_a, v_b = p["V_0"] + a_a * (l - short), p["V_0"] + a_b * (long - l)
    tyres = p["f_t"] / 3 * sqrt(p["G"] ** 3 / p["p_t"])
    ring = p["mu_r"] / 2 * p["G"] * (mpf(4.4) * p["L_max"] + p["D_L"])
    standing, travelling = tyres + ring, tyres / p["k_v"] + ring
    reaction = -(travelling if travels else standing) * w / sqrt(w * w + CREEP**2)
    for end, beyond in ((RANGE[0], min), (RANGE[1], max)):
        depth = theta - end
        if beyond(depth, 0) != 0:
            push = -p["J"] * (STOP**2 * depth + 2 * STOP * w)
            reaction += push if push * depth < 0 else 0
    push = a_a * p["p_A"] - a_b * p["p_B"]
    speed = arm * w
    return {
        "der(theta)": w,
        "der(omega_g)": (push * arm + reaction) / p["J"],
        "der(p_1)": p["beta_E"] / p["V_1"] * (q_1 - line_1 - relief[0]),
        "der(p_2)": p["beta_E"] / p["V_1"] * (q_2 - line_2 - relief[1]),
        "der(p_A)": p["beta_E"] / v_a * (line_1 - leak - a_a * speed),
        "der(p_B)": p["beta_E"] / v_b * (line_2 + leak + a_b * speed),
        "der(x_v)": p["v_v"],
        # The command of the valve is held: that of the scene's start.
        "der(v_v)": p["omega_v"] ** 2 * -x - 2 * p["zeta_v"] * p["omega_v"] * p["v_v"],
        "R": l,
        "od": arm,
        "f_c": push,
        "M_R": reaction,
        "q_v": pump,
        "v_c": speed,
        "q_g": (a_a if speed >= 0 else a_b) * speed,
        "f_g": standing / abs(arm),
        "f_gx": travelling / abs(arm),
        "z.open_1": x - p["x_0"],
        "z.open_2": -x - p["x_0"],
        "z.relief_1": p["p_R"] - p["p_1"],
        "z.relief_2": p["p_R"] - p["p_2"],
        "z.min": theta - RANGE[0],
        "z.max": RANGE[1] - theta,
    }


def main():
    print("case,unknown,known,value,derivative")
    for case, (number, states, speed) in CASES.items():
        known = {**PARAMETERS, **{key: mpf(float(value)) for key, value in states.items()}, "G": load(number - 1)}
        of = lambda changed: group({**known, **changed}, MIRRORED[number - 1], float(speed) != 0)
        values = of({})
        for key, value in known.items():
            step = STEP * max(abs(value), 1)
            above, below = of({key: value + step}), of({key: value - step})
            for unknown in values:
                derivative = (above[unknown] - below[unknown]) / (2 * step)
                if abs(derivative) > mpf(10) ** -35 * (1 + abs(values[unknown])):
                    print(f"{case},{unknown},{key},{float(values[unknown])!r},{float(derivative)!r}")


if __name__ == "__main__":
    main()
