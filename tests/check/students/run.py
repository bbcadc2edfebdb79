"""Plants mistakes into an independent tracer and holds what `raytree check` names against them.

    python3 run.py RAYTREE                        the assignments' scenes and a few others
    python3 run.py RAYTREE --quick                a sample, for CI
    python3 run.py RAYTREE --log                  and every case that is not named
    python3 run.py RAYTREE --unknown              mistakes that the catalogue does not have
    python3 run.py RAYTREE --matrix FILE          what was named for what was planted, as JSON;
                                                  draw_matrix.py makes a picture of it

Exit 0: of the cases in which a mistake changes a number at least 98 % are found and 90 % named
first, none is named wrongly with "sure", and every right tree passes.
"""

import argparse
import collections
import json
import math
import os
import random
import struct
import subprocess
import sys
import tempfile
from pathlib import Path

from student import Student, TooLarge

import mistakes  # after student, which says where the oracle is
import more_mistakes  # noqa: F401 - adds to those of mistakes.py
import unknown
from reader import read_source

DATA = Path(__file__).resolve().parents[3] / "data"

# Scenes besides the assignments' variants, with pixels where much happens.
OTHERS = {
    "glass-ball": [(210, 286), (320, 250)],
    "air-bubble": [(332, 240)],
    "ellipsoids": [(90, 462), (300, 240)],
    "nested-media": [(375, 273)],
    "prism": [(195, 205)],
    "cut-open": [(150, 240)],
    "mirrors-facing": [(485, 165)],
}

UNSEEN = ("id", "parent", "skipped", "termination", "children", "level", "weight")


def only(document, *keys, hit=("object", "t")):
    rays = []
    for ray in document["rays"]:
        kept = {key: ray[key] for key in ("kind", "id", "parent", *keys) if key in ray}
        if kept.get("hit"):
            kept["hit"] = {key: kept["hit"][key] for key in hit}
        rays.append(kept)
    return {**document, "rays": rays}


def without_shadow_rays(document):
    return {**document, "rays": [ray for ray in document["rays"] if ray["kind"] != "shadow"]}


def colours(document):
    """Origin, direction, t, object and the colour of every ray."""
    return only(without_shadow_rays(document), "origin", "direction", "hit", "intensity")


def positions(document):
    return only(without_shadow_rays(document), "origin", "direction", "hit")


def intensities(document):
    return only(without_shadow_rays(document), "intensity")


def stretch(ray, factor):
    """A direction of another length; t is in its units."""
    ray["direction"] = ray["direction"] and [factor * x for x in ray["direction"]]
    for part in (ray.get("hit"), ray.get("blocked_by")):
        if part:
            part["t"] /= factor


def bare(document):
    """What a small program prints: rays in one another, words for ids, a parameter for t."""
    document = json.loads(json.dumps(colours(document)))
    rays = document["rays"]
    for ray in rays:
        stretch(ray, 0.3 + 0.7 * (ray["id"] % 5))
        ray["children"] = [c for c in rays if c.get("parent") == ray["id"]]
    for ray in rays:
        ray["id"] = f"ray-{ray['id']}"
        ray.pop("parent", None)
    return rounded({**document, "rays": rays[:1]}, 9)


def nested(document):
    """Rays in one another, without ids, directions of another length, in reverse order."""
    rays = json.loads(json.dumps(document["rays"]))
    for ray in rays:
        stretch(ray, 2.5)
        ray["children"] = [c for c in rays if c["parent"] == ray["id"]][::-1]
    for ray in rays:
        for key in ("id", "parent", "level"):
            del ray[key]
    return {**document, "rays": rays[:1]}


def in_float(value):
    """Every number rounded to float."""
    if isinstance(value, float):
        return struct.unpack("f", struct.pack("f", value))[0]
    if isinstance(value, dict):
        return {k: in_float(v) for k, v in value.items()}
    if isinstance(value, (list, tuple)):
        return [in_float(v) for v in value]
    return value


def six_digits(document):
    return rounded(document, 6)


def rounded(value, digits):
    if isinstance(value, float):
        return float(f"%.{digits}g" % value)
    if isinstance(value, dict):
        return {k: rounded(v, digits) for k, v in value.items()}
    if isinstance(value, (list, tuple)):
        return [rounded(v, digits) for v in value]
    return value


FORMS = {
    "everything": lambda d: d,
    "float": in_float,
    "six digits": six_digits,
    "colours": colours,
    "colours, six digits": lambda d: six_digits(colours(d)),
    "nested": nested,
    "bare": bare,
    "positions": positions,
    "intensities": intensities,
}


def numbers(value):
    if isinstance(value, bool) or value is None or isinstance(value, str):
        yield value
    elif isinstance(value, (int, float)):
        yield value
    elif isinstance(value, dict):
        for key in sorted(value):
            yield key
            yield from numbers(value[key])
    else:
        for item in value:
            yield from numbers(item)


def comparable(document):
    """Without names of rays, and without shadow rays that add nothing, blocked ones too: a program
    may ask lights behind the surface."""
    rays = []
    for ray in document["rays"]:
        idle = ray["kind"] == "shadow" and max(
            map(abs, (*ray.get("diffuse", [1]), *ray.get("specular", [1])))) < 1e-6
        if not idle:
            rays.append({k: v for k, v in ray.items() if k not in UNSEEN})
    return list(numbers(rays))


def differ(a, b):
    a, b = comparable(a), comparable(b)
    if len(a) != len(b):
        return True
    for x, y in zip(a, b):
        if isinstance(x, (int, float)) and isinstance(y, (int, float)):
            if not math.isclose(x, y, rel_tol=1e-4, abs_tol=1e-5):
                return True
        elif x != y:
            return True
    return False


def finite(document):
    return all(math.isfinite(x) for x in numbers(document) if isinstance(x, (int, float)))


def without_nan(value):
    """Directions that are no numbers are null, as in the languages that print them so."""
    if isinstance(value, dict):
        return {k: None if k == "direction" and math.isnan(v[0]) else without_nan(v)
                for k, v in value.items()}
    return [without_nan(v) for v in value] if isinstance(value, (list, tuple)) else value


def grown(source, plant, pixel):
    """The tree, or none where the program never ends or fails."""
    try:
        document = Student(source, plant).tree(*pixel)
        document = json.loads(json.dumps(without_nan(document)))
    except (TooLarge, ZeroDivisionError, OverflowError, ValueError, RecursionError, IndexError):
        return None
    return document if finite(document) else None


class Table:
    def __init__(self):
        self.rows = collections.defaultdict(collections.Counter)
        self.named, self.tied = collections.Counter(), collections.Counter()
        self.log = []

    def judge(self, name, report, where):
        row = self.rows[name]
        row["changed"] += 1
        named = report["mistakes"]
        fits = [m for m in named if name == m["id"] or name in m["ties"]]
        row["found"] += report["verdict"] == "fail"
        row["named"] += bool(fits)
        top = named[0] if named else None
        row["first"] += top is not None and top in fits
        row["alone"] += top is not None and top["id"] == name and not top["ties"]
        wrong = bool(top and top["sure"] and top not in fits)
        row["wrong and sure"] += wrong
        key = (name, top["id"] if top else "nothing")
        self.named[key] += 1
        self.tied[key] += bool(fits) and top in fits
        if not fits or wrong or top not in fits:
            what = "; ".join(f"{m['id']}{' SURE' if m['sure'] else ''} ties {m['ties']}"
                             for m in named)
            first = [f["text"][:150] for f in report["findings"] if f["follows_from"] is None][:2]
            self.log.append(f"{name} at {where}: {report['verdict']}, {report['profile']}, "
                            f"{what or 'not named'} | {first}")

    def total(self):
        total = collections.Counter()
        for row in self.rows.values():
            total.update(row)
        return total


def checked(raytree, scene, folder, options=()):
    done = subprocess.run([raytree, "check", folder, "--scene", scene, "--as", "json", *options],
                          capture_output=True)
    if done.returncode not in (0, 1):
        raise SystemExit(f"raytree check {scene}: {done.returncode} {done.stderr.decode()}")
    reports = json.loads(done.stdout)["submissions"]
    return {Path(report["file"]).stem: report for report in reports}


def spots(raytree, folder, seed, quick):
    """(name, scene file, pixels)."""
    for name in ("ray-casting", "shadows", "mirrors", "glass"):
        target = folder / name
        subprocess.run([raytree, "assign", DATA / "assignments" / f"{name}.json", "--seed",
                        str(seed), "-o", target], check=True)
        handout = target / "handout" / "01"
        pixels = json.loads((handout / "pixels.json").read_text())["pixels"]
        yield name, handout / "scene.json", [tuple(p) for p in pixels[:1 if quick else 2]]
    for name, pixels in () if quick else OTHERS.items():
        yield name, DATA / "scenes" / f"{name}.json", pixels


def plant_all(raytree, spot, forms, tables, correct, options, planted):
    """All mistakes at the pixels of a scene, each tree grown once and handed in in every form."""
    name, scene, pixels = spot
    source = read_source(scene)
    trees = []  # (key, mistake or None, tree, right tree)
    for pixel in pixels:
        right = grown(source, None, pixel)
        trees.append((f"right-{pixel[0]}-{pixel[1]}", None, right, right))
        for k, (mistake, plant) in enumerate(planted):
            wrong = grown(source, plant, pixel)
            if wrong is not None:
                trees.append((f"{k}-{pixel[0]}-{pixel[1]}", mistake, wrong, right))
    for form in forms:
        seen = FORMS[{"nested": "everything", "bare": "colours"}.get(form, form)]
        with tempfile.TemporaryDirectory() as folder:
            cases = {}
            for key, mistake, tree, right in trees:
                if mistake is None or differ(seen(tree), seen(right)):
                    cases[key] = mistake
                    Path(folder, key + ".json").write_text(json.dumps(FORMS[form](tree)))
            reports = checked(raytree, scene, folder, options)
        for key, mistake in cases.items():
            where = f"{name} {key.partition('-')[2]} ({form})"
            if mistake:
                tables[form].judge(mistake, reports[key], where)
            else:
                correct[form].append((where, reports[key]["verdict"], reports[key]["profile"]))


def plant_pairs(raytree, spot, wanted, seed, options, log=False):
    """Two mistakes at once: (both named, one, none)."""
    name, scene, pixels = spot
    source, rng = read_source(scene), random.Random(seed)
    pixel = pixels[0]
    right = grown(source, None, pixel)
    alone = {}
    for k, (mistake, plant) in enumerate(mistakes.planted):
        tree = grown(source, plant, pixel)
        if tree and differ(tree, right):
            alone[k] = tree
    result, cases = collections.Counter(), {}
    with tempfile.TemporaryDirectory() as folder:
        for _ in range(40 * wanted):
            if len(cases) >= wanted or len(alone) < 2:
                break
            a, b = rng.sample(sorted(alone), 2)
            (one, plant), (other, also) = mistakes.planted[a], mistakes.planted[b]

            def both(s):
                plant(s)
                also(s)

            tree = grown(source, both, pixel)
            if one == other or tree is None or any(not differ(tree, alone[k]) for k in (a, b)):
                continue
            if not differ(tree, right):
                continue
            cases[f"{a}-{b}"] = (one, other)
            Path(folder, f"{a}-{b}.json").write_text(json.dumps(tree))
        reports = checked(raytree, scene, folder, options) if cases else {}
    for key, names in cases.items():
        said = {x for m in reports[key]["mistakes"] for x in (m["id"], *m["ties"])}
        result[sum(n in said for n in names)] += 1
        wrong = [m["id"] for m in reports[key]["mistakes"]
                 if m["sure"] and not set(names) & {m["id"], *m["ties"]}]
        result["wrong and sure"] += bool(wrong)
        if sum(n in said for n in names) < 2 and log:
            print(f"  pair {names} at {name} {pixel}: {sorted(said)} {'SURE' if wrong else ''}")
    return result


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("raytree")
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--log", action="store_true")
    parser.add_argument("--seed", type=int, default=11)
    parser.add_argument("--form", choices=FORMS, action="append")
    parser.add_argument("--scenes", default="")
    parser.add_argument("--matrix")
    parser.add_argument("--unknown", action="store_true")
    parser.add_argument("--pairs", type=int, default=20, help="in each scene")
    parser.add_argument("--profile", default="lecture")
    arguments = parser.parse_args()
    options = ["--profile", arguments.profile] if arguments.profile != "none" else []
    fine = True
    matrix = {}
    with tempfile.TemporaryDirectory() as folder:
        every = list(spots(arguments.raytree, Path(folder), arguments.seed, arguments.quick))
        if arguments.scenes:
            every = [s for s in every if s[0] in arguments.scenes.split(",")]
        forms = arguments.form or (["everything"] if arguments.quick else list(FORMS))
        tables = {form: Table() for form in forms}
        correct = {form: [] for form in forms}
        for spot in every:
            plant_all(arguments.raytree, spot, forms, tables, correct, options,
                      unknown.planted if arguments.unknown else mistakes.planted)
        for form in forms:
            table, total = tables[form], tables[form].total()
            wrong = [c for c in correct[form] if c[1] != "pass"]
            print(f"{form}: {len(table.rows)} mistakes, {total['changed']} cases, found "
                  f"{total['found']}, named {total['named']}, first {total['first']}, alone "
                  f"{total['alone']}, wrong and sure {total['wrong and sure']}; "
                  f"right trees {len(correct[form])}, called wrong {len(wrong)}", flush=True)
            for line in wrong:
                print("  right but:", line)
            if arguments.log:
                for line in table.log:
                    print("  " + line)
            matrix[form] = [[a, b, n, table.tied[a, b]]
                            for (a, b), n in sorted(table.named.items())]
            # What only shades leaves no trace in positions; what nobody knows has no name.
            few = form == "positions" or arguments.unknown
            fine = fine and not wrong and total["wrong and sure"] == 0 and (
                few or (total["found"] >= 0.98 * total["changed"]
                        and total["first"] >= 0.9 * total["changed"]))
        pairs = collections.Counter()
        pairs_wanted = 0 if arguments.unknown else arguments.pairs
        for k, spot in enumerate(every if pairs_wanted else []):
            pairs.update(plant_pairs(arguments.raytree, spot, pairs_wanted, k, options,
                                     arguments.log))
        if pairs_wanted:
            tried = sum(pairs[n] for n in (0, 1, 2))
            print(f"pairs: {tried}; both named {pairs[2]}, one {pairs[1]}, none {pairs[0]}; "
                  f"wrong and sure {pairs['wrong and sure']}")
            fine = fine and 2 * pairs[2] >= tried
    if arguments.matrix:
        Path(arguments.matrix).write_text(json.dumps(matrix))
    return 0 if fine else 1


if __name__ == "__main__":
    sys.exit(main())
