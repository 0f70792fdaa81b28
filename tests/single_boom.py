"""What the FMUs of all single booms in motion are asked alike."""

import numpy as np
from fmpy import simulate_fmu

from conftest import lemnis

ENDS = {"FMI 2": ".fmi2.fmu", "FMI 3": ".fmu"}
G = 9.81


def scene(text, fidelity, folder, inertias, joint, rope):
    """A ready scene at a level that moves: inertias by their keys (kg·m²), viscous and dry friction and the drive's moment
    in N·m·s and N·m, and what the scene says of the rope at level swing."""
    viscous, coulomb, moment = (number / 1e3 for number in joint)
    bodies = "".join(f'{key} = "{value} kg.m2"\n' for key, value in inertias.items())
    dynamics = (f'[luffing.dynamics]\n{bodies}c_v = "{viscous} kN.m.s"\nM_F = "{coulomb} kN.m"\nM_A = "{moment} kN.m"\n'
                f'step = "2 ms"\n{rope if fidelity == "swing" else ""}\n')
    text = text.replace("[luffing]\n", f'[luffing]\nfidelity = "{fidelity}"\n', 1)
    path = folder / f"{fidelity}.toml"
    path.write_text(text.replace("[luffing.limits]", dynamics + "[luffing.limits]", 1), encoding="utf-8")
    return path


def rates(forms, head, drive, mass, swings):
    """Rates of angle, angular velocity and, where it swings, of the load as a point in the plane: by Lagrange from what the mechanism
    has, inertia and height of the weights (J) over the angle; the head with two derivatives over it, the drive's moment, viscous and
    dry friction, and the load's mass."""
    inertia, height = forms
    slope, weight = inertia.deriv(), height.deriv()
    moment, viscous, coulomb = drive

    def of(_, y):
        phi, omega = y[:2]
        force = moment - viscous * omega - coulomb - 0.5 * slope(phi) * omega ** 2 - weight(phi)
        if not swings:
            return [omega, force / inertia(phi)]
        return pulled(y, head(phi), (inertia(phi), force), mass)
    return of


def packed(path, name, folder):
    """Its FMUs by their standard."""
    lemnis("fmu", path, "--output", folder)
    return {standard: str(folder / f"{name}{end}") for standard, end in ENDS.items()}


def pulled(y, head, bar, mass, lead=(0.0, 0.0)):
    """Rates of angle, angular velocity and of the load as a point in the plane, on a rope whose length at the head is a
    constraint: d²|line|²/dt² with the tension on both. The head with two derivatives, inertia and force of the bar, the
    load's mass, and what the mechanism takes of the rope for one radian, with its change."""
    omega, place, speed = y[1], np.array(y[2:4]), np.array(y[4:6])
    (at, travel, bend), (inertia, force), (led, bent) = head, bar, lead
    line, relative = place - at, speed - travel * omega
    long = float(np.hypot(*line))
    along, weight = line / long, np.array([0.0, -G])
    arm = float(travel @ along) - led
    free = (along @ (weight - bend * omega ** 2) + (relative @ relative - (led * omega) ** 2) / long
            + bent * omega ** 2 - arm * force / inertia)
    tension = free / (1 / mass + arm * arm / inertia)
    return [omega, (force + arm * tension) / inertia, *speed, *(weight - along * tension / mass)]


def solved(rates, y, times, steps=250):
    """The classical method of fourth order, in so many steps from one time to the next."""
    states = [np.array(y)]
    for start, end in zip(times, times[1:]):
        y, h = states[-1], (end - start) / steps
        for _ in range(steps):
            a = np.array(rates(start, y))
            b = np.array(rates(start, y + 0.5 * h * a))
            c = np.array(rates(start, y + 0.5 * h * b))
            d = np.array(rates(start, y + h * c))
            y = y + h / 6.0 * (a + 2.0 * (b + c) + d)
        states.append(y)
    return np.array(states).T


# What tells where the load is, and how it moves, in a row.
ROPE = ["phi_R", "omega_R", "l_R"]


def states(row, head, rope=None):
    """Angle, angular velocity and, where it swings, the load as a point in the plane with its velocity: on a rope of a length
    (m) of which the mechanism takes so much for one radian of the bar."""
    own = [row["phi"], row["omega"]]
    if rope is None:
        return own
    long, taken = rope
    along = np.array([np.sin(row["phi_R"]), -np.cos(row["phi_R"])])
    across = np.array([-along[1], along[0]])
    speed = head[1] * row["omega"] - along * taken * row["omega"] + across * long * row["omega_R"]
    return [*own, *(head[0] + along * long), *speed]


def runs(paths, stop, output):
    """Of both standards by both interfaces."""
    return {(standard, kind): simulate_fmu(path, fmi_type=kind, stop_time=stop, output_interval=0.25, relative_tolerance=1e-10,
                                           record_events=False, output=output)
            for standard, path in paths.items() for kind in ("CoSimulation", "ModelExchange")}


def agrees(runs, found, heads):
    """Angle, angular velocity and, where the load swings, the rope's angle with states found elsewhere; the same of both
    standards. Returns how near each run must be."""
    bounds = {}
    for key, run in runs.items():
        bound = bounds[key] = 1e-7 if key[1] == "CoSimulation" else 2e-5
        assert np.max(np.abs(run["phi"] - found[0])) < bound, (key, np.max(np.abs(run["phi"] - found[0])))
        assert np.max(np.abs(run["omega"] - found[1])) < bound, key
        if len(found) > 2:
            at = np.arctan2(found[2] - heads[:, 0], heads[:, 1] - found[3])
            assert np.max(np.abs(run["phi_R"] - at)) < 10 * bound, (key, np.max(np.abs(run["phi_R"] - at)))
    assert np.array_equal(runs["FMI 3", "CoSimulation"]["phi"], runs["FMI 2", "CoSimulation"]["phi"])
    return bounds
