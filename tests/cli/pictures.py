"""What is known of pictures: that they show the trees, for every number of threads; that they are
those of other people's tracers; and what bounds a tree that would grow forever."""

import array
import hashlib
import json
import os
import random
import re
import struct
import subprocess
import sys
import time
from decimal import Decimal, getcontext

getcontext().prec = 50  # more than the reference arithmetic has


def read_pfm(data):
    """width, height, floats from the top left, three for each pixel in colour, else one."""
    kind, size, scale, rest = data.split(b"\n", 3)
    width, height = map(int, size.split())
    assert float(scale) == -1
    channels = {b"PF": 3, b"Pf": 1}[kind]
    floats = array.array("f", rest)
    if sys.byteorder == "big":
        floats.byteswap()
    row = width * channels
    rows = [floats[j * row:(j + 1) * row] for j in range(height)]
    assert len(floats) == row * height
    return width, height, [x for r in reversed(rows) for x in r]


def read_ppm(data):
    kind, size, most, pixels = data.split(b"\n", 3)
    assert kind == b"P6" and most == b"255"
    width, height = map(int, size.split())
    assert len(pixels) == 3 * width * height
    return width, height, pixels


def nearest_float(x):
    return struct.unpack("f", struct.pack("f", x))[0]


def must(bench, name, command, seconds=60):
    done = bench.run(command, seconds)
    return bench.check(name, done.returncode == 0, done.stderr.decode()[:600])


def content(bench, name):
    return (bench.folder / name).read_bytes()


def tree_of(bench, scene, pixel, *options):
    command = ["trace", str(scene), "--pixel", f"{pixel[0]},{pixel[1]}", *options]
    done = bench.run(command, 60)
    return json.loads(done.stdout) if done.returncode == 0 else None


def pictures(bench):
    for scene in sorted((bench.data / "scenes").glob("*.json")):
        if scene.stem != "sphereflake":
            same_for_all_threads(bench, scene)
            shows_its_trees(bench, scene)
    sizes_and_kinds(bench)
    maps(bench)
    error_map(bench)
    converted(bench)
    names_its_scene(bench)


def same_for_all_threads(bench, scene):
    made = []
    for options in ("--threads 1", "--threads 4", "--threads 3 --counts counts.json"):
        if must(bench, f"{scene.stem} {options}",
                f"render '{scene}' -o p.pfm --size 80x60 {options}"):
            made.append(content(bench, "p.pfm"))
    bench.check(f"{scene.stem}: the same on any number of threads, counted or not",
                len(set(made)) == 1)


def shows_its_trees(bench, scene):
    """The picture's pixel is its tree's root intensity, exactly."""
    for precision in ("double", "float"):
        options = ["--size", "80x60", "--precision", precision]
        if not must(bench, f"{scene.stem} in {precision}",
                    ["render", str(scene), "-o", "p.pfm", *options]):
            return
        width, height, floats = read_pfm(content(bench, "p.pfm"))
        chosen = random.Random(scene.stem)
        for _ in range(6):
            i, j = chosen.randrange(width), chosen.randrange(height)
            tree = tree_of(bench, scene, (i, j), *options)
            start = 3 * (j * width + i)
            bench.check(f"{scene.stem}: pixel {i},{j} in {precision} shows its tree",
                        tree and tree["intensity"] == tree["rays"][0]["intensity"] and
                        [nearest_float(x) for x in tree["intensity"]] == floats[start:start + 3])


def sizes_and_kinds(bench):
    """A PPM file holds what the PFM file holds, in 8 bits as the scene says."""
    for scene in ("scene.json", "bright.json", "course.txt"):
        must(bench, scene, f"render {scene} -o p.ppm")
        must(bench, scene, f"render {scene} -o p.pfm")
        width, height, pixels = read_ppm(content(bench, "p.ppm"))
        floats = read_pfm(content(bench, "p.pfm"))[2]
        exact = [255 * min(max(x, 0), 1) for x in floats]
        # A float on the border between two bytes may lie on the other side than its double.
        middle = 0 if scene == "course.txt" else 0.5
        off = max(abs(byte + 0.5 - (x + middle)) for byte, x in zip(pixels, exact))
        bench.check(f"{scene}: size", (width, height) in ((32, 24), (24, 24)))
        bench.check(f"{scene} in 8 bits", off < 0.5001, f"off by {off}")
    must(bench, "PNG", "render scene.json -o p.png")
    bench.check("size of a PNG", content(bench, "p.png")[16:24] == struct.pack(">II", 32, 24))


def maps(bench):
    """The maps' values are those of the trees."""
    for measure in ("rays", "levels", "ended"):
        if not must(bench, measure, f"render scene.json -o m.pfm --map {measure}"):
            continue
        width, height, values = read_pfm(content(bench, "m.pfm"))
        for i, j in ((16, 12), (16, 20), (0, 0), (25, 10)):
            tree = tree_of(bench, "scene.json", (i, j))
            known = {"rays": len(tree["rays"]), "levels": tree["counts"]["levels"],
                     "ended": ended_number(tree)}[measure]
            bench.check(f"map {measure} at {i},{j}", values[j * width + i] == known,
                        f"{values[j * width + i]}, not {known}")
    must(bench, "counts", "render scene.json -o p.png --counts c.json")
    counts = json.loads(content(bench, "c.json"))
    must(bench, "rays", "render scene.json -o m.pfm --map rays")
    rays = sum(counts[kind]["rays"] for kind in ("primary", "reflected", "refracted", "shadow"))
    bench.check("map of rays against counts", sum(read_pfm(content(bench, "m.pfm"))[2]) == rays)


def error_map(bench):
    """Its values are the differences between the trees of the two arithmetics."""
    for precision in ("double", "float"):
        if not must(bench, precision,
                    f"render scene.json -o e.pfm --map error --precision {precision}"):
            continue
        width, height, values = read_pfm(content(bench, "e.pfm"))
        bench.check(f"some pixels have an error in {precision}", max(values) > 0)
        worst = values.index(max(values))
        for place in (worst, 12 * width + 16, 20 * width + 16, 0, 10 * width + 25):
            pixel = (place % width, place // width)
            own, exact = (intensity_of(bench, pixel, p) for p in (precision, "reference"))
            known = max(abs(a - b) for a, b in zip(own, exact))
            bench.check(f"map of errors in {precision} at {pixel}",
                        abs(Decimal(values[place]) - known) <= known * Decimal("1e-6") +
                        Decimal("1e-35"),  # the last digit of what is printed
                        f"{values[place]}, not {known}")
    must(bench, "no errors", "render scene.json -o e.pfm --map error --precision reference")
    bench.check("the reference has no error", max(read_pfm(content(bench, "e.pfm"))[2]) == 0)


def intensity_of(bench, pixel, precision):
    """A pixel's intensity to all its digits; those of float and double are the shortest that read
    back as the same number."""
    must(bench, "tree", ["trace", "scene.json", "--pixel", "%d,%d" % pixel, "-o", "t.json",
                         "--precision", precision])
    read = Decimal if precision == "reference" else lambda text: Decimal(float(text))
    return json.loads(content(bench, "t.json"), parse_float=read, parse_int=read)["intensity"]


def converted(bench):
    """A scene in another format that can say all of it gives the same picture."""
    for scene, other in (("ball.nff", "b.json"), ("course.txt", "c.json"), ("gem.obj", "g.json"),
                         ("scene.json", "s.json"), ("mesh.json", "m.json"), ("b.json", "b.nff")):
        must(bench, f"{scene} to {other}", f"convert {scene} {other} --size 24x16")
        must(bench, scene, f"render {scene} -o 1.pfm --size 24x16")
        must(bench, other, f"render {other} -o 2.pfm")
        bench.check(f"{scene} looks like {other}",
                    content(bench, "1.pfm") == content(bench, "2.pfm"))


def names_its_scene(bench):
    """A tree says which file it is of; with the scene inside, that scene gives the same tree."""
    tree = tree_of(bench, "scene.json", (16, 12), "--embed-scene")
    digest = hashlib.sha256(content(bench, "scene.json")).hexdigest()
    bench.check("the scene's hash", tree["scene"]["sha256"] == digest)
    bench.write("embedded.json", json.dumps(tree["scene"]["document"]))
    again = tree_of(bench, "embedded.json", (16, 12))
    bench.check("the scene inside", again and again["rays"] == tree["rays"])


REASONS = ["light_behind_surface", "surface_unlit", "not_reflective", "not_transmissive",
           "total_internal_reflection", "max_depth", "low_intensity", "ray_budget",
           "no_intersection", "max_distance", "opaque"]


def ended_number(tree):
    """The reason of the weightiest leaf, the first of equals."""
    leaves = [r for r in tree["rays"] if r["kind"] != "shadow" and r["termination"]]
    return REASONS.index(max(leaves, key=lambda r: max(r["weight"]))["termination"])


def costs(bench, name, command, most_seconds, most_megabytes):
    """The command succeeds in so much time and memory."""
    begin = time.perf_counter()
    process = subprocess.Popen([bench.raytree, *command.split()], cwd=bench.folder,
                               stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    # On a busy machine what the program itself has taken tells more than the clock.
    seconds = min(time.perf_counter() - begin, usage.ru_utime + usage.ru_stime)
    megabytes = usage.ru_maxrss / 1024
    bench.check(name, process.returncode == 0, f"exit code {process.returncode}")
    bench.check(f"the cost of {name}",
                bench.slow or (seconds < most_seconds and megabytes < most_megabytes),
                f"{seconds:.1f} s, {megabytes:.0f} MB")


def limits(bench):
    """A hall of mirrors 64 levels deep, two branches each, would have 10^19 rays."""
    costs(bench, "a picture of the hall", "render hall.json -o h.png --counts h.json", 20, 100)
    skipped = json.loads(content(bench, "h.json"))["skipped"]
    bench.check("its picture ends by the budget", skipped["ray_budget"] > 0, str(skipped))
    costs(bench, "a tree of a million rays", "trace hall.json --pixel 1,1 -o /dev/null", 30, 2500)
    tree = tree_of(bench, "small-hall.json", (1, 1))
    reasons = {s["reason"] for r in tree["rays"] for s in r.get("skipped", [])}
    ended = {r.get("termination") for r in tree["rays"]}
    # Shadow rays are always traced, so that the rays on the way may go a little beyond.
    count = len(tree["rays"])
    bench.check("the budget of a small hall", 1000 <= count <= 1000 + 65 * 2, str(count))
    bench.check("its reason", "ray_budget" in reasons & ended, f"{reasons} {ended}")
    done = bench.run("trace small-hall.json --pixel 1,1 --as text")
    bench.check("its outline", re.search(rb"ray_budget", done.stdout), done.stdout[:300])


# By Haines' plain tracer at 513 x 513 and depth 5: reflected, refracted and shadow rays; and the
# primary hits of a tracer by the rules of this project.
NFF_RAYS = {"balls": (263169, 175095, 0, 954368), "mount": (173686, 354769, 354769, 412922),
            "rings": (263169, 315236, 0, 1085002), "tetra": (49950, 0, 0, 46112),
            "tree": (169907, 0, 0, 1097419)}


def shared_data(bench):
    for name, (hits, *others) in NFF_RAYS.items():
        scene = bench.shared / "nff" / f"{name}.nff"
        if not must(bench, name, f"render '{scene}' --size 513x513 -o p.png --counts c.json", 120):
            continue
        counts = json.loads(content(bench, "c.json"))
        found = counts["primary"]["hits"]
        bench.check(f"{name}: primary hits", abs(found - hits) <= 2, f"{found}, not {hits}")
        for kind, expected in zip(("reflected", "refracted", "shadow"), others):
            found = counts[kind]["rays"]
            bench.check(f"{name}: {kind} rays", abs(found - expected) <= 0.015 * expected,
                        f"{found}, not {expected}")
