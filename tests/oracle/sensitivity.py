"""How far the truth itself moves when the last bit of the input does.

A field that moves by more than LIMIT under a change of one unit in the last place cannot be asked
of a program that computes in double; a tree that changes its shape cannot be asked at all.
"""

import math
import random

from arithmetic import EXACT
from compare import compare, error_of, flat, is_number
from model import trace
from reader import Source

LIMIT = 1e-10
RUNS = 4
# Counts and indices, and the switches that no tracer computes with.
KEPT = {"width", "height", "max_depth", "ray_budget", "faces"}


def doubtful_fields(source, pixel, truth, seed=0, runs=RUNS):
    """{(ray id, field): largest movement} of what moves too far; None if the tree's shape does."""
    rng = random.Random(seed)
    moved = {}
    for _ in range(runs):
        other = trace(perturbed(source, rng), pixel, EXACT)
        if compare(truth, other, math.inf).differences:
            return None
        for field, movement in movements(truth, other):
            moved[field] = max(movement, moved.get(field, 0))
    return {field: float(movement) for field, movement in moved.items() if movement >= LIMIT}


def movements(truth, other):
    for a, b in zip(truth["rays"], other["rays"]):
        b = flat(b)
        for name, value in flat(a).items():
            if is_number(value):
                yield (a["id"], name), error_of(value, b[name])


def perturbed(source, rng):
    """The same scene with every number one unit in the last place higher or lower."""
    document, meshes = (nudged(part, rng) for part in (source.document, source.meshes))
    return Source(document, meshes, source.sha256)


def nudged(value, rng, key=None):
    if key in KEPT or isinstance(value, (str, bool)) or value is None:
        return value
    if isinstance(value, dict):
        return {name: nudged(part, rng, name) for name, part in value.items()}
    if isinstance(value, list):
        # A transform's last row has to stay 0 0 0 1.
        rows = [nudged(part, rng) for part in value]
        return rows[:3] + value[3:] if key == "transform" else rows
    # 0 stays: next to it lie numbers that no rounding makes.
    return math.nextafter(value, rng.choice([-math.inf, math.inf])) if value else value
