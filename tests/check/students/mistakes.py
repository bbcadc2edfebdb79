"""What students get wrong, as they write it. Names are those of the literature on mistakes.

`planted` gives (id, plant): `plant(student)` changes the student's tracer. An id may be planted in
several ways.
"""

import math

from arithmetic import add, along, cross, dot, length, scale, subtract, times, unit
from hits import Ray
from shapes import Cone, Polygon, Sphere

planted = []


def mistake(name):
    def keep(plant):
        planted.append((name, plant))
        return plant

    return keep


# The camera


def film_by(name, rule):
    def plant(s):
        s.film = lambda i, j: rule(s, i, j)

    planted.append((name, plant))


def book_film(s, i, j):
    return type(s).film(s, i, j)


def window(s):
    return s.camera.window, s.camera.width, s.camera.height


def at(s, u, v):
    (left, right, bottom, top), _, _ = window(s)
    return left + u * (right - left), top - v * (top - bottom)


def inside(s):
    return 0 if s.settings["pixel_sample"] == "corner" else 0.5


def half_angle(s):
    degrees = s.scene.source.document["camera"].get("horizontal_fov_degrees")
    return degrees and math.radians(degrees / 2)


def zoomed(rule):
    def film(s, i, j):
        half = half_angle(s)
        k = rule(half) / math.tan(half) if half else 1
        x, y = book_film(s, i, j)
        return k * x, k * y

    return film


film_by("cam.no_half", lambda s, i, j: at(s, i / s.camera.width, j / s.camera.height))
film_by("cam.wminus1", lambda s, i, j: at(s, i / (s.camera.width - 1), j / (s.camera.height - 1)))
film_by("cam.row_off_by_one", lambda s, i, j: book_film(s, i, j + 1))
film_by("cam.row_off_by_one", lambda s, i, j: book_film(s, i, j - 1))
film_by("cam.ij_swapped", lambda s, i, j: book_film(s, j, i))
film_by("cam.fov_not_halved", zoomed(lambda half: math.tan(2 * half)))
film_by("cam.fov_degrees", zoomed(lambda half: math.tan(half * 180 / math.pi)))
film_by("cam.fov_horizontal",
        lambda s, i, j: [x * s.camera.width / s.camera.height for x in book_film(s, i, j)])
film_by("cam.fov_horizontal",
        lambda s, i, j: [x * s.camera.height / s.camera.width for x in book_film(s, i, j)])
film_by("cam.aspect_inverted", lambda s, i, j: (
    book_film(s, i, j)[0], book_film(s, i, j)[1] * (s.camera.width / s.camera.height) ** 2))
film_by("cam.aspect_missing", lambda s, i, j: (
    book_film(s, i, j)[0], book_film(s, i, j)[1] * s.camera.width / s.camera.height))
film_by("cam.y_flipped", lambda s, i, j: book_film(s, i, s.camera.height - 1 - j))
film_by("cam.mirrored", lambda s, i, j: (-book_film(s, i, j)[0], book_film(s, i, j)[1]))
film_by("num.int_division", lambda s, i, j: at(s, i // s.camera.width, j // s.camera.height))


@mistake("cam.window_symmetric")
def _(s):
    (left, right, bottom, top), w, h = window(s)
    s.film = lambda i, j: (
        (2 * (i + inside(s)) / w - 1) * right,
        (1 - 2 * (j + inside(s)) / h) * top,
    )


@mistake("cam.lookat_as_dir")
def _(s):
    look = s.scene.source.document["camera"]["look_at"]
    up = s.scene.source.document["camera"].get("up", [0, 1, 0])
    if length(look) > 0:
        forward = unit([float(x) for x in look])
        right = unit(cross(forward, up))
        s.axes = lambda: (right, cross(right, forward), forward)


@mistake("cam.up_not_orthogonalised")
def _(s):
    up = unit([float(x) for x in s.scene.source.document["camera"].get("up", [0, 1, 0])])
    s.axes = lambda: (s.camera.x_axis, up, s.camera.z_axis)


@mistake("cam.origin_is_pixel")
def _(s):
    s.eye = lambda i, j: add(s.camera.eye, s.primary_direction(i, j))


# Intersection


def with_spheres(name, formula):
    """`formula(a, b, c, sphere, origin, direction)` gives the roots."""

    def plant(s):
        for sphere in s.shapes:
            if isinstance(sphere, Sphere):
                sphere.meets = solver(sphere, formula)

    planted.append((name, plant))


def solver(sphere, formula):
    def meets(origin, direction, leaving):
        m = subtract(origin, sphere.centre)
        a, b = dot(direction, direction), 2 * dot(m, direction)
        c = dot(m, m) - sphere.radius**2
        try:
            found = formula(a, b, c, sphere, origin, direction)
        except (ValueError, ZeroDivisionError):
            return ()
        return sorted(t for t in found if t > (1e-6 if leaving else 0))

    return meets


def quadratic(a, b, disc):
    root = math.sqrt(disc)
    return (-b - root) / (2 * a), (-b + root) / (2 * a)


with_spheres("isect.missing_paren", lambda a, b, c, *_: (
    (-b - math.sqrt(b * b - 4 * a * c)) / 2 * a, (-b + math.sqrt(b * b - 4 * a * c)) / 2 * a))
with_spheres("isect.b_not_doubled", lambda a, b, c, *_: quadratic(a, b / 2, b * b / 4 - 4 * a * c))
with_spheres("isect.disc_no4", lambda a, b, c, *_: quadratic(a, b, b * b - a * c))
with_spheres("isect.no_sqrt", lambda a, b, c, *_: (
    ((-b - (b * b - 4 * a * c)) / (2 * a), (-b + (b * b - 4 * a * c)) / (2 * a))
    if b * b - 4 * a * c >= 0 else ()))
with_spheres("isect.far_root", lambda a, b, c, *_: quadratic(a, b, b * b - 4 * a * c)[1:])
with_spheres("isect.near_only", lambda a, b, c, *_: quadratic(a, b, b * b - 4 * a * c)[:1])
with_spheres("isect.w_in_dot", lambda a, b, c, *_: quadratic(a, b, b * b - 4 * a * (c + 1)))


def crossings_by(name, rule):
    """`rule(s, crossings)` changes what a ray meets."""

    def plant(s):
        book = s.finder.crossings
        s.finder.crossings = lambda origin, direction, leaving: rule(
            s, book(origin, direction, leaving), origin, direction, leaving)

    planted.append((name, plant))


def units(s, found, origin, direction, leaving):
    for t, thing, shape in found:
        yield t * length(thing.to_own_space(origin, direction)[1]), thing, shape


crossings_by("isect.local_dir_normalised", units)


@mistake("isect.translation_on_dir")
def _(s):
    for thing in s.scene.things:
        if thing.inverse is not None:
            rows = thing.inverse

            def moved(origin, direction, rows=rows):
                return (tuple(dot(r, origin) + r[3] for r in rows),
                        tuple(dot(r, direction) + r[3] for r in rows))

            index = s.scene.things.index(thing)
            s.scene.things[index] = Moved(thing, moved)


class Moved:
    def __init__(self, thing, to_own_space):
        self.kind, self.material, self.shapes = thing.kind, thing.material, thing.shapes
        self.normal_to_world, self.to_own_space = thing.normal_to_world, to_own_space


def closest_by(name, prefer):
    def plant(s):
        def closest(ray):
            found = [c for c in s.finder.crossings(ray.origin, ray.direction, ray.leaving)]
            if ray.kind == "primary":
                near = s.camera.near / dot(ray.direction, s.camera.z_axis)
                found = [c for c in found if c[0] >= near]
            limit = s.settings["max_distance"]
            if limit is not None:
                found = [c for c in found if ray.path + c[0] < limit]
            # Of each object its nearest.
            nearest = {}
            for c in found:
                if c[2] not in nearest or c[0] < nearest[c[2]][0]:
                    nearest[c[2]] = c
            chosen = prefer(list(nearest.values()))
            return s.finder.describe(ray, *chosen) if chosen else None

        s.finder.closest = closest

    planted.append((name, plant))


closest_by("isect.last_wins", lambda found: found[-1] if found else None)
closest_by("isect.first_wins", lambda found: found[0] if found else None)
closest_by("isect.farthest",
           lambda found: max(found, key=lambda c: c[0]) if found else None)


@mistake("isect.negative_t")
def _(s):
    """The quadratic's smaller root, whatever its sign; planes too."""

    def closest(ray):
        nearest = None
        for thing in s.scene.things:
            o, d = thing.to_own_space(ray.origin, ray.direction)
            for shape in thing.shapes:
                leaving = shape is ray.leaving
                found = list(shape.meets(o, d, leaving)) + [
                    -t for t in shape.meets(o, scale(-1, d), leaving)]
                for t in sorted(found)[:1]:
                    if abs(t) > 1e-9 and (nearest is None or t < nearest[0]):
                        nearest = (t, thing, shape)
        return s.finder.describe(ray, *nearest) if nearest else None

    s.finder.closest = closest


@mistake("isect.plane_sign")
def _(s):
    for shape in s.shapes:
        if isinstance(shape, Polygon):
            book = shape.meets
            shape.meets = (lambda book: lambda o, d, leaving: book(o, scale(-1, d), leaving))(book)


def closest_then(name, change):
    """What is met is right; `change(s, ray, crossing)` gives another (t, thing, shape) or none."""

    def plant(s):
        book = s.finder.closest

        def describe(ray, t, thing, shape):
            return type(s).describe(s, ray, *change(s, ray, t, thing, shape))

        s.finder.describe = describe

    planted.append((name, plant))


def whole_number(s, ray, t, thing, shape):
    s.beside.add(along(ray.origin, ray.direction, float(int(t))))
    return float(int(t)), thing, shape


closest_then("isect.t_int", whole_number)
# In a program that knows which surface a ray leaves, and does not look for it again.
closest_then("isect.t_int", lambda s, ray, t, thing, shape: (float(int(t)), thing, shape))


def beyond(name, least, secondary_only=False, primary_only=False):
    """Only what is farther than `least(s)` is met."""

    def plant(s):
        book = s.finder.crossings

        def closest(ray):
            limit = s.settings["max_distance"]
            found = []
            is_primary = ray.kind == "primary"
            for c in book(ray.origin, ray.direction, ray.leaving):
                near = s.camera.near / dot(ray.direction, s.camera.z_axis) if is_primary else 0
                if not (secondary_only and is_primary) and not (primary_only and not is_primary):
                    near = least(s)
                if c[0] >= near and (limit is None or ray.path + c[0] < limit):
                    found.append(c)
            return s.finder.describe(ray, *min(found, key=lambda c: c[0])) if found else None

        s.finder.closest = closest

    planted.append((name, plant))


beyond("eps.too_large", lambda s: 0.25, secondary_only=True)
beyond("hit.near_rule_on_secondary", lambda s: s.camera.near, secondary_only=True)
beyond("hit.primary_without_near", lambda s: 0, primary_only=True)
beyond("isect.bool_precedence", lambda s: 0, primary_only=True)


def point_by(name, rule):
    def plant(s):
        s.point = lambda ray, t: rule(s, ray, t)

    planted.append((name, plant))


point_by("hit.point_no_origin", lambda s, ray, t: scale(t, ray.direction))
point_by("hit.t_units_mixed", lambda s, ray, t: along(
    ray.origin, ray.direction,
    t / length(s.primary_direction(*s.pixel)) if ray.kind == "primary" else t))


# Normals


def normal_by(name, rule, spheres_only=False):
    """`rule(s, thing, shape, own_point)` gives the outward normal, which is then turned."""

    def plant(s):
        def normal(ray, thing, shape, own_point, is_front):
            if spheres_only and not isinstance(shape, Sphere):
                return type(s).normal(s, ray, thing, shape, own_point, is_front)
            found = rule(s, thing, shape, own_point)
            return found if is_front else scale(-1, found)

        s.normal = normal

    planted.append((name, plant))


def matrix_of(s, thing):
    index = s.scene.things.index(thing)
    rows = s.scene.source.document["objects"][index].get("transform")
    return rows and [[float(x) for x in row] for row in rows]


def own_normal(shape, point):
    return unit(shape.normals(point)[1])


def forward(s, thing, shape, point, w=0):
    m = matrix_of(s, thing)
    n = own_normal(shape, point)
    return unit([sum(m[i][k] * n[k] for k in range(3)) + w * m[i][3] for i in range(3)]) if m else n


normal_by("nrm.forward_matrix", forward)
normal_by("nrm.homogeneous_point", lambda s, t, h, p: forward(s, t, h, p, 1))
normal_by("nrm.object_space", lambda s, thing, shape, point: own_normal(shape, point))
normal_by("nrm.inverse_not_transposed", lambda s, thing, shape, point: unit(
    [dot(row[:3], own_normal(shape, point)) for row in thing.inverse]
    if thing.inverse is not None else own_normal(shape, point)))
normal_by("nrm.from_origin", lambda s, thing, shape, point: unit(s.world_point), True)


@mistake("nrm.p_minus_c")
def _(s):
    def normal(ray, thing, shape, own_point, is_front):
        m = matrix_of(s, thing)
        if not isinstance(shape, Sphere) or not m:
            return type(s).normal(s, ray, thing, shape, own_point, is_front)
        centre = [sum(m[i][k] * shape.centre[k] for k in range(3)) + m[i][3] for i in range(3)]
        n = unit(subtract(s.world_point, centre))
        return n if is_front else scale(-1, n)

    s.normal = normal


@mistake("nrm.inverted")
def _(s):
    s.normal = lambda *a: scale(-1, type(s).normal(s, *a))


@mistake("nrm.not_normalised")
def _(s):
    def normal(ray, thing, shape, own_point, is_front):
        right = type(s).normal(s, ray, thing, shape, own_point, is_front)
        return scale(shape.radius, right) if isinstance(shape, Sphere) else right

    s.normal = normal


@mistake("nrm.not_flipped_inside")
def _(s):
    s.normal = lambda ray, thing, shape, point, front: type(s).normal(
        s, ray, thing, shape, point, True)


# Shadows


def blockers(s, hit, towards, most, leaving="hit", origin=None):
    start = hit.point if origin is None else origin
    found = s.finder.crossings(start, towards, hit.shape if leaving == "hit" else leaving)
    return sorted((c for c in found if most is None or c[0] < most), key=lambda c: c[0])


def shadow_by(name, rule):
    """`rule(s, hit, towards, distance)` gives the blockers."""

    def plant(s):
        def shadow(hit, towards, distance):
            found = rule(s, hit, towards, distance)
            light = s.white
            for crossing in found:
                if s.settings["shadows"] == "opaque":
                    return crossing, s.black
                light = times(light, crossing[1].material.kt)
                if max(light) == 0:
                    return crossing, s.black
            return None, light

        s.shadow = shadow

    planted.append((name, plant))


near = 1 - 1e-12
shadow_by("shd.missing", lambda s, *_: [])
shadow_by("shd.unlimited", lambda s, hit, l, d: blockers(s, hit, l, None))
shadow_by("shd.unnormalised_tmax",
          lambda s, hit, l, d: blockers(s, hit, l, None if d is None else d * d))
shadow_by("shd.tmax_one_unit", lambda s, hit, l, d: blockers(s, hit, l, 1))
shadow_by("shd.reversed", lambda s, hit, l, d: blockers(s, hit, scale(-1, l), d and d * near))
shadow_by("shd.from_eye", lambda s, hit, l, d: blockers(
    s, hit, l, d and d * near, None, s.camera.eye))
shadow_by("shd.only_first_object", lambda s, hit, l, d: [
    c for c in blockers(s, hit, l, d and d * near) if c[1] is s.scene.things[0]])
shadow_by("shd.skip_self", lambda s, hit, l, d: [
    c for c in blockers(s, hit, l, d and d * near) if c[1] is not s.things_of[hit.shape]])


@mistake("shd.missing")
def _(s):
    s.no_shadow_rays = True
    s.shadow = lambda *_: (None, s.white)


@mistake("shd.reversed")
def _(s):
    """The ray as it is exported goes the wrong way too."""
    book = s.shadow

    def shadow_ray(record, hit, light, towards, distance, shares):
        return type(s).shadow_ray(s, record, hit, light, scale(-1, towards), distance, shares)

    s.shadow_ray = shadow_ray


@mistake("shd.inverted")
def _(s):
    book = s.shadow

    def shadow(hit, towards, distance):
        blocker, light = book(hit, towards, distance)
        return (blocker, s.white) if max(light) == 0 else (None, s.black)

    s.shadow = shadow


@mistake("shd.no_offset")
def _(s):
    s.shadow = lambda hit, *_: ((0.0, s.things_of[hit.shape], hit.shape), s.black)


@mistake("shd.from_light")
def _(s):
    book = s.shadow

    def shadow(hit, towards, distance):
        if distance is None:
            return book(hit, towards, distance)
        start = along(hit.point, towards, distance)
        found = blockers(s, hit, scale(-1, towards), None, None, start)
        return (found[0] if found else (distance, s.things_of[hit.shape], hit.shape)), s.black

    s.shadow = shadow


def partly_dark(s, share):
    """A shadow lets so much of the light through."""
    book = s.shadow

    def shadow(*a):
        blocker, light = book(*a)
        return blocker, (share, share, share) if max(light) == 0 else light

    s.shadow = shadow


mistake("shd.half_dark")(lambda s: partly_dark(s, 0.5))


@mistake("shd.spec_not_shadowed")
def _(s):
    def shadow_ray(record, hit, light, towards, distance, shares):
        kept = type(s).shadow_ray(s, record, hit, light, towards, distance, shares)
        if not s.no_shadow_rays:
            s.rays[-1]["specular"] = shares[1]
        return kept[0], shares[1]

    s.shadow_ray = shadow_ray


@mistake("shd.kills_ambient")
def _(s):
    book = s.combine
    s.combine = lambda hit, ambient, diffuse, specular, grown: book(
        hit, s.black if max(diffuse) <= 0 and max(specular) <= 0 else ambient, diffuse, specular,
        grown)


# Local illumination


def ambient_by(name, rule):
    def plant(s):
        s.ambient = lambda hit: rule(s, hit)

    planted.append((name, plant))


ambient_by("lit.ambient_missing", lambda s, hit: s.black)
ambient_by("lit.ambient_no_color", lambda s, hit: times(hit.material.ka, s.scene.ambient))
ambient_by("lit.ambient_per_light", lambda s, hit: scale(
    len(s.scene.lights), times(times(hit.material.ka, hit.material.color), s.scene.ambient)))


def to_light_by(name, rule):
    def plant(s):
        book = s.to_light
        s.to_light = lambda light, point: rule(s, light, point, *book(light, point))

    planted.append((name, plant))


to_light_by("lit.L_reversed", lambda s, light, p, l, d: (scale(-1, l), d))
to_light_by("lit.L_is_position", lambda s, light, p, l, d: (
    l if light.position is None else unit(light.position), d))


@mistake("lit.L_not_normalised")
def _(s):
    """L as it comes is used in n . L and in R; the shadow ray is right."""

    def longer(light, towards, distance):
        return towards if distance is None else scale(distance, towards)

    def shares(ray, hit, light, towards, distance):
        return type(s).shares(s, ray, hit, light, longer(light, towards, distance), distance)

    s.shares = shares


@mistake("lit.L_not_normalised")
def _(s):
    def diffuse(hit, light, towards, distance, arriving):
        return scale(distance or 1, type(s).diffuse(s, hit, light, towards, distance, arriving))

    s.diffuse = diffuse


@mistake("lit.ndotl_unclamped")
def _(s):
    s.unlit_reason = lambda hit, towards: None
    spec = s.specular
    s.specular = lambda ray, hit, light, l, d, a: (
        spec(ray, hit, light, l, d, a) if dot(hit.normal, l) > 0 else s.black)


@mistake("lit.ndotl_abs")
def _(s):
    s.unlit_reason = lambda hit, towards: None
    spec, book = s.specular, s.diffuse
    s.diffuse = lambda hit, light, l, d, a: scale(
        -1 if dot(hit.normal, l) < 0 else 1, book(hit, light, l, d, a))
    s.specular = lambda ray, hit, light, l, d, a: (
        spec(ray, hit, light, l, d, a) if dot(hit.normal, l) > 0 else s.black)


@mistake("lit.spec_on_backface")
def _(s):
    s.unlit_reason = lambda hit, towards: None
    book = s.diffuse
    s.diffuse = lambda hit, light, l, d, a: (
        book(hit, light, l, d, a) if dot(hit.normal, l) > 0 else s.black)


def diffuse_by(name, rule):
    def plant(s):
        s.diffuse = lambda hit, light, l, d, a: rule(s, hit, light, l, d, a)

    planted.append((name, plant))


diffuse_by("lit.diffuse_no_color", lambda s, hit, light, l, d, a: scale(
    dot(hit.normal, l), times(hit.material.kd, a)))
diffuse_by("lit.kd_missing", lambda s, hit, light, l, d, a: scale(
    dot(hit.normal, l), times(hit.material.color, a)))
diffuse_by("lit.componentwise_dot", lambda s, hit, light, l, d, a: times(
    times(hit.normal, l), times(s.surface_colour(hit), a)))


@mistake("lit.light_color_ignored")
def _(s):
    s.arriving = lambda light, d: scale(
        1 if d is None else s.fading(light.attenuation, d), s.white)


@mistake("lit.ks_kd_swapped")
def _(s):
    s.surface_colour = lambda hit: times(hit.material.ks, hit.material.color)
    s.gloss = lambda hit: times(hit.material.kd, hit.material.specular_color)


def fading_by(name, rule):
    def plant(s):
        s.fading = lambda abc, d: rule(s, abc, d)

    planted.append((name, plant))


def fall(a, b, c, d):
    return min(1, 1 / (a + b * d + c * d * d))


fading_by("lit.att_missing", lambda s, abc, d: 1)
fading_by("lit.att_twice", lambda s, abc, d: fall(*abc, d) ** 2)
fading_by("lit.att_swapped", lambda s, abc, d: fall(abc[0], abc[2], abc[1], d))
fading_by("lit.att_d4", lambda s, abc, d: fall(*abc, d * d))


def cosine_by(name, rule):
    """`rule(s, ray, hit, l, v)` gives what is raised to the exponent."""

    def plant(s):
        s.highlight_cosine = lambda ray, hit, l: rule(s, ray, hit, l, s.viewer(ray, hit))

    planted.append((name, plant))


def positive(x):
    return max(0.0, x)


cosine_by("lit.R_sign", lambda s, ray, hit, l, v: positive(-dot(s.mirrored(hit, l), v)))
cosine_by("lit.R_paren", lambda s, ray, hit, l, v: positive(dot(
    scale(2 * dot(hit.normal, l), subtract(hit.normal, l)), v)))
cosine_by("lit.R_no_factor2", lambda s, ray, hit, l, v: positive(dot(
    subtract(scale(dot(hit.normal, l), hit.normal), l), v)))
cosine_by("lit.blinn", lambda s, ray, hit, l, v: positive(
    dot(hit.normal, unit(add(l, v))) if s.is_phong() else dot(s.mirrored(hit, l), v)))
cosine_by("lit.spec_uses_VdotN", lambda s, ray, hit, l, v: positive(dot(v, hit.normal)))
cosine_by("lit.spec_uses_LdotV", lambda s, ray, hit, l, v: positive(dot(v, l)))
cosine_by("lit.spec_abs", lambda s, ray, hit, l, v: abs(dot(s.mirrored(hit, l), v)))


@mistake("lit.spec_unclamped")
def _(s):
    def cosine(ray, hit, l):
        return dot(s.mirrored(hit, l), s.viewer(ray, hit))

    def specular(ray, hit, light, l, d, a):
        c, n = cosine(ray, hit, l), hit.material.shininess
        power = c**n if c >= 0 or n == int(n) else 0.0
        return scale(power, times(s.gloss(hit), a))

    s.specular = specular


def viewer_by(name, rule):
    def plant(s):
        s.viewer = lambda ray, hit: rule(s, ray, hit)

    planted.append((name, plant))


viewer_by("lit.V_is_ray_dir", lambda s, ray, hit: ray.direction)
viewer_by("lit.V_from_camera", lambda s, ray, hit: unit(subtract(s.camera.eye, hit.point)))
viewer_by("lit.V_not_negated_point", lambda s, ray, hit: unit(hit.point))


def exponent_by(name, rule):
    def plant(s):
        s.exponent = lambda hit: rule(hit.material.shininess)

    planted.append((name, plant))


exponent_by("lit.exponent_x4", lambda n: 4 * n)
exponent_by("lit.exponent_ignored", lambda n: 1)


def specular_then(name, rule):
    def plant(s):
        book = s.specular
        s.specular = lambda ray, hit, light, l, d, a: rule(
            s, hit, l, book(ray, hit, light, l, d, a))

    planted.append((name, plant))


specular_then("lit.spec_times_base", lambda s, hit, l, c: times(hit.material.color, c))
specular_then("lit.spec_times_ndotl", lambda s, hit, l, c: scale(dot(hit.normal, l), c))
specular_then("lit.spec_missing", lambda s, hit, l, c: s.black)


def arriving_then(name, rule):
    def plant(s):
        book = s.arriving
        s.arriving = lambda light, d: scale(rule(s, light), book(light, d))

    planted.append((name, plant))


arriving_then("lit.averaged_over_lights", lambda s, light: 1 / len(s.scene.lights))
arriving_then("lit.only_last_light", lambda s, light: float(light is s.scene.lights[-1]))


def combine_by(name, rule):
    """`rule(s, hit, local, branches)` of the terms and (kind, factor, light) of the branches."""

    def plant(s):
        def combine(hit, ambient, diffuse, specular, grown):
            branches = [(kind, factor, scale(child["attenuation"], child["intensity"]))
                        for kind, factor, child in grown]
            return rule(s, hit, (ambient, diffuse, specular), branches)

        s.combine = combine

    planted.append((name, plant))


def summed(*colours):
    return tuple(map(sum, zip(*colours)))


def rest(k):
    return tuple(1 - x for x in k)


def added(branches):
    return [times(factor, light) for _, factor, light in branches]


def clamped(c):
    return tuple(min(1.0, x) for x in c)


combine_by("lit.clamped_early", lambda s, hit, local, b: summed(clamped(summed(*local)), *added(b)))


# Reflection


def reflected_by(name, rule):
    def plant(s):
        s.reflected = lambda ray, hit: rule(ray.direction, hit.normal, dot(ray.direction, hit.normal))

    planted.append((name, plant))


reflected_by("refl.plus", lambda d, n, c: along(d, n, 2 * c))
reflected_by("refl.no_factor2", lambda d, n, c: along(d, n, -c))
reflected_by("refl.reversed", lambda d, n, c: subtract(scale(2 * c, n), d))
reflected_by("refl.componentwise", lambda d, n, c: subtract(d, scale(2, times(times(d, n), n))))
reflected_by("refl.swapped_args", lambda d, n, c: subtract(n, scale(2 * c, d)))
reflected_by("refl.geometric_normal", lambda d, n, c: along(d, n, -2 * c))


def meets_itself(name, kind):
    def plant(s):
        book = s.finder.closest

        def closest(ray):
            if ray.kind == kind and ray.leaving is not None:
                return s.finder.describe(ray, 0.0, s.things_of[ray.leaving], ray.leaving)
            return book(ray)

        s.finder.closest = closest

    planted.append((name, plant))


meets_itself("refl.no_offset", "reflected")
meets_itself("refr.no_offset", "refracted")


def start_by(name, kind, rule, free=True):
    def plant(s):
        s.start = lambda of, ray, hit: rule(s, hit) if of == kind else hit.point
        if free:
            # Every shape is met again, as a program finds that knows only points.
            book = s.branch
            s.branch = lambda of, *a: (book(of, *a)._replace(leaving=None)
                                       if of == kind else book(of, *a))

    planted.append((name, plant))


start_by("refl.from_eye", "reflected", lambda s, hit: s.camera.eye)
start_by("refr.from_eye", "refracted", lambda s, hit: s.camera.eye)
start_by("refl.offset_inside", "reflected", lambda s, hit: along(hit.point, hit.normal, -1e-4), True)
start_by("refr.offset_outside", "refracted", lambda s, hit: along(hit.point, hit.normal, 1e-4), True)


def share_by(name, kind, rule):
    def plant(s):
        s.share = lambda of, factor, hit: rule(s, factor, hit) if of == kind else factor

    planted.append((name, plant))


share_by("refl.kr_missing", "reflected", lambda s, k, hit: s.white)
share_by("refl.kr_squared", "reflected", lambda s, k, hit: times(k, k))
share_by("refl.times_base", "reflected", lambda s, k, hit: times(k, hit.material.color))
share_by("refr.kt_missing", "refracted", lambda s, k, hit: s.white)
share_by("refr.kt_squared", "refracted", lambda s, k, hit: times(k, k))
share_by("refr.one_minus", "refracted", lambda s, k, hit: rest(hit.material.kr))


def without_branch(name, kind, when):
    def plant(s):
        book = s.branches

        def branches(hit):
            for of, factor, total in book(hit):
                yield of, s.black if of == kind and when(hit) else factor, total

        s.branches = branches

    planted.append((name, plant))


without_branch("refl.missing_child", "reflected", lambda hit: True)
without_branch("refl.only_outside", "reflected", lambda hit: hit.side == "back")


# Refraction


def indices_by(name, rule):
    def plant(s):
        s.indices = lambda ray, hit, thing: rule(hit.eta[0], hit.eta[1], hit.side == "front",
                                                 thing.material.ior)

    planted.append((name, plant))


indices_by("refr.eta_inverted", lambda a, b, front, n: (b, a))
indices_by("refr.eta_same_on_exit", lambda a, b, front, n: (a, b) if front else (b, a))
indices_by("refr.eta_is_ior", lambda a, b, front, n: (n, 1.0))
indices_by("refr.nested_media", lambda a, b, front, n: (1.0, n) if front else (n, 1.0))


def refracted_by(name, rule, total=None):
    """`rule(d, n, eta, c, k)`: c = -d . n, k = 1 - eta^2 (1 - c^2)."""

    def plant(s):
        def refracted(ray, hit):
            eta = hit.eta[0] / hit.eta[1]
            return rule(ray.direction, hit.normal, eta, hit.c1, 1 - hit.s2)

        s.refracted = refracted
        if total:
            book = s.branches
            s.branches = lambda hit: [(k, f, False) for k, f, _ in book(hit)]

    planted.append((name, plant))


def bent(d, n, a, b):
    return along(scale(a, d), n, b)


def root(k):
    return math.sqrt(max(0.0, k))


refracted_by("refr.uses_V", lambda d, n, e, c, k: bent(d, n, -e, e * c - root(k)))
refracted_by("refr.cos_plus", lambda d, n, e, c, k: bent(d, n, e, e * c + root(k)))
refracted_by("refr.cos_sign", lambda d, n, e, c, k: bent(d, n, e, -e * c - root(k)))
refracted_by("refr.no_sqrt", lambda d, n, e, c, k: bent(d, n, e, e * c - k))
refracted_by("refr.watt_div_eta2", lambda d, n, e, c, k: bent(
    d, n, e, e * c - root(1 - (1 - c * c) / (e * e))))
refracted_by("refr.watt_div_eta2", lambda d, n, e, c, k: bent(d, n, e, e * c - root(k) / (e * e)))
refracted_by("refr.straight", lambda d, n, e, c, k: d)
refracted_by("refr.tir_abs", lambda d, n, e, c, k: bent(d, n, e, e * c - root(abs(k))), True)
refracted_by("refr.tir_zero", lambda d, n, e, c, k: bent(d, n, e, e * c - root(k)), True)
refracted_by("refr.tir_straight",
             lambda d, n, e, c, k: d if k < 0 else bent(d, n, e, e * c - root(k)), True)


@mistake("refr.normal_not_flipped")
def _(s):
    def refracted(ray, hit):
        eta = hit.eta[0] / hit.eta[1]
        n = hit.normal if hit.side == "front" else scale(-1, hit.normal)
        c = -dot(ray.direction, n)
        return bent(ray.direction, n, eta, eta * c - root(1 - eta * eta * (1 - c * c)))

    s.refracted = refracted


@mistake("refr.tir_black")
def _(s):
    def branches(hit):
        total = max(hit.material.kt) > 0 and hit.s2 > 1
        kr, kt = hit.material.kr, hit.material.kt
        if total and s.settings["total_internal_reflection"] != "reflect":
            kr = add(kr, kt)
        return [("reflected", kr, False), ("refracted", kt, total)]

    s.branches = branches


NOWHERE = (math.nan,) * 3


def nowhere(name, when):
    """The refracted direction is no numbers: it meets nothing, and is written as null."""

    def plant(s):
        if name == "refr.tir_nan":
            book = s.branches
            s.branches = lambda hit: [(k, f, False) for k, f, _ in book(hit)]
        s.refracted = lambda ray, hit: (
            NOWHERE if when(hit) else type(s).refracted(s, ray, hit))
        met = s.finder.closest
        s.finder.closest = lambda ray: None if math.isnan(ray.direction[0]) else met(ray)
        of = s.branch

        def branch(kind, record, ray, hit, weight):
            if kind == "refracted" and when(hit):
                return Ray(kind, ray.level + 1, record["id"], hit.point, NOWHERE, weight, hit.shape,
                           hit.media_beyond, ray.path + hit.t)
            return of(kind, record, ray, hit, weight)

        s.branch = branch

    planted.append((name, plant))


nowhere("refr.tir_nan", lambda hit: hit.s2 > 1)
nowhere("refr.library_mismatch", lambda hit: True)


def long_primary(s):
    """The primary direction is as long as it comes; t is in its units."""
    s.primary_ray = lambda i, j: Ray(
        "primary", 1, None, s.eye(i, j), s.primary_direction(i, j), s.white, None, (), 0.0)


@mistake("cam.dir_not_normalised")
def _(s):
    long_primary(s)
    book = s.refracted
    s.refracted = lambda ray, hit: book(
        ray._replace(direction=unit(ray.direction)),
        hit._replace(c1=-dot(unit(ray.direction), hit.normal),
                     s2=(hit.eta[0] / hit.eta[1]) ** 2 * (1 - dot(unit(ray.direction), hit.normal) ** 2)))


@mistake("refr.not_normalised")
def _(s):
    long_primary(s)
    s.viewer = lambda ray, hit: scale(-1, unit(ray.direction))


@mistake("shd.first_hit_only_then_compare")
def _(s):
    """for each object: if it is hit, return whether that is nearer than the light."""

    def shadow(hit, towards, distance):
        for thing in s.scene.things:
            met = [c for c in s.finder.crossings(hit.point, towards, hit.shape) if c[1] is thing]
            if met:
                first = min(met, key=lambda c: c[0])
                if distance is None or first[0] < distance:
                    light = (s.black if s.settings["shadows"] == "opaque"
                             else first[1].material.kt)
                    return (first if max(light) == 0 else None), light
                return None, s.white
        return None, s.white

    s.shadow = shadow


# Recursion, background, output


def depth_by(name, more):
    def plant(s):
        book = s.branch_reason
        s.branch_reason = lambda kind, factor, total, level, weight: book(
            kind, factor, total, level - more, weight)

    planted.append((name, plant))


depth_by("rec.depth_plus_one", 1)
depth_by("rec.depth_minus_one", -1)


@mistake("rec.never_ends")
def _(s):
    """The share that is handed on stays whole: only the depth ends the tree."""
    book = s.branch_reason
    s.branch_reason = lambda kind, factor, total, level, weight: book(
        kind, factor, total, level, s.white)
    of = s.branch
    s.branch = lambda kind, record, ray, hit, weight: of(kind, record, ray, hit, ray.weight)

combine_by("rec.lerp", lambda s, hit, local, b: summed(
    times(rest(hit.material.kr), summed(*local)), *added(b)))
combine_by("rec.overwrites", lambda s, hit, local, b: summed(*(added(b) or local)))
combine_by("out.child_clamped", lambda s, hit, local, b: clamped(summed(*local, *added(b))))


@mistake("rec.multiplied")
def _(s):
    def combine(hit, ambient, diffuse, specular, grown):
        total = summed(ambient, diffuse, specular)
        for kind, factor, child in grown:
            total = times(total, times(factor, scale(child["attenuation"], child["intensity"])))
        return total

    s.combine = combine


@mistake("rec.depth_shared_by_siblings")
def _(s):
    """trace(reflected, ++depth) and then trace(refracted, ++depth)."""
    plain_shade(s)


def plain_shade(s):
    """`shade` with a depth of its own that each call of trace raises before it is made."""
    from model import termination

    def follow(ray, depth=1):
        s.counted = depth
        return type(s).follow(s, ray)

    def shade(record, ray, hit):
        depth = s.counted
        f = s.fade(ray, hit)
        record.update(attenuation=f, hit=s.hit_record(hit), skipped=[])
        ambient = s.ambient(hit)
        diffuse, specular = s.light_up(record, ray, hit)
        record.update(ambient=ambient, diffuse=diffuse, specular=specular)
        grown, reasons, next_depth = [], [], depth
        for kind, factor, total in s.branches(hit):
            weight = scale(f, times(ray.weight, factor))
            reason = type(s).branch_reason(s, kind, factor, total, depth, weight)
            if reason:
                reasons.append(reason)
                record["skipped"].append({"kind": kind, "reason": reason})
                continue
            next_depth += 1
            child = follow(s.branch(kind, record, ray, hit, weight), next_depth)
            grown.append((kind, factor, child))
        record["intensity"] = s.combine(hit, ambient, diffuse, specular, grown)
        record["termination"] = termination(reasons)

    s.counted = 1
    tree = s.tree

    def counted_tree(i, j):
        s.counted = 1
        return tree(i, j)

    s.shade, s.tree = shade, counted_tree


def miss_by(name, rule):
    def plant(s):
        book = s.miss
        s.miss = lambda record: rule(s, record["kind"] == "primary", book(record))

    planted.append((name, plant))


miss_by("bg.black_for_secondary", lambda s, primary, c: c if primary else s.black)
miss_by("bg.secondary_ambient", lambda s, primary, c: c if primary else times(s.scene.ambient, c))
miss_by("bg.background_for_secondary", lambda s, primary, c: s.scene.background)
