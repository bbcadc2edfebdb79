#!/usr/bin/env python3
"""Writes the folder of ready truths that run.py --truth judges by: make_truth.py FOLDER.

A dozen small scenes, two pixels each, and a third that sees nothing where that is special. A case
names the features of its scene and what its trees have to show between them; seeds are tried in
order until they do, so that the same folder comes out every time.
"""

import json
import sys
from pathlib import Path

from arithmetic import EXACT
from document import write_tree
from model import trace
from reader import read_source
from run import DOUBTFUL
from scenes import choose_pixels, make_scene, sights, write_scene
from sensitivity import doubtful_fields

CASES = [
    ({"smooth_mesh", "cones", "close_light"}, {"primary mesh front", "refracted mesh back"}),
    (
        {"flat_mesh", "attenuation", "directional", "nested"},
        {"primary mesh front", "shadow mesh blocker", "refracted sphere core back"},
    ),
    (
        {"smooth_mesh", "moved_mesh", "mirrored", "blinn", "concave"},
        {"refracted mesh moved back", "reflected mesh moved"},
    ),
    (
        {"flat_mesh", "moved_mesh", "transmissive", "many_lights", "light_attenuation",
         "close_light"},
        {"primary mesh moved front", "shadow dimmed", "shadow mesh moved blocker"},
    ),
    ({"near", "image_plane", "nested"}, {"primary sphere back"}),
    (
        {"corner", "tilted", "image_plane", "no_shadows", "tir_reflect", "moved_sphere",
         "mirrored"},
        {"primary sphere moved front", "total_internal_reflection", "sphere moved back"},
    ),
    (
        {"in_place", "nested", "transmissive", "tir_reflect", "directional"},
        {"refracted sphere own back", "refracted sphere own front", "shadow dimmed"},
    ),
    (
        {"ray_budget", "many_lights", "nested", "vertex_normals"},
        {"reflected ray_budget", "refracted ray_budget", "ended ray_budget"},
    ),
    (
        {"moved_polygon", "skewed_normals", "concave", "mirrored", "min_weight"},
        {"primary polygon moved normals", "negative cosine", "ended low_intensity"},
    ),
    (
        {"max_distance", "secondary_background", "in_place", "moved_cone", "mirrored", "corner"},
        {"ended max_distance", "cone moved own front", "cone moved own back", "missed"},
    ),
    ({"defaults", "smooth_mesh", "cones", "vertex_normals"}, {"ended max_depth", "mesh"}),
    (
        {"near", "image_plane", "moved_mesh", "smooth_mesh", "flat_mesh", "moved_cone", "blinn",
         "moved_polygon", "vertex_normals", "moved_sphere", "mirrored", "in_place", "nested",
         "transmissive", "attenuation", "light_attenuation", "directional", "max_distance"},
        {"mesh moved own", "polygon moved normals", "sphere moved", "shadow dimmed"},
    ),
]  # fmt: skip


def main(folder):
    folder.mkdir(parents=True, exist_ok=True)
    for old in [*folder.glob("*.json"), *folder.glob("*.obj")]:
        old.unlink()
    doubtful = {}
    for number, (features, wanted) in enumerate(CASES):
        doubtful.update(write_case(folder, f"{number:02d}", number, features, wanted))
    (folder / DOUBTFUL).write_text(json.dumps(doubtful, indent=1) + "\n")


def write_case(folder, stem, number, features, wanted):
    """{tree's file name: [[ray id, field], ...] that is not to be judged}."""
    for seed in range(1000 * (number + 1), 1000 * (number + 2)):
        source, texts = make_scene(seed, features, stem)
        with_miss = "secondary_background" in features
        pixels = choose_pixels(source, seed, 2, rays=(6, 36), with_miss=with_miss)
        trees = {pixel: trace(source, pixel, EXACT) for pixel in pixels}
        shown = set().union(*(sights(source, tree) for tree in trees.values()))
        if len(trees) < 2 or not all(any(want in sight for sight in shown) for want in wanted):
            continue
        fields = {p: doubtful_fields(source, p, tree, seed) for p, tree in trees.items()}
        if None not in fields.values():
            path = write_scene(folder, stem, source, texts)
            return write_trees(folder, stem, path, trees, fields)
    raise SystemExit(f"no seed shows {wanted} with {features}")


def write_trees(folder, stem, path, trees, fields):
    # Read back, so that the trees carry the hash of the file that was written.
    source, doubtful = read_source(path), {}
    for pixel, tree in trees.items():
        tree["scene"]["sha256"] = source.sha256
        name = f"{stem}.{pixel[0]},{pixel[1]}.tree.json"
        (folder / name).write_text(write_tree(tree))
        doubtful[name] = [list(field) for field in fields[pixel]]
        print(f"{name}: {len(tree['rays'])} rays, {len(fields[pixel])} doubtful fields")
    return doubtful


if __name__ == "__main__":
    main(Path(sys.argv[1]))
