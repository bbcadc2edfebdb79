"""Writes the ray tree of one pixel as raytree/1.0. Needs Python 3 and nothing else.

    recorder = Recorder(i, j)
    ray = recorder.ray("primary", None, eye, direction)
    ray.hit("ball", t, normal=n).set(intensity=colour)
    recorder.save("tree.json")

One call of `ray` (or `shadow`) for each ray is enough; what else is said of it is compared too.
A vector or colour is anything with three numbers in it: a tuple, a list, an array.
"""

import json
import math


def _plain(value):
    """As JSON has it: lists of floats. What is no number stays visible as a word, which the check
    then points at."""
    if value is None or isinstance(value, (str, bool, dict)):
        return value
    if hasattr(value, "__iter__"):
        return [_plain(x) for x in value]
    number = float(value)
    return number if math.isfinite(number) else str(number)


class Ray:
    """What is known of a ray, said in any order."""

    def __init__(self, fields):
        self.fields = fields

    def set(self, **fields):
        """weight, ambient, diffuse, specular, attenuation, intensity; of a shadow ray distance,
        transmittance."""
        self.fields.update((key, _plain(value)) for key, value in fields.items())
        return self

    def hit(self, object, t, **more):
        """What it hits, t in units of its direction; point, normal, side ("front" or "back"),
        cos_incident, eta, sin2_transmitted."""
        self.fields["hit"] = {"object": object, "t": _plain(t),
                              **{key: _plain(value) for key, value in more.items()}}
        return self

    def miss(self):
        self.fields["hit"] = None
        return self

    def blocked_by(self, object=None):
        """Of a shadow ray: the name of what stands between; None where nothing does."""
        self.fields["blocked_by"] = None if object is None else {"object": object}
        return self


class Recorder:
    def __init__(self, column, row):
        self.pixel = [int(column), int(row)]
        self.rays = []

    def ray(self, kind, parent, origin, direction, **fields):
        """kind is "primary", "reflected" or "refracted"; parent the Ray that hit, or None."""
        ray = Ray({"id": len(self.rays), "parent": parent and parent.fields["id"], "kind": kind})
        self.rays.append(ray.fields)
        return ray.set(origin=origin, direction=direction, **fields)

    def shadow(self, parent, light, origin, direction, **fields):
        """A shadow ray; light is its name in the scene."""
        return self.ray("shadow", parent, origin, direction, light=light, **fields)

    def json(self):
        rows = ",\n  ".join(json.dumps(ray) for ray in self.rays)
        return (f'{{"format": "raytree/1.0", "pixel": {json.dumps(self.pixel)},\n'
                f' "rays": [\n  {rows}\n]}}\n')

    def save(self, file):
        with open(file, "w", encoding="utf-8") as out:
            out.write(self.json())
