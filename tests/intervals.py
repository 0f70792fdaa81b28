"""Numbers that are known between two ends, and what follows from them.

Every operation holds all values that its operands may have. Beside its ends an interval carries its scale: the
amount of the greatest term that it was put together from, which a difference of nearly equal terms does not show.
"""

import math
from dataclasses import dataclass


@dataclass
class Interval:
    low: float
    high: float
    scale: float

    @classmethod
    def around(cls, value, half=0.0):
        """What is printed as a value, and may be off by a half of its last digit to both sides."""
        return cls(value - half, value + half, abs(value))

    @property
    def half(self):
        return (self.high - self.low) / 2

    def __contains__(self, value):
        return self.low <= value <= self.high

    def __neg__(self):
        return Interval(-self.high, -self.low, self.scale)

    def __add__(self, other):
        return Interval(self.low + other.low, self.high + other.high, max(self.scale, other.scale))

    def __sub__(self, other):
        return self + -other

    def __mul__(self, other):
        ends = [a * b for a in (self.low, self.high) for b in (other.low, other.high)]
        return Interval(min(ends), max(ends), self.scale * other.scale)

    def __truediv__(self, other):
        assert 0 not in other, "a division by what may be zero"
        inverse = Interval(1 / other.high, 1 / other.low, 1 / min(abs(other.low), abs(other.high)))
        return self * inverse

    def __pow__(self, exponent):
        ends = [end**exponent for end in (self.low, self.high)] + ([0.0] if 0 in self and exponent % 2 == 0 else [])
        return Interval(min(ends), max(ends), self.scale**exponent)

    def through(self, function, scale):
        """By a function that rises or falls all the way."""
        ends = [function(end) for end in (self.low, self.high)]
        return Interval(min(ends), max(ends), scale)


def absolute(x):
    ends = [abs(x.low), abs(x.high)] + ([0.0] if 0 in x else [])
    return Interval(min(ends), max(ends), x.scale)


def sqrt(x):
    return x.through(lambda end: math.sqrt(max(end, 0.0)), math.sqrt(x.scale))


def wave(x, function, greatest, scale):
    """Of an angle; the peaks, of which the upper one is given, may lie between the ends."""
    values = [function(x.low), function(x.high)]
    for place, peak in (greatest, 1.0), (greatest + math.pi, -1.0):
        if math.floor((x.high - place) / math.tau) >= math.ceil((x.low - place) / math.tau):
            values.append(peak)
    return Interval(min(values), max(values), max(scale, *map(abs, values)))


def sin(x):
    return wave(x, math.sin, math.pi / 2, min(1.0, x.scale))


def cos(x):
    return wave(x, math.cos, 0.0, 1.0)


def inside(function):
    return lambda x: x.through(lambda end: function(min(1.0, max(-1.0, end))), 1.0)


def atan2(y, x):
    """In (-90°, 270°], and around it by less than half a turn."""
    assert not (0 in x and 0 in y), "the direction of what may be no vector"
    middle = math.atan2((y.low + y.high) / 2, (x.low + x.high) / 2)
    middle += math.tau if middle <= -math.pi / 2 else 0.0
    corners = [math.atan2(b, a) - middle for a in (x.low, x.high) for b in (y.low, y.high)]
    corners = [middle + corner - math.tau * round(corner / math.tau) for corner in corners]
    return Interval(min(corners), max(corners), 1.0)


FUNCTIONS = {
    "frac": lambda a, b: a / b, "sqrt": sqrt, "abs": absolute, "sin": sin, "cos": cos, "arcsin": inside(math.asin),
    "arccos": inside(math.acos), "arctan2": atan2, "pi": Interval.around(math.pi),
}
