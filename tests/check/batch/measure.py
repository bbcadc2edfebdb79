"""Time and memory of `raytree check` on many submissions of one pixel.

    python3 measure.py RAYTREE [COUNT…]             default: 1000 and 10000 submissions
    python3 measure.py RAYTREE --wrong [COUNT…]     all of them wrong

Each is the tree of a pixel of nested glass, 31 rays. A third of them are right, a third wrong by a
mistake that differs from one to the next, a third rounded to six digits. With --wrong they have the
mistakes of ../students in turn, all that change something there. Elapsed time, processor time and
the largest memory of the process.
"""

import json
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

SCENE = Path(__file__).resolve().parents[3] / "data" / "scenes" / "nested-media.json"
PIXEL, DEPTH = (241, 206), 6
TRACE = ["--scene", SCENE, "--max-depth", str(DEPTH)]


def rounded(value):
    if isinstance(value, float):
        return float(f"{value:.6g}")
    if isinstance(value, list):
        return [rounded(v) for v in value]
    return {k: rounded(v) for k, v in value.items()} if isinstance(value, dict) else value


def wrong(tree, k):
    """Ambient light left out, intensities too low, or normals the wrong way, in turn."""
    tree = json.loads(json.dumps(tree))
    for ray in tree["rays"]:
        if k % 3 == 0 and "ambient" in ray:
            ray["ambient"] = [0, 0, 0]
        if k % 3 == 1:
            ray["intensity"] = [x * 0.9 for x in ray.get("intensity", [])]
        if k % 3 == 2 and ray.get("hit"):
            ray["hit"]["normal"] = [-x for x in ray["hit"]["normal"]]
    return tree


def of_a_class(tree):
    texts = [json.dumps(t) for t in (tree, *(wrong(tree, k) for k in range(3)), rounded(tree))]
    return [texts[0], texts[1], texts[4], texts[0], texts[2], texts[4], texts[0], texts[3],
            texts[4]]


def all_wrong():
    """A tree for each of the planter's mistakes that changes one."""
    sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "students"))
    import run as planter
    source = planter.read_source(SCENE)
    source.document["settings"]["max_depth"] = DEPTH
    right = planter.grown(source, None, PIXEL)
    trees = [planter.grown(source, plant, PIXEL) for _, plant in planter.mistakes.planted]
    return [json.dumps(t) for t in trees if t and planter.differ(t, right)]


def main():
    raytree = os.path.abspath(sys.argv[1])
    mixed = "--wrong" in sys.argv
    counts = [int(x) for x in sys.argv[2:] if x != "--wrong"] or [1000, 10_000]
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        done = subprocess.run([raytree, "trace", SCENE, "--pixel", "%d,%d" % PIXEL,
                               "--max-depth", str(DEPTH)], capture_output=True, check=True)
        tree = json.loads(done.stdout)
        texts = all_wrong() if mixed else of_a_class(tree)
        for count in counts:
            os.makedirs(f"class{count}")
            for k in range(count):
                Path(f"class{count}", f"{k:06}.json").write_text(texts[k % len(texts)])
            start = time.time()
            run = subprocess.Popen([raytree, "check", f"class{count}", *TRACE, "--as", "json",
                                    "-o", "report.json"])
            _, _, used = os.wait4(run.pid, 0)
            elapsed = time.time() - start
            report = json.loads(Path("report.json").read_text())
            verdicts = [s["verdict"] for s in report["submissions"]]
            print(f"{count} submissions of {len(tree['rays'])} rays: "
                  f"{elapsed:.1f} s elapsed, "
                  f"{used.ru_utime + used.ru_stime:.1f} s of processor time, "
                  f"{used.ru_maxrss / 1024:.0f} MB; {verdicts.count('pass')} pass, "
                  f"{verdicts.count('fail')} fail")


if __name__ == "__main__":
    main()
