"""Two ray trees, field by field.

A number agrees when it lies within a tolerance of the truth, relative to the largest component of
its quantity, which counts as 1e-3 at least. Everything else has to be the same: the rays, their
order and shape, what they hit, how they end, what was skipped and why.
"""

from dataclasses import dataclass, field

FLOOR = 1e-3
WHOLE = {"id", "parent", "level"}
# Present under some conditions only (formats.md): where the truth lacks one, so must the other.
CONDITIONAL = {
    "hit", "light", "distance", "blocked_by", "transmittance", "ambient", "diffuse", "specular",
    "weight", "intensity", "termination", "skipped", "attenuation",
    "hit.eta", "hit.sin2_transmitted", "blocked_by.t", "blocked_by.object",
}  # fmt: skip


@dataclass
class Report:
    """`differences` is empty for trees that agree; `worst` is (error, where)."""

    differences: list = field(default_factory=list)
    judged: int = 0
    skipped: int = 0
    worst: tuple = (0, "")

    def differ(self, where, truth, found):
        self.differences.append(f"{where}: expected {shown(truth)}, found {shown(found)}")


def compare(truth, found, tolerance, doubtful=frozenset(), strict=True):
    """`doubtful` holds (ray id, field) that are not judged; without `strict` fields that the truth
    leaves out may be anything."""
    report = Report()
    compare_tops(truth, found, tolerance, doubtful, report)
    for number, (a, b) in enumerate(zip(truth["rays"], found["rays"])):
        compare_rays(number, a, b, tolerance, doubtful, strict, report)
        # What follows a wrong turn is noise.
        if any(is_structural(line) for line in report.differences):
            break
    counts = [len(tree["rays"]) for tree in (truth, found)]
    if counts[0] != counts[1]:
        report.differ("number of rays", *counts)
    return report


def is_structural(line):
    name = line.split(": ")[0].split(" ")[-1]
    return name in ("kind", "parent", "hit", "hit.object", "hit.side", "termination", "skipped")


def compare_tops(truth, found, tolerance, doubtful, report):
    if not str(found.get("format", "")).startswith("raytree/1."):
        report.differ("format", "raytree/1.0", found.get("format"))
    exact = {"pixel": list(truth["pixel"])}
    for name, count in truth.get("counts", {}).items():
        if name != "intersection_tests":
            exact["counts." + name] = count
    if "scene" in truth:
        exact["scene.name"] = truth["scene"]["name"]
    here = flat({key: found.get(key) for key in ("pixel", "counts", "scene")})
    for name, value in exact.items():
        report.judged += 1
        if here.get(name) != value:
            report.differ(name, value, here.get(name))
    judge("intensity", truth["intensity"], found.get("intensity"), tolerance, report)


def compare_rays(number, truth, found, tolerance, doubtful, strict, report):
    a, b = flat(truth), flat(found)
    for name, value in a.items():
        where = f"ray {number} {name}"
        if (truth["id"], name) in doubtful:
            report.skipped += 1
        elif name not in b:
            report.differ(where, value, "nothing")
        elif name in WHOLE or not is_number(value):
            report.judged += 1
            if plain(value) != plain(b[name]):
                report.differ(where, value, b[name])
        else:
            judge(where, value, b[name], tolerance, report)
    for name in sorted(CONDITIONAL & set(b) - set(a)) if strict else ():
        report.differ(f"ray {number} {name}", "nothing", b[name])


def judge(where, truth, found, tolerance, report):
    report.judged += 1
    error = error_of(truth, found)
    if error is None or not error <= tolerance:
        by = "" if error is None else f" (off by {float(error):.2g})"
        report.differ(where + by, truth, found)
    if error is not None and error > report.worst[0]:
        report.worst = (error, where)


def error_of(truth, found):
    """Relative to the quantity's largest component; None where the two cannot be compared."""
    if not is_number(found):
        return None
    a, b = (list(x) if isinstance(x, (list, tuple)) else [x] for x in (truth, found))
    if len(a) != len(b) or isinstance(truth, (list, tuple)) != isinstance(found, (list, tuple)):
        return None
    return max(abs(x - y) for x, y in zip(a, b)) / max([FLOOR] + [abs(x) for x in a])


def flat(record, prefix=""):
    """Fields of the objects inside as "hit.t"; an object that is null stays a field."""
    fields = {}
    for name, value in record.items():
        if isinstance(value, dict):
            fields[prefix + name] = "an object"
            fields.update(flat(value, prefix + name + "."))
        else:
            fields[prefix + name] = value
    return fields


def is_number(value):
    if isinstance(value, (list, tuple)):
        return bool(value) and all(is_number(x) and not isinstance(x, (list, tuple)) for x in value)
    return value is not None and not isinstance(value, (bool, str, dict))


def plain(value):
    return list(map(plain, value)) if isinstance(value, (list, tuple)) else value


def shown(value):
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(map(shown, value)) + "]"
    return f"{value}" if not is_number(value) or isinstance(value, int) else f"{float(value):.17g}"
