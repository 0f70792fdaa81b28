"""40-digit reference of a column in three bearings: their forces in two load cases, pressures, friction moment, balancing
counterweight.

Independent of Lemnis: every weight is a force in space at its centre of gravity, gravity leans by the slope, the wind pushes
at the centres of its areas. The five reactions, two at the upper bearing and three at the foot, are unknowns of five
equations of equilibrium about a point that is neither; friction of the pivot is integrated over its rings; the counterweight
is that for which both moments of the upper works, solved one by one, are opposite.

    python tests/oracles/slewing_column.py > tests/oracles/slewing_column.csv

Columns: distance of the bearings (m), bodies (weight, place, height), areas (area, height), slope (rad; empty without), height
of the load's suspension (m), cases (factor of the load, pressure in Pa, direction in rad), load (N), reach (m), slewing angle
(rad), sizes (m: D_u, b_u, D_f, b_f, D_p, d_p), coefficients of friction (upper, foot, pivot), place of the counterweight (m);
then of each case: weight on the pivot, forces on upper and foot bearing (N), friction moment (N·m), pressures (Pa: upper, foot,
pivot); the counterweight (N).
"""

import random

from mpmath import cos, lu_solve, matrix, mp, mpf, nstr, pi, quad, sin, sqrt

mp.dps = 40


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


class Column:
    def __init__(self, rng, number):
        pick = lambda low, high: mpf(str(round(rng.uniform(low, high), 3)))
        self.h = pick(2, 12)
        self.upper = [(pick(200e3, 500e3), pick(-1.2, 0), pick(1, 4)), (pick(50e3, 120e3), pick(5, 9), pick(7, 14)),
                      (pick(80e3, 250e3), pick(-6, -3), pick(1, 5))]
        self.areas = [(pick(10, 40), pick(2, 5)), (pick(10, 30), pick(8, 15))] if number % 3 else []
        self.gamma = pick(0.002, 0.02) if number % 2 else None
        self.h_q = pick(15, 30)
        self.cases = [(pick(0.9, 1.4), pick(100, 400), pick(-3, 3)), (pick(0, 1), pick(0, 900), pick(-3, 3))]
        self.load, self.reach, self.psi = pick(10e3, 100e3), pick(8, 25), pick(-3, 3)
        inner = pick(0.05, 0.2) if number % 4 else mpf(0)
        self.sizes = [pick(0.8, 2), pick(0.1, 0.3), pick(0.3, 0.6), pick(0.2, 0.4), pick(0.3, 0.6), inner]
        self.mu = [pick(0.01, 0.15) for _ in range(3)]
        self.r_d = pick(3, 7)

    def wrench(self, case, about, more=()):
        """Force and moment of all that acts: x downhill, y to the left of that, z along the column."""
        factor, pressure, to = case
        gamma = self.gamma or mpf(0)
        down = [sin(gamma), mpf(0), -cos(gamma)]
        at = lambda r, h: [r * cos(self.psi), r * sin(self.psi), h]
        bodies = [(g, at(r, h)) for g, r, h in [*self.upper, *more]] + [(factor * self.load, at(self.reach, self.h_q))]
        forces = [([g * d for d in down], place) for g, place in bodies]
        forces += [([pressure * a * cos(to), pressure * a * sin(to), mpf(0)], [mpf(0), mpf(0), h]) for a, h in self.areas]
        arms = [cross([p - o for p, o in zip(place, about)], f) for f, place in forces]
        return [sum(f[i] for f, _ in forces) for i in range(3)], [sum(arm[i] for arm in arms) for i in range(3)]

    def reactions(self, case):
        about = [mpf("0.3"), mpf("-0.7"), mpf("1.1")]
        force, moment = self.wrench(case, about)
        places = [[mpf(0), mpf(0), mpf(0)], [mpf(0), mpf(0), -self.h]]
        unknown = [(places[0], 0), (places[0], 1), (places[1], 0), (places[1], 1), (places[1], 2)]
        rows = matrix(5, 5)
        for column, (place, axis) in enumerate(unknown):
            unit = [mpf(int(i == axis)) for i in range(3)]
            arm = cross([p - o for p, o in zip(place, about)], unit)
            for i, value in enumerate([*unit, arm[0], arm[1]]):
                rows[i, column] = value
        return lu_solve(rows, matrix([-force[0], -force[1], -force[2], -moment[0], -moment[1]]))

    def result(self, case):
        found = self.reactions(case)
        upper, foot, weight = sqrt(found[0] ** 2 + found[1] ** 2), sqrt(found[2] ** 2 + found[3] ** 2), found[4]
        d_u, b_u, d_f, b_f, d_p, inner = self.sizes
        area = pi * (d_p**2 - inner**2) / 4
        pivot = quad(lambda r: self.mu[2] * weight / area * 2 * pi * r * r, [inner / 2, d_p / 2])
        turn = self.mu[0] * upper * d_u / 2 + self.mu[1] * foot * d_f / 2 + pivot
        return [weight, upper, foot, turn, upper / (d_u * b_u), foot / (d_f * b_f), weight / area]

    def counterweight(self):
        """On level ground without wind; the rest of both moments is linear in the weight."""
        gamma, self.gamma = self.gamma, None
        origin = [mpf(0)] * 3

        def rest(weight):
            more = [(weight, -self.r_d, mpf(0))]
            both = [self.wrench((factor, mpf(0), mpf(0)), origin, more)[1] for factor in (0, 1)]
            return sum(sin(self.psi) * m[0] - cos(self.psi) * m[1] for m in both)

        zero, one = rest(mpf(0)), rest(mpf(1000))
        self.gamma = gamma
        return -1000 * zero / (one - zero)

    def row(self):
        text = lambda x: "" if x is None else nstr(x, 25)
        listed = lambda many: ";".join(" ".join(nstr(x, 20) for x in one) for one in many)
        return ",".join([text(self.h), listed(self.upper), listed(self.areas), text(self.gamma), text(self.h_q), listed(self.cases),
                         text(self.load), text(self.reach), text(self.psi), listed([self.sizes]), listed([self.mu]), text(self.r_d),
                         ";".join(" ".join(text(x) for x in self.result(case)) for case in self.cases), text(self.counterweight())])


def main():
    print("h,upper,areas,gamma,h_Q,cases,Q,R,psi,sizes,mu,r_d,results,G_d")
    rng = random.Random(632)
    for number in range(30):
        print(Column(rng, number).row())


main()
