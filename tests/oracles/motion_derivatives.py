"""Derivatives of rates and reactions of the levels in motion by every state, input and parameter, in 50 digits.

Independent of Lemnis: joints by intersecting two circles, accelerations of every body by numerical derivatives
of its place, the principle of virtual work, the oil written again by hand, all with 200 digits (mpmath); then
central differences of these.

    python tests/oracles/motion_derivatives.py > tests/oracles/motion_derivatives.csv

Columns: case, unknown, known, value of the unknown, derivative. A derivative that is not listed is zero.
"""

from mpmath import atan2, cos, lu_solve, matrix, mp, mpf, pi, sin, sqrt

from lemniscate_derivatives import SCENE, Pose

mp.dps = 200
INNER, OUTER = mpf(10) ** -40, mpf(10) ** -30

# In SI, as the doubles that a program reads from the decimal text.
DYNAMICS = {name: mpf(float(text)) for name, text in {
    "J_1": "620816.667", "J_2": "248645", "J_3": "72030", "c_v": "200e3", "M_F": "20e3", "g": "9.81"}.items()}
OIL = {name: mpf(float(text)) for name, text in {
    "l_min": "3.5", "l_max": "10", "V_0": "2e-3", "V_1": "2e-4", "Q_N": "0.01", "dp_N": "35e5", "dp_L": "2e5",
    "beta_E": "1.4e9", "p_R": "280e5", "k_R": "1e-9", "k_L": "1e-12", "omega_v": "300", "zeta_v": "0.7"}.items()}
LOW, HIGH = mpf(float(60 * pi / 180)), mpf(float(120 * pi / 180))
LAMINAR, CREEP, STOP = mpf(20000), mpf(10) ** -4, mpf(100)

MOMENT = {"M_A": "2.1e6", "M_S": "3e4"}
SWING = {"theta_1": "1.4", "omega_1": "-0.12", "phi_R": "0.3", "omega_R": "0.2", "l_R": "9.5"}
PORTS = {"x_v": "0.3", "v_v": "5", "p_1": "120e5", "p_2": "25e5", "p_A": "90e5", "p_B": "60e5"}
OPEN = {"x_v": "-0.6", "v_v": "-20", "p_1": "320e5", "p_2": "300e5", "p_A": "250e5", "p_B": "190e5"}
VALVE = {"u_v": "0.4", "p_P": "250e5"}
# How the bar moves is given by the sign; a held bar has none.
CASES = {
    "rigid/forward": ({"theta_1": "1.2", "omega_1": "0.15"}, MOMENT, 1),
    "rigid/backward": ({"theta_1": "1.9", "omega_1": "-0.2"}, MOMENT, -1),
    "rigid/held": ({"theta_1": "1.3", "omega_1": "0"}, {"M_A": "2.1e6", "M_S": "5e6"}, 0),
    "swing/taut": (SWING, {**MOMENT, "v_h": "0.05"}, -1),
    "swing/held": ({**SWING, "omega_1": "0"}, {"M_A": "1e6", "M_S": "9e6", "v_h": "-0.3"}, 0),
    "swing/slack": ({**SWING, "phi_R": "2.2", "s_Q": "9.1", "v_Q": "0.4"}, {**MOMENT, "v_h": "0.05"}, -1),
    "hydraulic/raising": ({"theta_1": "1.2", "omega_1": "0.05", **PORTS}, VALVE, 1),
    "hydraulic/relief": ({"theta_1": "1.9", "omega_1": "-0.03", **OPEN}, VALVE, -1),
    "hydraulic/stop": ({"theta_1": "2.0955", "omega_1": "0.05", **PORTS}, VALVE, 1),
    "hydraulic with swing/raising": ({**SWING, **PORTS}, {**VALVE, "v_h": "0.05"}, 1),
    "hydraulic with swing/slack": ({**SWING, "phi_R": "2.2", "s_Q": "9.1", "v_Q": "0.4", **PORTS},
                                   {**VALVE, "v_h": "0.05"}, -1),
}


def parts(p, theta):
    """Mass, inertia, then value, first and second derivative by theta of place and angle, for every bar and the head."""
    h = INNER
    poses = [Pose(p, theta + k * h) for k in (-1, 0, 1)]

    def derivatives(f):
        a, b, c = [f(x) for x in poses]
        return b, (c - a) / (2 * h), (a - 2 * b + c) / h**2

    bar = lambda x: atan2(x.b[1], x.b[0])
    jib = lambda x: x.bc
    rocker = lambda x: x.theta_3
    found = []
    for place, angle, mass, inertia in [
        (lambda x: x.s_1, bar, p["G_1"] / p["g"], p["J_1"]),
        (lambda x: x.s_2, jib, p["G_2"] / p["g"], p["J_2"]),
        (lambda x: x.s_3, rocker, p["G_3"] / p["g"], p["J_3"]),
        (lambda x: x.a, bar, None, mpf(0)),
    ]:
        found.append((mass, inertia, derivatives(lambda x: place(x)[0]), derivatives(lambda x: place(x)[1]), derivatives(angle)))
    return found, derivatives(lambda x: x.l_d)


def inertia(p, theta, fixed):
    total = mpf(0)
    for mass, spin, x, y, angle in parts(p, theta)[0]:
        mass = (p["Q"] / p["g"] if fixed else 0) if mass is None else mass
        total += mass * (x[1] ** 2 + y[1] ** 2) + spin * angle[1] ** 2
    return total


def accelerations(p, bodies, moment, load, free):
    """Of bar and rope. `load`: "fixed", "taut" or "slack"; `free`: whether the bar moves. And the moment that holds it."""
    w = p["omega_1"]
    m_11, force = mpf(0), moment
    for mass, spin, x, y, angle in bodies:
        if mass is None:
            if load != "fixed":
                continue
            mass = p["Q"] / p["g"]
        m_11 += mass * (x[1] ** 2 + y[1] ** 2) + spin * angle[1] ** 2
        # Bars' angles are those of points on circles: alpha = angle'' w^2 + angle' theta''.
        force -= mass * (x[1] * x[2] + y[1] * y[2]) * w**2 + spin * angle[1] * angle[2] * w**2 + mass * p["g"] * y[1]
    if load != "taut":
        return (force / m_11 if free else mpf(0)), mpf(0), -(force - moment)
    _, _, x, y, _ = bodies[3]
    m, l = p["Q"] / p["g"], p["l_R"]
    across = (cos(p["phi_R"]), sin(p["phi_R"]))
    inward = (-across[1], across[0])
    # The load's acceleration without theta'' and phi''.
    rest = [(x, y)[i][2] * w**2 + inward[i] * l * p["omega_R"] ** 2 + across[i] * 2 * p["v_h"] * p["omega_R"] for i in (0, 1)]
    rest[1] += p["g"]
    head = (x[1], y[1])
    couple = m * l * (head[0] * across[0] + head[1] * across[1])
    rope = -m * l * (rest[0] * across[0] + rest[1] * across[1])
    bar = force - m * (head[0] * rest[0] + head[1] * rest[1])
    if not free:
        phi = rope / (m * l**2)
        return mpf(0), phi, moment - (bar - couple * phi)
    a, phi = lu_solve(matrix([[m_11 + m * (head[0] ** 2 + head[1] ** 2), couple], [couple, m * l**2]]), matrix([bar, rope]))
    return a, phi, None


def rope(p, head, alpha):
    """Pull of a taut rope, from the load's acceleration along it."""
    _, _, x, y, _ = head
    out = (sin(p["phi_R"]), -cos(p["phi_R"]))
    along = sum(((x, y)[i][1] * alpha + (x, y)[i][2] * p["omega_1"] ** 2) * out[i] for i in (0, 1)) + p["g"] * out[1]
    return p["Q"] / p["g"] * (p["l_R"] * p["omega_R"] ** 2 - along)


def root(x):
    return x / sqrt(sqrt(x * x + LAMINAR**2))


def free(p, case, way):
    level, mode = case.split("/")
    bodies, _ = parts(p, p["theta_1"])
    dry = p["M_F"] + p["M_S"]
    moment = p["M_A"] - (p["c_v"] * p["omega_1"] + way * dry if way else 0)
    load = {"rigid": "fixed"}.get(level, "slack" if mode == "slack" else "taut")
    alpha, phi, hold = accelerations(p, bodies, moment, load, way != 0)
    found = {"der(theta_1)": p["omega_1"], "der(omega_1)": alpha}
    found["M_R"] = -p["c_v"] * p["omega_1"] - way * dry if way else hold - p["M_A"]
    if level == "rigid":
        return found
    return found | swinging(p, bodies[3], alpha, phi, load)


def swinging(p, head, alpha, phi, load):
    """Rates of rope and load, and the rope's pull."""
    found = {"der(phi_R)": p["omega_R"], "der(l_R)": p["v_h"], "der(s_Q)": p["v_h"], "der(v_Q)": mpf(0), "der(omega_R)": phi}
    if load == "taut":
        return found | {"S_R": rope(p, head, alpha)}
    # In free fall: the second derivative of A + s (sin, -cos) is (0, -g).
    _, _, x, y, _ = head
    fall = [-((x, y)[i][1] * alpha + (x, y)[i][2] * p["omega_1"] ** 2) for i in (0, 1)]
    fall[1] -= p["g"]
    out, across = (sin(p["phi_R"]), -cos(p["phi_R"])), (cos(p["phi_R"]), sin(p["phi_R"]))
    found["der(s_Q)"] = p["v_Q"]
    found["der(v_Q)"] = fall[0] * out[0] + fall[1] * out[1] + p["s_Q"] * p["omega_R"] ** 2
    found["der(omega_R)"] = (fall[0] * across[0] + fall[1] * across[1] - 2 * p["v_Q"] * p["omega_R"]) / p["s_Q"]
    return found | {"S_R": mpf(0)}


def hydraulic(p, case, way):
    swings = case.startswith("hydraulic with swing")
    bodies, (length, arm, _) = parts(p, p["theta_1"])
    bore = pi / 4 * p["D_c"] ** 2
    ring = pi / 4 * (p["D_c"] ** 2 - p["d_r"] ** 2)
    w, x = p["omega_1"], p["x_v"]
    push = bore * p["p_A"] - ring * p["p_B"]
    moment = push * arm - p["c_v"] * w - p["M_F"] * w / sqrt(w * w + CREEP**2)
    if p["theta_1"] > HIGH:
        spring = inertia(p, LOW, not swings)
        moment -= spring * STOP**2 * (p["theta_1"] - HIGH) + 2 * spring * STOP * w
    load = "slack" if case.endswith("slack") else "taut" if swings else "fixed"
    alpha, phi, _ = accelerations(p, bodies, moment, load, True)
    valve, line = p["Q_N"] / sqrt(p["dp_N"]) * x, p["Q_N"] / sqrt(p["dp_L"])
    to_1 = valve * root(p["p_P"] - p["p_1"]) if x >= 0 else valve * root(p["p_1"])
    to_2 = -valve * root(p["p_2"]) if x >= 0 else -valve * root(p["p_P"] - p["p_2"])
    on_a, on_b = line * root(p["p_1"] - p["p_A"]), line * root(p["p_2"] - p["p_B"])
    over = [p["k_R"] * max(mpf(0), p[port] - p["p_R"]) for port in ("p_1", "p_2")]
    gap = p["k_L"] * (p["p_A"] - p["p_B"])
    found = {
        "der(theta_1)": w,
        "der(omega_1)": alpha,
        "der(p_1)": p["beta_E"] / p["V_1"] * (to_1 - on_a - over[0]),
        "der(p_2)": p["beta_E"] / p["V_1"] * (to_2 - on_b - over[1]),
        "der(p_A)": p["beta_E"] / (p["V_0"] + bore * (length - p["l_min"])) * (on_a - gap - bore * arm * w),
        "der(p_B)": p["beta_E"] / (p["V_0"] + ring * (p["l_max"] - length)) * (on_b + gap + ring * arm * w),
        "der(x_v)": p["v_v"],
        "der(v_v)": p["omega_v"] ** 2 * (p["u_v"] - x) - 2 * p["zeta_v"] * p["omega_v"] * p["v_v"],
        "F_c": push,
    }
    return found | (swinging(p, bodies[3], alpha, phi, load) if swings else {})


def main():
    print("case,unknown,known,value,derivative")
    for case, (states, inputs, way) in CASES.items():
        scene = {**SCENE, **DYNAMICS, **{k: mpf(float(v)) for k, v in {**states, **inputs}.items()}}
        of = free
        if case.startswith("hydraulic"):
            scene, of = {**scene, **OIL}, hydraulic
        values = of(scene, case, way)
        for known in scene:
            above, below = [of({**scene, known: scene[known] + step}, case, way) for step in (OUTER, -OUTER)]
            for unknown, value in values.items():
                derivative = (above[unknown] - below[unknown]) / (2 * OUTER)
                if abs(derivative) > mpf(10) ** -40 * (1 + abs(value)):
                    print(f"{case},{unknown},{known},{float(value)!r},{float(derivative)!r}")


if __name__ == "__main__":
    main()
