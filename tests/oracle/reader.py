"""From a raytree-scene/1.0 document to what is traced: defaults, units, transforms (formats.md).

A `Source` is a scene as it was written, with its meshes; a `Scene` is the same in one arithmetic.
The oracle trusts its scenes: it does not report mistakes in them.
"""

import hashlib
import json
from pathlib import Path
from typing import Any, NamedTuple

from arithmetic import Arithmetic, cross, dot, length, scale, subtract, tan, unit
from obj import read_obj, triangles
from shapes import Cone, Polygon, Sphere

SETTINGS = {
    "max_depth": 6,
    "min_weight": 0.001,
    "max_distance": None,
    "attenuation": [1, 0, 0],
    "specular_model": "phong",
    "shadows": "opaque",
    "total_internal_reflection": "drop",
    "pixel_sample": "center",
    "secondary_background": None,
    "quantize": "round",
    "ray_budget": 1_000_000,
}

MATERIAL = {
    "color": [0.8, 0.8, 0.8],
    "specular_color": [1, 1, 1],
    "ka": 0.1,
    "kd": 0.7,
    "ks": 0,
    "kr": 0,
    "kt": 0,
    "shininess": 32,
    "ior": 1.5,
}


class Source(NamedTuple):
    document: dict
    meshes: dict
    sha256: str = ""


class Material:
    """Compared by identity: that is what makes one written in place a medium of its own."""

    def __init__(self, name, written, arithmetic):
        values = {**MATERIAL, **written}
        self.name = name
        for key in ("color", "specular_color", "ka", "kd", "ks", "kr", "kt"):
            setattr(self, key, rgb(values[key], arithmetic))
        self.shininess = arithmetic.number(values["shininess"])
        self.ior = arithmetic.number(values["ior"])


class Light(NamedTuple):
    name: str
    position: Any
    towards: Any
    intensity: Any
    attenuation: Any


class Thing(NamedTuple):
    """An object of the scene: its shapes (many for a mesh) and how to get into their space."""

    kind: str
    material: Material
    shapes: list
    inverse: Any

    def to_own_space(self, origin, direction):
        if self.inverse is None:
            return origin, direction
        rows = self.inverse
        return tuple(dot(r, origin) + r[3] for r in rows), tuple(dot(r, direction) for r in rows)

    def normal_to_world(self, normal):
        """By the inverse transpose, unit."""
        if self.inverse is not None:
            rows = self.inverse
            normal = tuple(sum(rows[i][j] * normal[i] for i in range(3)) for j in range(3))
        return unit(normal)


class Camera(NamedTuple):
    eye: Any
    x_axis: Any
    y_axis: Any
    z_axis: Any
    window: Any
    width: int
    height: int
    near: Any


class Scene(NamedTuple):
    source: Source
    arithmetic: Arithmetic
    settings: dict
    camera: Camera
    background: Any
    ambient: Any
    lights: list
    things: list
    names: dict


def read_source(path):
    text = Path(path).read_bytes()
    document = json.loads(text)
    document.setdefault("name", Path(path).stem)
    files = {o["file"] for o in document["objects"] if o["type"] == "mesh"}
    meshes = {name: read_obj((Path(path).parent / name).read_text()) for name in files}
    return Source(document, meshes, hashlib.sha256(text).hexdigest())


def rgb(value, arithmetic):
    """RGB, or one number for all three channels."""
    channels = value if isinstance(value, list) else [value] * 3
    return tuple(arithmetic.number(x) for x in channels)


def build_scene(source, arithmetic):
    document = source.document
    things, names = build_things(source, arithmetic)
    lights = document.get("lights", [])
    return Scene(
        source,
        arithmetic,
        used_settings(document, arithmetic),
        build_camera(document, arithmetic),
        rgb(document.get("background", 0), arithmetic),
        rgb(document.get("ambient", 1), arithmetic),
        [build_light(i, light, arithmetic) for i, light in enumerate(lights)],
        things,
        names,
    )


def used_settings(document, arithmetic):
    settings = {**SETTINGS, **document.get("settings", {})}
    settings["min_weight"] = arithmetic.number(settings["min_weight"])
    settings["attenuation"] = rgb(settings["attenuation"], arithmetic)
    if settings["max_distance"] is not None:
        settings["max_distance"] = arithmetic.number(settings["max_distance"])
    if settings["secondary_background"] is not None:
        settings["secondary_background"] = rgb(settings["secondary_background"], arithmetic)
    return settings


def build_camera(document, arithmetic):
    """model.md, section 1: the axes, and the window on the plane at distance 1."""
    written = document["camera"]
    number = arithmetic.number
    eye, look_at, up = (
        tuple(number(x) for x in written.get(key, [0, 1, 0])) for key in ("eye", "look_at", "up")
    )
    z_axis = unit(subtract(look_at, eye))
    x_axis = unit(cross(z_axis, up))
    if "image_plane" in written:
        window = tuple(number(x) for x in written["image_plane"])
    else:
        side = tan(number(written["horizontal_fov_degrees"]) / 2 * arithmetic.pi / 180)
        top = side * written["height"] / written["width"]
        window = (-side, side, -top, top)
    return Camera(
        eye,
        x_axis,
        cross(x_axis, z_axis),
        z_axis,
        window,
        written["width"],
        written["height"],
        number(written.get("near", 0)),
    )


def build_light(index, written, arithmetic):
    number = arithmetic.number
    is_point = written["type"] == "point"
    place = tuple(number(x) for x in written["position" if is_point else "direction"])
    return Light(
        written.get("name", f"light{index}"),
        place if is_point else None,
        None if is_point else scale(-1 / length(place), place),
        rgb(written.get("intensity", 1), arithmetic),
        rgb(written.get("attenuation", [1, 0, 0]), arithmetic) if is_point else None,
    )


def build_things(source, arithmetic):
    materials = {
        name: Material(name, written, arithmetic)
        for name, written in source.document.get("materials", {}).items()
    }
    things, names = [], {}
    for index, written in enumerate(source.document["objects"]):
        name = written.get("name", f"{written['type']}{index}")
        material = written["material"]
        if isinstance(material, dict):
            material = Material(name, material, arithmetic)
        else:
            material = materials[material]
        shapes = build_shapes(written, source.meshes, arithmetic.number)
        for k, shape in enumerate(shapes):
            names[shape] = f"{name}#{k}" if written["type"] == "mesh" else name
        inverse = inverted(written.get("transform"), arithmetic.number)
        things.append(Thing(written["type"], material, shapes, inverse))
    return things, names


def build_shapes(written, meshes, number):
    def point(value):
        return tuple(number(x) for x in value)

    kind = written["type"]
    if kind == "sphere":
        return [Sphere(point(written["center"]), number(written["radius"]))]
    if kind == "cone":
        ends = [(point(written[e]), number(written[e + "_radius"])) for e in ("base", "apex")]
        return [Cone(*ends[0], *ends[1])]
    if kind == "polygon":
        normals = [point(normal) for normal in written.get("normals", ())]
        return [Polygon([point(vertex) for vertex in written["vertices"]], normals)]
    return mesh_shapes(meshes[written["file"]], written.get("smooth", True), point)


def mesh_shapes(mesh, smooth, point):
    places, normals = [point(v) for v in mesh["v"]], [point(n) for n in mesh["vn"]]
    shapes = []
    for corners in triangles(mesh):
        has_normals = smooth and all(normal is not None for _, normal in corners)
        shapes.append(
            Polygon(
                [places[vertex] for vertex, _ in corners],
                [normals[normal] for _, normal in corners] if has_normals else None,
            )
        )
    return shapes


def inverted(matrix, number):
    """The inverse of an affine 4 x 4 matrix, its first three rows; by cofactors."""
    if matrix is None:
        return None
    rows = [tuple(number(x) for x in row) for row in matrix[:3]]
    a, b, c = (row[:3] for row in rows)
    columns = [cross(b, c), cross(c, a), cross(a, b)]
    inverse = [[columns[j][i] / dot(a, columns[0]) for j in range(3)] for i in range(3)]
    moved = [row[3] for row in rows]
    return [tuple(row) + (-dot(row, moved),) for row in inverse]
