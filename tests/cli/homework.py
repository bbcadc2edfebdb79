"""Homework for a class: archives, reports that are merged, rubrics, pictures, assignments."""

import gzip
import io
import json
import os
import shutil
import subprocess
import sys
import tarfile
import time
import xml.dom.minidom
import zipfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "schemas"))
import checking
import validate


def zipped(bench, name, files):
    with zipfile.ZipFile(bench.folder / name, "w", zipfile.ZIP_DEFLATED) as archive:
        for path, text in files.items():
            archive.writestr(path, text)


def tarred(bench, name, files, mode="w:gz"):
    with tarfile.open(bench.folder / name, mode) as archive:
        for path, text in files.items():
            entry = tarfile.TarInfo(path)
            if text is None:
                entry.type, entry.linkname = tarfile.SYMTYPE, "/etc/passwd"
                archive.addfile(entry)
            else:
                entry.size = len(text)
                archive.addfile(entry, io.BytesIO(text.encode()))


class Endless(io.RawIOBase):
    """As many blanks as are asked for."""

    def __init__(self, size):
        self.left = size

    def readable(self):
        return True

    def readinto(self, buffer):
        count = min(self.left, len(buffer))
        buffer[:count] = b" " * count
        self.left -= count
        return count


def bomb(bench, name, size):
    with tarfile.open(bench.folder / name, "w:gz", compresslevel=1) as archive:
        entry = tarfile.TarInfo("bomb.json")
        entry.size = size
        archive.addfile(entry, io.BufferedReader(Endless(size), 1 << 20))


def forged_size(bench, name, size):
    """A tar whose entry says that it is 100 GB large, packed, and whose bytes are not there."""
    entry = tarfile.TarInfo("huge.json")
    entry.size = size
    data = entry.tobuf(format=tarfile.GNU_FORMAT) + b" " * 100_000
    (bench.folder / name).write_bytes(gzip.compress(data))


def report_of(bench, command, code=None):
    done = bench.run(f"check {command} --as json", seconds=10)
    bench.check(f"exit code of check {command}", code is None or done.returncode == code,
                (done.stdout + done.stderr)[:500])
    return json.loads(done.stdout)


def verdicts(report):
    return {s["file"]: s["verdict"] for s in report["submissions"]}


def archives(bench, right, dark):
    zipped(bench, "class.zip", {"b/dark.json": dark, "a/right.json": right, "notes.txt": "x",
                                "__MACOSX/a/._right.json": "Mac", "a/.right.json": "{",
                                "../out.json": right})
    tarred(bench, "class.tar.gz", {"right.json": right, "link.json": None, "/abs.json": right})
    tarred(bench, "class.tar", {"right.json": right}, "w")
    (bench.folder / "cut.zip").write_bytes((bench.folder / "class.zip").read_bytes()[:200])
    (bench.folder / "none.tar.gz").write_bytes(b"not an archive")
    bench.check("zip", verdicts(report_of(bench, "class.zip --scene scene.json", 1)) == {
        "class.zip/../out.json": "unreadable", "class.zip/a/right.json": "pass",
        "class.zip/b/dark.json": "fail"})
    bench.check("tar.gz", verdicts(report_of(bench, "class.tar.gz --scene scene.json", 1)) == {
        "class.tar.gz//abs.json": "unreadable", "class.tar.gz/link.json": "unreadable",
        "class.tar.gz/right.json": "pass"})
    bench.check("tar", verdicts(report_of(bench, "class.tar --scene scene.json", 0)) == {
        "class.tar/right.json": "pass"})
    zipped(bench, "notes.zip", {"notes.txt": "x"})
    (bench.folder / "zeros.tar.gz").write_bytes(gzip.compress(bytes(1 << 20)))
    for name in ("notes.zip", "zeros.tar.gz"):
        bench.expect(name, f"check {name} --scene scene.json", 1, r"unreadable\n.*has no trees", "")
    for name in ("cut.zip", "none.tar.gz"):
        bench.expect(name, f"check {name} --scene scene.json", 1, r"unreadable", "")
    bomb(bench, "bomb.tar.gz", 200 << 20)
    forged_size(bench, "forged.tar.gz", 100 << 30)
    zipped(bench, "wide.zip", {f"{k}.json": " " * (15 << 20) for k in range(40)})
    zipped(bench, "many.zip", {f"{k}.txt": "" for k in range(20_100)})
    for name, words in (("bomb.tar.gz", "unpacks to more"), ("wide.zip", "unpacks to more"),
                        ("forged.tar.gz", "unpacks to more"),
                        ("many.zip", "more than 20000 entries")):
        started = time.monotonic()
        bench.expect(name, f"check {name} --scene scene.json", 1, rf"(?s)unreadable.*{words}", "")
        bench.check(f"{name} within 10 s", bench.slow or time.monotonic() - started < 10)


def alike(bench, right):
    """A class packs well: many small trees that are much alike are no bomb."""
    many = {f"{k:05}.json": right.rstrip()[:-1] + " " * 900_000 + "}" for k in range(60)}
    tarred(bench, "alike.tar.gz", many)
    size = (bench.folder / "alike.tar.gz").stat().st_size
    unpacked = sum(map(len, many.values()))
    bench.check("a class that packs well", unpacked > (32 << 20) + 50 * size, (size, unpacked))
    report = report_of(bench, "alike.tar.gz --scene scene.json", 0)
    bench.check("all of a class that packs well", len(report["submissions"]) == 60)


def links(bench, right):
    """Links in a folder are not followed out of it."""
    folder, outside = bench.folder / "linked", bench.folder / "outside"
    for path in (folder / "inside", outside):
        path.mkdir(parents=True)
        (path / "tree.json").write_text(right)
    (folder / "alias.json").symlink_to("inside/tree.json")
    (folder / "far.json").symlink_to(outside / "tree.json")
    (folder / "none.json").symlink_to("nowhere.json")
    (folder / "loop").symlink_to(folder)
    (folder / "other").symlink_to(outside)
    (folder / "notes.txt").symlink_to("/etc/passwd")
    report = report_of(bench, "linked --scene scene.json", 1)
    bench.check("links in a folder", verdicts(report) == {
        "linked/alias.json": "pass", "linked/inside/tree.json": "pass",
        "linked/far.json": "unreadable", "linked/none.json": "unreadable",
        "linked/loop": "unreadable", "linked/other": "unreadable"}, verdicts(report))
    said = {s["file"]: s["findings"][0]["text"] for s in report["submissions"] if s["findings"]}
    bench.check("what is said of links", "not in the folder" in said["linked/far.json"]
                and "link to a folder" in said["linked/loop"], said)
    bench.expect("a link that is named itself", "check linked/far.json --scene scene.json", 0,
                 "pass", "")


def merging(bench, right, dark):
    folder = bench.folder / "all"
    folder.mkdir()
    names = ["a.json", "b.json", "c.json", "d.json"]
    for name, text in zip(names, (right, dark, "{", dark)):
        (folder / name).write_text(text)
    formats = ("json", "text", "csv", "junit", "gradescope")
    single = {form: bench.run(f"check all --scene scene.json --as {form}").stdout
              for form in formats}
    for k, name in enumerate(names):
        bench.run(f"check all/{name} --scene scene.json --as json -o part{k}.json")
    for form in formats:
        merged = bench.run(f"check --merge part3.json part1.json part0.json part2.json --as {form}")
        bench.check(f"merged {form} as of one run", merged.stdout == single[form]
                    and merged.returncode == 1, merged.stderr)
    named = bench.run("check --merge part0.json part1.json --anonymous --as csv").stdout
    bench.check("anonymous when merged", b"a.json" not in named and b"submission-00002" in named,
                named)
    bench.write("forged.json", json.dumps({
        "format": "raytree-report/1.0",
        "submissions": [{"file": "=1", "verdict": "fail", "profile": "=2,3",
                         "mistakes": [{"id": "@x,\"y"}]}]}))
    row = bench.run("check --merge forged.json --as csv").stdout.decode().splitlines()[1]
    bench.check("words of a report that is read are no formulas",
                row.startswith("\"'=1\",fail,0,,\"'=2,3\",") and ",\"'@x,\"\"y\"," in row, row)
    bench.expect("merging what is no report", "check --merge all/a.json", 2, "", r"raytree-report")
    bench.expect("merging by a scene", "check --merge part0.json --scene scene.json", 2, "",
                 r"takes no scene")
    for form in formats:
        hidden = bench.run(f"check all --scene scene.json --anonymous --as {form}").stdout
        bench.check(f"anonymous {form}", b"a.json" not in hidden and b"submission-00004" in hidden,
                    hidden[:400])
    again = bench.run("check all/d.json all/c.json all/a.json all/b.json --scene scene.json")
    bench.check("in any order the same", again.stdout == single["text"], again.stdout)


def batches(bench):
    """A process for each file, by either of the two scripts, gives the report of one run."""
    scripts = Path(__file__).resolve().parents[1] / "check" / "batch"
    one = bench.run("check all --scene scene.json --as json").stdout
    tools = {**os.environ, "PATH": f"{bench.raytree.parent}:{os.environ['PATH']}"}

    def script(name, *words, **more):
        return subprocess.run([scripts / name, *words], cwd=bench.folder, capture_output=True,
                              env={**tools, **more}, timeout=60)

    files = sorted(f"all/{p.name}" for p in (bench.folder / "all").iterdir())
    bench.write("files.txt", "".join(f"{name}\n" for name in files))
    for task in range(1, len(files) + 1):
        done = script("slurm_array.sh", "files.txt", "scene.json", "parts",
                      SLURM_ARRAY_TASK_ID=str(task))
        bench.check(f"task {task} of an array", done.returncode == 0, done.stderr)
    bench.expect("joining a folder of parts", "check --merge parts --as json -o array.json", 1, "",
                 "", "array.json")
    bench.run("check --merge parts --as json -o array.json")
    bench.check("an array of tasks gives the report of one run",
                (bench.folder / "array.json").read_bytes() == one)
    if not shutil.which("parallel"):
        print("skipped: GNU parallel is not on this machine")
        return
    done = script("parallel.sh", "all", "scene.json", "parallel report.json")
    bench.check("GNU parallel gives the report of one run", done.returncode == 0
                and (bench.folder / "parallel report.json").read_bytes() == one, done.stderr)


RUBRIC = {"format": "raytree-rubric/1.0", "total": 20, "quantities": {"ambient": 4, "t": 0},
          "kinds": {"shadow": 0.5}, "levels": {"1": 2}}
BAD_RUBRICS = [({"quantities": {"ambiant": 1}}, r"/quantities/ambiant.*ambient"),
               ({"total": -1}, r"/total.*0 or more"), ({"levels": {"0": 1}}, r"/levels/0"),
               ({"kinds": 3}, r"/kinds"), ({"points": 3}, r"/points")]


def rubrics(bench, dark):
    bench.write("dark.json", dark)
    bench.write("rubric.json", json.dumps(RUBRIC))
    report = report_of(bench, "dark.json --scene scene.json --rubric rubric.json", 1)
    points = report["submissions"][0]["points"]
    rows = points["rows"]
    lost = [row for row in rows if row["right"] < row["compared"]]
    due = 20 * sum(row["points"] for row in rows) / sum(row["of"] for row in rows)
    bench.check("points", points["total"] == 20 and abs(points["earned"] - due) < 1e-9
                and 0 < points["earned"] < 20, points)
    bench.check("points are lost where it is wrong",
                lost and {row["quantity"] for row in lost} == {"ambient"}
                and all(row["of"] == 4 * row["compared"] * (2 if row["level"] == 1 else 1)
                        for row in lost), lost)
    whole = report_of(bench, "right.json --scene scene.json --rubric rubric.json", 0)
    bench.check("all points", whole["submissions"][0]["points"]["earned"] == 20)
    for extra, message in BAD_RUBRICS:
        bench.write("bad-rubric.json", json.dumps({"format": "raytree-rubric/1.0", **extra}))
        bench.expect(f"rubric {extra}",
                     "check right.json --scene scene.json --rubric bad-rubric.json", 2, "", message)


def rendered(bench):
    bench.run("render scene.json -o true.ppm")
    bench.expect("a true picture", "check true.ppm --scene scene.json", 0, r": pass, \d+ pixels", "")
    data = (bench.folder / "true.ppm").read_bytes()
    head = data.index(b"255\n") + 4
    width = 32
    rows = [data[head + 3 * width * j:head + 3 * width * (j + 1)] for j in range(24)]
    (bench.folder / "flipped.ppm").write_bytes(data[:head] + b"".join(reversed(rows)))
    bench.expect("a picture on its head", "check flipped.ppm --scene scene.json --profile lecture",
                 1, r"(?s)rows=up.*\d+ of 768 differ", "")
    bench.expect("a picture of another size", "check true.ppm --scene scene.json --size 16x12", 1,
                 r"unreadable", "")


def drawings(bench):
    """Each tree over the true one, with names that lead nowhere else."""
    with zipfile.ZipFile(bench.folder / "odd.zip", "w") as archive:
        archive.writestr("a b<&>\".json", (bench.folder / "dark.json").read_bytes())
        archive.writestr("a b____.json", (bench.folder / "right.json").read_bytes())
        archive.writestr("c.json", b"{")
    bench.run("check odd.zip dark.json --scene scene.json --picture drawn")
    files = sorted(p.name for p in (bench.folder / "drawn").iterdir())
    bench.check("a drawing for each tree", files == [
        "dark.svg", "odd.zip_a_b____-2.svg", "odd.zip_a_b____.svg"], files)
    for file in (bench.folder / "drawn").iterdir():
        xml.dom.minidom.parseString(file.read_bytes())
    drawn = (bench.folder / "drawn" / "dark.svg").read_text()
    bench.check("what differs is drawn", "ambient is (0, 0, 0)" in drawn and "must be" in drawn
                and ">different<" in drawn and ">follows<" in drawn, drawn[:500])
    bench.expect("no folder for drawings", "check dark.json --scene scene.json --picture scene.json",
                 2, "", r"scene\.json.*cannot be made")


TEMPLATE = {"format": "raytree-assignment/1.0", "pixels": 2, "scene": {
    "format": "raytree-scene/1.0",
    "camera": {"eye": [0, 0, 5], "look_at": [0, 0, 0], "width": 40, "height": 30,
               "image_plane": [-0.4, 0.5, -0.3, 0.4]},
    "lights": [{"type": "point", "position": [{"from": 1, "to": 3, "step": 0.5}, 4, 4]}],
    "objects": [{"type": "sphere", "center": [0, 0, 0], "radius": {"from": 0.8, "to": 1.2},
                 "material": {"kd": 0.5, "ks": 0.3, "shininess": {"one_of": [3, 5]}}}]}}


def bad_templates():
    def changed(**scene):
        return {**TEMPLATE, "scene": {**TEMPLATE["scene"], **scene}}
    yield changed(ambient={"from": 2, "to": 1}), r"/scene/ambient.*from must not be above"
    yield changed(ambient={"from": 0, "to": 1, "step": 0}), r"/scene/ambient/step"
    yield changed(ambient={"from": 0}), r"/scene/ambient/to"
    yield changed(ambient={"one_of": []}), r"/scene/ambient/one_of"
    yield changed(lihgts=[]), r"/scene/lihgts.*lights"
    yield changed(background={"from": 1, "to": 2, "stepp": 1}), r"/scene/background/stepp"
    yield {**TEMPLATE, "pixels": 0}, r"/pixels"
    yield {**TEMPLATE, "exposes": ["nothing."]}, r"/exposes"
    yield {"format": "raytree-assignment/1.0"}, r"/scene"


def files_of(folder):
    return {p.relative_to(folder): p.read_bytes() for p in sorted(folder.rglob("*")) if p.is_file()}


def assignments(bench):
    bench.write("template.json", json.dumps(TEMPLATE))
    for name, seed in (("one", 7), ("two", 7), ("three", 8)):
        done = bench.run(f"assign template.json --seed {seed} --count 3 -o {name}")
        bench.check(f"assign {name}", done.returncode == 0 and not done.stderr, done.stderr)
    one, two, three = (files_of(bench.folder / name) for name in ("one", "two", "three"))
    bench.check("same seed, same bytes", one == two and one != three)
    scenes = {bytes for path, bytes in one.items() if path.name == "scene.json"}
    bench.check("variants differ", len(scenes) == 3)
    bench.check("no answers in the handout",
                {p.name for p in one if p.parts[0] == "handout"}
                == {"scene.json", "pixels.json", "task.md"})
    for k in ("01", "02", "03"):
        task = json.loads(one[Path("handout", k, "pixels.json")])
        for i, j in task["pixels"]:
            bench.expect("the key is right",
                         f"check one/key/{k}/{i},{j}.json --scene one/handout/{k}/scene.json",
                         0, ": pass", "")
    for bad, message in bad_templates():
        bench.write("bad-template.json", json.dumps(bad))
        bench.expect(f"bad template {message}", "assign bad-template.json -o four", 2, "", message)
    for name in ("ray-casting", "shadows", "mirrors", "glass"):
        done = bench.run(["assign", str(bench.data / "assignments" / f"{name}.json"), "--seed", "3",
                          "-o", name])
        key = json.loads((bench.folder / name / "key" / "01" / "key.json").read_text())
        bench.check(f"ready assignment {name}", done.returncode == 0
                    and key["exposed"] >= 0.8 * key["mistakes"], done.stderr)
        bench.check(f"{name} hides nothing by symmetry", not done.stderr, done.stderr)


def schemas(bench):
    validators = validate.load_validators(bench.data / "schemas")
    for command in ("all --scene scene.json", "true.ppm flipped.ppm --scene scene.json",
                    "dark.json --scene scene.json --rubric rubric.json --suggest-pixels",
                    "right.json --scene scene.json --profile ucla", "class.zip --scene scene.json"):
        report = report_of(bench, command)
        errors = [error.message for error in validators[report["format"]].iter_errors(report)]
        bench.check(f"the report's schema: check {command}", not errors, errors[:3])
    for name, document in (("rubric", RUBRIC), ("template", TEMPLATE)):
        errors = list(validators[document["format"]].iter_errors(document))
        bench.check(f"the schema of a {name}", not errors, errors[:2])
    for bad, _ in BAD_RUBRICS:
        document = {"format": "raytree-rubric/1.0", **bad}
        bench.check(f"the schema refuses {bad}",
                    not validators["raytree-rubric/1.0"].is_valid(document))


def homework(bench):
    right = json.dumps(checking.tree(bench))
    dark = json.dumps(checking.without_ambient(checking.tree(bench)))
    bench.write("right.json", right)
    archives(bench, right, dark)
    alike(bench, right)
    links(bench, right)
    merging(bench, right, dark)
    batches(bench)
    rubrics(bench, dark)
    rendered(bench)
    drawings(bench)
    assignments(bench)
    schemas(bench)
    table = bench.data.parent / "lib" / "check" / "CATALOGUE.md"
    made = bench.run("check --catalogue").stdout
    bench.check("CATALOGUE.md is current (raytree check --catalogue > lib/check/CATALOGUE.md)",
                made.count(b"\n| `") > 200 and made == table.read_bytes())
