"""40-digit reference of a slewing crane's accelerations with a load on a rope that swings in all directions.

Independent of Lemnis: every bar is three points with masses (1, 4, 1)/6, which have the mass, centre and
inertia of a uniform bar; all points are placed in space as functions of four angles; Jacobians and
accelerations come from central differences with 120 digits (mpmath); the equations are d'Alembert's
principle. The crane is that of the reference motion: uniform bars of 20 t, 6 t (from C to A) and 4 t, a load
of 16 t, g = 9.81; the slewing axis is 5.2 m behind O1, all else that slews has 5e6 kg m2.

    python tests/oracles/slewing.py > tests/oracles/slewing.csv

Columns: states (rad, rad/s, m, m/s), moments (N m), then accelerations of luffing and slewing (rad/s2), of
the load from the head along forward, up and left of the frame that slews (m/s2), force of the rope (N).
"""

from mpmath import acos, atan2, cos, hypot, lu_solve, matrix, mp, mpf, nstr, sin, sqrt

mp.dps = 120
G = mpf("9.81")
X1, X2, X3, X4, X5, X6, X7, X8 = (mpf(x) for x in ("19.3", "6.5", "14.7", "16", "6.4", "5.3", "1.354", "5.2"))
REST = mpf(5000000)
LOAD = mpf(16000)
H = mpf(10) ** -25


def joints(theta):
    """O1, B, C, O3, A in the plane: forward and up from O1."""
    beta_0 = acos(X7 / X2) + acos(X7 / X4)
    b = (X1 * cos(theta), X1 * sin(theta))
    dx, dy = b[0] + X5, b[1] - X6
    d = hypot(dx, dy)
    along = (d**2 + X3**2 - X2**2) / (2 * d)
    across = sqrt(X3**2 - along**2)
    c = (-X5 + (along * dx - across * dy) / d, X6 + (along * dy + across * dx) / d)
    be = atan2(c[1] - b[1], c[0] - b[0])
    a = (b[0] + X4 * cos(be - beta_0), b[1] + X4 * sin(be - beta_0))
    return (mpf(0), mpf(0)), b, c, (-X5, X6), a


def points(q, length):
    """Masses and places in space: forward, up, left of a frame that stands still; the load last."""
    theta, psi, phi, chi = q
    o1, b, c, o3, a = joints(theta)
    flat = []
    for mass, p, r in ((20000, o1, b), (6000, c, a), (4000, o3, c)):
        middle = ((p[0] + r[0]) / 2, (p[1] + r[1]) / 2)
        flat += [(mpf(mass) / 6, p), (mpf(mass) * 2 / 3, middle), (mpf(mass) / 6, r)]
    placed = [(m, (x + X8, y, mpf(0))) for m, (x, y) in flat]
    load = rope(phi, chi, length)
    placed.append((LOAD, (a[0] + X8 + load[0], a[1] + load[1], load[2])))
    # Forward turns to the left.
    turn = [(m, (x * cos(psi) - z * sin(psi), y, x * sin(psi) + z * cos(psi))) for m, (x, y, z) in placed]
    # The rest: two masses at 1 m from the axis.
    for side in (1, -1):
        turn.append((REST / 2, (side * cos(psi), mpf(0), side * sin(psi))))
    return turn


def rope(phi, chi, length):
    return length * cos(chi) * sin(phi), -length * cos(chi) * cos(phi), length * sin(chi)


def second(f):
    v = [f(k * H) for k in (-2, -1, 0, 1, 2)]
    return (-v[0] + 16 * v[1] - 30 * v[2] + 16 * v[3] - v[4]) / (12 * H * H)


def first(f):
    v = [f(k * H) for k in (-2, -1, 1, 2)]
    return (v[0] - 8 * v[1] + 8 * v[2] - v[3]) / (12 * H)


def accelerations(q, rates, length, hoist, moments):
    def shifted(i, h):
        return [x + (h if j == i else 0) for j, x in enumerate(q)]

    def path(t, acceleration=(0, 0, 0, 0)):
        return [x + v * t + a * t * t / 2 for x, v, a in zip(q, rates, acceleration)]

    masses = [m for m, _ in points(q, length)]
    mass, force = matrix(4, 4), matrix(4, 1)
    for k, m in enumerate(masses):
        jacobian = [[first(lambda h: points(shifted(i, h), length)[k][1][axis]) for axis in range(3)] for i in range(4)]
        bend = [second(lambda t: points(path(t), length + hoist * t)[k][1][axis]) for axis in range(3)]
        for i in range(4):
            for j in range(4):
                mass[i, j] += m * sum(x * y for x, y in zip(jacobian[i], jacobian[j]))
            weight = G if k < len(masses) - 2 else 0
            force[i] -= m * sum(x * y for x, y in zip(jacobian[i], bend)) + m * weight * jacobian[i][1]
    force[0] += moments[0]
    force[1] += moments[1]
    found = list(lu_solve(mass, force))
    load = [second(lambda t: rope(path(t, found)[2], path(t, found)[3], length + hoist * t)[axis]) for axis in range(3)]
    whole = [second(lambda t: points(path(t, found), length + hoist * t)[-3][1][axis]) for axis in range(3)]
    place, psi = rope(q[2], q[3], length), q[1]
    towards = (place[0] * cos(psi) - place[2] * sin(psi), place[1], place[0] * sin(psi) + place[2] * cos(psi))
    pull = -LOAD * (sum(x * y for x, y in zip(whole, towards)) + G * towards[1]) / length
    return found[:2] + load + [pull]


if __name__ == "__main__":
    cases = [
        # theta, psi, phi, chi; their rates; length, hoist; moments
        ((1.2, 0.0, 0.1, 0.0), (0.0, 0.0, 0.0, 0.0), 10.0, 0.0, (1.8e6, 0.0)),
        ((1.2, 0.0, 0.1, 0.0), (0.05, 0.0, 0.2, 0.0), 10.0, 0.0, (1.8e6, 0.0)),
        ((1.3, 2.0, 0.0, 0.0), (0.0, 0.15, 0.0, 0.0), 12.0, 0.0, (2e6, 4e5)),
        ((1.5, -0.7, 0.3, -0.4), (0.08, 0.2, -0.5, 0.6), 8.0, 0.5, (2e6, -3e5)),
        ((1.9, 5.0, -0.9, 0.8), (-0.1, -0.3, 1.5, -1.1), 25.0, -1.0, (-1e6, 2e6)),
        ((1.4, 1.0, 2.5, 0.2), (0.1, 0.1, 3.0, 0.5), 3.0, 0.2, (1e6, 1e6)),
        ((1.4, 1.0, 3.124, 0.0), (0.05, 0.2, 4.0, 0.0), 10.0, 0.0, (1e6, 0.0)),
        ((1.6, 0.3, 0.2, 1.55), (0.02, 0.1, 0.1, 2.0), 10.0, 0.1, (1e6, -1e6)),
        ((1.2, 0.0, 0.5, 0.5), (0.0, 0.5, 0.1, 0.1), 0.01, 0.0, (1.8e6, 0.0)),
        ((1.2, 0.0, 0.05, -0.02), (0.03, -0.1, 0.01, 0.02), 1000.0, 1.0, (1.8e6, 1e5)),
    ]
    print("theta,psi,phi,chi,d_theta,d_psi,d_phi,d_chi,length,hoist,m_1,m_2,a_theta,a_psi,a_x,a_y,a_z,rope")
    for q, rates, length, hoist, moments in cases:
        exact = [[mpf(x) for x in v] for v in (q, rates, moments)]
        values = accelerations(exact[0], exact[1], mpf(length), mpf(hoist), exact[2])
        given = [*q, *rates, length, hoist, *moments]
        print(",".join([repr(x) for x in given] + [nstr(v, 20) for v in values]))
