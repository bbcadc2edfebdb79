#!/usr/bin/env python3
"""Prints sphereflake.json: a ball that bears nine balls of a third of its radius, and so on.

    python3 make-sphereflake.py > sphereflake.json

Six of the nine sit around a ball's equator and three on its upper half, where the balls of a densest
packing touch it; "up" is the way away from the ball that bears it. 1 + 9 + 81 + 729 + 6,561 balls
are 7,381, and with the floor 7,382 objects.
"""

import json
import math

LEVELS = 5
DIGITS = 5

HEAD = {
    "format": "raytree-scene/1.0",
    "name": "Sphereflake: 7,381 balls on a floor",
    "camera": {"eye": [-2, 1.8, 4.5], "look_at": [0.02, -0.08, 0],
               "horizontal_fov_degrees": 41, "width": 512, "height": 512},
    "background": [0.55, 0.62, 0.67],
    "ambient": [1, 1, 1],
    "settings": {"max_depth": 5, "min_weight": 0.004},
    "materials": {
        "floor": {"color": [0.55, 0.62, 0.67], "ka": 0.62, "kd": 0.25, "kr": 0.1},
        "level 1": {"color": [0.13, 0.17, 0.24], "ka": 0.3, "kd": 0.5, "ks": 0.4, "shininess": 60,
                    "kr": 0.3},
        "level 2": {"color": [0.12, 0.40, 0.44], "ka": 0.3, "kd": 0.5, "ks": 0.4, "shininess": 60,
                    "kr": 0.25},
        "level 3": {"color": [0.45, 0.60, 0.50], "ka": 0.3, "kd": 0.5, "ks": 0.3, "shininess": 60,
                    "kr": 0.2},
        "level 4": {"color": [0.90, 0.66, 0.28], "ka": 0.3, "kd": 0.5, "ks": 0.3, "shininess": 60,
                    "kr": 0.15},
        "level 5": {"color": [0.82, 0.36, 0.22], "ka": 0.3, "kd": 0.5, "ks": 0.2, "shininess": 60,
                    "kr": 0.1},
    },
    "lights": [
        {"name": "key", "type": "point", "position": [-4, 6, 5], "intensity": [0.80, 0.77, 0.70]},
        {"name": "fill", "type": "point", "position": [5, 4, 3], "intensity": [0.32, 0.35, 0.40]},
        {"name": "rim", "type": "point", "position": [1, 5, -5], "intensity": [0.30, 0.30, 0.32]},
    ],
}

FLOOR = {"type": "polygon", "vertices": [[-40, -1, 40], [40, -1, 40], [40, -1, -40], [-40, -1, -40]],
         "material": "floor"}


def add(a, b):
    return tuple(x + y for x, y in zip(a, b))


def scaled(k, a):
    return tuple(k * x for x in a)


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def turned(vector, start, end):
    """`vector`, turned by the smallest turn that takes the unit vector `start` to `end`."""
    axis = cross(start, end)
    cosine = dot(start, end)
    along = scaled(dot(axis, vector) / (1 + cosine), axis)
    return add(add(scaled(cosine, vector), cross(axis, vector)), along)


def directions(side, up):
    """Where the nine balls sit, on a ball whose pole is `up` and whose meridian goes by `side`."""
    other = cross(up, side)
    height = math.sqrt(2 / 3)
    ring = [(math.radians(60 * k), 0) for k in range(6)]
    crown = [(math.radians(30 + 120 * k), height) for k in range(3)]
    for angle, rise in ring + crown:
        reach = math.sqrt(1 - rise * rise)
        level = add(scaled(reach * math.cos(angle), side), scaled(reach * math.sin(angle), other))
        yield add(level, scaled(rise, up))


def balls(center, radius, side, up, level=1):
    """(centre, radius, level) of the ball and of all that it bears."""
    yield center, radius, level
    if level < LEVELS:
        for direction in directions(side, up):
            child = add(center, scaled(radius * 4 / 3, direction))
            yield from balls(child, radius / 3, turned(side, up, direction), direction, level + 1)


def short(number):
    return round(number, DIGITS) + 0.0  # never -0.0


def sphere(center, radius, level):
    return {"type": "sphere", "center": [short(x) for x in center], "radius": short(radius),
            "material": f"level {level}"}


def member(key, value):
    """A line of the file; of the materials and lights, a line each."""
    if key == "materials":
        lines = [f"{json.dumps(name)}: {json.dumps(material)}" for name, material in value.items()]
        return f'  "{key}": ' + block("{}", lines)
    if isinstance(value, list) and isinstance(value[0], dict):
        return f'  "{key}": ' + block("[]", map(json.dumps, value))
    return f'  "{key}": {json.dumps(value)}'


def block(brackets, lines):
    return brackets[0] + "\n    " + ",\n    ".join(lines) + "\n  " + brackets[1]


def main():
    spheres = [sphere(*ball) for ball in balls((0, 0, 0), 1, (1, 0, 0), (0, 1, 0))]
    scene = {**HEAD, "objects": [FLOOR, *spheres]}
    print("{\n" + ",\n".join(member(*item) for item in scene.items()) + "\n}")


if __name__ == "__main__":
    main()
