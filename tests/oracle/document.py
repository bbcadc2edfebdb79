"""Trees as JSON (formats.md), with numbers that keep all the digits they have."""

import json

from mpmath import mp, mpf

DIGITS = 40


def tree_document(tracer, pixel, root):
    scene, kinds = tracer.scene, [ray["kind"] for ray in tracer.rays]
    written = scene.source.document
    lights, levels = len(scene.lights), scene.settings["max_depth"]
    counts = {kind: kinds.count(kind) for kind in ("primary", "reflected", "refracted", "shadow")}
    counts.update(
        levels=max(ray["level"] for ray in tracer.rays),
        lights=lights,
        full_tree=float((lights + 1) * (2**levels - 1)),
        intersection_tests=tracer.finder.tests,
    )
    return {
        "format": "raytree/1.0",
        "generator": "50-digit reference",
        "scene": {"name": written["name"], "sha256": scene.source.sha256},
        "pixel": list(pixel),
        "camera": written["camera"],
        "settings": scene.settings,
        "intensity": root["intensity"],
        "counts": counts,
        "rays": tracer.rays,
    }


def read_tree(text):
    """Numbers with a point or an exponent become mpf, so that no digit is lost."""
    return json.loads(text, parse_float=mpf)


def write_tree(tree):
    """JSON with one ray a line."""
    lines = [f"{write(key)}: {write(value)}" for key, value in tree.items() if key != "rays"]
    rays = ",\n".join(write(ray) for ray in tree["rays"])
    return "{" + ",\n".join(lines) + ',\n"rays": [\n' + rays + "\n]}\n"


def write(value):
    if isinstance(value, dict):
        return "{" + ", ".join(f"{write(k)}: {write(v)}" for k, v in value.items()) + "}"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(map(write, value)) + "]"
    if isinstance(value, mpf):
        # A whole number is written as one: shorter, and exact.
        is_whole = value == int(value) and abs(value) < 2**53
        return str(int(value)) if is_whole else mp.nstr(value, DIGITS)
    return json.dumps(value)
