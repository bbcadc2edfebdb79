"""The files that the tests of the command line are about: good ones, and every kind of bad one."""

import copy
import json

GOOD = {
    "format": "raytree-scene/1.0",
    "name": "two balls",
    "camera": {"eye": [0, 1, 6], "look_at": [0, 0.5, 0], "horizontal_fov_degrees": 40,
               "width": 32, "height": 24},
    "background": [0.2, 0.3, 0.5],
    "settings": {"max_depth": 5},
    "materials": {
        "glass": {"color": [1, 1, 1], "ks": 0.5, "kr": 0.1, "kt": 0.8, "ior": 1.5},
        "matt": {"color": [0.7, 0.3, 0.2], "kd": 0.8}},
    "lights": [{"name": "key", "type": "point", "position": [3, 6, 4], "intensity": 0.4},
               {"name": "sun", "type": "directional", "direction": [0, -1, 0], "intensity": 0.2}],
    "objects": [
        {"name": "ball", "type": "sphere", "center": [0, 1, 0], "radius": 1, "material": "glass"},
        {"name": "pane", "type": "polygon", "material": "matt",
         "vertices": [[-4, 0, -4], [-4, 0, 4], [4, 0, 4], [4, 0, -4]]},
        {"name": "post", "type": "cone", "base": [2, 0, 0], "base_radius": 0.3, "apex": [2, 2, 0],
         "apex_radius": 0.1, "material": "matt"}],
}

COURSE = """NEAR 1
LEFT -1
RIGHT 1
BOTTOM -1
TOP 1
RES 24 24
SPHERE s1 0 0 -10 2 4 2 0.5 0 0 1 1 0.9 0.2 50
LIGHT l1 0 5 0 0.9 0.9 0.9
BACK 1 1 1
AMBIENT 0.2 0.2 0.2
OUTPUT ../elsewhere/course.ppm
"""

NFF = """v
from 0 0 5
at 0 0 0
up 0 1 0
angle 30
hither 1
resolution 16 16
b 0.1 0.2 0.3
l 3 4 5
f 0.8 0.6 0.4 0.7 0.3 20 0 0
s 0 0 0 1
"""

OBJ = """v 0 0 0
v 1 0 0
v 0 1 0
v 0 0 1
f 1 3 2
f 1 2 4
f 1 4 3
f 2 3 4
"""


def changed(*changes):
    """The good scene with values set (or members removed, for `...`) at JSON pointers."""
    scene = copy.deepcopy(GOOD)
    for pointer, value in changes:
        *path, last = [int(p) if p.isdigit() else p for p in pointer.split("/")[1:]]
        inner = scene
        for part in path:
            inner = inner[part]
        if value is ...:
            del inner[last]
        elif last == "-":
            inner.append(value)
        else:
            inner[last] = value
    return json.dumps(scene)


def mirrors(k, *changes):
    """Four half-silvered panes, one behind another, around the eye: each ray has two branches."""
    panes = [{"name": f"pane {z}", "type": "polygon", "material": "pane",
              "vertices": [[-90, -90, z], [90, -90, z], [90, 90, z], [-90, 90, z]]}
             for z in (-2, -1, 1, 2)]
    pane = {"color": 1, "kd": 0.2, "kr": k, "kt": k, "ior": 1}
    return changed(("/camera/eye", [0, 0, 0]), ("/camera/look_at", [0, 0, -1]),
                   ("/camera/width", 2), ("/camera/height", 2),
                   ("/camera/horizontal_fov_degrees", 9),
                   ("/settings", {"max_depth": 64, "min_weight": 0}),
                   ("/materials", {"pane": pane}), ("/objects", panes), *changes)


SQUARE = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]
FLAT = [[1, 0, 0, 0], [0, 0, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]

FILES = {
    "scene.json": json.dumps(GOOD),
    "course.txt": COURSE,
    "ball.nff": NFF,
    "gem.obj": OBJ,
    "mesh.json": changed(("/objects/-", {"name": "gem", "type": "mesh", "file": "gem.obj",
                                         "material": "matt"})),
    "scene.dat": json.dumps(GOOD),
    "bright.json": changed(("/lights/1/intensity", 9)),
    "hall.json": mirrors(0.5),
    "small-hall.json": mirrors(0.5, ("/settings/ray_budget", 1000)),
    "overflow.json": mirrors(1e200, ("/settings/max_depth", 9)),
    "newer.json": changed(("/format", "raytree-scene/1.7"), ("/sparkle", 3)),
    "huge.pfm.json": changed(("/background", 1e60), ("/objects", [])),
    "no-picture.txt": COURSE.replace("OUTPUT ../elsewhere/course.ppm\n", ""),
    "other-picture.txt": COURSE.replace("course.ppm", "course.tiff"),
}

# name, bytes, what the message must say.
BAD_SCENES = [
    ("cut off", json.dumps(GOOD)[:-40], r"line 1, column \d+"),
    ("empty", "", r"line 1, column 1"),
    ("nested 100,000 deep", "[" * 100_000, r"deep"),
    ("nested and closed", '{"a":' * 100_000 + "1" + "}" * 100_000, r"deep"),
    ("no JSON", "hello", r"line 1, column"),
    ("no object", "[1, 2]", r"object"),
    ("not UTF-8", b'{"format": "\xff\xfe"}', r"UTF-8|line 1, column"),
    ("NaN", changed(("/objects/0/radius", float("nan"))), r"line 1, column \d+"),
    ("infinity", changed(("/objects/0/radius", float("inf"))), r"line 1, column \d+"),
    ("1e999", changed(("/objects/0/radius", 7)).replace('"radius": 7', '"radius": 1e999'),
     r"1e999"),
    ("key given twice", '{"format": "raytree-scene/1.0", "format": "x"}', r"twice"),
    ("other format", changed(("/format", "raytree/1.0")), r"/format: .*raytree-scene/1\.0"),
    ("other major version", changed(("/format", "raytree-scene/2.0")),
     r"/format: .*raytree-scene/1\.0"),
    ("unknown key", changed(("/camera/widht", 3)), r'/camera/widht: .*did you mean "width"'),
    ("missing key", changed(("/camera/eye", ...)), r"/camera/eye: is missing"),
    ("wrong type", changed(("/objects/0/radius", "1")), r"/objects/0/radius: .*number"),
    ("wrong length", changed(("/camera/eye", [1, 2])), r"/camera/eye: .*(three|3) numbers"),
    ("several mistakes", changed(("/objects/0/radius", 0), ("/settings/max_depth", 0)),
     r"(?=.*/objects/0/radius)(?=.*/settings/max_depth)"),
    ("radius 0", changed(("/objects/0/radius", 0)), r"/objects/0/radius: found 0, .*over 0"),
    ("radius below 0", changed(("/objects/0/radius", -1)), r"/objects/0/radius: found -1"),
    ("two vertices", changed(("/objects/1/vertices", SQUARE[:2])),
     r"/objects/1/vertices: .*3 or more"),
    ("collinear", changed(("/objects/1/vertices", [[0, 0, 0], [1, 1, 1], [3, 3, 3]])),
     r"/objects/1/vertices: .*collinear"),
    ("not planar", changed(("/objects/1/vertices", SQUARE[:3] + [[0, 1, 0.2]])),
     r"/objects/1/vertices: .*planar"),
    ("a normal too few", changed(("/objects/1/normals", [[0, 1, 0]] * 3)), r"/objects/1/normals: "),
    ("normal of length 0", changed(("/objects/1/normals", [[0, 0, 0]] * 4)),
     r"/objects/1/normals/0: "),
    ("singular transform", changed(("/objects/0/transform", FLAT)),
     r"/objects/0/transform: .*singular"),
    ("projective transform", changed(("/objects/0/transform", FLAT[:3] + [[0, 0, 1, 1]])),
     r"/objects/0/transform"),
    ("cone of no radius", changed(("/objects/2/base_radius", 0), ("/objects/2/apex_radius", 0)),
     r"/objects/2: .*radius"),
    ("cone of no length", changed(("/objects/2/apex", [2, 0, 0])), r"/objects/2: .*same point"),
    ("unknown material", changed(("/objects/0/material", "glas")),
     r'/objects/0/material: .*"glas".*did you mean "glass"'),
    ("duplicate name", changed(("/objects/1/name", "ball")), r'/objects/1/name: .*"ball"'),
    ("duplicate of a default name", changed(("/lights/1/name", "light0"), ("/lights/0/name", ...)),
     r'"light0"'),
    ("unknown type", changed(("/objects/0/type", "spere")),
     r'/objects/0/type: .*did you mean "sphere"'),
    ("view along up", changed(("/camera/up", [0, -1, -12])), r"/camera.*up"),
    ("eye is look_at", changed(("/camera/look_at", [0, 1, 6])), r"/camera: .*same point"),
    ("straight angle", changed(("/camera/horizontal_fov_degrees", 180)),
     r"/camera/horizontal_fov_degrees: .*under 180"),
    ("a billion pixels", changed(("/camera/width", 40000), ("/camera/height", 25000)),
     r"/camera: .*1000000000 pixels; at most 2\^28"),
    ("too wide", changed(("/camera/width", 10**9)), r"/camera/width: .*1 to 65535"),
    ("half a pixel", changed(("/camera/width", 0.5)), r"/camera/width: .*whole number"),
    ("max_depth 10^9", changed(("/settings/max_depth", 10**9)), r"/settings/max_depth: .*1 to 64"),
    ("max_depth 10^30", changed(("/settings/max_depth", 10**30)),
     r"/settings/max_depth: .*1 to 64"),
    ("negative coefficient", changed(("/materials/matt/kd", -0.1)),
     r"/materials/matt/kd: .*0 or more"),
    ("attenuation all 0", changed(("/settings/attenuation", [0, 0, 0])),
     r"/settings/attenuation: "),
    ("no mesh file",
     changed(("/objects/0", {"type": "mesh", "file": "none.obj", "material": "matt"})),
     r"none\.obj"),
    ("light of no direction", changed(("/lights/1/direction", [0, 0, 0])),
     r"/lights/1/direction: "),
]

# file name, text, what the message must say.
BAD_FOREIGN = [
    ("word.nff", NFF.replace("hither", "hithr"), r"word\.nff: line 6, column 1"),
    ("top.nff", NFF.replace("b 0.1", "x 0.1"), r"top\.nff: line 8, column 1.*x"),
    ("number.nff", NFF.replace("angle 30", "angle x"), r"number\.nff: line 5, column 7"),
    ("nan.nff", NFF.replace("angle 30", "angle nan"), r"nan\.nff: line 5, column 7"),
    ("cut.nff", NFF[:-4], r"cut\.nff: "),
    ("word.txt", COURSE.replace("BACK", "BAKC"), r"word\.txt: line 9, column 1.*BAKC"),
    ("nan.txt", COURSE.replace("NEAR 1", "NEAR nan"), r"nan\.txt: line 1, column 6"),
    ("flat.txt", COURSE.replace("2 4 2", "2 0 2"), r"flat\.txt: "),
    ("no-size.txt", COURSE.replace("RES 24 24\n", ""), r"no-size\.txt: .*RES"),
    ("index.obj", OBJ.replace("f 1 3 2", "f 1 3 9"), r"index\.obj: "),
    ("nan.obj", OBJ.replace("v 1 0 0", "v nan 0 0"), r"nan\.obj: "),
    ("empty.obj", "", r"empty\.obj: "),
]
