"""40-digit reference of a crane on a portal with four corners: what the corners bear, of a rigid and of a hinged portal, the
greatest over the full slewing circle, the safety against tipping.

Independent of Lemnis: every weight is a force in space at its place, turned by the slewing angle, the wind forces at the
centres of their areas; moments are cross products. The rigid portal stands on four equal springs that never pull: of all
sets of legs, the one whose forces push and whose frame clears the others (every set is tried). On four legs it is the
plane through all four, whatever their signs. The hinged portal gives the weight to its front and rear by the law of the
lever, and each of them its part to its two legs. Over the circle every corner is looked at in steps of three degrees, and
the best place closed in by golden section. About an edge, weights and load count by their distance from it.

    python tests/oracles/portal_corners.py > tests/oracles/portal_corners.csv

Columns: base, gauge (m), bodies of the portal (weight x y), of the upper works (weight r), pressure of the wind (Pa), its
direction (rad), areas (area height), load (N), reach (m), slewing angle (rad); then weight of all, M_x, M_y, corner loads on
four legs, rigid, hinged (N, corners counter-clockwise from the right one in front), safeties (edges from that in front; empty
where nothing tips the crane); over the circle the greatest corner load of the rigid portal, its angle, the least on four
legs, the greatest of the hinged one.
"""

import random
from itertools import combinations

from mpmath import cos, lu_solve, matrix, mp, mpf, nstr, pi, sin, sqrt

mp.dps = 40
TINY = mpf(10) ** -30


def plane(points, those, force, at):
    """Forces of springs at those points: the plane that holds the force."""
    a = matrix(3, 3)
    for i in those:
        row = (mpf(1), *points[i])
        for j in range(3):
            for k in range(3):
                a[j, k] += row[j] * row[k]
    found = lu_solve(a, matrix([force, force * at[0], force * at[1]]))
    return [found[0] + found[1] * x + found[2] * y for x, y in points]


def shares(points, force, at):
    """Forces of four springs that never pull; none where the crane tips."""
    for count in (4, 3):
        for those in combinations(range(4), count):
            deep = plane(points, those, force, at)
            if all(deep[i] >= -TINY * force if i in those else deep[i] <= TINY * force for i in range(4)):
                return [deep[i] if i in those else mpf(0) for i in range(4)]
    return None


def hinged(points, force, at):
    (x0, _), (_, y1), (x2, _) = points[0], points[1], points[2]
    front = (at[0] - x2) / (x0 - x2)
    left = (at[1] + y1) / (2 * y1)
    ends = {True: front * force, False: (1 - front) * force}
    return [ends[x > 0] * (left if y > 0 else 1 - left) for x, y in points]


def golden(f, low, high):
    part = (sqrt(mpf(5)) - 1) / 2
    a, b = high - part * (high - low), low + part * (high - low)
    fa, fb = f(a), f(b)
    for _ in range(90):
        if fa > fb:
            high, b, fb = b, a, fa
            a = high - part * (high - low)
            fa = f(a)
        else:
            low, a, fa = a, b, fb
            b = low + part * (high - low)
            fb = f(b)
    return (low + high) / 2


class Crane:
    def __init__(self, rng, heavy):
        number = lambda low, high: mpf(str(round(rng.uniform(low, high), 3)))
        self.a, self.b = number(7, 13), number(6, 13)
        self.portal = [(number(500e3, 900e3), number(-0.3, 0.3), number(-0.3, 0.3)), (number(20e3, 80e3), number(-3, 3), number(-3, 3))]
        self.upper = [(number(300e3, 700e3), number(-1.2, 0)), (number(100e3, 220e3), number(6, 10)), (number(200e3, 350e3), number(-7, -4))]
        self.pressure, self.to = (number(100, 400), number(-3, 3)) if rng.random() < 0.7 else (mpf(0), mpf(0))
        self.areas = [(number(20, 50), number(5, 9)), (number(30, 70), number(15, 22))] if self.pressure else []
        self.load, self.reach = number(20e3, 160e3) * heavy, number(9, 30)
        self.psi = number(-3.1, 3.1)
        half = (self.a / 2, self.b / 2)
        self.points = [(half[0], -half[1]), half, (-half[0], half[1]), (-half[0], -half[1])]

    def weights(self, psi):
        """Of the crane without load: weight and place."""
        ahead = (cos(psi), sin(psi))
        return [*self.portal, *((g, r * ahead[0], r * ahead[1]) for g, r in self.upper)]

    def hung(self, psi):
        return self.load, self.reach * cos(psi), self.reach * sin(psi)

    def wind(self):
        """Of forces at heights about the rails: as weights would give them, about x and y."""
        turn = [mpf(0), mpf(0)]
        for area, height in self.areas:
            force = (self.pressure * area * cos(self.to), self.pressure * area * sin(self.to))
            # (0, 0, h) × (F_x, F_y, 0) = (-h F_y, h F_x, 0); a weight gives (-y G, x G, 0).
            turn = [turn[0] + height * force[1], turn[1] + height * force[0]]
        return turn

    def ground(self, psi):
        all_of = [*self.weights(psi), self.hung(psi)]
        force = sum(g for g, _, _ in all_of)
        wind = self.wind()
        m_x = sum(g * y for g, _, y in all_of) + wind[0]
        m_y = sum(g * x for g, x, _ in all_of) + wind[1]
        return force, m_x, m_y

    def at(self, psi):
        force, m_x, m_y = self.ground(psi)
        return force, (m_y / force, m_x / force)

    def safeties(self):
        found = []
        wind = self.wind()
        for out, far, blown in [((1, 0), self.a / 2, wind[1]), ((0, 1), self.b / 2, wind[0]), ((-1, 0), self.a / 2, -wind[1]),
                                ((0, -1), self.b / 2, -wind[0])]:
            beyond = lambda body: body[0] * (out[0] * body[1] + out[1] * body[2] - far)
            holds = -sum(beyond(body) for body in self.weights(self.psi))
            tips = beyond(self.hung(self.psi)) + blown
            found.append(holds / tips if tips > 0 else None)
        return found

    def best(self, of):
        """Greatest of all corners over the circle, with its angle."""
        step = pi / 60
        values = [of(i * step) for i in range(120)]
        corner, i = max(((c, i) for c in range(4) for i in range(120)), key=lambda at: values[at[1]][at[0]])
        place = golden(lambda psi: of(psi)[corner], (i - 1) * step, (i + 1) * step)
        return of(place)[corner], place

    def stands(self, lifted):
        """Whether it does so at every slewing angle, with a leg lifted at some of them or not."""
        around = [i * pi / 18 for i in range(36)]
        low = min(min(plane(self.points, range(4), *self.at(psi))) for psi in around)
        return (low < 0) == lifted and all(shares(self.points, *self.at(psi)) for psi in around)

    def row(self):
        force, m_x, m_y = self.ground(self.psi)
        _, place = self.at(self.psi)
        rigid = lambda psi: shares(self.points, *self.at(psi))
        four = lambda psi: plane(self.points, range(4), *self.at(psi))
        loose = lambda psi: hinged(self.points, *self.at(psi))
        greatest, angle = self.best(rigid)
        least, _ = self.best(lambda psi: [-load for load in four(psi)])
        peak, _ = self.best(loose)
        listed = lambda many: ";".join(" ".join(nstr(x, 20) for x in one) for one in many)
        text = lambda x: "" if x is None else nstr(x, 25)
        many = lambda values: " ".join(text(x) for x in values)
        given = [self.pressure, self.to]
        return ",".join([text(self.a), text(self.b), listed(self.portal), listed(self.upper), *map(text, given), listed(self.areas),
                         text(self.load), text(self.reach), text(self.psi), text(force), text(m_x), text(m_y),
                         many(four(self.psi)), many(rigid(self.psi)), many(loose(self.psi)),
                         ";".join(text(k) for k in self.safeties()), text(greatest), text(angle), text(-least), text(peak)])


def main():
    print("a,b,portal,upper,p_w,chi_w,areas,Q,R,psi,V,M_x,M_y,N_4,N_r,N_h,K,N_cir,psi_cir,N_4_cir,N_h_cir")
    rng = random.Random(72)
    for heavy, count, lifted in [(1, 16, False), (2, 16, True)]:
        made = 0
        while made < count:
            crane = Crane(rng, heavy)
            if crane.stands(lifted):
                print(crane.row(), flush=True)
                made += 1


main()
