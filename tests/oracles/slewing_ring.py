"""40-digit reference of a slewing ring: forces and moment on it in two load cases, forces on its rolling elements, contact
stress, static safety, friction.

Independent of Lemnis: every weight is a force in space at its centre of gravity, gravity leans by the slope, the wind pushes
at the centres of its areas; the ring bears their sum and the cross products about its centre. The rolling elements are
found from both unknowns of a rigid ring at once, its sinking and its tilt: Newton's method in two dimensions on the sums of
forces and moments, from springs on. Contact stresses come from the size of the contact (its radius, its half width), the
static safety by halving over what lies under the load curve, friction from the forces one by one.

    python tests/oracles/slewing_ring.py > tests/oracles/slewing_ring.csv

Columns: diameter (m), number of elements, contact angle (rad), law, rows, bodies (weight, place, height), areas (area, height),
slope (rad; empty without), height of the load's suspension (m), cases (factor of the load, pressure in Pa, direction in rad),
load (N), reach (m), slewing angle (rad), radius of curvature, length of the roller (m; empty at a point), load curve; then of
each case: vertical and horizontal force (N), moment (N·m), greatest force on an element, that on the far side, sum of all by
amount along the contact (N), contact stress (Pa), static safety, friction moments of both forms (N·m), whether the far side
lifts.
"""

import random

from mpmath import cos, fabs, lu_solve, matrix, mp, mpf, nstr, pi, sign, sin, sqrt

mp.dps = 40
POWERS = {"linear": mpf(1), "line": mpf(10) / 9, "point": mpf(3) / 2}
E, NU = mpf(206) * 10**9, mpf("0.3")
MU_N, MU_M = mpf("0.008"), mpf("0.004")
F_ST = mpf("1.25")


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def shared(force, moment, diameter, cosines, power, held):
    """Forces of the rolling elements under a force and a moment: sinking u and tilt t of the ring."""
    def one(x):
        return sign(x) * fabs(x) ** power if held or x > 0 else mpf(0)

    def rate(x):
        return power * fabs(x) ** (power - 1) if x != 0 and (held or x > 0) else mpf(0)

    arms = [diameter / 2 * c for c in cosines]
    z = len(cosines)
    # From springs on two rows; the load is brought to the size of one first, and grows in steps.
    size = force + 2 * moment / diameter
    f, m = force / size, moment / size
    u, t = f / z, 2 * m / (diameter / 2 * sum(c * c for c in cosines)) / 2
    u, t = (fabs(u) ** (1 / power)), (fabs(t) * diameter / 2) ** (1 / power)

    def off(u, t):
        p = [one(u + t * c) for c in cosines]
        return f - sum(p), (m - sum(q * a for q, a in zip(p, arms))) * 2 / diameter

    miss = off(u, t)
    for _ in range(400):
        k = [rate(u + t * c) for c in cosines]
        a = matrix(2, 2)
        for kj, c in zip(k, cosines):
            a[0, 0] += kj
            a[0, 1] += kj * c
            a[1, 0] += kj * c
            a[1, 1] += kj * c * c
        step = lu_solve(a, matrix(list(miss)))
        part = mpf(1)
        while True:
            new = off(u + part * step[0], t + part * step[1])
            if max(map(fabs, new)) < max(map(fabs, miss)) or part < mpf(10) ** -6:
                break
            part /= 2
        u, t, miss = u + part * step[0], t + part * step[1], new
        if max(map(fabs, miss)) < mpf(10) ** -33:
            break
    assert max(map(fabs, miss)) < mpf(10) ** -30, miss
    return [one(u + t * c) * size for c in cosines], u + t * min(cosines)


class Ring:
    def __init__(self, rng, law, held):
        number = lambda low, high: mpf(str(round(rng.uniform(low, high), 3)))
        self.d, self.z, self.alpha = number(2, 5), rng.randint(12, 60), number(0.7, 1.57)
        self.law, self.held = law, held
        self.upper = [(number(300e3, 700e3), number(-1.2, 0), number(2, 5)), (number(100e3, 220e3), number(6, 10), number(9, 15)),
                      (number(200e3, 350e3), number(-7, -4), number(3, 7))]
        self.areas = [(number(10, 40), number(2, 5)), (number(10, 30), number(8, 15))] if rng.random() < 0.7 else []
        self.gamma = number(0.002, 0.02) if rng.random() < 0.6 else None
        self.h_q = number(15, 30)
        self.cases = [(number(0.9, 1.4), number(100, 400), number(-3, 3)), (number(0, 1), number(0, 900), number(-3, 3))]
        self.load, self.reach, self.psi = number(20e3, 160e3), number(9, 30), number(-3, 3)
        self.rho = number(0.01, 0.03)
        self.b_r = number(0.02, 0.05) if law == "line" else None
        self.curve = [(mpf(0), number(6e6, 9e6)), (number(1e6, 3e6), number(5e6, 8e6)), (number(6e6, 9e6), mpf(0))]

    def wrench(self, case):
        """Force and moment at the ring, in its own directions: x downhill, y to the left of that, z square to the ring."""
        factor, pressure, to = case
        gamma = self.gamma or mpf(0)
        down = [sin(gamma), mpf(0), -cos(gamma)]
        at = lambda r, h: [r * cos(self.psi), r * sin(self.psi), h]
        bodies = [(g, at(r, h)) for g, r, h in self.upper] + [(factor * self.load, at(self.reach, self.h_q))]
        forces = [([g * d for d in down], place) for g, place in bodies]
        forces += [([pressure * a * cos(to), pressure * a * sin(to), mpf(0)], [mpf(0), mpf(0), h]) for a, h in self.areas]
        force = [sum(f[i] for f, _ in forces) for i in range(3)]
        turns = [cross(place, f) for f, place in forces]
        turn = [sum(t[i] for t in turns) for i in range(3)]
        return -force[2], sqrt(force[0] ** 2 + force[1] ** 2), sqrt(turn[0] ** 2 + turn[1] ** 2)

    def stress(self, force):
        modulus = 1 / (2 * (1 - NU**2) / E)
        if self.b_r is None:
            radius = (3 * force * self.rho / (4 * modulus)) ** (mpf(1) / 3)
            return 3 * force / (2 * pi * radius**2)
        half = sqrt(4 * force * self.rho / (pi * self.b_r * modulus))
        return 2 * force / (pi * half * self.b_r)

    def below(self, force, moment):
        for (f_1, m_1), (f_2, m_2) in zip(self.curve, self.curve[1:]):
            if f_1 <= force <= f_2:
                return moment <= m_1 + (m_2 - m_1) * (force - f_1) / (f_2 - f_1)
        return False

    def safety(self, force, moment):
        low, high = mpf(0), mpf(1000)
        for _ in range(150):
            middle = (low + high) / 2
            low, high = (middle, high) if self.below(force * middle, moment * middle) else (low, middle)
        return low

    def result(self, case):
        v, h, m = self.wrench(case)
        if not self.held and 2 * m / (v * self.d) > mpf("0.97"):
            return None
        cosines = [cos(2 * pi * j / self.z) for j in range(self.z)]
        forces, far = shared(v, m, self.d, cosines, POWERS[self.law], self.held)
        normal = [fabs(p) / sin(self.alpha) for p in forces]
        turn = sum(MU_N * n * self.d / 2 for n in normal)
        maker = MU_M / 2 * (mpf("4.4") * m + v * self.d + mpf("2.2") * mpf("1.73") * h * self.d)
        equivalent = v + mpf("5.046") * h
        return [v, h, m, max(forces), forces[self.z // 2], sum(normal), self.stress(max(normal)), self.safety(equivalent, m), turn, maker,
                mpf(1 if far < 0 else 0)]

    def row(self):
        results = [self.result(case) for case in self.cases]
        if any(result is None for result in results):
            return None
        text = lambda x: "" if x is None else nstr(x, 25)
        listed = lambda many: ";".join(" ".join(nstr(x, 20) for x in one) for one in many)
        return ",".join([text(self.d), str(self.z), text(self.alpha), self.law, "hold_down" if self.held else "pressure", listed(self.upper),
                         listed(self.areas), text(self.gamma), text(self.h_q), listed(self.cases), text(self.load), text(self.reach),
                         text(self.psi), text(self.rho), text(self.b_r), listed(self.curve),
                         ";".join(" ".join(text(x) for x in result) for result in results)])


def main():
    print("D,z,alpha,law,rows,upper,areas,gamma,h_Q,cases,Q,R,psi,rho,b_r,curve,results")
    rng = random.Random(63)
    for law in POWERS:
        for held in (False, True):
            made = 0
            while made < 6:
                row = Ring(rng, law, held).row()
                if row is not None:
                    print(row, flush=True)
                    made += 1


main()
