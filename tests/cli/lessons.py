"""Lessons from outside: listed, shown, checked, and found out when they are changed by hand."""

import json
import shutil

STUDIES = ["time", "hierarchies", "shower", "volumes", "depth", "z_buffer", "crossings", "self_hits",
           "picture"]


def copied(bench, name):
    """A folder of its own with one of the lessons in it."""
    source = bench.data.parent / "lessons" / name
    folder = bench.folder / "changed"
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(source, folder / name)
    return folder


def replace(file, old, new):
    text = file.read_text()
    assert old in text, f"{file}: no {old}"
    file.write_text(text.replace(old, new, 1))


def changed_by_hand(bench):
    check = "lesson check --lessons changed spheres"
    folder = copied(bench, "04-spheres")
    bench.expect("unchanged lesson", check, 0, "all hold", "")

    replace(folder / "04-spheres/balls.json", '"radius": 1,', '"radius": 1.1,')
    bench.expect("changed scene", check, 1, r"\d+ do not hold", r"lesson\.json: /steps/\d+.*does not hold")

    folder = copied(bench, "04-spheres")
    replace(folder / "04-spheres/lesson.json", "{primary.how.b; 3}", "-10.17")
    bench.expect("number typed into a text", check, 2, "", r"/steps/\d+/text/\d+: the number 10\.17 .*typed by hand")

    folder = copied(bench, "04-spheres")
    replace(folder / "04-spheres/lesson.json", "primary.how.b", "primary.how.bb")
    bench.expect("reference to nothing", check, 1, "do not hold", r"/steps/\d+/.*no member 'bb'")

    folder = copied(bench, "04-spheres")
    (folder / "04-spheres/balls.json").unlink()
    bench.expect("scene missing", check, 1, "do not hold", r"/steps/0/show: .*balls\.json")

    replace(folder / "04-spheres/lesson.json", "{", "[")
    bench.expect("no JSON", check, 2, "", r"lesson\.json: line \d+")
    shutil.rmtree(folder)


def studies(bench):
    for what in STUDIES:
        done = bench.run(f"study scene.json {what} --pixel 16,12 --light key --rays 500 --depth-size 16", 60)
        good = done.returncode == 0 and what in json.loads(done.stdout)
        bench.check(f"study {what}", good, done.stderr.decode()[:300])
    for kind in ("spheres", "boxes", "octree", "production"):
        done = bench.run(f"study scene.json traversal --pixel 16,12 --hierarchy {kind}")
        bench.check(f"study traversal {kind}", done.returncode == 0, done.stderr.decode()[:300])
    same = [bench.run("study scene.json shower --light key --rays 2000").stdout for _ in range(2)]
    bench.check("a shower is always the same", same[0] == same[1])
    bench.expect("study an expression", "study scene.json primary.hit.t --pixel 16,12", 0, r'"primary\.hit\.t": \d', "")
    bench.expect("study what there is not", "study scene.json primary.hitt", 2, "", r"no member 'hitt'; did you mean \"hit\"")
    bench.expect("study without a light", "study scene.json shower", 2, "", "which")
    bench.expect("study an unknown light", "study scene.json shower --light kea", 2, "", 'did you mean "key"')
    bench.expect("study outside", "study scene.json primary.id --pixel 999,0", 2, "", "lies outside")
    bench.expect("a depth picture", "study scene.json depth --light key --depth-picture d.png", 0, "stored|compared", "", "d.png")
    bench.expect("a depth picture of no light", "study scene.json time --depth-picture d.png", 2, "", "--light")


def lessons(bench):
    folder = bench.data.parent / "lessons"
    steps = len(json.loads((folder / "04-spheres/lesson.json").read_text())["steps"])
    bench.expect("all lessons hold", f"lesson check --lessons {folder}", 0, "21-.*all hold", "",
                 seconds=120)
    bench.expect("list", f"lesson list --lessons {folder}", 0, r"(?s)01-.*04-spheres.*min.*21-", "")
    bench.expect("show", f"lesson show spheres --lessons {folder}", 0, rf"(?s)1 of {steps}.*Answer: .*{steps} of {steps}", "")
    bench.expect("show a step", f"lesson show 4 --step 3 --lessons {folder}", 0, f"3 of {steps}", "")
    bench.expect("no such step", f"lesson show 4 --step {steps + 1} --lessons {folder}", 2, "", f"1 to {steps}")
    bench.expect("no such lesson", f"lesson show sphere --lessons {folder}", 2, "", 'did you mean "spheres"')
    bench.expect("no such folder", "lesson list --lessons nowhere", 2, "", "nowhere")
    bench.expect("no lessons in it", "lesson list --lessons .", 2, "", "no lessons")
    bench.expect("lesson alone", "lesson", 2, "", "subcommand is required")
    changed_by_hand(bench)
    studies(bench)
