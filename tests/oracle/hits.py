"""What a ray meets (model.md, sections 1 and 2), and the media on both sides of it (section 3)."""

from typing import Any, NamedTuple

from arithmetic import along, dot, scale, unit
from reader import Material


class Ray(NamedTuple):
    """`leaving` is the shape that the origin lies on, `path` how far that is from the eye."""

    kind: str
    level: int
    parent: Any
    origin: Any
    direction: Any
    weight: Any
    leaving: Any
    media: tuple
    path: Any


class Hit(NamedTuple):
    shape: Any
    material: Material
    t: Any
    point: Any
    normal: Any
    side: str
    c1: Any
    eta: Any
    s2: Any
    media_beyond: tuple


class Finder:
    """Primary rays of a scene, and the hits of any ray."""

    def __init__(self, scene):
        self.scene, self.settings = scene, scene.settings
        self.nothing = scene.arithmetic.nothing
        self.zero, self.one = (scene.arithmetic.number(x) for x in (0, 1))
        self.tests = 0

    def primary_ray(self, i, j):
        camera, number = self.scene.camera, self.scene.arithmetic.number
        inside = number(0 if self.settings["pixel_sample"] == "corner" else 0.5)
        left, right, bottom, top = camera.window
        xp = left + (i + inside) * (right - left) / camera.width
        yp = top - (j + inside) * (top - bottom) / camera.height
        towards = along(along(camera.z_axis, camera.x_axis, xp), camera.y_axis, yp)
        direction = unit(towards)
        return Ray("primary", 1, None, camera.eye, direction, (self.one,) * 3, None, (), self.zero)

    def crossings(self, origin, direction, leaving):
        """(t, thing, shape) of everything that the ray meets at t > 0, in scene order."""
        for thing in self.scene.things:
            own_origin, own_direction = thing.to_own_space(origin, direction)
            for shape in thing.shapes:
                self.tests += 1
                for t in shape.meets(own_origin, own_direction, shape is leaving):
                    if t > self.nothing:
                        yield t, thing, shape

    def closest(self, ray):
        """The hit of a primary, reflected or refracted ray, or None."""
        nearest = None
        first_seen = self.zero
        if ray.kind == "primary":
            first_seen = self.scene.camera.near / dot(ray.direction, self.scene.camera.z_axis)
        for crossing in self.crossings(ray.origin, ray.direction, ray.leaving):
            if crossing[0] < first_seen:
                continue
            # Equal distances differ by rounding here; the first object has to win all the same.
            if nearest is None or crossing[0] < nearest[0] - self.nothing:
                nearest = crossing
        limit = self.settings["max_distance"]
        if nearest is None or (limit is not None and ray.path + nearest[0] >= limit):
            return None
        return self.describe(ray, *nearest)

    def describe(self, ray, t, thing, shape):
        own_origin, own_direction = thing.to_own_space(ray.origin, ray.direction)
        geometric, shading = shape.normals(along(own_origin, own_direction, t))
        is_front = dot(ray.direction, thing.normal_to_world(geometric)) < 0
        normal = thing.normal_to_world(shading)
        if not is_front:
            normal = scale(-1, normal)
        c1 = -dot(ray.direction, normal)
        eta, beyond = self.media(ray, thing.material, is_front)
        s2 = (eta[0] / eta[1]) ** 2 * (1 - c1 * c1)
        point = along(ray.origin, ray.direction, t)
        side = "front" if is_front else "back"
        return Hit(shape, thing.material, t, point, normal, side, c1, eta, s2, beyond)

    def media(self, ray, material, is_front):
        """The two indices at a surface, and the media of a ray that goes through it."""
        if is_front:
            return (self.index(ray.media), material.ior), ray.media + (material,)
        beyond = list(ray.media)
        for place in reversed(range(len(beyond))):
            if beyond[place] is material:
                del beyond[place]
                break
        return (material.ior, self.index(beyond)), tuple(beyond)

    def index(self, media):
        return media[-1].ior if media else self.one
