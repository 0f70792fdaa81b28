"""Reference of the steering geometry: rigid bodies as complex velocity fields.

Independent of Lemnis: the plane is the complex plane, the machine's velocity at z
is v(z) = i omega (z - c), a group's angle is the argument of v(z) and its speed the
modulus, scaled so that the fastest group has the travel speed. 10,000 random
machines with 4 to 64 groups at random places, in six kinds of command; one random
group of each is written. The random numbers come from a linear congruential
generator that the test repeats.

    python tests/oracles/steering_rigid_body.py > tests/oracles/steering_rigid_body.csv
"""

from cmath import exp, phase, pi

state = 1


def uniform(low, high):
    global state
    state = (state * 6364136223846793005 + 1442695040888963407) % 2**64
    return low + (high - low) * ((state >> 11) / 2**53)


def on_line(base, theta, line):
    """Where the axle line of `base` at `theta` meets the line re(z) = `line`."""
    axle = 1j * exp(1j * theta)
    return complex(line, (base + axle * ((line - base.real) / axle.real)).imag)


print("machine,omega,group,theta,v")
for machine in range(10000):
    n = 4 + int(uniform(0, 61))
    groups = [complex(uniform(-20, 20), uniform(-10, 10)) for _ in range(n)]
    kind, speed = int(uniform(0, 6)), uniform(-2, 2)
    first, second = uniform(-1.5, 1.5), uniform(-60, 60)
    xs, ys = [z.real for z in groups], [z.imag for z in groups]
    front, rear = max(xs), min(xs)
    middle = complex((front + rear) / 2, (min(ys) + max(ys)) / 2)
    base = groups[1] if kind == 3 else groups[0]
    line = {1: middle.real, 2: rear, 3: front}.get(kind)
    if base.real == line:  # its angle commands nothing: pivot instead
        kind = 5
    if kind == 0:  # free
        c = complex(40 * first, second)
    elif kind == 1:  # all-wheel by angle
        c = on_line(base, first, line)
    elif kind == 2:  # front-axle by angle
        c = on_line(base, first, line)
    elif kind == 3:  # rear-axle by angle, the second group commands
        c = on_line(base, first, line)
    elif kind == 4:  # all-wheel by radius
        c = complex(middle.real, middle.imag + second)
    else:  # pivot
        c = middle
    field = [1j * (z - c) for z in groups]
    # Forward: the base along its heading, or the middle forward.
    sense = exp(1j * first).conjugate() * 1j * (base - c) if kind in (1, 2, 3) else 1j * (middle - c)
    sign = -1 if sense.real < 0 else 1
    omega = sign * speed / max(abs(v) for v in field)
    group = int(uniform(0, n))
    v = omega * 1j * (groups[group] - c)
    theta, size = phase(field[group]), abs(v)
    while theta > pi / 2:
        theta -= pi
    while theta <= -pi / 2:
        theta += pi
    along = (v * exp(-1j * theta)).real
    print(f"{machine},{omega!r},{group},{theta!r},{along!r}")
