"""A student's tracer: the oracle's, in floats, with one thing wrong.

It shares no code with the program under test, and its mistakes (mistakes.py) are written as students
write them: into the formulas of a tracer, not into the steps that `raytree check` tries.
"""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "oracle"))

from arithmetic import FAST, add, along, dot, length, scale, subtract, times, unit  # noqa: E402
from hits import Ray  # noqa: E402
from model import Tracer  # noqa: E402
from reader import build_scene  # noqa: E402

MOST_RAYS = 2000


class TooLarge(Exception):
    """The tree of a program that never ends."""


class Student(Tracer):
    """The tracer by the book, cut into a few more steps, each of which a mistake may replace."""

    def __init__(self, source, plant=None):
        super().__init__(build_scene(source, FAST))
        self.camera, self.shapes = self.scene.camera, []
        self.things_of = {}
        for thing in self.scene.things:
            for shape in thing.shapes:
                self.shapes.append(shape)
                self.things_of[shape] = thing
        self.no_shadow_rays = False
        self.finder.primary_ray = self.primary_ray
        self.finder.describe = self.describe
        self.finder.crossings = self.crossings
        self.book_describe = type(self.finder).describe
        self.book_crossings = type(self.finder).crossings
        self.beside = set()
        if plant:
            plant(self)

    def tree(self, i, j):
        self.rays.clear()
        self.pixel = (i, j)
        self.follow(self.finder.primary_ray(i, j))
        return {"format": "raytree/1.0", "pixel": [i, j], "rays": self.rays}

    # The camera

    def film(self, i, j):
        inside = 0 if self.settings["pixel_sample"] == "corner" else 0.5
        left, right, bottom, top = self.camera.window
        return (
            left + (i + inside) * (right - left) / self.camera.width,
            top - (j + inside) * (top - bottom) / self.camera.height,
        )

    def axes(self):
        return self.camera.x_axis, self.camera.y_axis, self.camera.z_axis

    def primary_direction(self, i, j):
        x, y = self.film(i, j)
        right, up, forward = self.axes()
        return along(along(forward, right, x), up, y)

    def eye(self, i, j):
        return self.camera.eye

    def primary_ray(self, i, j):
        direction = unit(self.primary_direction(i, j))
        return Ray("primary", 1, None, self.eye(i, j), direction, self.white, None, (), 0.0)

    # Hits

    def point(self, ray, t):
        return along(ray.origin, ray.direction, t)

    def normal(self, ray, thing, shape, own_point, is_front):
        """The shading normal in the world, turned to the ray."""
        normal = thing.normal_to_world(shape.normals(own_point)[1])
        return normal if is_front else scale(-1, normal)

    def describe(self, ray, t, thing, shape):
        hit = self.book_describe(self.finder, ray, t, thing, shape)
        own_origin, own_direction = thing.to_own_space(ray.origin, ray.direction)
        self.world_point = hit.point
        normal = self.normal(
            ray, thing, shape, along(own_origin, own_direction, t), hit.side == "front"
        )
        c1 = -dot(ray.direction, normal)
        eta = self.indices(ray, hit, thing)
        s2 = (eta[0] / eta[1]) ** 2 * (1 - c1 * c1)
        point = self.point(ray, t)
        # Where the point lies beside the surface, a program finds the surface again.
        if length(subtract(point, hit.point)) > 1e-9:
            self.beside.add(point)
        return hit._replace(point=point, normal=normal, c1=c1, eta=eta, s2=s2)

    def crossings(self, origin, direction, leaving):
        leaving = None if origin in self.beside else leaving
        return self.book_crossings(self.finder, origin, direction, leaving)

    def indices(self, ray, hit, thing):
        return hit.eta

    # Light: as the oracle has it, in more steps

    def shares(self, ray, hit, light, towards, distance):
        arriving = self.arriving(light, distance)
        return self.diffuse(hit, light, towards, distance, arriving), self.specular(
            ray, hit, light, towards, distance, arriving
        )

    def arriving(self, light, distance):
        if distance is None:
            return light.intensity
        return scale(self.fading(light.attenuation, distance), light.intensity)

    def fading(self, abc, distance):
        return self.attenuated(abc, distance)

    def diffuse(self, hit, light, towards, distance, arriving):
        return scale(dot(hit.normal, towards), times(self.surface_colour(hit), arriving))

    def surface_colour(self, hit):
        return times(hit.material.kd, hit.material.color)

    def gloss(self, hit):
        return times(hit.material.ks, hit.material.specular_color)

    def viewer(self, ray, hit):
        return scale(-1, ray.direction)

    def mirrored(self, hit, towards):
        return subtract(scale(2 * dot(hit.normal, towards), hit.normal), towards)

    def is_phong(self):
        return self.settings["specular_model"] == "phong"

    def highlight_cosine(self, ray, hit, towards):
        view = self.viewer(ray, hit)
        if self.is_phong():
            return max(0.0, dot(self.mirrored(hit, towards), view))
        return max(0.0, dot(hit.normal, unit(add(towards, view))))

    def exponent(self, hit):
        return hit.material.shininess

    def specular(self, ray, hit, light, towards, distance, arriving):
        power = self.highlight_cosine(ray, hit, towards) ** self.exponent(hit)
        return scale(power, times(self.gloss(hit), arriving))

    def shadow_ray(self, record, hit, light, towards, distance, shares):
        if self.no_shadow_rays:
            _, transmittance = self.shadow(hit, towards, distance)
            return tuple(times(transmittance, share) for share in shares)
        return super().shadow_ray(record, hit, light, towards, distance, shares)

    # The tree

    def ambient(self, hit):
        return times(times(hit.material.ka, hit.material.color), self.scene.ambient)

    def combine(self, hit, ambient, diffuse, specular, grown):
        total = add(add(ambient, diffuse), specular)
        for kind, factor, child in grown:
            total = add(total, self.branch_light(kind, factor, child, hit))
        return total

    def branch_light(self, kind, factor, child, hit):
        return times(
            self.share(kind, factor, hit), scale(child["attenuation"], child["intensity"])
        )

    def share(self, kind, factor, hit):
        return factor

    def fade(self, ray, hit):
        return 1.0 if ray.kind == "primary" else self.attenuated(self.settings["attenuation"], hit.t)

    def miss(self, record):
        secondary = self.settings["secondary_background"]
        if record["kind"] != "primary" and secondary is not None:
            return secondary
        return self.scene.background

    def follow(self, ray):
        if len(self.rays) > MOST_RAYS or ray.level > 60:
            raise TooLarge
        return super().follow(ray)

    def end_in_background(self, record):
        super().end_in_background(record)
        record["intensity"] = self.miss(record)

    def shade(self, record, ray, hit):
        f = self.fade(ray, hit)
        record.update(attenuation=f, hit=self.hit_record(hit), skipped=[])
        ambient = self.ambient(hit)
        diffuse, specular = self.light_up(record, ray, hit)
        record.update(ambient=ambient, diffuse=diffuse, specular=specular)
        grown, reasons = [], []
        for kind, factor, is_total in self.branches(hit):
            weight = scale(f, times(ray.weight, factor))
            reason = self.branch_reason(kind, factor, is_total, ray.level, weight)
            if reason:
                reasons.append(reason)
                record["skipped"].append({"kind": kind, "reason": reason})
                continue
            child = self.follow(self.branch(kind, record, ray, hit, weight))
            grown.append((kind, factor, child))
        record["intensity"] = self.combine(hit, ambient, diffuse, specular, grown)
        record["termination"] = self.end(reasons)

    def end(self, reasons):
        from model import termination

        return termination(reasons)

    def reflected(self, ray, hit):
        return along(ray.direction, hit.normal, 2 * hit.c1)

    def refracted(self, ray, hit):
        eta = hit.eta[0] / hit.eta[1]
        return along(scale(eta, ray.direction), hit.normal, eta * hit.c1 - max(0, 1 - hit.s2) ** 0.5)

    def start(self, kind, ray, hit):
        return hit.point

    def branch(self, kind, record, ray, hit, weight):
        reflected = kind == "reflected"
        towards = self.reflected(ray, hit) if reflected else self.refracted(ray, hit)
        if not length(towards) > 0:
            raise TooLarge
        return Ray(kind, ray.level + 1, record["id"], self.start(kind, ray, hit), unit(towards),
                   weight, hit.shape, ray.media if reflected else hit.media_beyond,
                   ray.path + hit.t)
