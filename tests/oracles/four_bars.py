"""IFToMM benchmark A02 in closed form: N four-bars of 1 m, bars of 1 kg, started upright with 1 m/s.

As long as the bars keep their branch, all N + 1 upright bars turn together and all N horizontal
ones are shifted: phi″ = k sin phi with phi from the vertical and k = 3 g (3 N + 1)/(2 (4 N + 1)).
Its first integral gives t = F(phi/2 | -4 k/w²) · 2/w, Legendre's integral of the first kind, inverted
here with 50 digits.

    python tests/oracles/four_bars.py
"""

from mpmath import ellipf, findroot, mp, mpf, odefun, sin

mp.dps = 50
G, W = mpf("9.81"), mpf(1)


def angle(n, t):
    k = 3 * G * (3 * n + 1) / (2 * (4 * n + 1))
    m = -4 * k / W**2
    # Monotone: bracket it, then Newton's method.
    low, high = mpf(0), mpf(1000)
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if ellipf(middle, m) * 2 / W < t else (low, middle)
    return 2 * findroot(lambda u: ellipf(u, m) * 2 / W - t, low)


def stepped(n, t):
    """The same by a Taylor series method, at a short time, to check the formula."""
    k = 3 * G * (3 * n + 1) / (2 * (4 * n + 1))
    return odefun(lambda _, y: [y[1], k * sin(y[0])], 0, [mpf(0), W])(t)[0]


for n in (2, 40):
    assert abs(angle(n, mpf(1)) - stepped(n, mpf(1))) < mpf(10) ** -30
    print(n, mp.nstr(angle(n, mpf(20)), 25))
