"""Homework: what raytree check says of right, wrong and hostile submissions."""

import csv
import io
import json
import unicodedata
import xml.dom.minidom

PIXEL = "16,12"


def tree(bench):
    return json.loads(bench.run(f"trace scene.json --pixel {PIXEL} --embed-scene").stdout)


def nested(document):
    """The same tree with rays in one another, and little more than numbers."""
    rays = document["rays"]
    for ray in rays:
        ray["children"] = [child for child in rays if child.get("parent") == ray["id"]]
    for ray in rays:
        for key in ("id", "parent", "level", "weight"):
            ray.pop(key, None)
    return {"format": "raytree/1.0", "pixel": document["pixel"], "rays": [rays[0]]}


def stretched(document):
    """Directions of length 3, t in their units, rays in another order."""
    for ray in document["rays"]:
        ray["direction"] = [3 * x for x in ray["direction"]]
        if ray.get("hit"):
            ray["hit"]["t"] /= 3
        if ray.get("blocked_by"):
            ray["blocked_by"]["t"] /= 3
    document["rays"].reverse()
    return document


def without_ambient(document):
    for ray in document["rays"]:
        if "ambient" in ray:
            ray["ambient"] = [0, 0, 0]
    return document


def without_a_ray(document):
    gone = next(r["id"] for r in document["rays"] if r["kind"] == "reflected")
    document["rays"] = [r for r in document["rays"] if gone not in (r["id"], r["parent"])]
    ids = {r["id"] for r in document["rays"]}
    document["rays"] = [r for r in document["rays"] if r["parent"] is None or r["parent"] in ids]
    return document


def crowded(document, rays=200_000):
    """A primary ray with more children than any tree has."""
    primary = document["rays"][0]
    children = [{"id": f"c{k}", "parent": primary["id"], "kind": "reflected"} for k in range(rays)]
    return {**document, "rays": [primary, *children]}


def bushy(document, rays=1 << 15):
    """Every ray with both branches, all of them with numbers that are wrong."""
    wrong = {"intensity": [3, 1, 4], "direction": [0, 1, 0.5]}
    kinds = ["refracted", "reflected"]
    branches = [{"id": k, "parent": (k - 1) // 2, "kind": kinds[k % 2], **wrong}
                for k in range(1, rays)]
    return {**document, "rays": [{"id": 0, "kind": "primary", **wrong}, *branches]}


def filled(bench, *keys):
    """The template of the tree with some of its numbers filled in, as the tree has them."""
    document = json.loads(bench.run(f"trace scene.json --pixel {PIXEL} --template").stdout)
    for empty, full in zip(document["rays"], tree(bench)["rays"]):
        for key in keys:
            if key in empty:
                empty[key] = full[key]
            elif key in empty.get("hit", {}):
                empty["hit"][key] = full["hit"][key]
    return document


def wrongly_filled(bench):
    document = filled(bench, "origin", "t")
    document["rays"][0]["hit"]["t"] = 1
    return document


def inputs(bench):
    (bench.folder / "class").mkdir()
    bench.write("right.json", json.dumps(tree(bench)))
    bench.write("nested.json", json.dumps(nested(tree(bench))))
    bench.write("stretched.json", json.dumps(stretched(tree(bench))))
    bench.write("dark.json", json.dumps(without_ambient(tree(bench))))
    bench.write("missing.json", json.dumps(without_a_ray(tree(bench))))
    bench.write("empty.json", json.dumps(filled(bench)))
    bench.write("partly.json", json.dumps(filled(bench, "origin", "t", "intensity")))
    bench.write("partly-wrong.json", json.dumps(wrongly_filled(bench)))
    bench.write("cut.json", json.dumps(tree(bench))[:500])
    bench.write("crowded.json", json.dumps(crowded(tree(bench))))
    bench.write("bushy.json", json.dumps(bushy(tree(bench))))
    bench.write("class/=cmd|' \"x.json", "{}")
    bench.write("class/<b>&.json", json.dumps(without_ambient(tree(bench))))
    bench.write("class/right.json", json.dumps(tree(bench)))


CASES = [
    ("right", "right.json --scene scene.json", 0, r"^right\.json: pass, \d+ rays"),
    ("by a reference", "right.json --reference right.json", 0, r": pass"),
    ("nested, partial", "nested.json --scene scene.json", 0, r"(?s): pass.*not given by any ray.*weight"),
    ("not unit, reversed", "stretched.json --scene scene.json", 0, r": pass"),
    ("required", "nested.json --scene scene.json --require weight", 1, r"weight.*required"),
    ("a mistake", "dark.json --scene scene.json", 1, r"(?s): fail.*lit\.ambient_missing"),
    ("a missing ray", "missing.json --scene scene.json", 1, r"(?s): fail.*lacks its reflected ray"),
    ("a template as it is", "empty.json --scene scene.json", 1, r"(?s): fail.*no quantity"),
    ("a template partly filled in", "partly.json --scene scene.json",
     0, r"(?s): pass.*not given by any ray, and so not compared: .*normal"),
    ("a template filled in wrongly", "partly-wrong.json --scene scene.json",
     1, r"(?s): fail.*t is 1, must be"),
    ("cut off", "cut.json --scene scene.json", 1, r": unreadable"),
    ("no such file", "none.json --scene scene.json", 1, r"(?s)unreadable.*no such file"),
    ("several", "right.json cut.json --scene scene.json", 1, r"1 of 2 pass"),
    ("a folder", "class --scene scene.json", 1, r"1 of 3 pass"),
    ("a profile", "right.json --scene scene.json --profile ucla", 1, r"by the profile ucla"),
]
MISUSE = [
    ("no scene", "right.json", r"--scene SCENE or --reference TREE"),
    ("a reference without scene", "right.json --reference nested.json", r"/scene/document"),
    ("unknown profile", "right.json --scene scene.json --profile lectur", r'mean "lecture"'),
    ("unknown field", "right.json --scene scene.json --require colour", r"--require"),
    ("tolerance of 0", "right.json --scene scene.json --rtol 0", r"--rtol.*over 0"),
    ("unknown report", "right.json --scene scene.json --as html", r"--as"),
    ("no such scene", "right.json --scene none.json", r"none\.json: there is no such file"),
    ("a folder without trees", "folder.png --scene scene.json", r"no \.json files"),
]


def reports(bench):
    done = bench.run("check class dark.json --scene scene.json --as json")
    report = json.loads(done.stdout)
    bench.check("report as json", report["format"] == "raytree-report/1.0"
                and [s["verdict"] for s in report["submissions"]]
                == ["fail", "unreadable", "pass", "fail"], done.stdout[:500])
    finding = report["submissions"][0]["findings"][0]
    bench.check("keys of a finding", {"ray", "kind", "quantity", "expected", "found", "text",
                                      "relative_error", "follows_from"} <= finding.keys(), finding)
    bench.check("groups", report["groups"] == [
        {"id": "lit.ambient_missing", "files": ["class/<b>&.json", "dark.json"]}],
        report["groups"])
    again = bench.run("check class dark.json --scene scene.json --as json --threads 1")
    bench.check("the same on one thread", again.stdout == done.stdout)
    rows = list(csv.DictReader(io.StringIO(
        bench.run("check class --scene scene.json --as csv").stdout.decode())))
    bench.check("report as csv", len(rows) == 3 and rows[0]["mistake"] == "lit.ambient_missing",
                rows)
    junit = bench.run("check class --scene scene.json --as junit").stdout
    suite = xml.dom.minidom.parseString(junit).documentElement
    bench.check("report as junit", suite.getAttribute("tests") == "3"
                and suite.getAttribute("errors") == "1", junit)
    scope = json.loads(bench.run("check dark.json --scene scene.json --as gradescope").stdout)
    bench.check("report for gradescope", 0 < scope["score"] < 100 and len(scope["tests"]) == 1,
                scope)
    bench.expect("report to a file", "check right.json --scene scene.json -o r.txt", 0, "", "",
                 "r.txt")


def odd_texts(bench):
    """What a submission says cannot steer what shows the report: a terminal, a spreadsheet."""
    document = tree(bench)
    document["rays"][0]["hit"]["object"] = '=1+1\x9b31m\u202e<b>|"\r\n'
    bench.write("=odd.json", json.dumps(document))
    (bench.folder / "wide.json").write_bytes(json.dumps(document).encode("utf-16"))
    for form in ("text", "json", "csv", "junit", "gradescope"):
        out = bench.run(f"check =odd.json wide.json --scene scene.json --as {form}").stdout.decode()
        odd = {c for c in out if c != "\n" and unicodedata.category(c) in ("Cc", "Cf", "Zl", "Zp")}
        bench.check(f"only text in {form}", len(out) > 100 and not odd, odd)
        if form in ("json", "gradescope"):
            json.loads(out)
        elif form == "junit":
            xml.dom.minidom.parseString(out)
        elif form == "csv":
            rows = list(csv.reader(out.splitlines()))
            bench.check("no formulas in csv", len(rows) == 3 and not any(
                cell[:1] in tuple("=+-@") for row in rows for cell in row if cell), rows)


def rays_text(rays):
    return '{"format": "raytree/1.0", "pixel": [16, 12], "rays": [' + ",".join(rays) + "]}"


def hostile_files():
    """Submissions that want to be large, and what is said of them."""
    primary = '{"id": 0, "kind": "primary", "direction": [0, 0, -1]}'
    fits = 15 << 20  # bytes: less than a submission may have
    child = '{"id":%d,"parent":0,"kind":"shadow"}'
    deep = '{"id":%d,"parent":%d,"kind":"refracted","direction":[0,1,0.5],"intensity":[1,1,1]}'
    yield "a million rays", rays_text([primary, *(child % k for k in range(1, 10**6))]), "MB large"
    yield "as many rays as fit", rays_text(
        [primary, *(child % k for k in range(1, fits // len(child % 300000)))]), "fail"
    yield "too deep", rays_text([primary, *(deep % (k, k - 1) for k in range(1, 100_000))]), (
        "up to 1000")
    yield "deep", rays_text([primary, *(deep % (k, k - 1) for k in range(1, 990))]), "fail"
    yield "a circle", rays_text([primary, *(deep % (k, k % 90_000 + 1) for k in range(1, 90_001))]), (
        "unreadable")
    yield "brackets", "[" * fits, "nested too deep"
    yield "one word", '{"format": "raytree/1.0", "generator": "' + "x" * fits + '"}', "unreadable"
    yield "many keys", "{" + ",".join(f'"k{k}":{k}' for k in range(10**6)) + "}", "unreadable"
    yield "numbers", rays_text(['{"kind":"primary","direction":[' + "1," * (fits // 2) + "1]}"]), (
        "unreadable")
    yield "numbers that are none", rays_text(
        ['{"kind":"primary","direction":[' + "NaN," * (fits // 4) + "1]}"]), "fail"
    yield "many mistakes", rays_text([primary, *(
        '{"id":%d,"parent":0,"kind":"reflected","t":"x","hit":3}' % k for k in range(1, 10**5))]), (
        "unreadable")


def hostile(bench):
    """Each ends in a finding or a message, within 10 s and 1 GiB."""
    def judged(name, file, expected):
        done, seconds, memory = bench.measured(f"check {file} --scene scene.json")
        bench.check(f"{name}: said", done.returncode == 1 and expected.encode() in done.stdout
                    and not done.stderr, (done.returncode, done.stdout[:300], done.stderr[:300]))
        bench.check(f"{name}: within 10 s and 1 GiB",
                    bench.slow or (seconds < 10 and memory < 1024),
                    f"{seconds:.1f} s, {memory:.0f} MB")
        return memory

    for name, text, expected in hostile_files():
        bench.write("hostile.json", text)
        judged(name, "hostile.json", expected)
    for name, expected in (("crowded", "fail"), ("bushy", "fail")):
        judged(name, f"{name}.json", expected)
    with open(bench.folder / "hostile.json", "wb") as file:
        file.truncate(1 << 30)
    judged("1 GB of nothing", "hostile.json", "1024 MB large")
    (bench.folder / "hostile.png").write_bytes(b"\x89PNG\r\n\x1a\n" + b"\0" * (1 << 20))
    judged("a picture that is none", "hostile.png", "unreadable")
    # Many large ones at once need no more than a few.
    (bench.folder / "large").mkdir()
    for k in range(6):
        bench.write(f"large/{k}.json", json.dumps(bushy(tree(bench))))
    judged("a folder of large ones", "large", "0 of 6 pass")
    (bench.folder / "hostile.json").unlink()
    (bench.folder / "hostile.png").unlink()


def checking(bench):
    inputs(bench)
    hostile(bench)
    odd_texts(bench)
    for name, command, code, out in CASES:
        bench.expect(name, "check " + command, code, out, "")
    for name, command, err in MISUSE:
        bench.expect(name, "check " + command, 2, "", err)
    reports(bench)
