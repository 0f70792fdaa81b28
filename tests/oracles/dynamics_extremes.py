"""50-digit reference of reduced inertia, its slope and the moment of the weights, near singular positions.

Independent of Lemnis: intersected circles and numerical derivatives with 150 digits (mpmath). The
angles are doubles; masses and lengths are scaled from the lemniscate crane (uniform bars of 20 t,
6 t, 4 t, 16 t fixed to the head, g = 9.81).

    python tests/oracles/dynamics_extremes.py > tests/oracles/dynamics_extremes.csv

Columns: case, angle as hexadecimal double, scale of lengths, scale of masses, inertia, slope, moment.
"""

from mpmath import acos, atan2, cos, hypot, mp, mpf, nstr, sin, sqrt

mp.dps = 150
BASE = [mpf(float(x)) for x in ("19.3", "6.5", "14.7", "16", "6.4", "5.3", "1.354")]


def bodies(scale, mass, theta):
    """Mass, inertia, centre and angle of every body."""
    x1, x2, x3, x4, x5, x6, x7 = (x * scale for x in BASE)
    beta_0 = acos(x7 / x2) + acos(x7 / x4)
    b = (x1 * cos(theta), x1 * sin(theta))
    dx, dy = b[0] + x5, b[1] - x6
    d = hypot(dx, dy)
    along = (d**2 + x3**2 - x2**2) / (2 * d)
    across = sqrt(x3**2 - along**2)
    c = (-x5 + (along * dx - across * dy) / d, x6 + (along * dy + across * dx) / d)
    be = atan2(c[1] - b[1], c[0] - b[0])
    a = (b[0] + x4 * cos(be - beta_0), b[1] + x4 * sin(be - beta_0))
    ac = sqrt(x2**2 + x4**2 - 2 * x2 * x4 * cos(beta_0))
    t3 = atan2(c[1] - x6, c[0] + x5)
    return [
        (20000 * mass, 20000 * mass * x1**2 / 12, (b[0] / 2, b[1] / 2), theta),
        (6000 * mass, 6000 * mass * ac**2 / 12, ((a[0] + c[0]) / 2, (a[1] + c[1]) / 2), be),
        (4000 * mass, 4000 * mass * x3**2 / 12, ((c[0] - x5) / 2, (c[1] + x6) / 2), t3),
        (16000 * mass, mpf(0), a, mpf(0)),
    ]


def reduced(scale, mass, theta, room):
    h = room * mpf(10) ** -40
    steps = [bodies(scale, mass, theta + k * h) for k in (-2, -1, 0, 1, 2)]
    inertia = slope = moment = mpf(0)
    for i, (m, spin, _, _) in enumerate(steps[2]):
        def first(f):
            v = [f(s[i]) for s in steps]
            return (v[0] - 8 * v[1] + 8 * v[3] - v[4]) / (12 * h)

        def second(f):
            v = [f(s[i]) for s in steps]
            return (-v[0] + 16 * v[1] - 30 * v[2] + 16 * v[3] - v[4]) / (12 * h * h)

        parts = [(m, lambda s: s[2][0]), (m, lambda s: s[2][1]), (spin, lambda s: s[3])]
        for weight, f in parts:
            inertia += weight * first(f) ** 2
            slope += 2 * weight * first(f) * second(f)
        moment += m * mpf("9.81") * first(lambda s: s[2][1])
    return inertia, slope, moment


def dead_points():
    x1, x2, x3, x5, x6 = BASE[0], BASE[1], BASE[2], BASE[4], BASE[5]
    frame, direction = hypot(x5, x6), atan2(x6, -x5)
    half = acos((x1**2 + frame**2 - (x2 + x3) ** 2) / (2 * x1 * frame))
    return direction - half, direction + half


if __name__ == "__main__":
    low, high = dead_points()
    cases = [("middle", 1.5, 1, 1), ("parallel", float.fromhex("0x1.8eaa334fdb5bbp+0"), 1, 1)]
    for k in range(1, 16):
        cases.append((f"low_1e-{k}", float(low + mpf(10) ** -k), 1, 1))
        cases.append((f"high_1e-{k}", float(high - mpf(10) ** -k), 1, 1))
    for exponent in (-3, 6):
        cases.append((f"length_1e{exponent}", 1.5, exponent, 1))
    print("case,theta,length,mass,inertia,slope,moment")
    for name, theta, exponent, mass in cases:
        scale = mpf(10) ** exponent if exponent != 1 else mpf(1)
        exact = mpf(theta)
        room = min(exact - low, high - exact)
        values = reduced(scale, mpf(mass), exact, room)
        print(f"{name},{theta.hex()},{nstr(scale, 3)},{mass}," + ",".join(nstr(v, 20) for v in values))
