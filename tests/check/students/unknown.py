"""What students get wrong and the catalogue does not know: to be called wrong, and never named with
"sure".

As in mistakes.py, `planted` gives (id, plant). The ids are of nobody's catalogue.
"""

import math

import mistakes as known
from arithmetic import add, along, dot, length, scale, subtract, times, unit
from shapes import Sphere

planted = []


def of(name, maker, *arguments):
    """Plants with a maker of mistakes.py, into this list."""
    before = len(known.planted)
    maker("unknown." + name, *arguments)
    planted.extend(known.planted[before:])
    del known.planted[before:]


def mistake(name):
    def keep(plant):
        planted.append(("unknown." + name, plant))
        return plant

    return keep


# The camera

of("fov_tenth_more", known.film_by, known.zoomed(lambda half: math.tan(1.1 * half)))
of("fov_sine", known.film_by, known.zoomed(math.sin))
of("column_off_by_one", known.film_by, lambda s, i, j: known.book_film(s, i + 1, j))
of("quarter_pixel", known.film_by, lambda s, i, j: known.book_film(s, i + 0.25, j + 0.25))


# Intersection, points and normals

of("sphere_diameter", known.with_spheres, lambda a, b, c, sphere, *_: known.quadratic(
    a, b, b * b - 4 * a * (c - 3 * sphere.radius**2)))
of("sphere_nearest_point", known.with_spheres, lambda a, b, c, *_: (
    (-b / (2 * a),) if b * b - 4 * a * c >= 0 else ()))
of("root_tenth", known.with_spheres, lambda a, b, c, *_: [
    1.1 * t for t in known.quadratic(a, b, b * b - 4 * a * c)])
of("point_half_way", known.point_by, lambda s, ray, t: along(ray.origin, ray.direction, t / 2))
of("point_beyond", known.point_by, lambda s, ray, t: along(ray.origin, ray.direction, t + 0.01))
of("normal_from_eye", known.normal_by,
   lambda s, thing, shape, p: unit(subtract(s.world_point, s.camera.eye)))
of("normal_is_up", known.normal_by, lambda s, thing, shape, p: (0.0, 1.0, 0.0))
of("normal_tilted", known.normal_by, lambda s, thing, shape, p: unit(
    add(thing.normal_to_world(shape.normals(p)[1]), (0.1, 0.0, 0.0))))
of("normal_z_flipped", known.normal_by, lambda s, thing, shape, p: times(
    (1.0, 1.0, -1.0), thing.normal_to_world(shape.normals(p)[1])), True)


# Shadows

of("blocked_beyond_half", known.shadow_by,
   lambda s, hit, l, d: known.blockers(s, hit, l, d and d / 2))
of("blocked_by_last", known.shadow_by, lambda s, hit, l, d: [
    c for c in known.blockers(s, hit, l, d and d * known.near) if c[1] is s.scene.things[-1]])
of("spheres_cast_none", known.shadow_by, lambda s, hit, l, d: [
    c for c in known.blockers(s, hit, l, d and d * known.near) if not isinstance(c[2], Sphere)])


mistake("third_dark")(lambda s: known.partly_dark(s, 0.3))


# Local illumination

of("ambient_twice", known.ambient_by, lambda s, hit: scale(
    2, times(times(hit.material.ka, hit.material.color), s.scene.ambient)))
of("ambient_by_background", known.ambient_by, lambda s, hit: times(
    times(hit.material.ka, hit.material.color), s.scene.background))
of("ambient_by_ks", known.ambient_by, lambda s, hit: times(
    times(hit.material.ks, hit.material.color), s.scene.ambient))
of("diffuse_over_pi", known.diffuse_by, lambda s, hit, light, l, d, a: scale(
    dot(hit.normal, l) / math.pi, times(s.surface_colour(hit), a)))
of("diffuse_cosine_squared", known.diffuse_by, lambda s, hit, light, l, d, a: scale(
    dot(hit.normal, l) ** 2, times(s.surface_colour(hit), a)))
of("diffuse_half_lambert", known.diffuse_by, lambda s, hit, light, l, d, a: scale(
    0.5 * dot(hit.normal, l) + 0.5, times(s.surface_colour(hit), a)))
of("diffuse_angle", known.diffuse_by, lambda s, hit, light, l, d, a: scale(
    1 - math.acos(min(1, dot(hit.normal, l))) / (math.pi / 2), times(s.surface_colour(hit), a)))
of("diffuse_colour_squared", known.diffuse_by, lambda s, hit, light, l, d, a: scale(
    dot(hit.normal, l), times(hit.material.color, times(s.surface_colour(hit), a))))
of("diffuse_grey", known.diffuse_by, lambda s, hit, light, l, d, a: (
    sum(scale(dot(hit.normal, l), times(s.surface_colour(hit), a))) / 3,) * 3)
of("light_squared", known.arriving_then, lambda s, light: max(light.intensity))
of("light_halved", known.arriving_then, lambda s, light: 0.5)
of("fades_linearly", known.fading_by, lambda s, abc, d: min(1, 1 / d))
of("fades_by_root", known.fading_by, lambda s, abc, d: known.fall(*abc, d) ** 0.5)
of("fades_from_2", known.fading_by, lambda s, abc, d: known.fall(*abc, d + 2))
of("exponent_half", known.exponent_by, lambda n: n / 2)
of("exponent_more", known.exponent_by, lambda n: n + 1)
of("exponent_squared", known.exponent_by, lambda n: n * n)
of("highlight_twice", known.specular_then, lambda s, hit, l, c: scale(2, c))
of("highlight_normalised", known.specular_then, lambda s, hit, l, c: scale(
    (hit.material.shininess + 2) / (2 * math.pi), c))
of("highlight_by_kd", known.specular_then, lambda s, hit, l, c: times(hit.material.kd, c))
of("highlight_half_of_r", known.cosine_by, lambda s, ray, hit, l, v: known.positive(
    dot(unit(add(s.mirrored(hit, l), v)), v)))
of("highlight_schlick", known.cosine_by, lambda s, ray, hit, l, v: (
    lambda c, n: (c / (n - n * c + c)) ** (1 / n) if c > 0 and n > 0 else 0.0)(
        known.positive(dot(s.mirrored(hit, l), v)), hit.material.shininess))
of("viewer_along_z", known.viewer_by, lambda s, ray, hit: scale(-1, s.camera.z_axis))


# Reflection and refraction

of("reflected_n_plus_d", known.reflected_by, lambda d, n, c: add(d, n))
of("reflected_three", known.reflected_by, lambda d, n, c: along(d, n, -3 * c))
of("reflected_z", known.reflected_by, lambda d, n, c: times(
    (1.0, 1.0, -1.0), along(d, n, -2 * c)))
of("reflected_half", known.share_by, "reflected", lambda s, factor, hit: scale(0.5, factor))
of("reflected_root", known.share_by, "reflected",
   lambda s, factor, hit: tuple(x**0.5 for x in factor))
of("reflected_cosine", known.share_by, "reflected", lambda s, factor, hit: scale(hit.c1, factor))
of("reflected_fresnel", known.share_by, "reflected", lambda s, factor, hit: tuple(
    k + (1 - k) * (1 - min(1, abs(hit.c1))) ** 5 for k in factor))
of("refracted_half", known.share_by, "refracted", lambda s, factor, hit: scale(0.5, factor))
of("refracted_fresnel", known.share_by, "refracted", lambda s, factor, hit: tuple(
    k * (1 - (1 - min(1, abs(hit.c1))) ** 5) for k in factor))


def bent(name, rule):
    """`rule(ray, hit, eta)` gives the refracted direction."""

    @mistake(name)
    def _(s):
        s.refracted = lambda ray, hit: rule(ray, hit, hit.eta[0] / hit.eta[1])


def snell(d, n, c, eta):
    return along(scale(eta, d), n, eta * c - max(0, 1 - eta * eta * (1 - c * c)) ** 0.5)


bent("bent_by_square", lambda ray, hit, eta: snell(ray.direction, hit.normal, hit.c1, eta**2))
bent("bent_by_root", lambda ray, hit, eta: snell(ray.direction, hit.normal, hit.c1, eta**0.5))
bent("bent_as_water", lambda ray, hit, eta: snell(
    ray.direction, hit.normal, hit.c1, 1 / 1.33 if hit.side == "front" else 1.33))
bent("bent_half", lambda ray, hit, eta: add(
    ray.direction, snell(ray.direction, hit.normal, hit.c1, eta)))


# The sum, and the tree

def sums(name, rule):
    of(name, known.combine_by, rule)


sums("sum_halved", lambda s, hit, local, b: scale(
    0.5, known.summed(*local, *known.added(b))))
sums("largest_wins", lambda s, hit, local, b: max(
    known.summed(*local), *known.added(b), key=max) if b else known.summed(*local))
sums("local_less_kt", lambda s, hit, local, b: known.summed(
    times(known.rest(hit.material.kt), known.summed(*local)), *known.added(b)))
sums("diffuse_twice", lambda s, hit, local, b: known.summed(*local, local[1], *known.added(b)))
sums("ambient_last", lambda s, hit, local, b: known.summed(
    local[1], local[2], *known.added(b)) if b else known.summed(*local))
sums("eight_bits", lambda s, hit, local, b: tuple(
    round(255 * x) / 255 for x in known.summed(*local, *known.added(b))))


of("miss_halved", known.miss_by, lambda s, primary, c: c if primary else scale(0.5, c))
of("miss_white", known.miss_by, lambda s, primary, c: c if primary else s.white)
of("miss_ambient_twice", known.miss_by,
   lambda s, primary, c: c if primary else add(c, s.scene.ambient))


@mistake("stops_at_a_tenth")
def _(s):
    book = s.branch_reason
    s.branch_reason = lambda kind, factor, total, level, weight: (
        book(kind, factor, total, level, weight) or (max(weight) < 0.1 and "low_intensity") or None)


@mistake("reflects_once")
def _(s):
    book = s.branch_reason
    s.branch_reason = lambda kind, factor, total, level, weight: (
        book(kind, factor, total, level, weight)
        or (kind == "reflected" and level > 1 and "max_depth") or None)
