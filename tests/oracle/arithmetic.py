"""The numbers that the oracle computes with, and vectors of three of them.

The oracle is written once for two arithmetics: EXACT has 50 decimal digits and makes the truth,
FAST is Python's float and only helps to choose pixels. Vectors are plain tuples: mpmath's own
matrices cost ten times as much.
"""

import math
from typing import Any, Callable, NamedTuple

from mpmath import mp, mpf

mp.dps = 50


class Arithmetic(NamedTuple):
    """How to make a number, and the distance below which two points are one.

    Everything in a scene is a double, so `number` goes through float even when it is asked for
    50 digits (formats.md: "what is read is always the nearest double").
    """

    number: Callable[[Any], Any]
    pi: Any
    nothing: Any


EXACT = Arithmetic(lambda value: mpf(float(value)), +mp.pi, mpf("1e-40"))
FAST = Arithmetic(float, math.pi, 1e-9)


def sqrt(x):
    return math.sqrt(x) if isinstance(x, float) else mp.sqrt(x)


def tan(x):
    return math.tan(x) if isinstance(x, float) else mp.tan(x)


def power(base, exponent):
    """0^0 is 1, as in every language that a tracer is likely to be written in."""
    return base**exponent if base > 0 or exponent > 0 else base * 0 + 1


def add(a, b):
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


def subtract(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def scale(s, a):
    return (s * a[0], s * a[1], s * a[2])


def times(a, b):
    """Channel by channel, for colours."""
    return (a[0] * b[0], a[1] * b[1], a[2] * b[2])


def along(origin, direction, t):
    return (
        origin[0] + t * direction[0],
        origin[1] + t * direction[1],
        origin[2] + t * direction[2],
    )


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return (
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    )


def length(a):
    return sqrt(dot(a, a))


def unit(a):
    return scale(1 / length(a), a)
