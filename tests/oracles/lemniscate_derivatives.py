"""Derivatives of the default crane's results by every input and parameter, in 50 digits.

Independent of Lemnis: joints by intersecting two circles, moments as numerical
derivatives of potential energy, pin forces by solving the equilibrium of the
bodies, all with 120 digits (mpmath); then central differences of these.

    python tests/oracles/lemniscate_derivatives.py > tests/oracles/lemniscate_derivatives.csv
"""

from mpmath import acos, atan2, cos, diff, hypot, lu_solve, matrix, mp, mpf, pi, sin, sqrt

mp.dps = 120
INNER, OUTER = mpf(10) ** -50, mpf(10) ** -30

DEGREE = pi / 180
# The default scene in SI, as the doubles that a program reads from the decimal text.
SCENE = {
    "omega_1": mpf(float(DEGREE)), "Q": mpf(160000),
    **{name: mpf(float(text)) for name, text in {
        "X_1": "19.3", "X_2": "6.5", "X_3": "14.7", "X_4": "16", "X_5": "6.4", "X_6": "5.3", "X_7": "1.354",
        "X_8": "5.2", "G_1": "196200", "s_1": "9.65", "G_2": "58860", "s_2": "4.98", "G_3": "39240", "s_3": "7.35",
        "E_x": "3", "E_y": "-1.5", "s_d": "7", "D_c": "0.32", "d_r": "0.22"}.items()},
    "chi_1": mpf(0), "chi_2": mpf(float(mpf("-152.2") * DEGREE)), "chi_3": mpf(0),
    "chi_d": mpf(float(-5 * DEGREE)),
}
ANGLES = ("1.1", "1.5", "1.9", "0.8555")


def turn(vector, angle):
    return (vector[0] * cos(angle) - vector[1] * sin(angle), vector[0] * sin(angle) + vector[1] * cos(angle))


def upright(angle):
    return angle + 2 * pi if angle <= -pi / 2 else angle


class Pose:
    def __init__(self, p, theta):
        self.b = (p["X_1"] * cos(theta), p["X_1"] * sin(theta))
        o3 = (-p["X_5"], p["X_6"])
        dx, dy = self.b[0] - o3[0], self.b[1] - o3[1]
        self.l = hypot(dx, dy)
        along = (self.l**2 + p["X_3"] ** 2 - p["X_2"] ** 2) / (2 * self.l)
        across = sqrt(p["X_3"] ** 2 - along**2)
        self.c = (o3[0] + (along * dx - across * dy) / self.l, o3[1] + (along * dy + across * dx) / self.l)
        self.theta_3 = upright(atan2(self.c[1] - o3[1], self.c[0] - o3[0]))
        self.bc = atan2(self.c[1] - self.b[1], self.c[0] - self.b[0])
        beta_0 = acos(p["X_7"] / p["X_2"]) + acos(p["X_7"] / p["X_4"])
        alpha = self.bc - beta_0
        self.a = (self.b[0] + p["X_4"] * cos(alpha), self.b[1] + p["X_4"] * sin(alpha))
        self.alpha_1 = upright(atan2(self.a[1] - self.c[1], self.a[0] - self.c[0]))
        # Centres of gravity, and the anchor of the drive on the boom.
        self.s_1 = turn((p["s_1"] * cos(p["chi_1"]), p["s_1"] * sin(p["chi_1"])), theta)
        r_2 = turn((p["s_2"], 0), self.bc + p["chi_2"])
        self.s_2 = (self.b[0] + r_2[0], self.b[1] + r_2[1])
        r_3 = turn((p["s_3"], 0), self.theta_3 + p["chi_3"])
        self.s_3 = (o3[0] + r_3[0], o3[1] + r_3[1])
        d = turn((p["s_d"], 0), theta + p["chi_d"])
        self.drive = (d[0] - p["E_x"], d[1] - p["E_y"])
        self.l_d = hypot(*self.drive)


def results(p, theta):
    pose = Pose(p, theta)
    rate = lambda quantity: diff(lambda t: quantity(Pose(p, t)), theta, h=INNER)
    m_q = p["Q"] * rate(lambda x: x.a[1])
    m_g = sum(p[f"G_{i}"] * rate(lambda x, i=i: getattr(x, f"s_{i}")[1]) for i in (1, 2, 3))
    h_d = rate(lambda x: x.l_d)
    v = (rate(lambda x: x.a[0]) * p["omega_1"], rate(lambda x: x.a[1]) * p["omega_1"])
    # Forces of boom (B) and rocker (C) on the jib, from the jib's and the rocker's equilibrium.
    bx, by = pose.b
    cx, cy = pose.c
    o3x, o3y = -p["X_5"], p["X_6"]
    load = p["Q"] + p["G_2"]
    moment = p["Q"] * (pose.a[0] - bx) + p["G_2"] * (pose.s_2[0] - bx)
    equations = matrix([
        [1, 0, 1, 0],
        [0, 1, 0, 1],
        [0, 0, -(cy - by), cx - bx],  # about B
        [0, 0, cy - o3y, -(cx - o3x)],  # of the rocker about O3, with -F_C acting on it
    ])
    f_bx, f_by, f_cx, f_cy = lu_solve(equations, matrix([0, load, moment, p["G_3"] * (pose.s_3[0] - o3x)]))
    f_d = (m_q + m_g) / h_d
    push = (f_d * pose.drive[0] / pose.l_d, f_d * pose.drive[1] / pose.l_d)
    speed = h_d * p["omega_1"]
    return {
        "theta_3": pose.theta_3, "alpha_1": pose.alpha_1, "R": pose.a[0] + p["X_8"], "A.y": pose.a[1],
        "C.x": pose.c[0], "L": pose.l, "i_2": rate(lambda x: x.bc), "V_AX": v[0], "V_AY": v[1],
        "beta": atan2(v[1], v[0]) if v[0] > 0 else upright(atan2(v[1], v[0])),
        "L_d": pose.l_d, "h_d": h_d, "v_d": speed, "q_d": pi / 4 * p["D_c"] ** 2 * speed,
        "M_Q": m_q, "M_G": m_g, "M_D": m_q + m_g, "F_B.y": f_by, "F_C.x": f_cx,
        "N_3": -(f_cx * (cx - o3x) + f_cy * (cy - o3y)) / p["X_3"],
        "F_O1.x": f_bx - push[0], "F_O3.y": f_cy + p["G_3"], "F_d": f_d,
    }


def main():
    print("theta_1,output,known,value,derivative")
    for text in ANGLES:
        theta = mpf(float(text))
        values = results(SCENE, theta)
        for known in ["theta_1", *SCENE]:
            def at(step):
                if known == "theta_1":
                    return results(SCENE, theta + step)
                return results({**SCENE, known: SCENE[known] + step}, theta)
            above, below = at(OUTER), at(-OUTER)
            for output, value in values.items():
                derivative = (above[output] - below[output]) / (2 * OUTER)
                if abs(derivative) > mpf(10) ** -25:
                    print(f"{text},{output},{known},{float(value)!r},{float(derivative)!r}")
                else:
                    print(f"{text},{output},{known},{float(value)!r},0.0")


if __name__ == "__main__":
    main()
