"""The smallest tracer that records: the two balls of ../sample-scene.json.

    python3 sample.py 16 12 > tree.json
"""

import math
import sys

from raytree_recorder import Recorder

# name, centre, radius, colour, ka, kd, kr
BALLS = [("ball", (0, 0, 0), 1, (0.9, 0.9, 0.9), 0.1, 0.3, 0.6),
         ("small", (1.2, 0.8, 0.8), 0.4, (0.8, 0.4, 0.2), 0.2, 0.7, 0.1)]
BACKGROUND = (0.1, 0.2, 0.3)
LAMP = (3, 5, 4)


def along(a, s, b):
    return tuple(x + s * y for x, y in zip(a, b))


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def unit(a):
    return tuple(x / math.sqrt(dot(a, a)) for x in a)


def nearest(origin, direction, until):
    found = None
    for ball in BALLS:
        to = along(origin, -1, ball[1])
        b = dot(to, direction)
        root = b * b - dot(to, to) + ball[2] ** 2
        if root >= 0:
            for t in (-b - math.sqrt(root), -b + math.sqrt(root)):
                if 1e-6 < t < until:
                    found, until = ball, t
    return found, until


def trace(recorder, kind, parent, origin, direction, level):
    ray = recorder.ray(kind, parent, origin, direction)
    ball, t = nearest(origin, direction, math.inf)
    if ball is None:
        ray.miss().set(intensity=BACKGROUND)
        return BACKGROUND
    name, centre, radius, colour, ka, kd, kr = ball
    point = along(origin, t, direction)
    normal = tuple(x / radius for x in along(point, -1, centre))
    total = tuple(ka * c for c in colour)
    to_lamp = along(LAMP, -1, point)
    towards = unit(to_lamp)
    if dot(normal, towards) > 0:
        between, _ = nearest(point, towards, math.sqrt(dot(to_lamp, to_lamp)))
        recorder.shadow(ray, "lamp", point, towards).blocked_by(between and between[0])
        if between is None:
            total = along(total, kd * dot(normal, towards), colour)
    if level < 4:
        mirrored = unit(along(direction, -2 * dot(direction, normal), normal))
        total = along(total, kr, trace(recorder, "reflected", ray, point, mirrored, level + 1))
    ray.hit(name, t, normal=normal).set(intensity=total)
    return total


if __name__ == "__main__":
    i, j = (int(word) for word in sys.argv[1:3]) if len(sys.argv) > 2 else (16, 12)
    the_recorder = Recorder(i, j)
    aim = unit((-0.4 + (i + 0.5) * 0.8 / 32, 0.3 - (j + 0.5) * 0.6 / 24, -1))
    trace(the_recorder, "primary", None, (0, 0, 5), aim, 1)
    sys.stdout.write(the_recorder.json())
