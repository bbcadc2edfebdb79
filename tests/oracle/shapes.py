"""One ray against one shape, in the shape's own space (model.md, section 2).

Every shape has two methods. `meets(origin, direction, leaving)` gives the distances, lowest first,
some perhaps not positive; `leaving` says that the origin is a point of this very shape, which the
ray does not meet again. `normals(point)` gives the geometric and the shading normal, neither of
them turned towards the ray nor necessarily of unit length.
"""

from arithmetic import along, cross, dot, scale, sqrt, subtract, unit


def roots(a, b, c, leaving):
    """Roots of a t² + b t + c, lowest first; the root 0 of a ray that leaves is left out.

    The start of a leaving ray satisfies the equation, so c is 0 up to rounding and the other root
    needs no square root and no threshold.
    """
    if a == 0:
        return () if leaving or b == 0 else (-c / b,)
    if leaving:
        return (-b / a,)
    discriminant = b * b - 4 * a * c
    if discriminant < 0:
        return ()
    root = sqrt(discriminant)
    low, high = (-b - root) / (2 * a), (-b + root) / (2 * a)
    return (low, high) if low <= high else (high, low)


class Sphere:
    def __init__(self, centre, radius):
        self.centre, self.radius = centre, radius

    def meets(self, origin, direction, leaving):
        m = subtract(origin, self.centre)
        return roots(
            dot(direction, direction),
            2 * dot(m, direction),
            dot(m, m) - self.radius * self.radius,
            leaving,
        )

    def normals(self, point):
        outward = subtract(point, self.centre)
        return outward, outward


class Cone:
    """The lateral surface of a frustum; both ends belong to it.

    `s` is the share of the way from the base to the apex, at which the radius is r0 + dr s.
    """

    def __init__(self, base, base_radius, apex, apex_radius):
        self.base, self.axis = base, subtract(apex, base)
        self.r0, self.dr = base_radius, apex_radius - base_radius
        self.squared_height = dot(self.axis, self.axis)

    def split(self, vector):
        """The share along the axis, and what of the vector is at right angles to it."""
        s = dot(vector, self.axis) / self.squared_height
        return s, subtract(vector, scale(s, self.axis))

    def meets(self, origin, direction, leaving):
        s0, q0 = self.split(subtract(origin, self.base))
        s1, q1 = self.split(direction)
        radius, growth = self.r0 + self.dr * s0, self.dr * s1
        found = roots(
            dot(q1, q1) - growth * growth,
            2 * (dot(q0, q1) - radius * growth),
            dot(q0, q0) - radius * radius,
            leaving,
        )
        return [t for t in found if 0 <= s0 + t * s1 <= 1]

    def normals(self, point):
        _, q = self.split(subtract(point, self.base))
        outward = subtract(unit(q), scale(self.dr / self.squared_height, self.axis))
        return outward, outward


class Polygon:
    """A plane polygon, convex or not; a mesh is made of triangles of this kind."""

    def __init__(self, vertices, normals=None):
        self.vertices = vertices
        self.vertex_normals = normals and [unit(n) for n in normals]
        self.normal = newell(vertices)
        total = [sum(v[axis] for v in vertices) for axis in range(3)]
        self.offset = dot(self.normal, total) / len(vertices)
        sizes = [abs(x) for x in self.normal]
        dropped = sizes.index(max(sizes))
        # Cyclic order decides which coordinate is "the second" for interpolation.
        self.u, self.v = (dropped + 1) % 3, (dropped + 2) % 3
        self.outline = [(p[self.u], p[self.v]) for p in vertices]

    def meets(self, origin, direction, leaving):
        slope = dot(self.normal, direction)
        if leaving or slope == 0:
            return ()
        t = (self.offset - dot(self.normal, origin)) / slope
        if t <= 0:
            return ()
        point = along(origin, direction, t)
        crossings = [x for x, _ in self.crossings(point) if x > point[self.u]]
        return (t,) if len(crossings) % 2 else ()

    def crossings(self, point):
        """Where the line of the point's second coordinate cuts the boundary.

        Gives the first coordinate and (edge, share of the way along it).
        """
        level = point[self.v]
        found = []
        a = self.outline[-1]
        for edge, b in enumerate(self.outline):
            if (a[1] > level) != (b[1] > level):
                share = (level - a[1]) / (b[1] - a[1])
                found.append((a[0] + share * (b[0] - a[0]), (edge - 1, share)))
            a = b
        return found

    def normals(self, point):
        if not self.vertex_normals:
            return self.normal, self.normal
        here = point[self.u]
        found = self.crossings(point)
        left = max((c for c in found if c[0] <= here), key=lambda c: c[0])
        right = min((c for c in found if c[0] > here), key=lambda c: c[0])
        share = (here - left[0]) / (right[0] - left[0])
        return self.normal, mix(self.on_edge(left[1]), self.on_edge(right[1]), share)

    def on_edge(self, place):
        """The normal between the ends of edge k, which starts at vertex k (-1 is the last)."""
        edge, share = place
        return mix(self.vertex_normals[edge], self.vertex_normals[edge + 1], share)


def mix(a, b, share):
    return tuple(x + share * (y - x) for x, y in zip(a, b))


def newell(vertices):
    """Newell's normal: counter-clockwise as seen from the side that it points to."""
    total = (0, 0, 0)
    for a, b in zip(vertices, vertices[1:] + vertices[:1]):
        total = tuple(x + y for x, y in zip(total, cross(a, b)))
    return total
