"""50-digit reference of the double-link mechanism near its singular positions.

Independent of Lemnis: the joint is found by intersecting two circles, and every
velocity is a numerical derivative, both with 150 digits (mpmath). Each
reference is written as a pair of doubles (value, remainder) in hexadecimal.

    python tests/oracles/lemniscate_extremes.py > tests/oracles/lemniscate_extremes.csv
"""

from mpmath import acos, atan2, cos, diff, findroot, hypot, mp, mpf, pi, sin, sqrt

mp.dps = 150

# Lengths as the doubles that a program reads from the decimal text.
X1, X2, X3, X4, X5, X6, X7 = (mpf(float(x)) for x in ("19.3", "6.5", "14.7", "16", "6.4", "5.3", "1.354"))
Q = mpf(160000)
BETA_0 = acos(X7 / X2) + acos(X7 / X4)
O3 = (-X5, X6)


def circles(centre, joint, radius, coupler):
    """The joint at `radius` from `centre` and `coupler` from `joint`, left of centre -> joint."""
    dx, dy = joint[0] - centre[0], joint[1] - centre[1]
    d = hypot(dx, dy)
    along = (d**2 + radius**2 - coupler**2) / (2 * d)
    across = sqrt(radius**2 - along**2)
    return centre[0] + (along * dx - across * dy) / d, centre[1] + (along * dy + across * dx) / d


def boom(theta):
    b = X1 * cos(theta), X1 * sin(theta)
    return b, circles(O3, b, X3, X2)


def rocker(theta):
    c = O3[0] + X3 * cos(theta), O3[1] + X3 * sin(theta)
    return circles((mpf(0), mpf(0)), c, X1, X2), c


def head(pose, theta):
    b, c = pose(theta)
    alpha = atan2(c[1] - b[1], c[0] - b[0]) - BETA_0
    return b[0] + X4 * cos(alpha), b[1] + X4 * sin(alpha)


def upright(angle):
    return angle + 2 * pi if angle <= -pi / 2 else angle


def follower(pose, theta):
    b, c = pose(theta)
    vector = (c[0] - O3[0], c[1] - O3[1]) if pose is boom else b
    return upright(atan2(vector[1], vector[0]))


def dead_points(crank, target, centre):
    """Angles at which the diagonal has the length `target`, on both sides of `centre`."""
    frame = hypot(X5, X6)
    half = acos((crank**2 + frame**2 - target**2) / (2 * crank * frame))
    return centre - half, centre + half


def pair(x):
    high = float(x)
    return f"{high.hex()},{float(x - high).hex()}"


def main():
    centre = atan2(X6, -X5)
    low, high = dead_points(X1, X2 + X3, centre)
    parallel = findroot(lambda t: follower(boom, t) - t, mpf("1.5573"))
    cases = []
    for k in range(1, 16):
        gap = mpf(10) ** -k
        cases += [(f"boom_low_1e-{k}", boom, low + gap), (f"boom_high_1e-{k}", boom, high - gap)]
    cases += [("boom_parallel", boom, parallel)]
    for k in (12, 13, 14, 15):
        gap = mpf(10) ** -k
        cases += [(f"boom_parallel+1e-{k}", boom, parallel + gap), (f"boom_parallel-1e-{k}", boom, parallel - gap)]
    # Driven at the rocker: jib and boom fold over each other.
    below, above = dead_points(X3, X1 - X2, -atan2(X6, X5))
    for k in range(1, 16):
        gap = mpf(10) ** -k
        cases += [(f"rocker_low_1e-{k}", rocker, above + gap), (f"rocker_high_1e-{k}", rocker, below + 2 * pi - gap)]
    print("case,theta,follower,follower_lo,Y_A,Y_A_lo,M_Q,M_Q_lo,dX_A,dX_A_lo")
    for name, pose, theta in cases:
        theta = float(theta)  # what a program is given
        at = mpf(theta)
        step = mpf(10) ** -60
        rates = [diff(lambda t, i=i: head(pose, t)[i], at, h=step) for i in (0, 1)]
        values = [follower(pose, at), head(pose, at)[1], Q * rates[1], rates[0]]
        print(",".join([name, theta.hex(), *map(pair, values)]))


if __name__ == "__main__":
    main()
