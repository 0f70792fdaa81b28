"""30-digit reference of a slewing drive: what resists it in two load cases, its motors' start and heating, stops of its brakes,
torque of the coupling, force and stresses of its pinions.

Independent of Lemnis: the moment about the axis is a sum of forces in space at their places, in directions that do not slew;
outswing is the equilibrium of a pendulum in a frame that turns, found by bisection; power is moment times speed; a start and a
stop are integrated as pieces of constant acceleration of the whole crane about its axis, with what the motors' own inertia
comes to there; root mean squares are integrals.

    python tests/oracles/slewing_drive.py > tests/oracles/slewing_drive.csv

Columns: bodies (weight, place, height), areas (area, height, place), slope (rad; empty without), cases (factor of the load,
pressure in Pa, direction in rad, speed in 1/s, sway in rad, safety of the brake), load (N), reach (m), slewing angle (rad), column
(h, D_u, b_u, D_f, b_f, D_p, d_i in m) and its coefficients of friction (upper, foot, pivot), drive (J_e, z_d, i_sl, eta_sl, P_N,
n_N, lambda_M, k_a, J_M), rope (m; empty without), brake (torque, delay), k_lim, pinion (r_z, r_g, K_F, Y_F, b_z, m_t, alpha_t,
E_t, nu_t, 1 where inside); then of each case: M_z, M_st, J_c, R_i, P_M, P_lr, t_start, a_start, T_h, t_stop, psi_stop, a_stop,
T_c, F_t, sigma_F, sigma_H; P_rms of the first over a whole circle.
"""

import random

from mpmath import atan2, cos, mp, mpf, nstr, pi, quad, sin, sqrt, tan

mp.dps = 30
G = mpf("9.81")


class Crane:
    def __init__(self, rng, number):
        pick = lambda low, high: mpf(str(round(rng.uniform(low, high), 3)))
        self.upper = [(pick(200e3, 500e3), pick(-1.2, 0), pick(1, 4)), (pick(50e3, 120e3), pick(5, 9), pick(7, 14)),
                      (pick(80e3, 250e3), pick(-6, -3), pick(1, 5))]
        self.areas = [(pick(10, 40), pick(2, 5), pick(-1, 1)), (pick(10, 30), pick(8, 15), pick(4, 9))] if number % 3 else []
        self.gamma = pick(0.002, 0.02) if number % 2 else None
        sway = (lambda: pick(0.02, 0.2)) if number % 4 == 1 else (lambda: mpf(0))
        self.cases = [(pick(0.9, 1.4), pick(50, 250), pick(-3, 3), pick(0.01, 0.03), sway(), pick(1.1, 1.6)),
                      (pick(0, 1), pick(0, 400), pick(-3, 3), mpf(0) if number % 5 == 0 else pick(0.005, 0.02), sway(), pick(1.1, 1.6))]
        self.load, self.reach, self.psi = pick(10e3, 100e3), pick(8, 25), pick(-3, 3)
        self.column = [pick(5, 9), pick(0.8, 2), pick(0.1, 0.3), pick(0.3, 0.6), pick(0.2, 0.4), pick(0.3, 0.6), mpf(0)]
        self.mu = [pick(0.01, 0.1) for _ in range(3)]
        self.drive = [pick(1e5, 1e6), mpf(rng.randint(1, 3)), pick(400, 900), pick(0.75, 0.95), pick(20e3, 50e3), mpf(16), pick(1.8, 2.6),
                      pick(1.3, 1.8), pick(0.3, 1.5)]
        self.rope = pick(8, 30) if number % 3 != 1 else None
        self.brake = [pick(150, 500), pick(0, 0.5)]
        self.k_lim = pick(1.05, 1.3)
        self.pinion = [pick(0.12, 0.3), pick(1.5, 2.5), pick(1, 2), pick(2.2, 3.2), pick(0.1, 0.25), pick(0.012, 0.025), pick(0.26, 0.44),
                       mpf(206e9), mpf("0.3"), mpf(number % 2)]

    def pushes(self, case, psi):
        """Forces with their places, seen from above: x downhill, y to the left of that."""
        factor, pressure, to, *_ = case
        steep = sin(self.gamma or mpf(0))
        at = lambda r: (r * cos(psi), r * sin(psi))
        weights = [(g, r) for g, r, _ in self.upper] + [(factor * self.load, self.reach)]
        forces = [((g * steep, mpf(0)), at(r)) for g, r in weights]
        return forces + [((pressure * a * cos(to), pressure * a * sin(to)), at(r)) for a, _, r in self.areas]

    def about_axis(self, case, psi):
        return sum(x * fy - y * fx for (fx, fy), (x, y) in self.pushes(case, psi))

    def friction(self, case, psi):
        """Of a full pivot, upper and foot bearing, by moments about each of them."""
        h, d_u, _, d_f, _, d_p, _ = self.column
        factor, pressure, to, *_ = case
        gamma = self.gamma or mpf(0)
        bodies = [*self.upper, (factor * self.load, self.reach, mpf(HIGH))]
        weight = sum(g for g, *_ in bodies) * cos(gamma)

        def moment(up):
            along = sum(g * (r * cos(psi) * cos(gamma) + (z + up) * sin(gamma)) for g, r, z in bodies)
            along += sum(pressure * a * cos(to) * (z + up) for a, z, _ in self.areas)
            aside = sum(g * r * sin(psi) * cos(gamma) for g, r, _ in bodies)
            aside += sum(pressure * a * sin(to) * (z + up) for a, z, _ in self.areas)
            return sqrt(along**2 + aside**2)

        pivot = self.mu[2] * weight * d_p / 3
        return self.mu[0] * moment(h) / h * d_u / 2 + self.mu[1] * moment(mpf(0)) / h * d_f / 2 + pivot

    def outswing(self, omega):
        if self.rope is None:
            return self.reach
        low, high = mpf(0), pi / 2 - mpf(10) ** -30
        for _ in range(140):
            middle = (low + high) / 2
            rest = omega**2 * (self.reach + self.rope * sin(middle)) * cos(middle) - G * sin(middle)
            low, high = (middle, high) if rest > 0 else (low, middle)
        return self.reach + self.rope * sin(low)

    def at_motor(self, moment):
        """Torque of each motor against a moment at the axis: losses cost where it resists, and help where it drives."""
        _, z, i, eta, *_ = self.drive
        return moment / (z * i) * (1 / eta if moment > 0 else eta)

    def result(self, case):
        j_e, z, i, eta, p_n, n_n, lam, k_a, j_m = self.drive
        _, _, _, n, sway, safety = case
        omega = 2 * pi * n
        reach = self.outswing(omega)
        outer, friction = self.about_axis(case, self.psi), self.friction(case, self.psi)
        load = case[0] * self.load
        pull = load * reach * tan(sway)
        mass = mpf(0) if sway else load / G * reach**2
        turned = j_e + sum(g / G * r**2 for g, r, _ in self.upper) + mass
        steady = friction + pull + abs(outer)
        against, speed = self.at_motor(steady), omega * i
        power = against * speed
        ways = [self.at_motor(friction + pull + sign * outer) * speed for sign in (1, -1)]
        both = sqrt((ways[0] ** 2 + ways[1] ** 2) / 2)
        # A start: all of it at one motor's shaft.
        whole = j_m + turned / (i**2 * z * eta)
        # A motor that cannot start stays where it is.
        quick = max((k_a * p_n / (2 * pi * n_n) - against) / whole, mpf(0))
        start, head = speed / quick if quick else mpf("inf"), (reach * quick / i if n else mpf(0))
        held = safety * (abs(outer) + pull) / (z * i) * eta
        # Stops.
        torque, delay = self.brake
        stopped = j_m + turned * eta / (i**2 * z)
        behind = self.at_motor(friction - pull - abs(outer))
        rate, turns, time = speed, mpf(0), mpf(0)
        slows = behind / stopped
        if n:
            if slows > 0 and rate / slows < delay:
                time, turns = rate / slows, rate**2 / slows / 2
            else:
                turns = rate * delay - slows * delay**2 / 2
                rate -= slows * delay
                now = (torque + behind) / stopped
                never = mpf("inf")
                time, turns = (delay + rate / now, turns + rate**2 / now / 2) if now > 0 else (never, never)
        hard = (torque + self.at_motor(friction - pull + abs(outer))) / stopped
        coupling = max(against + ((whole - j_m) * quick if n else 0), torque - j_m * (torque + behind) / stopped)
        r_z, r_g, k, y, b, m, alpha, e, nu, inside = self.pinion
        force = (steady + (turned * quick / i if n else 0)) / (r_g * z)
        curved = sin(alpha) / (1 / r_z + (-1 if inside else 1) / r_g)
        contact = sqrt(k * force / cos(alpha) / b / curved * e / (2 * pi * (1 - nu**2)))
        return [outer, steady, turned, reach, power, both, start, head, held, time, turns / i, hard * reach / i if n else mpf(0),
                coupling, force, k * force * y / (b * m), contact]

    def heating(self):
        """Over the circle; pieces end where the moment of slope and wind is zero, which has the form a sin(psi + b)."""
        case = self.cases[0]
        a, b = self.about_axis(case, mpf(0)), self.about_axis(case, pi / 2)
        zeros = sorted({(k * pi - atan2(a, b)) for k in range(-1, 3)})
        ends = sorted([-pi, pi, *(z for z in zeros if -pi < z < pi)])
        own = self.psi
        pieces = [low + (high - low) * k / 4 for low, high in zip(ends, ends[1:]) for k in range(4)] + [pi]

        def square(psi):
            self.psi = psi
            return self.result(case)[5] ** 2

        found = sqrt(quad(square, pieces) / (2 * pi))
        self.psi = own
        return found

    def row(self):
        text = lambda x: "" if x is None else nstr(x, 25)
        listed = lambda many: ";".join(" ".join(nstr(x, 20) for x in one) for one in many)
        return ",".join([listed(self.upper), listed(self.areas), text(self.gamma), listed(self.cases), text(self.load), text(self.reach),
                         text(self.psi), listed([self.column]), listed([self.mu]), listed([self.drive]), text(self.rope),
                         listed([self.brake]), text(self.k_lim), listed([self.pinion]),
                         ";".join(" ".join(text(x) for x in self.result(case)) for case in self.cases), text(self.heating())])


# Height of the load's suspension above the upper bearing, in m.
HIGH = "18"


def main():
    print("upper,areas,gamma,cases,Q,R,psi,column,mu,drive,l_R,brake,k_lim,pinion,results,P_rms")
    rng = random.Random(65)
    for number in range(24):
        print(Crane(rng, number).row())


main()
