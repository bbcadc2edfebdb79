"""Random scenes that together use every feature of raytree-scene/1.0.

`make_scene(seed)` draws a set of FEATURES and builds a scene that has them; the same seed gives
the same scene for ever. `choose_pixels` picks pixels whose trees are worth a comparison.
"""

import json
import random
from pathlib import Path

from arithmetic import FAST
from builders import (
    ball_obj, box_obj, material_palette, moved_obj, noise, outline, placement, pyramid_obj,
)  # fmt: skip
from model import trace
from obj import read_obj
from reader import Source

FEATURES = (
    # camera
    "image_plane", "near", "corner", "tilted",
    # settings
    "max_distance", "attenuation", "blinn", "transmissive", "no_shadows", "tir_reflect",
    "secondary_background", "ray_budget", "min_weight", "shallow", "defaults",
    # lights
    "directional", "light_attenuation", "many_lights", "close_light",
    # objects
    "smooth_mesh", "flat_mesh", "moved_mesh", "moved_polygon", "moved_cone", "moved_sphere",
    "mirrored", "in_place", "concave", "vertex_normals", "skewed_normals", "nested", "cones",
)  # fmt: skip


def make_scene(seed, features=None, stem=None):
    """(Source, {file name: OBJ text}); `stem` begins the names of all its files."""
    rng = random.Random(seed)
    drawn = {feature for feature in FEATURES if rng.random() < 0.45}
    features = drawn if features is None else set(features)
    return Maker(rng, features, stem or f"{seed:02d}").scene(f"oracle {seed}")


def write_scene(folder, stem, source, texts):
    """Writes NN.scene.json and its OBJ files; gives the scene's path."""
    for file, text in texts.items():
        (Path(folder) / file).write_text(text)
    path = Path(folder) / f"{stem}.scene.json"
    path.write_text(json.dumps(source.document, indent=1) + "\n")
    return path


class Maker:
    """Builds one scene; every choice comes from one generator, in one order."""

    def __init__(self, rng, features, stem):
        self.rng, self.features, self.stem = rng, features, stem
        self.objects, self.texts = [], {}
        self.palette = material_palette(rng)

    def has(self, feature):
        return feature in self.features

    def scene(self, name):
        rng = self.rng
        self.add_objects()
        document = {
            "format": "raytree-scene/1.0",
            "name": name,
            "camera": self.camera(),
            "background": noise(rng, 0.1, 0.6),
            "ambient": rng.choice([0.5, noise(rng, 0.3, 1)]),
            "settings": self.settings(),
            "materials": self.palette,
            "lights": self.lights(),
            "objects": self.objects,
        }
        if self.has("defaults"):
            document = {k: v for k, v in document.items() if k not in ("background", "ambient")}
        meshes = {file: read_obj(text) for file, text in self.texts.items()}
        return Source(document, meshes), self.texts

    def camera(self):
        rng = self.rng
        camera = {
            "eye": [rng.uniform(-2, 2), rng.uniform(0.8, 3), rng.uniform(5.5, 7)],
            "look_at": [rng.uniform(-0.3, 0.3), rng.uniform(0.3, 0.9), 0],
            "width": rng.randint(60, 120),
            "height": rng.randint(50, 90),
        }
        if self.has("image_plane"):
            left, bottom = rng.uniform(-0.6, -0.2), rng.uniform(-0.5, -0.2)
            window = [left, rng.uniform(0.2, 0.5), bottom, rng.uniform(0.2, 0.4)]
            camera["image_plane"] = window
        else:
            camera["horizontal_fov_degrees"] = rng.uniform(35, 60)
        if self.has("near"):
            camera["near"] = rng.uniform(5, 6.5)
        if self.has("tilted"):
            camera["up"] = noise(rng, -0.4, 0.4, centre=[0, 1, 0])
        return camera

    def settings(self):
        rng, has = self.rng, self.has
        if has("defaults"):
            return {"ray_budget": rng.randint(4, 30)} if has("ray_budget") else {}
        settings = {
            "max_depth": rng.randint(2, 3) if has("shallow") else rng.randint(4, 7),
            "min_weight": rng.uniform(0.01, 0.08) if has("min_weight") else 0,
        }
        if has("max_distance"):
            settings["max_distance"] = rng.uniform(7, 13)
        if has("attenuation"):
            settings["attenuation"] = [rng.uniform(0.5, 1.1), rng.uniform(0.05, 0.4), 0.01]
        if has("blinn"):
            settings["specular_model"] = "blinn"
        if has("transmissive") or has("no_shadows"):
            settings["shadows"] = "transmissive" if has("transmissive") else "none"
        if has("tir_reflect"):
            settings["total_internal_reflection"] = "reflect"
        if has("corner"):
            settings["pixel_sample"] = "corner"
        if has("secondary_background"):
            settings["secondary_background"] = rng.choice([0.25, noise(rng, 0, 0.5)])
        if has("ray_budget"):
            settings["ray_budget"] = rng.randint(4, 30)
        return settings

    def lights(self):
        rng = self.rng
        lights = [self.point_light(rng)]
        if self.has("close_light"):
            # Among the objects: what lies behind it must not shade.
            lights[0]["position"] = noise(rng, -0.7, 0.7, [0, 1, 0.5])
        if self.has("many_lights"):
            lights += [{**self.point_light(rng), "name": "fill"}, self.point_light(rng)]
        if self.has("directional"):
            lights.append({"type": "directional", "direction": noise(rng, -1, 1, [0, -2, -1])})
            lights[-1]["intensity"] = rng.choice([0.4, noise(rng, 0.2, 0.6)])
        return lights

    def point_light(self, rng):
        light = {"type": "point", "position": noise(rng, -4, 4, [0, 6, 4])}
        if rng.random() < 0.7:
            light["intensity"] = noise(rng, 0.3, 1)
        if self.has("light_attenuation"):
            constant = rng.choice([0, 1])
            light["attenuation"] = [constant, rng.uniform(0.02, 0.2), rng.uniform(0, 0.05)]
        return light

    # Objects

    def add_objects(self):
        rng = self.rng
        floor = [[-20, -1, 20], [20, -1, 20], [20, -1, -20], [-20, -1, -20]]
        floor = {"type": "polygon", "vertices": floor, "name": "floor"}
        self.add(floor, ["matt", "mirror", "tiles"])
        for _ in range(rng.randint(2, 4)):
            self.add_sphere(self.has("moved_sphere") and rng.random() < 0.6)
        if self.has("nested"):
            self.add_nested()
        for _ in range(rng.randint(1, 3)):
            self.add_polygon()
        if self.has("cones") or self.has("moved_cone"):
            self.add_cone([0.3, rng.choice([0.7, 0.3])])
            self.add_cone(rng.choice([[0, 0.5], [0.6, 0]]))
        if self.has("smooth_mesh"):
            self.add_mesh("ball.obj", ball_obj(rng))
        if self.has("flat_mesh"):
            self.add_mesh("box.obj", box_obj(rng))
            self.add_mesh("pyramid.obj", pyramid_obj(rng), smooth=False)

    def add(self, shape, materials, moved=False):
        rng = self.rng
        name = rng.choice(materials)
        shape["material"] = name
        if self.has("in_place") and rng.random() < 0.5:
            shape["material"] = dict(self.palette[name])
        if moved:
            shape["transform"] = placement(rng, self.has("mirrored"))
        self.objects.append(shape)

    def add_sphere(self, moved):
        rng = self.rng
        sphere = {"type": "sphere", "radius": rng.uniform(0.5, 0.9), "center": self.place()}
        if moved:
            sphere["center"] = noise(rng, -0.3, 0.3)
        self.add(sphere, ["glass", "water", "mirror", "tinted", "matt"], moved)

    def place(self):
        rng = self.rng
        return [rng.uniform(-1.6, 1.6), rng.uniform(-0.4, 1.8), rng.uniform(-1.5, 1.5)]

    def add_nested(self):
        """Balls in balls; the core is of the outer one's material, which is then met twice."""
        centre = self.place()
        layers = [("outer", 0.95, ["glass"]), ("inner", 0.65, ["water", "tinted"])]
        layers.append(("core", 0.35, ["glass"]))
        for name, radius, materials in layers:
            layer = {"type": "sphere", "center": noise(self.rng, -0.1, 0.1, centre)}
            self.add({**layer, "radius": radius, "name": name}, materials)

    def add_polygon(self):
        rng, moved = self.rng, self.has("moved_polygon")
        centre = noise(rng, -0.2, 0.2) if moved else self.place()
        vertices, normal = outline(rng, centre, self.has("concave"))
        polygon = {"type": "polygon", "vertices": vertices}
        if self.has("vertex_normals") or self.has("skewed_normals"):
            skew = 1.6 if self.has("skewed_normals") else 0.3
            polygon["normals"] = [noise(rng, -skew, skew, normal) for _ in vertices]
        self.add(polygon, ["mirror", "tinted", "glass", "matt"], moved)

    def add_cone(self, radii):
        rng, moved = self.rng, self.has("moved_cone")
        base = noise(rng, -0.4, 0.4) if moved else self.place()
        apex = noise(rng, -0.6, 0.6, [base[0], base[1] + 1, base[2]])
        cone = {"type": "cone", "base": base, "apex": apex}
        cone.update(base_radius=radii[0], apex_radius=radii[1])
        self.add(cone, ["mirror", "tinted", "glass", "matt"], moved)

    def add_mesh(self, file, text, smooth=None):
        """A mesh is made around the origin, so one that has no transform gets a moved file."""
        file = f"{self.stem}.{file}"
        moved = self.has("moved_mesh")
        self.texts[file] = text if moved else moved_obj(text, self.place())
        mesh = {"type": "mesh", "file": file}
        if smooth is not None:
            mesh["smooth"] = smooth
        self.add(mesh, ["glass", "mirror", "tinted"], moved)


def choose_pixels(source, seed, count=2, rays=(5, 80), tries=250, with_miss=True):
    """Pixels whose trees show most that the pixels before them do not, by a float trace.

    The last of several is the one with the most rays. `with_miss` adds one that misses everything,
    where the tries find one.
    """
    rng, camera = random.Random(seed), source.document["camera"]
    candidates, missed = [], []
    for _ in range(tries):
        pixel = (rng.randrange(camera["width"]), rng.randrange(camera["height"]))
        tree = trace(source, pixel, FAST)
        if rays[0] <= len(tree["rays"]) <= rays[1]:
            candidates.append((pixel, sights(source, tree), len(tree["rays"])))
        elif len(tree["rays"]) == 1 and tree["rays"][0]["hit"] is None:
            missed = [pixel]
    chosen, seen = [], set()
    while candidates and len(chosen) < count:
        is_last = chosen and len(chosen) == count - 1
        best = max(candidates, key=lambda c: c[2] if is_last else len(c[1] - seen))
        candidates = [c for c in candidates if c[0] != best[0]]
        chosen.append(best[0])
        seen |= best[1]
    return chosen + (missed if with_miss else [])


def sights(source, tree):
    """What a tree shows, as words: used to choose pixels and to count what was covered."""
    kinds = {}
    for index, thing in enumerate(source.document["objects"]):
        features = [thing["type"]] + ["moved"] * ("transform" in thing)
        features += ["normals"] * ("normals" in thing)
        features += ["own"] * isinstance(thing["material"], dict)
        name = thing.get("name", f"{thing['type']}{index}")
        kinds[name] = " ".join(features + [name] * (name == "core"))
    seen = set()
    for ray in tree["rays"]:
        for key in ("hit", "blocked_by"):
            if ray.get(key):
                side = ray[key].get("side", "blocker")
                seen.add(f"{ray['kind']} {kinds[ray[key]['object'].split('#')[0]]} {side}")
        hit = ray.get("hit")
        if ray["kind"] == "primary" and not hit:
            seen.add("primary missed")
        if hit and hit.get("cos_incident", 0) < 0:
            seen.add("negative cosine")
        seen.update(f"{entry['kind']} {entry['reason']}" for entry in ray.get("skipped", ()))
        if ray.get("termination"):
            seen.add(f"ended {ray['termination']}")
        if ray["kind"] == "shadow" and 0 < max(ray["transmittance"]) < 1:
            seen.add("shadow dimmed")
    return seen
