"""Strength of what drives a luffing mechanism, from statics alone, with 50 digits; SI. Independent of Lemnis.

Where a textbook prints a formula this goes another way to it: Johnson's parabola is found as the one from the yield point
that touches Euler's hyperbola, contact of teeth by the half width of two pressed cylinders, the nut by its annuli, von Mises
by principal stresses, a screw's torque by the forces on an inclined plane.
"""

from mpmath import atan, cos, findroot, matrix, lu_solve, mp, mpf, pi, sin, sqrt

mp.dps = 50


def euler(e, slenderness):
    return pi**2 * e / slenderness**2


def johnson(e, yields):
    """Slenderness at which a parabola yields - c x^2 touches Euler's curve, and c."""
    same = lambda x, c: (yields - c * x**2 - euler(e, x), -2 * c * x + 2 * euler(e, x) / x)
    scale = sqrt(e / yields)
    found = findroot(lambda x, c: [y / yields for y in same(x * scale, c * yields / scale**2)], (4, mpf(1) / 40))
    return found[0] * scale, found[1] * yields / scale**2


def critical(e, yields, slenderness):
    meets, bend = johnson(e, yields)
    return euler(e, slenderness) if slenderness >= meets else yields - bend * slenderness**2


def buckling(e, yields, safety, factor, free, area, radius, push):
    """Slenderness, and the use of a bar that is pushed; a pull does not buckle it."""
    slenderness = factor * free / radius
    bears = critical(e, yields, slenderness) * area
    return slenderness, safety * max(push, mpf(0)) / bears


def round_bar(d):
    """Area and radius of gyration, by its second moment."""
    area = pi * d**2 / 4
    return area, sqrt(pi * d**4 / 64 / area)


def teeth(load, form, width, module, angle, e, nu, pinion, force, sector=None):
    """Bending at the root, and pressure of two cylinders in line contact by its half width."""
    bending = load * abs(force) / width * form / module
    radii = [pinion * sin(angle)] + ([] if sector is None else [sector * sin(angle)])
    radius = 1 / sum(1 / r for r in radii)
    line = load * abs(force) / cos(angle) / width
    stiff = e / (2 * (1 - nu**2))
    half = sqrt(4 * line * radius / (pi * stiff))
    return bending, 2 * line / (pi * half)


def screw(pitch_diameter, lead, friction, flank, core, overlap, pitch, nut, force):
    """Pressure on the nut's annuli, torque, and equivalent stress of the core."""
    force = abs(force)
    outer, inner = pitch_diameter + overlap, pitch_diameter - overlap
    pressure = force / (pi / 4 * (outer**2 - inner**2) * nut / pitch)
    climb = atan(lead / (pi * pitch_diameter))
    rubs = friction / cos(flank)
    # Normal force and push around, along and around the screw.
    around = lu_solve(matrix([[cos(climb) - rubs * sin(climb), 0], [-(sin(climb) + rubs * cos(climb)), 1]]), matrix([force, 0]))[1]
    torque = around * pitch_diameter / 2
    along, twist = force / (pi * core**2 / 4), torque * (core / 2) / (pi * core**4 / 32)
    middle, radius = along / 2, sqrt(along**2 / 4 + twist**2)
    one, other = middle + radius, middle - radius
    return pressure, torque, sqrt(one**2 - one * other + other**2)


def cylinder(bore, rod, force):
    area = pi * bore**2 / 4 - (pi * rod**2 / 4 if force < 0 else 0)
    return abs(force) / area


def rope(falls, efficiency, breaking, safety, force):
    """Pull at the drum, negative where the force presses; and the rope's use."""
    pull = -force / falls / efficiency
    return pull, max(pull, mpf(0)) / (breaking / safety)


def pin(d, width, force):
    return force / d / width, force / 2 / (pi * d**2 / 4)
