"""50-digit reference of a mobile crane on its supports: tipping load, what is left behind without load, the load at which a
support is full, forces on the supports.

Independent of Lemnis: every weight is a force in space at its centre of gravity, turned by the slope, the wind a force at
the head; the ground's force stands where their moments in its plane vanish. The crane stands as long as that place lies in
some triangle of three supports, whatever the polygon is: the tipping load is closed in by halving. Forces of a rigid frame
on equal springs that never pull: of all sets of supports, the one whose forces push and whose frame clears all others
(every set is tried). The load at which a support is full is closed in by halving over those.

    python tests/oracles/mobile_crane.py > tests/oracles/mobile_crane.csv

Columns: supports (x y of each, m), what each bears at most (N, one for all), bodies of carrier (weight x y h), upper works
(weight r h) and boom (weight, weight for each metre of extension, place, part of the extension), foot (x h), distance of the
rope at the head, shortest length, length (m), angle, slewing angle (rad), load, hook (N), slope (rad), wind over weight; then
reach, height of the head (m), tipping load (N; empty where the load lies within), part left behind, load at which a support
is full (N; empty where none is), forces (N).
"""

import random
from itertools import combinations

from mpmath import cos, lu_solve, matrix, mp, mpf, nstr, sin, sqrt

mp.dps = 50
LAYOUTS = {
    "triangle": [(3, 0), (-2, 2.5), (-2, -2.5)],
    "outriggers": [(2.2, -3), (2.2, 3), (-2.9, 3), (-2.9, -3)],
    "askew": [(2.4, -2.1), (2.0, 3.1), (-3.2, 2.2), (-2.5, -3.3)],
    "five": [(3.5, 0), (1.5, 3), (-3, 2.2), (-3, -2.2), (1.5, -3)],
    "tyres": [(3.2, 1.1), (3.2, -1.1), (1.7, 1.1), (1.7, -1.1), (-1.4, 1.1), (-1.4, -1.1), (-2.8, 1.1), (-2.8, -1.1)],
}


def place(forces):
    """Ground's force, and where it acts: of forces (at, vector) the point of the plane without their moment."""
    down = -sum(f[2] for _, f in forces)
    turn_x = sum(at[1] * f[2] - at[2] * f[1] for at, f in forces)
    turn_y = sum(at[2] * f[0] - at[0] * f[2] for at, f in forces)
    return down, (turn_y / down, -turn_x / down)


def stands(points, at):
    """Whether a place lies in a triangle of three of the points."""
    def side(a, b, c):
        return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])

    for a, b, c in combinations(points, 3):
        signs = [side(a, b, at), side(b, c, at), side(c, a, at)]
        if side(a, b, c) != 0 and (all(s >= 0 for s in signs) or all(s <= 0 for s in signs)):
            return True
    return False


def shares(points, force, at):
    """Forces of all springs; none where the body falls."""
    for count in range(len(points), 2, -1):
        for those in combinations(range(len(points)), count):
            a = matrix(3, 3)
            for i in those:
                row = (mpf(1), points[i][0], points[i][1])
                for j in range(3):
                    for k in range(3):
                        a[j, k] += row[j] * row[k]
            try:
                plane = lu_solve(a, matrix([force, force * at[0], force * at[1]]))
            except ZeroDivisionError:
                continue
            deep = [plane[0] + plane[1] * x + plane[2] * y for x, y in points]
            tiny = force * mpf(10) ** -40
            if all(deep[i] >= -tiny if i in those else deep[i] <= tiny for i in range(len(points))):
                found = [deep[i] if i in those else mpf(0) for i in range(len(points))]
                # Supports on one line give any numbers.
                left = [sum(found) - force] + [sum(f * p[k] for f, p in zip(found, points)) - force * at[k] for k in (0, 1)]
                if max(map(abs, left)) < tiny * 100:
                    return found
    return None


def halve(low, high, holds):
    for _ in range(150):
        middle = (low + high) / 2
        low, high = (middle, high) if holds(middle) else (low, middle)
    return (low + high) / 2


class Crane:
    def __init__(self, rng, layout, steep=False):
        number = lambda low, high: mpf(str(round(rng.uniform(low, high), 3)))
        self.points = [(mpf(str(x)), mpf(str(y))) for x, y in LAYOUTS[layout]]
        self.cap = number(120e3, 260e3)
        self.carrier = [(number(60e3, 150e3), number(-0.5, 1.2), number(-0.2, 0.2), number(0.8, 1.4)) for _ in range(2)]
        self.upper = [(number(30e3, 50e3), number(-1, 0), number(1.5, 2.5)), (number(20e3, 40e3), number(-2.6, -1.5), number(1.5, 2))]
        self.boom = [(number(15e3, 25e3), number(0, 300), number(3, 5), mpf(0)), (number(5e3, 12e3), mpf(0), number(4, 6), number(0.3, 0.6)),
                     (number(5e3, 9e3), mpf(0), number(5, 7), mpf(1))]
        self.foot = (number(-1.5, 0.5), number(1.8, 2.8))
        self.beside, self.shortest = number(-0.4, 0.4), number(9, 11)
        self.length = self.shortest + number(0, 14)
        self.phi, self.psi = number(0.2, 1.25), number(-3.1, 3.1)
        if steep:
            self.length, self.phi = self.shortest, number(1.35, 1.45)
        self.load, self.hook = number(0, 40e3 if rng.random() < 0.4 else 120e3), number(0, 4e3)
        self.slope, self.wind = (number(0.002, 0.03), number(0, 0.02)) if rng.random() < 0.6 else (mpf(0), mpf(0))
        along, up = (cos(self.phi), sin(self.phi)), (sin(self.phi), -cos(self.phi))
        self.reach = self.foot[0] + self.length * along[0] + self.beside * up[0]
        self.height = self.foot[1] + self.length * along[1] + self.beside * up[1]

    def forces(self, hung, slope):
        ahead = (cos(self.psi), sin(self.psi))

        def weight(g, x, y, z):
            return (x, y, z), (g * sin(slope) * ahead[0], g * sin(slope) * ahead[1], -g * cos(slope))

        def in_front(g, r, z):
            return weight(g, r * ahead[0], r * ahead[1], z)

        all_of = [weight(*body) for body in self.carrier] + [in_front(*body) for body in self.upper]
        longer = self.length - self.shortest
        for g, q, s, kappa in self.boom:
            far = s + kappa * longer
            all_of.append(in_front(g + q * longer, self.foot[0] + far * cos(self.phi), self.foot[1] + far * sin(self.phi)))
        if hung:
            all_of.append(in_front(hung, self.reach, self.height))
            head = (self.reach * ahead[0], self.reach * ahead[1], self.height)
            all_of.append((head, (self.wind * hung * ahead[0], self.wind * hung * ahead[1], mpf(0))))
        return all_of

    def at(self, hung, slope=None):
        return place(self.forces(hung, self.slope if slope is None else slope))

    def tips(self):
        most = mpf(10) ** 9
        if stands(self.points, self.at(most)[1]):
            return None
        return halve(mpf(0), most, lambda load: stands(self.points, self.at(load)[1]))

    def back(self):
        """Without load, the slope to the rear: least share over all lines that have every support on one side, and the boom
        away from them."""
        at, parts = self.at(mpf(0), -self.slope)[1], []
        for a, b in combinations(self.points, 2):
            out = ((b[1] - a[1]), -(b[0] - a[0]))
            size = sqrt(out[0] ** 2 + out[1] ** 2)
            for sign in (1, -1):
                n = (sign * out[0] / size, sign * out[1] / size)
                inside = [n[0] * (a[0] - x) + n[1] * (a[1] - y) for x, y in self.points]
                if min(inside) >= -mpf(10) ** -40 and n[0] * cos(self.psi) + n[1] * sin(self.psi) < 0:
                    parts.append((n[0] * (a[0] - at[0]) + n[1] * (a[1] - at[1])) / max(inside))
        return min(parts)

    def full(self, tips):
        def free(load):
            found = shares(self.points, *self.at(load))
            return found is not None and max(found) < self.cap

        most = (tips or mpf(3000000)) * (1 - mpf(10) ** -30)
        if not free(mpf(0)):
            return mpf(0)
        last = mpf(0)
        for i in range(1, 41):
            load = most * i / 40
            if not free(load):
                return halve(last, load, free)
            last = load
        return None

    def row(self):
        listed = lambda many: ";".join(" ".join(nstr(x, 20) for x in one) for one in many)
        force, at = self.at(self.load + self.hook)
        tips = self.tips()
        found = shares(self.points, force, at)
        full = self.full(tips)
        if found is None or full == 0 or not stands(self.points, self.at(mpf(0))[1]):
            return None
        text = lambda x: "" if x is None else nstr(x, 25)
        given = [self.cap, *self.foot, self.beside, self.shortest, self.length, self.phi, self.psi, self.load, self.hook,
                 self.slope, self.wind]
        results = [self.reach, self.height, tips, self.back(), full]
        return ",".join([listed(self.points), listed(self.carrier), listed(self.upper), listed(self.boom),
                         *map(text, given), *map(text, results), " ".join(map(text, found))])


def main():
    print("points,carrier,upper,boom,cap,x_F,h_F,d_A,l_0,l,phi,psi,Q,G_h,gamma,w_Q,R,H,P,back,Q_N,N")
    rng = random.Random(20)
    for layout, count, steep in [("triangle", 8, 0), ("outriggers", 16, 0), ("askew", 16, 0), ("five", 10, 0), ("tyres", 12, 0),
                                 ("outriggers", 4, 1)]:
        made = 0
        while made < count:
            row = Crane(rng, layout, steep).row()
            if row:
                print(row, flush=True)
                made += 1


main()
