"""Parts of random scenes: materials, transforms, outlines, OBJ files."""

import math


def noise(rng, low, high, centre=(0, 0, 0)):
    return [x + rng.uniform(low, high) for x in centre]


def material_palette(rng):
    return {
        "glass": {
            "color": noise(rng, 0.7, 1), "ka": rng.uniform(0, 0.1), "kd": rng.uniform(0, 0.1),
            "ks": 0.5, "shininess": rng.choice([20, 61, 7.5]), "kr": rng.uniform(0.05, 0.3),
            "kt": noise(rng, 0.6, 0.9), "ior": rng.uniform(1.3, 2.2),
        },
        "water": {"color": [0.4, 0.6, 1], "kd": 0.1, "ks": 0.4, "kt": 0.8, "ior": 1.333},
        # The default index, transmission in one channel: its shadows can come to 0 in two steps.
        "tinted": {"ks": noise(rng, 0.1, 0.5), "kt": [0, rng.uniform(0.3, 0.8), 0], "kr": 0.2},
        "mirror": {
            "color": noise(rng, 0.1, 0.9), "kd": 0.1, "ks": 0.6, "kr": noise(rng, 0.6, 0.9),
            "specular_color": [1, 0.9, 0.5], "shininess": rng.choice([1, 15, 200]),
        },
        "matt": {"color": noise(rng, 0.2, 0.9), "ka": [0.1, 0.2, 0.1], "kd": noise(rng, 0.4, 0.9)},
        "tiles": {"color": 1, "ka": 0.3, "kd": 0, "kr": [0.5, 0, 0.25]},
    }  # fmt: skip


def rotation(rng):
    """Rows of a random rotation, from a random quaternion."""
    q = [rng.gauss(0, 1) for _ in range(4)]
    size = math.sqrt(sum(x * x for x in q))
    w, x, y, z = (c / size for c in q)
    return [
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ]


def product(a, b):
    return [[sum(a[i][k] * b[k][j] for k in range(3)) for j in range(3)] for i in range(3)]


def placement(rng, mirrored):
    """A 4 x 4 transform: turned, scaled unequally, perhaps mirrored, sheared, moved into view."""
    sizes = [rng.uniform(0.6, 1.5) for _ in range(3)]
    if mirrored:
        sizes[rng.randrange(3)] *= -1
    turned = rotation(rng)
    scaled = [[size * x for x in row] for size, row in zip(sizes, rotation(rng))]
    linear = product(turned, scaled)
    moved = [rng.uniform(-1.6, 1.6), rng.uniform(-0.2, 1.8), rng.uniform(-1.5, 1.5)]
    return [row + [x] for row, x in zip(linear, moved)] + [[0, 0, 0, 1]]


HORSESHOE = [(-1, -1), (1, -1), (1, 1), (0.5, 1), (0.5, -0.4), (-0.5, -0.4), (-0.5, 1), (-1, 1)]


def outline(rng, centre, concave):
    """Vertices around a centre in a random plane, counter-clockwise, and the plane's normal."""
    across, along, normal = rotation(rng)
    flat = star(rng, 1)
    if concave:
        # A line crosses the horseshoe four times, which a star seldom is.
        flat = HORSESHOE if rng.random() < 0.6 else star(rng, 0.3)
    vertices = [[c + x * a + y * b for c, a, b in zip(centre, across, along)] for x, y in flat]
    return vertices, normal


def star(rng, inner):
    """Every second vertex is at `inner` of the radius of its neighbours."""
    count = rng.choice([4, 6, 8])
    points = []
    for k in range(count):
        angle = 2 * math.pi * (k + rng.uniform(-0.2, 0.2)) / count
        radius = rng.uniform(1, 1.7) * (inner if k % 2 else 1)
        points.append((radius * math.cos(angle), radius * math.sin(angle)))
    return points


def line(word, numbers):
    return " ".join([word] + [repr(x) for x in numbers]) + "\n"


def ball_obj(rng):
    """An uneven globe of quadrilaterals and triangles, normals of any length, `v//vn` corners."""
    rings, sectors = 4, 6
    text = "# an uneven globe\no ball\n"
    places = [(0.0, 1.0, 0.0)]
    for i in range(1, rings):
        polar = math.pi * i / rings
        for j in range(sectors):
            turn = 2 * math.pi * (j + 0.1 * i) / sectors
            ring = math.sin(polar)
            places.append((ring * math.cos(turn), math.cos(polar), ring * math.sin(turn)))
    places.append((0.0, -1.0, 0.0))
    for place in places:
        size = rng.uniform(0.7, 0.9)
        text += line("v", [size * x for x in place])
        text += line("vn", [rng.uniform(0.5, 3) * x + rng.uniform(-0.1, 0.1) for x in place])
    last = len(places)
    faces = []
    for j in range(sectors):
        here, there = 2 + j, 2 + (j + 1) % sectors
        faces.append([1, there, here])
        for i in range(rings - 2):
            a, b = here + i * sectors, there + i * sectors
            faces.append([a, b, b + sectors, a + sectors])
        bottom = (rings - 2) * sectors
        faces.append([last, here + bottom, there + bottom])
    return text + "s 1\n" + "".join(face("{0}//{0}", corners) for corners in faces)


def face(form, corners):
    return "f " + " ".join(form.format(corner) for corner in corners) + "\n"


def box_obj(rng):
    """A closed box of quadrilaterals without normals, bent a little so that no face is plane."""
    text = "g box\nusemtl none\n"
    for k in range(8):
        corner = [(1 if k >> axis & 1 else -1) * rng.uniform(0.45, 0.65) for axis in range(3)]
        text += line("v", corner)
    faces = [[1, 3, 4, 2], [5, 6, 8, 7], [1, 2, 6, 5], [3, 7, 8, 4], [1, 5, 7, 3], [2, 4, 8, 6]]
    return text + "\n" + "".join(face("{0}", corners) for corners in faces)


def pyramid_obj(rng):
    """Negative indices, texture coordinates, normals that `smooth: false` has to leave alone.

    A flag on its top is written after the faces below it: -1 is not the last of the file.
    """
    text = ""
    for x, y, z in [(-1, 0, -1), (1, 0, -1), (1, 0, 1), (-1, 0, 1), (0, 1.2, 0)]:
        text += line("v", [0.7 * c + rng.uniform(-0.1, 0.1) for c in (x, y, z)])
        text += line("vt", [rng.random(), rng.random()])
        text += line("vn", noise(rng, -1, 1))
    faces = [[-5, -4, -3, -2], [-1, -4, -5], [-1, -3, -4], [-1, -2, -3]]
    text += "".join(face("{0}/{0}/{0}", corners) for corners in faces)
    text += "f 5/1 1/1 4/1   # the last side, counted from the start\n"
    for x, y in [(0.0, 0.8), (0.0, 1.5), (0.6, 1.4)]:
        text += line("v", [x, y, rng.uniform(-0.1, 0.1)])
    return text + face("{0}", [-3, -2, -1])


def moved_obj(text, place):
    """The same file with its vertices somewhere else."""
    lines = []
    for row in text.splitlines():
        words = row.split()
        if words and words[0] == "v":
            row = line("v", [float(x) + c for x, c in zip(words[1:], place)]).rstrip()
        lines.append(row)
    return "\n".join(lines) + "\n"
