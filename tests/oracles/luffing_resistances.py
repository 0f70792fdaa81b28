"""What the drive of a luffing mechanism must overcome, of the crane of [Balance004] with its new balance and of the boom on
a luffing rope, from the geometry alone: moments about the boom's foot (N m), positive where they raise the boom.

Independent of Lemnis: points in the plane are complex numbers (mpmath). Every moment is found twice, and both ways must
agree to 1e-20 of the greatest: by power (numeric derivatives of the work and of the kinetic energy by the boom's angle,
bodies as two masses at the ends of their radius of gyration) and by equilibrium (velocities and accelerations of the loops
by linear equations, forces of d'Alembert, one system of equations for all pins, the rod and the drive).

    python tests/oracles/luffing_resistances.py > tests/oracles/luffing_resistances.csv

Areas of wind, pins and the numbers of the cases are examples, of no standard. Pressure and sway are positive forward, slope
where the front is lower; v and a are those of the distance between the drive's ends. Friction acts against the motion on the
pins that carry all else of the case; where nothing moves there is none. The hanging load has no inertia and no
centrifugal force here.

Columns: crane, case, angle (deg), then own weights left by the balance, load, sway, wind, centrifugal, inertia, slope,
friction, their sum (N m), and the drive's force (N), positive where it presses its ends apart.
"""

from mpmath import conj, cos, expj, im, matrix, lu_solve, mp, mpc, mpf, nstr, pi, re, sin, sqrt, tan

mp.dps = 50
G = mpf("9.81")
STEP, NEAR = mpf(10) ** -12, mpf(10) ** -20
NAMES = ("own", "load", "sway", "wind", "centrifugal", "inertia", "slope", "friction")
# Load (share of the scene's), sway (deg), pressure (Pa), slope (deg), slewing speed (1/min), v (m/s), a (m/s2).
CASES = {
    "I": ("1", "3.5", "-75", "0", "1.2", "-0.05", "0"),
    "II": ("1", "-12", "250", "0.5", "1.5", "0.06", "0.03"),
    "III": ("0", "0", "-1100", "-1", "0", "0", "0"),
}


def numbers(text):
    return [mpf(x) for x in text.split()]


def rad(x):
    return mpf(x) * pi / 180


def cross(a, b):
    return im(conj(a) * b)


def dot(a, b):
    return re(conj(a) * b)


def first(f, x):
    return (8 * (f(x + STEP) - f(x - STEP)) - f(x + 2 * STEP) + f(x - 2 * STEP)) / (12 * STEP)


def meet(a, r, b, s):
    """Where circles around two points meet, on the left of the way from the first."""
    d = abs(b - a)
    along = (d * d + r * r - s * s) / (2 * d)
    return a + (b - a) / d * (along + 1j * sqrt(r * r - along * along))


def loop(crank, coupler, follower):
    """First and second derivatives of the angles of coupler and follower by that of the crank."""
    across = matrix([[-im(coupler), im(follower)], [re(coupler), -re(follower)]])
    one = lu_solve(across, matrix([im(crank), -re(crank)]))
    bend = crank + one[0] ** 2 * coupler - one[1] ** 2 * follower
    two = lu_solve(across, matrix([re(bend), im(bend)]))
    return (one[0], two[0]), (one[1], two[1])


class Body:
    """A weight (N) at a place from the body's origin, inertia (kg m2), direction along which it is slender, and area times
    drag coefficient (m2) with its centre."""

    def __init__(self, weight, centre, inertia, along, area, middle):
        self.mass, self.centre, self.inertia, self.along = weight / G, centre, inertia, along / abs(along)
        self.area, self.middle = area, middle


class DoubleLink:
    name, turned = "portal_004_new", [mpf(x) for x in range(44, 84, 2)]
    load, axis = mpf(100000), mpf(0)
    rear = mpc("-4.249827", "9.499717")
    boom, jib, rocker, head = mpf("26.3"), mpf("4.1"), mpf("22.1"), mpf("11.68") * expj(rad("-177.08"))
    pivot, k, rod, lever = mpf("10.358") * expj(rad("105.11")), mpf("1.602") * expj(rad("18.94")), mpf("9.058"), mpf("0.364")
    pinion, joint = mpc(-4, 10), 8 * expj(rad(10))
    pins = [(mpf("0.008"), r) for r in numbers("0.15 0.1 0.1 0.125 0.1 0.1 0.14")]  # mu, radius of O1, B, C, O3, K, L, M
    bodies = (
        Body(mpf(162000), mpf("11.725") * expj(rad(1)), mpf(951600), mpc(1), mpf(22), mpc(13)),
        Body(mpf(95140), mpf("2.6") * expj(rad("-165.55")), mpf(201200), head - jib, mpf(9), mpc(-3)),
        Body(mpf(27600), mpc("11.05"), mpf(114500), mpc(1), mpf(5), mpc("11.05")),
        Body(mpf(984800) / 3, 3 * expj(rad("156.81")), mpf(0), mpc(1), mpf(4), 3 * expj(rad("156.81"))),
    )

    def placed(self, phi):
        """Origin and direction of boom, jib, rocker, lever."""
        b = self.boom * expj(phi)
        c = meet(self.rear, self.rocker, b, self.jib)
        k = self.k * expj(phi)
        rod = meet(self.pivot, self.lever, k, self.rod)
        return ((mpc(0), expj(phi)), (b, (c - b) / self.jib), (self.rear, (c - self.rear) / self.rocker),
                (self.pivot, (rod - self.pivot) / self.lever))

    def hangs(self, phi):
        """Where the load's head is; what the rope gives to the load besides."""
        origin, turn = self.placed(phi)[1]
        return origin + self.head * turn, mpf(0)

    def driven(self, phi):
        return abs(self.joint * expj(phi) - self.pinion)

    def turns(self, phi):
        """Angles' first and second derivatives, origins' too, and the turn of each pin against its other body."""
        (o, boom), (b, jib), (rear, rocker), (pivot, lever) = self.placed(phi)
        k = self.k * boom
        along = pivot + self.lever * lever - k
        j, r = loop(b, self.jib * jib, self.rocker * rocker)
        t, m = loop(k, along, self.lever * lever)
        still = (mpc(0), mpc(0))
        return ([(1, 0), j, r, m], [still, (1j * b, -b), still, still],
                [1, j[0] - 1, j[0] - r[0], r[0], t[0] - 1, t[0] - m[0], m[0]])

    def hold(self, phi, forces, couples, load):
        """Moment of the drive about the foot, and the pins' forces, that hold forces at points and couples of each body."""
        (o, boom), (b, jib), (rear, rocker), (pivot, lever) = self.placed(phi)
        c, k, at = rear + self.rocker * rocker, self.k * boom, self.joint * boom
        tip, end = b + self.head * jib, pivot + self.lever * lever
        rod, rack = (end - k) / self.rod, (at - self.pinion) / abs(at - self.pinion)
        # Unknown forces with their places: body, point, direction.
        unknown = [[(0, o, d)] for d in (1, 1j)] + [[(0, b, d), (1, b, -d)] for d in (1, 1j)]
        unknown += [[(1, c, d), (2, c, -d)] for d in (1, 1j)] + [[(2, rear, d)] for d in (1, 1j)]
        unknown += [[(0, k, rod), (3, end, -rod)]] + [[(3, pivot, d)] for d in (1, 1j)] + [[(0, at, rack)]]
        f = solved(unknown, forces + [(1, tip, load)], couples, 4)
        pin = [abs(mpc(f[i], f[i + 1])) for i in (0, 2, 4, 6)] + [abs(f[8])] * 2 + [abs(mpc(f[9], f[10]))]
        return f[11] * cross(at, rack), pin

    def rubs(self, phi, moments):
        """Couples on boom, jib, rocker, lever; and the forces by which the massless rod hands its couples over."""
        o, b, c, r, k, end, m = moments
        (_, boom), _, _, (pivot, lever) = self.placed(phi)
        start, stop = self.k * boom, pivot + self.lever * lever
        across = 1j * (stop - start) / self.rod
        push = (k + end) / self.rod  # of the rod's couples, by its ends
        couples = [-o + b + k, -b - c, c - r, end - m]
        return couples, [(0, start, across * push), (3, stop, -across * push)]


def solved(unknown, forces, couples, count):
    left, right = matrix(3 * count, len(unknown)), matrix(3 * count, 1)
    for j, parts in enumerate(unknown):
        for body, at, d in parts:
            for i, x in enumerate((re(d), im(d), cross(at, d))):
                left[3 * body + i, j] += x
    for body, at, f in forces:
        for i, x in enumerate((re(f), im(f), cross(at, f))):
            right[3 * body + i] -= x
    for body, couple in enumerate(couples):
        right[3 * body + 2] -= couple
    return lu_solve(left, right)


class RopeBoom:
    name, turned = "rope_luffing", [mpf(x) for x in range(25, 79, 2)]
    load, axis = 10000 * G, mpf(2)
    head, anchor, k, sheave, falls = mpc(33, "0.4"), mpc("-4.5", 13), 30 * expj(rad("1.5")), mpc(-2, 12), 2
    pins = [(mpf("0.008"), mpf("0.15"))]
    bodies = (Body(9000 * G, 15 * expj(rad(1)), mpf(900000), mpc(1), mpf(18), mpc(16)),)

    def placed(self, phi):
        return ((mpc(0), expj(phi)),)

    def hangs(self, phi):
        tip = self.head * expj(phi)
        return tip, abs(tip - self.sheave) / self.falls

    def driven(self, phi):
        return abs(self.k * expj(phi) - self.anchor)

    def turns(self, phi):
        return [(1, 0)], [(mpc(0), mpc(0))], [1]

    def hold(self, phi, forces, couples, load):
        at, tip = self.k * expj(phi), self.head * expj(phi)
        rope = (at - self.anchor) / abs(at - self.anchor)
        # The vertical load alone pulls in the hoist rope; what sways it is a force at the head.
        led = (self.sheave - tip) / abs(self.sheave - tip) * abs(self.pull) / self.falls
        f = solved([[(0, mpc(0), 1)], [(0, mpc(0), 1j)], [(0, at, rope)]], forces + [(0, tip, load + led)], couples, 1)
        return f[2] * cross(at, rope), [abs(mpc(f[0], f[1]))]

    def rubs(self, phi, moments):
        return [-moments[0]], []


def held(crane, phi, forces=(), couples=None, load=mpc(0), pull=mpf(0)):
    crane.pull = pull
    return crane.hold(phi, list(forces), couples or [mpf(0)] * len(crane.bodies), load)


def resistances(crane, case, phi):
    """By power and by equilibrium, in the order of NAMES."""
    share, sway, pressure, slope, speed, v, a = (mpf(x) for x in case)
    q, sway, slope, speed = crane.load * share, rad(sway), rad(slope), speed * 2 * pi / 60
    stroke = first(crane.driven, phi)
    bent = first(lambda x: first(crane.driven, x), phi)
    rate = v / stroke
    turning = (a - bent * rate**2) / stroke
    down = mpc(sin(slope), -cos(slope))
    bodies = crane.bodies

    def centres(x):
        return [o + b.centre * t for b, (o, t) in zip(bodies, crane.placed(x))]

    def middles(x):
        return [o + b.middle * t for b, (o, t) in zip(bodies, crane.placed(x))]

    def halves(x):
        for b, (o, t) in zip(bodies, crane.placed(x)):
            for side in (1, -1):
                yield b.mass / 2, o + (b.centre + side * sqrt(b.inertia / b.mass) * b.along) * t

    def weights(x):
        return sum((b.mass * G * c for b, c in zip(bodies, centres(x))), mpc(0))

    def rise(x):
        tip, given = crane.hangs(x)
        return im(tip) + given

    def inert(x):
        return sum(m * abs(travel) ** 2 for (m, _), travel in zip(halves(x), travels(x)))

    def travels(x):
        places = [[p for _, p in halves(x + k * STEP)] for k in (-2, -1, 1, 2)]
        return [(8 * (r - l) - rr + ll) / (12 * STEP) for ll, l, r, rr in zip(*places)]

    tip = lambda x: crane.hangs(x)[0]
    power = [
        first(lambda x: -im(weights(x)), phi),
        -q * first(rise, phi),
        q * tan(sway) * first(lambda x: re(tip(x)), phi),
        first(lambda x: sum(pressure * b.area * re(m) for b, m in zip(bodies, middles(x))), phi),
        first(lambda x: speed**2 * sum(m * (re(p) + crane.axis) ** 2 for m, p in halves(x)) / 2, phi),
        -(inert(phi) * turning + first(inert, phi) * rate**2 / 2),
        first(lambda x: dot(down + 1j, weights(x) + q * tip(x)), phi),
    ]

    turns, origins, relative = crane.turns(phi)
    at, wind = centres(phi), middles(phi)
    pressed = [(i, wind[i], pressure * b.area) for i, b in enumerate(bodies)]
    own = [(i, at[i], -1j * b.mass * G) for i, b in enumerate(bodies)]
    tilted = [(i, at[i], (down + 1j) * b.mass * G) for i, b in enumerate(bodies)]
    flung = [(i, at[i], b.mass * speed**2 * (re(at[i]) + crane.axis)) for i, b in enumerate(bodies)]
    slender = [b.along * t for b, (_, t) in zip(bodies, crane.placed(phi))]
    spun = [-b.inertia * speed**2 * re(s) * im(s) for b, s in zip(bodies, slender)]
    slowed, stopped = [], []
    for i, (b, (w, e), (travel, bend), (o, t)) in enumerate(zip(bodies, turns, origins, crane.placed(phi))):
        arm = b.centre * t
        travel, bend = travel + 1j * w * arm, bend + (1j * e - w**2) * arm
        slowed.append((i, at[i], -b.mass * (travel * turning + bend * rate**2)))
        stopped.append(-b.inertia * (w * turning + e * rate**2))
    holds = [
        held(crane, phi, own),
        held(crane, phi, load=-1j * q, pull=q),
        held(crane, phi, load=mpc(q * tan(sway))),
        held(crane, phi, pressed),
        held(crane, phi, flung, spun),
        held(crane, phi, slowed, stopped),
        held(crane, phi, tilted, load=(down + 1j) * q),
    ]
    # All together, for the forces in the pins.
    forces = own + pressed + flung + slowed + tilted
    couples = [x + y for x, y in zip(spun, stopped)]
    _, pins = held(crane, phi, forces, couples, -1j * q + q * tan(sway) + (down + 1j) * q, q)
    crane.carried = pins
    way = (rate > 0) - (rate < 0)
    turned = [mu * r * f * ((w > 0) - (w < 0)) * way for (mu, r), f, w in zip(crane.pins, pins, relative)]
    power.append(-sum(m * w for m, w in zip(turned, relative)))
    couples, handed = crane.rubs(phi, turned)
    holds.append(held(crane, phi, handed, couples))
    return power, [-h[0] for h in holds], stroke


def rows():
    for crane in (DoubleLink(), RopeBoom()):
        for name, case in CASES.items():
            for degrees in crane.turned:
                power, equal, stroke = resistances(crane, case, rad(degrees))
                size = max(abs(x) for x in power)
                for what, x, y in zip(NAMES, power, equal):
                    assert abs(x - y) <= NEAR * size, (crane.name, name, nstr(degrees, 6), what, nstr(x, 20), nstr(y, 20))
                total = sum(power)
                yield [crane.name, name, nstr(degrees, 20)] + [nstr(x, 20) for x in [*power, total, -total / stroke]]


if __name__ == "__main__":
    print(",".join(["crane", "case", "angle", *NAMES, "sum", "force"]))
    for row in rows():
        print(",".join(row))
