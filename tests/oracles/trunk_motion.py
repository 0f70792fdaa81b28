"""Derivatives of what a boom with a curved trunk does in motion by its states, inputs and parameters, in 50 digits.

Independent of Lemnis: the point of contact by Newton's method on the closure with 120 digits (mpmath), places and angles
differentiated by central differences, the equations of motion from the energies, forces from equilibrium; then central
differences of these.

    python tests/oracles/trunk_motion.py > tests/oracles/trunk_motion.csv
"""

from mpmath import atan2, cos, findroot, hypot, lu_solve, matrix, mp, mpf, pi, sign, sin

mp.dps = 120
INNER, OUTER = mpf(10) ** -30, mpf(10) ** -20

DEGREE = pi / 180
# The ready scene in SI, as the doubles that a program reads from the decimal text.
SCENE = {
    **{name: mpf(float(text)) for name, text in {
        "b": "21.5", "a": "14.2", "L_t": "21.05", "O3_x": "-6", "O3_y": "12", "Z_x": "-1.15", "Z_y": "0.05", "rho": "5",
        "Q": "98100", "G_b": "127530", "r_b": "9.5", "G_t": "58860", "r_t": "1.8", "G_c": "392400", "r_c": "5.8",
        "J_b": "500000", "J_t": "180000", "c_v": "200e3", "M_F": "5e3", "g": "9.81"}.items()},
    "zeta_f": mpf(float(132 * DEGREE)), "chi_b": mpf(float(DEGREE)), "chi_t": mpf(float(3 * DEGREE)), "chi_c": mpf(0),
}
SWING = {"phi_R": mpf(float("0.3")), "omega_R": mpf(float("0.2")), "l_R": mpf(15)}
CASES = {
    "rigid/forward": {"phi": "1.0", "omega": "0.15", "M_A": "3e5"},
    "rigid/backward": {"phi": "1.35", "omega": "-0.2", "M_A": "-1e5"},
    "swing/taut": {"phi": "0.8", "omega": "0.12", "M_A": "3e5"},
}


def polar(length, angle):
    return matrix([length * cos(angle), length * sin(angle)])


def cross(a, b):
    return a[0] * b[1] - a[1] * b[0]


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1]


class Pose:
    """Boom, trunk and tie at an angle; the tail's end does not matter."""

    def __init__(self, p, phi):
        self.b = polar(p["b"], phi)
        way = matrix([p["O3_x"], p["O3_y"]]) - self.b

        def end(zeta):
            along = matrix([-sin(zeta), cos(zeta)])
            at = matrix([p["Z_x"], p["Z_y"]]) + polar(p["rho"], zeta)
            return at, along, at + along * (p["L_t"] - p["rho"] * (zeta - p["zeta_f"]))
        zeta = findroot(lambda zeta: dot(end(zeta)[2], end(zeta)[2]) - dot(way, way), mpf(3), tol=mpf(10) ** -230)
        at, along, tip = end(zeta)
        self.alpha = atan2(way[1], way[0]) - atan2(tip[1], tip[0])
        turn = lambda v: matrix([v[0] * cos(self.alpha) - v[1] * sin(self.alpha), v[0] * sin(self.alpha) + v[1] * cos(self.alpha)])
        self.tie, self.touch = turn(along), turn(at)
        self.a = self.b + polar(p["a"], self.alpha)
        self.s_b = polar(p["r_b"], phi + p["chi_b"])
        self.s_t = self.b + polar(p["r_t"], self.alpha + p["chi_t"])
        self.s_c = polar(p["r_c"], phi + p["chi_c"] + pi)


def found(p, swings):
    """Acceleration of boom and rope, the tie's force, those of boom and frame."""
    poses = [Pose(p, p["phi"] + k * INNER) for k in (-1, 0, 1)]
    here, up = poses[1], matrix([0, p["g"]])

    def ways(of):
        a, b, c = [of(pose) for pose in poses]
        return b, (c - a) / (2 * INNER), (a - 2 * b + c) / INNER**2
    boom, trunk, counterweight, head = [ways(lambda pose, name=name: getattr(pose, name)) for name in ("s_b", "s_t", "s_c", "a")]
    _, turn, change = ways(lambda pose: pose.alpha)
    mass = {name: p[name] / p["g"] for name in ("G_b", "G_t", "G_c", "Q")}
    w = p["omega"]
    bodies = [(mass["G_b"], boom), (mass["G_t"], trunk), (mass["G_c"], counterweight)] + ([] if swings else [(mass["Q"], head)])
    inertia = p["J_b"] + p["J_t"] * turn**2 + sum(m * dot(v, v) for m, (_, v, _) in bodies)
    force = p["M_A"] - p["c_v"] * w - p["M_F"] * sign(w) - p["J_t"] * turn * change * w**2
    force -= sum(m * (dot(v, a) * w**2 + p["g"] * v[1]) for m, (_, v, a) in bodies)
    _, travel, bend = head
    if swings:
        m, l = mass["Q"], p["l_R"]
        across = matrix([cos(p["phi_R"]), sin(p["phi_R"])])
        inward = matrix([-across[1], across[0]])
        rest = bend * w**2 + inward * (l * p["omega_R"] ** 2)
        couple = m * l * dot(travel, across)
        left = matrix([[inertia + m * dot(travel, travel), couple], [couple, m * l**2]])
        turning, swing = lu_solve(left, matrix([force - m * dot(travel, rest + up), -m * l * dot(across, rest + up)]))
        load = m * (rest + up + travel * turning + across * (l * swing))
    else:
        turning, swing = force / inertia, None
        load = mass["Q"] * (travel * turning + bend * w**2 + up)
    push = lambda m, way: m * (way[1] * turning + way[2] * w**2 + up)
    own = push(mass["G_t"], trunk)
    about = cross(here.s_t - here.b, own) + cross(here.a - here.b, load) + p["J_t"] * (turn * turning + change * w**2)
    pull = about / cross(here.touch, here.tie)
    on_trunk = own + load - here.tie * pull
    whole = on_trunk + push(mass["G_b"], boom) + push(mass["G_c"], counterweight)
    results = {"der(omega)": turning, "N_t": pull, "q_t": pull / p["rho"], "F_B.x": on_trunk[0], "F_B.y": on_trunk[1],
               "F_O1.x": whole[0], "F_O1.y": whole[1]}
    if swings:
        results["der(omega_R)"] = swing
        results["S_R"] = hypot(load[0], load[1])
    return results


def main():
    print("case,unknown,known,value,derivative")
    for case, given in CASES.items():
        swings = case.startswith("swing")
        p = {**SCENE, **{name: mpf(float(text)) for name, text in given.items()}, **(SWING if swings else {})}
        values = found(p, swings)
        for known in p:
            sides = [found({**p, known: p[known] + k * OUTER}, swings) for k in (-1, 1)]
            for unknown, value in values.items():
                slope = (sides[1][unknown] - sides[0][unknown]) / (2 * OUTER)
                print(f"{case},{unknown},{known},{float(value)!r},{float(slope)!r}")


main()
