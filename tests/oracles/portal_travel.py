"""40-digit reference of the travel of a crane on a portal: what resists it, its motors, a stop, driven wheels that slip or slide,
rail clamps and anchors in a storm.

Independent of Lemnis: every wheel has its own load and its own balance of moments about its axle; a motor has the torque of its
shaft times its speed; a stop takes the kinetic energy of the crane and of all shafts, and its force on the rails is Newton's law
of the crane alone; clamps hold the balance along the rails; about an edge all weights count by their distance from it. The four
corner loads are those of equal springs that all bear, from three balances and from the frame that stays plane.

    python tests/oracles/portal_travel.py > tests/oracles/portal_travel.csv

Columns: base, gauge (m), bodies of the portal (weight x y), of the upper works (weight r), pressure of the wind (Pa), its
direction (rad), areas (area height), load (N), reach (m), slewing angle (rad), wheels and driven wheels of the corners; of the
travel speed, acceleration, slope (rad), diameters of wheel and bearing, lever arm, friction, factor of flanges, adhesion, force
of the brakes, safety, motors, ratio, efficiency, rated power, overload, inertia; of the storm pressure, clamps, force of each;
gravity; then results by their names, all SI.
"""

import random

from mpmath import cos, lu_solve, matrix, mp, mpf, nstr, pi, sin

mp.dps = 40
G = mpf("9.81")
TRAVEL = ("v_t", "a_t", "gamma_t", "D_t", "d_j", "f_r", "mu_j", "beta_t", "mu_a", "F_br", "k_w", "z_m", "i_t", "eta_t", "P_N",
          "lambda_M", "J_M")
STORM = ("p_s", "z_c", "F_c")
SIDES = [(1, -1), (1, 1), (-1, 1), (-1, -1)]
# Where an edge lies, outward.
OUT = [(1, 0), (0, 1), (-1, 0), (0, -1)]


class Crane:
    def __init__(self, rng):
        number = lambda low, high: mpf(str(round(rng.uniform(low, high), 4)))
        self.a, self.b = number(8, 13), number(8, 13)
        self.portal = [(number(600e3, 900e3), number(-0.3, 0.3), number(-0.3, 0.3)), (number(20e3, 60e3), number(-3, 3), number(-3, 3))]
        self.upper = [(number(400e3, 700e3), number(-1.2, 0)), (number(100e3, 200e3), number(6, 9)), (number(200e3, 300e3), number(-6, -4))]
        self.pressure, self.to = number(100, 300), number(-3, 3)
        self.areas = [(number(20, 50), number(5, 9)), (number(30, 70), number(15, 22))]
        self.load, self.reach, self.psi = number(20e3, 140e3), number(9, 24), number(-3.1, 3.1)
        self.wheels = [mpf(rng.randint(4, 8)) for _ in range(4)]
        self.driven = [mpf(rng.choice((0, 2, 4))) for _ in range(4)]
        self.driven[rng.randrange(4)] = mpf(3)
        self.t = dict(zip(TRAVEL, (number(0.3, 0.6), number(0.05, 0.2), number(0, 0.01), number(0.4, 0.8), number(0.08, 0.15),
                                   number(0.0003, 0.001), number(0.01, 0.03), number(1, 2), number(0.1, 0.2), number(80e3, 160e3),
                                   number(1, 1.3), mpf(rng.randint(2, 12)), number(30, 90), number(0.8, 0.95), number(3e3, 9e3),
                                   number(1.5, 2.5), number(0.02, 0.2))))
        self.s = dict(zip(STORM, (number(500, 9000), mpf(rng.randint(2, 8)), number(20e3, 90e3))))

    def weights(self):
        ahead = (cos(self.psi), sin(self.psi))
        return [*self.portal, *((g, r * ahead[0], r * ahead[1]) for g, r in self.upper)]

    def corners(self):
        """Loads of four equal springs: three balances, and no warping."""
        all_of = [*self.weights(), (self.load, self.reach * cos(self.psi), self.reach * sin(self.psi))]
        force, x, y = (sum(g * at for g, *place in all_of for at in [(1, *place)[i]]) for i in range(3))
        blown = sum(self.pressure * area * height for area, height in self.areas)
        x, y = x + blown * cos(self.to), y + blown * sin(self.to)
        rows = matrix([[1] * 4, [sx * self.a / 2 for sx, _ in SIDES], [sy * self.b / 2 for _, sy in SIDES], [sx * sy for sx, sy in SIDES]])
        return force, list(lu_solve(rows, matrix([force, x, y, 0])))

    def wheel(self, load):
        """Force at the tread of a wheel that turns steadily: h D/2 = n f + μ n d/2."""
        t = self.t
        return (load * t["f_r"] + t["mu_j"] * load * t["d_j"] / 2) / (t["D_t"] / 2)

    def results(self):
        t, s = self.t, self.s
        force, corners = self.corners()
        level, down = cos(t["gamma_t"]), sin(t["gamma_t"])
        free = sum(n * self.wheel(load * level / n) for n, load in zip(self.wheels, corners))
        area = sum(a for a, _ in self.areas)
        wind = self.pressure * area * abs(cos(self.to))
        steady = t["beta_t"] * free + force * down + wind
        start = steady + force / G * t["a_t"]
        radius = t["D_t"] / 2
        turning, spin_up = t["v_t"] * t["i_t"] / radius, t["a_t"] * t["i_t"] / radius
        shaft = lambda push, rate: (push / t["z_m"] * radius / (t["i_t"] * t["eta_t"]) + t["J_M"] * rate) * turning
        found = {"F_0": free, "F_wt": wind, "F_t": steady, "F_ta": start, "n_t": turning / (2 * pi), "P_t": shaft(steady, 0),
                 "P_a": shaft(start, spin_up)}
        found["u_t"], found["u_a"] = found["P_t"] / t["P_N"], found["P_a"] / (t["lambda_M"] * t["P_N"])
        drives = wind + force * down - free
        energy = force / G * t["v_t"] ** 2 / 2 + t["z_m"] * t["J_M"] * turning ** 2 / 2
        way = energy / (t["F_br"] - drives)
        rate = t["v_t"] ** 2 / (2 * way)
        rails = force / G * rate + drives
        found |= {"F_do": drives, "u_hd": (drives + (t["k_w"] - 1) * wind) / t["F_br"], "a_br": rate, "t_br": 2 * way / t["v_t"],
                  "s_br": way, "F_tb": rails}
        many = sum(self.driven)
        for corner, (n, driven, load) in enumerate(zip(self.wheels, self.driven, corners), 1):
            gives = t["mu_a"] * load / n
            found[f"F_ad[{corner}]"] = gives
            for name, asked in (("k_st", start), ("k_br", rails)):
                found[f"{name}[{corner}]"] = gives / abs(asked / many) if driven else None
        empty = sum(g for g, _, _ in self.weights())
        storm = s["p_s"] * area
        clamps = t["k_w"] * storm + empty * down - self.wheel(empty * level)
        found |= {"F_cl": clamps, "u_c": clamps / (s["z_c"] * s["F_c"])}
        turns = sum(s["p_s"] * a * h for a, h in self.areas)
        for edge, (ox, oy) in enumerate(OUT, 1):
            far, across = (self.a / 2, self.a) if ox else (self.b / 2, self.b)
            holds = sum(g * (far - ox * x - oy * y) for g, x, y in self.weights())
            found[f"K_s[{edge}]"] = holds / turns
            found[f"U[{edge}]"] = (t["k_w"] * turns - holds) / across
        return found

    def legal(self):
        return min(self.corners()[1]) > 0 and self.results()["F_do"] < self.t["F_br"] and all(
            driven <= wheels for driven, wheels in zip(self.driven, self.wheels))

    def row(self, names):
        text = lambda x: "" if x is None else nstr(x, 25)
        many = lambda values: " ".join(nstr(x, 20) for x in values)
        listed = lambda rows: ";".join(map(many, rows))
        found = self.results()
        return ",".join([*map(text, (self.a, self.b)), listed(self.portal), listed(self.upper), text(self.pressure), text(self.to),
                         listed(self.areas), *map(text, (self.load, self.reach, self.psi)),
                         listed(zip(self.wheels, self.driven)), many(self.t.values()), many(self.s.values()), nstr(G, 20),
                         *(text(found[name]) for name in names)])


def main():
    rng = random.Random(720)
    cranes = []
    while len(cranes) < 24:
        crane = Crane(rng)
        if crane.legal():
            cranes.append(crane)
    names = list(cranes[0].results())
    print(",".join(["a", "b", "portal", "upper", "p_w", "chi_w", "areas", "Q", "R", "psi", "wheels", "travel", "storm", "g", *names]))
    for crane in cranes:
        print(crane.row(names))


if __name__ == "__main__":
    main()
