"""Draws what was named for what was planted: `run.py --matrix FILE`, then this, to an SVG.

    python3 draw_matrix.py FILE.json OUT.svg [FORM]

A row for each planted mistake, a column for each name that was given first; the darker and larger a
square, the more of the row's cases. What is right or tied lies on the diagonal or in the row's ring.
"""

import collections
import html
import json
import sys
from pathlib import Path

CELL, LEFT, TOP = 9, 210, 200
NOTHING = "nothing"


def families(names):
    """(family, first place, number of names), in order."""
    found = []
    for place, name in enumerate(names):
        family = name.partition(".")[0]
        if found and found[-1][0] == family:
            found[-1][2] += 1
        else:
            found.append([family, place, 1])
    return found


def draw(cases):
    order = {name: k for k, name in enumerate(dict.fromkeys(
        name for pair in cases for name in sorted(pair, key=lambda n: n == NOTHING)))}
    names = sorted((n for n in order if n != NOTHING), key=lambda n: (family_rank(n), n))
    columns = [*names, NOTHING]
    rows = [n for n in names if any(planted == n for planted, _ in cases)]
    place = {name: k for k, name in enumerate(columns)}
    width = LEFT + CELL * len(columns) + 30
    height = TOP + CELL * len(rows) + 60
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" '
           f'viewBox="0 0 {width} {height}" font-family="sans-serif" font-size="8">',
           f'<rect width="{width}" height="{height}" fill="#fff"/>',
           '<text x="20" y="26" font-size="16" font-weight="bold" fill="#2B3440">What was named '
           'first for what was planted</text>']
    totals = collections.Counter()
    for (planted, _), (n, _) in cases.items():
        totals[planted] += n
    right = sum(n for (p, q), (n, _) in cases.items() if p == q)
    tied = sum(t for (p, q), (_, t) in cases.items() if p != q)
    count = sum(totals.values())
    out.append(f'<text x="20" y="46" font-size="11" fill="#6B7683">{len(rows)} mistakes, {count} '
               f'cases: {right} named first, {tied} tied with the name that stands first (rings), '
               f'{count - right - tied} named otherwise or not (crosses)</text>')
    for family, first, size in families(rows):
        y = TOP + CELL * first
        out.append(f'<line x1="{LEFT}" x2="{width - 30}" y1="{y}" y2="{y}" stroke="#C9D0D8"/>')
    for family, first, size in families(names):
        x = LEFT + CELL * first
        out.append(f'<line x1="{x}" x2="{x}" y1="{TOP}" y2="{height - 60}" stroke="#C9D0D8"/>')
    for k, name in enumerate(rows):
        y = TOP + CELL * (k + 0.8)
        out.append(f'<text x="{LEFT - 5}" y="{y:.1f}" text-anchor="end" fill="#2B3440">'
                   f'{html.escape(name)} ({totals[name]})</text>')
    for k, name in enumerate(columns):
        x = LEFT + CELL * (k + 0.8)
        out.append(f'<text transform="translate({x:.1f} {TOP - 5}) rotate(-90)" fill="#2B3440">'
                   f'{html.escape(name)}</text>')
    row_of = {name: k for k, name in enumerate(rows)}
    for (planted, named), (n, ties) in sorted(cases.items()):
        x = LEFT + CELL * (place[named] + 0.5)
        y = TOP + CELL * (row_of[planted] + 0.5)
        out.append(mark(x, y, n / totals[planted], planted == named, ties == n,
                        f"{planted}: {n} of {totals[planted]} named {named}"))
    return "\n".join(out) + "\n</svg>\n"


def mark(x, y, share, is_right, is_tie, tip):
    tip = f"<title>{html.escape(tip)}</title>"
    size = 2 + 2 * share
    if is_right:
        return (f'<rect x="{x - size:.1f}" y="{y - size:.1f}" width="{2 * size:.1f}" '
                f'height="{2 * size:.1f}" fill="#1F6FA8">{tip}</rect>')
    if is_tie:
        return (f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{size - 1:.1f}" fill="none" '
                f'stroke="#B26A00" stroke-width="1.4">{tip}</circle>')
    d = size - 1
    return (f'<path d="M {x - d:.1f} {y - d:.1f} L {x + d:.1f} {y + d:.1f} M {x - d:.1f} {y + d:.1f} '
            f'L {x + d:.1f} {y - d:.1f}" stroke="#B3261E" stroke-width="1.6">{tip}</path>')


def family_rank(name):
    order = ["cam", "num", "isect", "eps", "hit", "nrm", "shd", "lit", "refl", "refr", "rec", "bg",
             "out"]
    family = name.partition(".")[0]
    return order.index(family) if family in order else len(order)


def main():
    matrix = json.loads(Path(sys.argv[1]).read_text())
    form = sys.argv[3] if len(sys.argv) > 3 else next(iter(matrix))
    cases = {(planted, named): (n, ties) for planted, named, n, ties in matrix[form]}
    Path(sys.argv[2]).write_text(draw(cases))


if __name__ == "__main__":
    main()
