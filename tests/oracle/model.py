"""The ray tree of one pixel, straight from model.md, recorded as a raytree/1.0 document.

Nothing here is fast, shared with the program under test or more general than the page it follows:
where the two disagree, read the page.
"""

from arithmetic import EXACT, add, along, dot, length, power, scale, sqrt, subtract, times, unit
from document import tree_document
from hits import Finder, Ray
from reader import build_scene

# Section 4: of the reasons of two branches, the later in this list explains the end of a ray.
REASONS = [
    "not_reflective",
    "not_transmissive",
    "total_internal_reflection",
    "max_depth",
    "low_intensity",
    "ray_budget",
]


def trace(source, pixel, arithmetic=EXACT):
    """The tree of one pixel, as a document whose numbers are of the given arithmetic."""
    tracer = Tracer(build_scene(source, arithmetic))
    root = tracer.follow(tracer.finder.primary_ray(*pixel))
    return tree_document(tracer, pixel, root)


class Tracer:
    def __init__(self, scene):
        self.scene, self.settings, self.finder = scene, scene.settings, Finder(scene)
        self.zero, self.one = (scene.arithmetic.number(x) for x in (0, 1))
        self.black, self.white = (self.zero,) * 3, (self.one,) * 3
        self.rays = []

    # Section 3: illumination of a hit

    def light_up(self, record, ray, hit):
        """The diffuse and specular sums over the lights; records the shadow rays."""
        diffuse = specular = self.black
        for light in self.scene.lights:
            towards, distance = self.to_light(light, hit.point)
            reason = self.unlit_reason(hit, towards)
            if reason:
                entry = {"kind": "shadow", "light": light.name, "reason": reason}
                record["skipped"].append(entry)
                continue
            shares = self.shares(ray, hit, light, towards, distance)
            if self.settings["shadows"] != "none":
                shares = self.shadow_ray(record, hit, light, towards, distance, shares)
            diffuse, specular = add(diffuse, shares[0]), add(specular, shares[1])
        return diffuse, specular

    def to_light(self, light, point):
        if light.position is None:
            return light.towards, None
        way = subtract(light.position, point)
        return unit(way), length(way)

    def unlit_reason(self, hit, towards):
        if dot(hit.normal, towards) <= 0:
            return "light_behind_surface"
        if max(hit.material.kd + hit.material.ks) == 0:
            return "surface_unlit"
        return None

    def shares(self, ray, hit, light, towards, distance):
        """What the light adds to diffuse and specular if nothing is in between."""
        material, cosine = hit.material, dot(hit.normal, towards)
        arriving = light.intensity
        if distance is not None:
            arriving = scale(self.attenuated(light.attenuation, distance), arriving)
        if self.settings["specular_model"] == "phong":
            mirrored = subtract(scale(2 * cosine, hit.normal), towards)
            highlight = -dot(mirrored, ray.direction)
        else:
            highlight = dot(hit.normal, unit(subtract(towards, ray.direction)))
        highlight = power(max(self.zero, highlight), material.shininess)
        diffuse = scale(cosine, times(times(material.kd, material.color), arriving))
        specular = scale(highlight, times(times(material.ks, material.specular_color), arriving))
        return diffuse, specular

    def attenuated(self, abc, t):
        return min(self.one, 1 / (abc[0] + abc[1] * t + abc[2] * t * t))

    def shadow_ray(self, hit_record, hit, light, towards, distance, shares):
        blocker, transmittance = self.shadow(hit, towards, distance)
        diffuse, specular = (times(transmittance, share) for share in shares)
        self.rays.append(
            {
                "id": len(self.rays),
                "parent": hit_record["id"],
                "kind": "shadow",
                "light": light.name,
                "level": hit_record["level"],
                "origin": hit.point,
                "direction": towards,
                "distance": distance,
                "blocked_by": blocker and {"object": self.scene.names[blocker[2]], "t": blocker[0]},
                "transmittance": transmittance,
                "diffuse": diffuse,
                "specular": specular,
            }
        )
        return diffuse, specular

    def shadow(self, hit, towards, distance):
        """(what stops the light, or None; what of the light arrives)."""
        met = self.finder.crossings(hit.point, towards, hit.shape)
        nothing = self.scene.arithmetic.nothing
        between = [c for c in met if distance is None or c[0] < distance - nothing]
        transmittance = self.white
        for crossing in sorted(between, key=lambda c: c[0]):
            if self.settings["shadows"] == "opaque":
                return crossing, self.black
            transmittance = times(transmittance, crossing[1].material.kt)
            if max(transmittance) == 0:
                return crossing, self.black
        return None, transmittance

    # Section 4: the tree

    def follow(self, ray):
        """Traces a ray and all below it; gives its record, with intensity and attenuation."""
        record = {
            "id": len(self.rays),
            "parent": ray.parent,
            "kind": ray.kind,
            "level": ray.level,
            "origin": ray.origin,
            "direction": ray.direction,
            "weight": ray.weight,
        }
        self.rays.append(record)
        hit = self.finder.closest(ray)
        if hit is None:
            self.end_in_background(record)
        else:
            self.shade(record, ray, hit)
        return record

    def end_in_background(self, record):
        background, secondary = self.scene.background, self.settings["secondary_background"]
        if record["kind"] != "primary" and secondary is not None:
            background = secondary
        unlimited = self.settings["max_distance"] is None
        record.update(
            attenuation=self.one,
            hit=None,
            intensity=background,
            termination="no_intersection" if unlimited else "max_distance",
            skipped=[],
        )

    def shade(self, record, ray, hit):
        is_primary = ray.kind == "primary"
        f = self.one if is_primary else self.attenuated(self.settings["attenuation"], hit.t)
        record.update(attenuation=f, hit=self.hit_record(hit), skipped=[])
        ambient = times(times(hit.material.ka, hit.material.color), self.scene.ambient)
        diffuse, specular = self.light_up(record, ray, hit)
        record.update(ambient=ambient, diffuse=diffuse, specular=specular)
        intensity = add(add(ambient, diffuse), specular)
        reasons = []
        for kind, factor, is_total in self.branches(hit):
            weight = scale(f, times(ray.weight, factor))
            reason = self.branch_reason(kind, factor, is_total, ray.level, weight)
            if reason:
                reasons.append(reason)
                record["skipped"].append({"kind": kind, "reason": reason})
                continue
            child = self.follow(self.branch(kind, record, ray, hit, weight))
            arriving = scale(child["attenuation"], child["intensity"])
            intensity = add(intensity, times(factor, arriving))
        record.update(intensity=intensity, termination=termination(reasons))

    def branches(self, hit):
        """(kind, kr or kt, whether total internal reflection forbids it) of the two branches."""
        kr, kt = hit.material.kr, hit.material.kt
        is_total = max(kt) > 0 and hit.s2 > 1
        if is_total and self.settings["total_internal_reflection"] == "reflect":
            kr = add(kr, kt)
        return [("reflected", kr, False), ("refracted", kt, is_total)]

    def branch_reason(self, kind, factor, is_total, level, weight):
        if max(factor) == 0:
            return "not_reflective" if kind == "reflected" else "not_transmissive"
        if is_total:
            return "total_internal_reflection"
        if level >= self.settings["max_depth"]:
            return "max_depth"
        if max(weight) < self.settings["min_weight"]:
            return "low_intensity"
        if len(self.rays) >= self.settings["ray_budget"]:
            return "ray_budget"
        return None

    def branch(self, kind, record, ray, hit, weight):
        if kind == "reflected":
            direction, media = along(ray.direction, hit.normal, 2 * hit.c1), ray.media
        else:
            eta = hit.eta[0] / hit.eta[1]
            bend = eta * hit.c1 - sqrt(1 - hit.s2)
            direction, media = along(scale(eta, ray.direction), hit.normal, bend), hit.media_beyond
        return Ray(
            kind,
            ray.level + 1,
            record["id"],
            hit.point,
            unit(direction),
            weight,
            hit.shape,
            media,
            ray.path + hit.t,
        )

    def hit_record(self, hit):
        record = {
            "object": self.scene.names[hit.shape],
            "material": hit.material.name,
            "t": hit.t,
            "point": hit.point,
            "normal": hit.normal,
            "side": hit.side,
            "cos_incident": hit.c1,
        }
        if max(hit.material.kt) > 0:
            record.update(eta=hit.eta, sin2_transmitted=hit.s2)
        return record


def termination(reasons):
    """What explains a hit under which both branches are missing, or None."""
    if len(reasons) < 2:
        return None
    last = max(reasons, key=REASONS.index)
    return "opaque" if REASONS.index(last) < 2 else last
