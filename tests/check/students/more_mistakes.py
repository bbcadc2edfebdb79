"""More of what students get wrong: mistakes of the catalogue that mistakes.py does not have, written
from their sentences. They are appended to its `planted`.
"""

import math

from arithmetic import add, along, cross, dot, length, scale, subtract, times, unit
from mistakes import (added, ambient_by, arriving_then, at, bent, blockers, book_film, combine_by,
                      cosine_by, crossings_by, diffuse_by, exponent_by, fading_by, fall, film_by,
                      indices_by, inside, miss_by, mistake, near, point_by, positive, quadratic,
                      reflected_by, refracted_by, root, shadow_by, share_by, specular_then, summed,
                      to_light_by, with_spheres, without_branch, zoomed)
from shapes import Polygon, Sphere

# The camera

film_by("cam.fov_halved_twice", zoomed(lambda half: math.tan(half / 2)))
film_by("cam.fov_angle_for_tangent", zoomed(lambda half: half))
film_by("cam.aspect_missing", lambda s, i, j: (
    book_film(s, i, j)[0],
    book_film(s, i, j)[1] * s.camera.width / s.camera.height
    / max(1, s.camera.width // s.camera.height)))
film_by("cam.turned_round", lambda s, i, j: [-x for x in book_film(s, i, j)])
film_by("cam.row_flipped_h_minus_j", lambda s, i, j: at(
    s, (i + inside(s)) / s.camera.width,
    1 - (s.camera.height - j + inside(s)) / s.camera.height))


@mistake("cam.looks_back")
def _(s):
    """z = eye - look_at, and x = z x up follows from it."""
    x, y, z = s.camera.x_axis, s.camera.y_axis, s.camera.z_axis
    s.axes = lambda: (scale(-1, x), y, scale(-1, z))


@mistake("cam.looks_back")
def _(s):
    x, y, z = s.camera.x_axis, s.camera.y_axis, s.camera.z_axis
    s.axes = lambda: (x, y, scale(-1, z))


def looks(s):
    camera = s.scene.source.document["camera"]
    return ([float(x) for x in camera["look_at"]], s.camera.eye,
            [float(x) for x in camera.get("up", [0, 1, 0])])


@mistake("cam.right_not_normalised")
def _(s):
    _, _, up = looks(s)
    right = cross(s.camera.z_axis, up)
    s.axes = lambda: (right, cross(right, s.camera.z_axis), s.camera.z_axis)


@mistake("cam.forward_not_normalised")
def _(s):
    target, eye, _ = looks(s)
    s.axes = lambda: (s.camera.x_axis, s.camera.y_axis, subtract(target, eye))


@mistake("cam.target_as_dir")
def _(s):
    """direction = P instead of P - eye."""
    book = s.primary_direction
    s.primary_direction = lambda i, j: add(s.camera.eye, book(i, j))


@mistake("cam.eye_ignored")
def _(s):
    s.eye = lambda i, j: (0.0, 0.0, 0.0)


# Intersection and hits

with_spheres("isect.not_halved", lambda a, b, c, *_: (
    (-b - math.sqrt(b * b - 4 * a * c)) / a, (-b + math.sqrt(b * b - 4 * a * c)) / a))
with_spheres("isect.b_sign", lambda a, b, c, *_: (
    (b - math.sqrt(b * b - 4 * a * c)) / (2 * a), (b + math.sqrt(b * b - 4 * a * c)) / (2 * a)))
with_spheres("isect.radius_not_squared", lambda a, b, c, sphere, *_: quadratic(
    a, b, b * b - 4 * a * (c + sphere.radius**2 - sphere.radius)))
with_spheres("isect.centre_ignored", lambda a, b, c, sphere, o, d: quadratic(
    a, 2 * dot(o, d), 4 * dot(o, d) ** 2 - 4 * a * (dot(o, o) - sphere.radius**2)))


def from_the_front(s, found, origin, direction, only):
    for t, thing, shape in found:
        o, d = thing.to_own_space(origin, direction)
        if isinstance(shape, only) and dot(shape.normals(along(o, d, t))[0], d) > 0:
            continue
        yield t, thing, shape


crossings_by("isect.backface_culled",
             lambda s, found, o, d, leaving: from_the_front(s, found, o, d, object))
crossings_by("isect.polygon_one_sided",
             lambda s, found, o, d, leaving: from_the_front(s, found, o, d, Polygon))
point_by("hit.point_minus", lambda s, ray, t: along(ray.origin, ray.direction, -t))
point_by("hit.point_from_eye", lambda s, ray, t: along(s.camera.eye, ray.direction, t))


@mistake("nrm.side_swapped")
def _(s):
    book = s.describe

    def describe(ray, t, thing, shape):
        hit = book(ray, t, thing, shape)
        return hit._replace(side="back" if hit.side == "front" else "front")

    s.finder.describe = describe


# Shadows


def between(s, hit, l, d):
    return blockers(s, hit, l, d and d * near)


def clear(crossing):
    return max(crossing[1].material.kt) > 0


shadow_by("shd.glass_casts_none",
          lambda s, hit, l, d: [c for c in between(s, hit, l, d) if not clear(c)])
shadow_by("shd.directional_none", lambda s, hit, l, d: [] if d is None else between(s, hit, l, d))


@mistake("shd.glass_is_opaque")
def _(s):
    def shadow(hit, l, d):
        found = between(s, hit, l, d)
        return (found[0], s.black) if found else (None, s.white)

    s.shadow = shadow


@mistake("shd.tint_once")
def _(s):
    def shadow(hit, l, d):
        found = between(s, hit, l, d)
        for c in found:
            if s.settings["shadows"] == "opaque" or not clear(c):
                return c, s.black
        return None, found[0][1].material.kt if found else s.white

    s.shadow = shadow


@mistake("shd.only_first_light")
def _(s):
    book, shadow_ray = s.shadow, s.shadow_ray

    def first_only(record, hit, light, towards, distance, shares):
        s.shadow = book if light is s.scene.lights[0] else lambda *_: (None, s.white)
        return shadow_ray(record, hit, light, towards, distance, shares)

    s.shadow_ray = first_only


@mistake("shd.diffuse_not_shadowed")
def _(s):
    book = s.shadow_ray

    def shadow_ray(record, hit, light, towards, distance, shares):
        kept = book(record, hit, light, towards, distance, shares)
        if not s.no_shadow_rays:
            s.rays[-1]["diffuse"] = shares[0]
        return shares[0], kept[1]

    s.shadow_ray = shadow_ray


# Local illumination

ambient_by("lit.ambient_no_ka", lambda s, hit: times(hit.material.color, s.scene.ambient))
ambient_by("lit.ambient_no_scene", lambda s, hit: times(hit.material.ka, hit.material.color))
ambient_by("lit.ambient_uses_kd", lambda s, hit: times(
    times(hit.material.kd, hit.material.color), s.scene.ambient))
to_light_by("lit.L_from_eye", lambda s, light, p, l, d: (l, d) if d is None else (
    unit(subtract(light.position, s.camera.eye)), length(subtract(light.position, s.camera.eye))))
to_light_by("lit.directional_sign",
            lambda s, light, p, l, d: (scale(-1, l), d) if d is None else (l, d))
diffuse_by("lit.diffuse_no_cosine",
           lambda s, hit, light, l, d, a: times(s.surface_colour(hit), a))
diffuse_by("lit.diffuse_missing", lambda s, hit, light, l, d, a: s.black)
arriving_then("lit.only_first_light", lambda s, light: float(light is s.scene.lights[0]))
fading_by("lit.att_no_square", lambda s, abc, d: min(1, 1 / (abc[0] + abc[1] * d + abc[2] * d)))
fading_by("lit.att_inverse_square", lambda s, abc, d: 1 / (d * d))
fading_by("lit.att_unclamped",
          lambda s, abc, d: 1 / (abc[0] + abc[1] * d + abc[2] * d * d))
exponent_by("lit.exponent_quarter", lambda n: n / 4)
cosine_by("lit.half_not_normalised", lambda s, ray, hit, l, v: positive(
    dot(hit.normal, scale(0.5, add(l, v))) if not s.is_phong() else dot(s.mirrored(hit, l), v)))
cosine_by("lit.spec_uses_LdotN", lambda s, ray, hit, l, v: positive(dot(l, hit.normal)))


@mistake("lit.ks_missing")
def _(s):
    s.gloss = lambda hit: hit.material.specular_color


@mistake("lit.exponent_multiplied")
def _(s):
    s.specular = lambda ray, hit, light, l, d, a: scale(
        s.highlight_cosine(ray, hit, l) * hit.material.shininess, times(s.gloss(hit), a))


@mistake("lit.spec_no_light_color")
def _(s):
    s.specular = lambda ray, hit, light, l, d, a: scale(
        s.highlight_cosine(ray, hit, l) ** hit.material.shininess
        * (1 if d is None else s.fading(light.attenuation, d)), s.gloss(hit))


combine_by("lit.local_tinted_twice", lambda s, hit, local, b: summed(
    times(hit.material.color, summed(*local)), *added(b)))


# Reflection and refraction

reflected_by("refl.along_normal", lambda d, n, c: n)
reflected_by("refl.backwards", lambda d, n, c: scale(-1, d))
reflected_by("refl.straight", lambda d, n, c: d)


@mistake("refl.uses_point")
def _(s):
    def reflected(ray, hit):
        n = unit(hit.point)
        return along(ray.direction, n, -2 * dot(ray.direction, n))

    s.reflected = reflected


share_by("refl.ks_for_kr", "reflected", lambda s, k, hit: hit.material.ks)
share_by("refl.kt_for_kr", "reflected", lambda s, k, hit: hit.material.kt)
share_by("refl.not_added", "reflected", lambda s, k, hit: s.black)
share_by("refr.kr_for_kt", "refracted", lambda s, k, hit: hit.material.kr)
share_by("refr.times_base", "refracted", lambda s, k, hit: times(k, hit.material.color))
share_by("refr.not_added", "refracted", lambda s, k, hit: s.black)
share_by("refr.one_minus", "refracted", lambda s, k, hit: tuple(1 - x for x in k))
without_branch("refr.missing_child", "refracted", lambda hit: True)
without_branch("refr.only_outside", "refracted", lambda hit: hit.side == "back")
indices_by("refr.eta_inverted_on_entry", lambda a, b, front, n: (b, a) if front else (a, b))
indices_by("refr.eta_squared", lambda a, b, front, n: (a * a, b * b))
refracted_by("refr.eta_missing_in_b", lambda d, n, e, c, k: bent(d, n, e, c - root(k)))
refracted_by("refr.eta_missing_in_a", lambda d, n, e, c, k: bent(d, n, 1, e * c - root(k)))
refracted_by("refr.eta_not_squared", lambda d, n, e, c, k: bent(
    d, n, e, e * c - root(1 - e * (1 - c * c))))
refracted_by("refr.c1_not_squared", lambda d, n, e, c, k: bent(
    d, n, e, e * c - root(1 - e * e * (1 - c))))
refracted_by("refr.reflected", lambda d, n, e, c, k: along(d, n, 2 * c))
refracted_by("refr.along_normal", lambda d, n, e, c, k: scale(-1, n))
refracted_by("refr.tir_as_refracted", lambda d, n, e, c, k: (
    along(d, n, 2 * c) if k < 0 else bent(d, n, e, e * c - root(k))), True)


@mistake("refr.tir_full")
def _(s):
    def branches(hit):
        total = max(hit.material.kt) > 0 and hit.s2 > 1
        return [("reflected", s.white if total else hit.material.kr, False),
                ("refracted", hit.material.kt, total)]

    s.branches = branches


# Recursion and background


@mistake("rec.min_weight_ignored")
def _(s):
    book = s.branch_reason
    s.branch_reason = lambda kind, factor, total, level, weight: book(
        kind, factor, total, level, s.white)


@mistake("rec.max_distance_ignored")
def _(s):
    s.settings["max_distance"] = None


@mistake("rec.distance_per_ray")
def _(s):
    book = s.branch
    s.branch = lambda *a: book(*a)._replace(path=0.0)


@mistake("rec.fade_missing")
def _(s):
    s.fade = lambda ray, hit: 1.0


@mistake("rec.fade_on_primary")
def _(s):
    s.fade = lambda ray, hit: s.attenuated(s.settings["attenuation"], hit.t)


@mistake("rec.fade_by_path")
def _(s):
    s.fade = lambda ray, hit: 1.0 if ray.kind == "primary" else s.attenuated(
        s.settings["attenuation"], ray.path + hit.t)


combine_by("rec.lerp", lambda s, hit, local, b: summed(times(
    tuple(1 - r - t for r, t in zip(hit.material.kr, hit.material.kt)), summed(*local)),
    *added(b)))
combine_by("rec.last_branch_only", lambda s, hit, local, b: summed(*local, *added(b)[-1:]))
combine_by("rec.averaged", lambda s, hit, local, b: scale(
    1 / (1 + len(b)), summed(*local, *added(b))))
combine_by("bg.added_to_hits",
           lambda s, hit, local, b: summed(*local, *added(b), s.scene.background))
miss_by("bg.black", lambda s, primary, c: s.black)
miss_by("bg.ambient_for_miss", lambda s, primary, c: s.scene.ambient)
