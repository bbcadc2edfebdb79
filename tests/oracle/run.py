#!/usr/bin/env python3
"""Judges a ray tracer by the oracle: run.py RAYTREE [--seeds A-B | --data FOLDER | --truth FOLDER].

RAYTREE is the program under test; the word `oracle` in its place tests the oracle against what it
is compared with. Exits 0 where every tree agrees, 1 where one differs.
"""

import argparse
import json
import shutil
import subprocess
import sys
import tempfile
from collections import Counter
from pathlib import Path
from typing import NamedTuple

from arithmetic import EXACT
from compare import compare
from document import read_tree, write_tree
from model import trace
from reader import read_source
from scenes import choose_pixels, make_scene, sights, write_scene
from sensitivity import doubtful_fields

DOUBTFUL = "doubtful.json"


class Case(NamedTuple):
    """A pixel with its truth; `doubtful` is None where the shape of the tree is."""

    name: str
    scene: Path
    pixel: tuple
    truth: dict
    doubtful: set
    strict: bool
    seen: set


def main():
    options = read_options()
    with tempfile.TemporaryDirectory() as temporary:
        folder = options.keep or Path(temporary)
        folder.mkdir(parents=True, exist_ok=True)
        if options.data:
            cases = data_cases(options.data)
        elif options.truth:
            cases = truth_cases(options.truth)
        else:
            cases = seeded_cases(options, folder)
        return judge_all(options, cases)


def read_options():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("raytree", help="the program under test, or `oracle`")
    source = parser.add_mutually_exclusive_group()
    source.add_argument("--seeds", default="1-40", help="random scenes, A-B (default 1-40)")
    source.add_argument("--data", type=Path, help="a folder of NN.scene.json, NN.I,J.tree.json")
    source.add_argument("--truth", type=Path, help="the same, written by make_truth.py")
    parser.add_argument("--pixels", type=int, default=3, help="of each random scene (default 3)")
    parser.add_argument("--precision", choices=["double", "reference"], default="double")
    parser.add_argument("--tol", type=float, help="default 1e-9; reference 1e-25, --data 1e-9")
    parser.add_argument("--keep", type=Path, help="leave the random scenes in this folder")
    parser.add_argument("--coverage", action="store_true", help="say what the trees showed")
    parser.add_argument("--quiet", action="store_true", help="only the trees that differ")
    options = parser.parse_args()
    if options.raytree != "oracle" and not shutil.which(options.raytree):
        parser.error(f"{options.raytree} is not a program")
    if options.tol is None:
        # Ready trees have the digits of a double, whatever they are compared with.
        full = options.precision == "reference" and not options.data
        options.tol = 1e-25 if full else 1e-9
    return options


def seeded_cases(options, folder):
    first, _, last = options.seeds.partition("-")
    for seed in range(int(first), int(last or first) + 1):
        stem = f"{seed:02d}"
        source, texts = make_scene(seed)
        path = write_scene(folder, stem, source, texts)
        for pixel in choose_pixels(source, seed, options.pixels):
            truth = trace(source, pixel, EXACT)
            doubtful = doubtful_fields(source, pixel, truth, seed)
            doubtful = None if doubtful is None else set(doubtful)
            name = f"{stem}.{pixel[0]},{pixel[1]}"
            yield Case(name, path, pixel, truth, doubtful, True, sights(source, truth))


def data_cases(folder):
    """Trees of somebody else: which of their fields are doubtful is found out here."""
    for path, scene, truth in ready_trees(folder):
        source, pixel = read_source(scene), tuple(truth["pixel"])
        doubtful = doubtful_fields(source, pixel, trace(source, pixel, EXACT)) or {}
        yield Case(path.name, scene, pixel, truth, set(doubtful), False, sights(source, truth))


def truth_cases(folder):
    doubtful = json.loads((folder / DOUBTFUL).read_text())
    for path, scene, truth in ready_trees(folder):
        fields = {(ray, name) for ray, name in doubtful.get(path.name, ())}
        seen = sights(read_source(scene), truth)
        yield Case(path.name, scene, tuple(truth["pixel"]), truth, fields, True, seen)


def ready_trees(folder):
    for path in sorted(folder.glob("*.tree.json")):
        scene = folder / f"{path.name.split('.')[0]}.scene.json"
        yield path, scene, read_tree(path.read_text())


def judge_all(options, cases):
    total, seen, failed, trees, worst = Counter(), Counter(), 0, 0, (0, "nothing")
    print(f"{'tree':24}{'rays':>5}{'judged':>8}{'doubtful':>9}  {'worst error':12}at")
    for case in cases:
        if case.doubtful is None:
            total["dropped"] += 1
            if not options.quiet:
                print(f"{case.name:24} dropped: its shape hangs on the last bit of the scene")
            continue
        trees += 1
        seen.update(case.seen)
        report, failure = judge_one(options, case)
        if report:
            total.update(judged=report.judged, doubtful=report.skipped)
            worst = max(worst, (report.worst[0], f"{case.name} {report.worst[1]}"))
        failed += bool(failure)
        show(options, case, report, failure)
    if options.coverage:
        print("\n".join(f"{count:6} {what}" for what, count in sorted(seen.items(), key=str)))
    print(
        f"{trees} trees, {total['judged']} fields judged within {options.tol:g}, "
        f"{total['doubtful']} doubtful, {total['dropped']} trees dropped; "
        f"worst {float(worst[0]):.2g} ({worst[1]}); {failed} trees differ"
    )
    # Nothing judged is no success: a wrong folder has to show.
    return 1 if failed or not trees else 0


def judge_one(options, case):
    """(report or None, what is wrong)."""
    try:
        found = read_tree(run(options, case))
    except (OSError, subprocess.SubprocessError, ValueError) as error:
        return None, [f"no tree: {error} {getattr(error, 'stderr', '') or ''}".strip()]
    report = compare(case.truth, found, options.tol, case.doubtful, case.strict)
    return report, report.differences


def run(options, case):
    if options.raytree == "oracle":
        return write_tree(trace(read_source(case.scene), case.pixel, EXACT))
    line = command(options, case)
    return subprocess.run(line, capture_output=True, text=True, timeout=120, check=True).stdout


def command(options, case):
    pixel = f"{case.pixel[0]},{case.pixel[1]}"
    line = [options.raytree, "trace", str(case.scene), "--pixel", pixel, "--as", "json", "-o", "-"]
    return line + (["--precision", "reference"] if options.precision == "reference" else [])


def show(options, case, report, failure):
    if failure:
        print(f"{case.name:24} DIFFERS: {failure[0]}")
        for line in failure[1:6]:
            print(f"{'':33}{line}")
        if len(failure) > 6:
            print(f"{'':33}and {len(failure) - 6} more")
        if options.raytree != "oracle":
            is_gone = not (options.keep or options.truth or options.data)
            again = "  (with --keep FOLDER)" if is_gone else ""
            print(f"{'':25}{' '.join(command(options, case))}{again}")
    elif not options.quiet:
        rays = len(case.truth["rays"])
        error, where = float(report.worst[0]), report.worst[1]
        print(f"{case.name:24}{rays:5}{report.judged:8}{report.skipped:9}  {error:<12.2g}{where}")


if __name__ == "__main__":
    sys.exit(main())
