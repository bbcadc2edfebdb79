"""Draws the work-precision picture of one scene: accuracy_plot.py accuracy-SCENE.json OUT.png

Run by `raytree bench accuracy`; needs Debian's python3-matplotlib.
"""

import json
import os
import sys
import tempfile
import textwrap

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
from matplotlib.patheffects import withStroke
from matplotlib.ticker import LogLocator, NullLocator

INK, GREY, GRID = "#2B3440", "#6B7480", "#E3E6EA"
# Okabe & Ito's colours, which the colour-blind can tell apart.
BLUE, ORANGE, GREEN, VERMILION, PURPLE, SKY = (
    "#0072B2", "#E69F00", "#009E73", "#D55E00", "#CC79A7", "#56B4E9")
ARITHMETIC = {"float": (VERMILION, "float (24 bits)"), "Embree": (ORANGE, "Embree (float)"),
              "double": (BLUE, "double (53 bits)")}


def style(axes, title):
    axes.set_title(title, loc="left", fontsize=12, fontweight="bold", color=INK, pad=22)
    axes.grid(True, color=GRID, linewidth=0.8)
    axes.set_axisbelow(True)
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)
    for side in ("left", "bottom"):
        axes.spines[side].set_color(GREY)
    axes.tick_params(colors=INK, which="both", length=3)


def front_line(axes, points):
    """The staircase that no point is below and left of."""
    best = sorted((p for p in points if p["on_front"]), key=lambda p: p["x"])
    xs, ys = [], []
    lowest = None
    for p in best:
        if lowest is not None and p["y"] > lowest:
            continue
        if lowest is not None:
            xs.append(p["x"])
            ys.append(lowest)
        xs.append(p["x"])
        ys.append(p["y"])
        lowest = p["y"]
    axes.plot(xs, ys, color="#B8BEC6", linewidth=5, solid_joinstyle="round", zorder=1,
              label="the front: nothing is faster and better")


def plan_labels(axes, wanted):
    """Puts a word beside each point, where it covers no other word."""
    axes.figure.canvas.draw()
    renderer = axes.figure.canvas.get_renderer()
    taken = []
    for x, y in {(w[0], w[1]) for w in wanted}:
        px, py = axes.transData.transform((x, y))
        taken.append((px - 6, py - 6, px + 6, py + 6))
    frame = axes.get_window_extent(renderer)
    for x, y, text, colour, weight in wanted:
        for dx, dy, ha, va in ((9, 0, "left", "center"), (0, 9, "center", "bottom"),
                               (0, -9, "center", "top"), (-9, 0, "right", "center"),
                               (8, 8, "left", "bottom"), (8, -8, "left", "top"),
                               (-8, -8, "right", "top"), (-8, 8, "right", "bottom"),
                               (0, 20, "center", "bottom"), (0, -20, "center", "top"),
                               (18, 18, "left", "bottom"), (18, -18, "left", "top")):
            label = axes.annotate(text, (x, y), xytext=(dx, dy), textcoords="offset points", ha=ha,
                                  va=va, fontsize=9.5, color=colour, fontweight=weight, zorder=6,
                                  path_effects=[withStroke(linewidth=3, foreground="white")])
            box = label.get_window_extent(renderer)
            free = (box.x0 > frame.x0 and box.x1 < frame.x1 and box.y0 > frame.y0
                    and box.y1 < frame.y1 and
                    all(box.x1 < t[0] or box.x0 > t[2] or box.y1 < t[1] or box.y0 > t[3]
                        for t in taken))
            if free:
                taken.append((box.x0, box.y0, box.x1, box.y1))
                break
            label.remove()


def grouped_labels(points):
    """One label for points in one place: "6-12" for levels that make no difference any more."""
    groups = []
    for p in points:
        same = [g for g in groups if abs(g[0]["y"] / p["y"] - 1) < 1e-6]
        if same:
            same[0].append(p)
        else:
            groups.append([p])
    for group in groups:
        names = [p["label"] for p in group]
        text = names[0] if len(names) == 1 else f"{names[0]} to {names[-1]}"
        yield group[len(group) // 2], text


def draw_prices(axes, data):
    points = data["points"]
    positive = [p["intensity"]["rms"] for p in points if p["intensity"]["rms"] > 0]
    floor = 10 ** -19
    for p in points:
        p["x"] = p["seconds_a_pixel"] * 1e6
        p["y"] = p["intensity"]["rms"] if p["intensity"]["rms"] > 0 else floor
    by = lambda family: [p for p in points if p["family"] == family]
    axes.set_xscale("log")
    axes.set_yscale("log")
    front_line(axes, points)
    labels = []
    for family, colour, name, word in (
            ("max_depth", BLUE, "double, trees cut at a level", "level"),
            ("min_weight", GREEN, "double, branches cut below a weight", "weight")):
        series = by(family)
        axes.plot([p["x"] for p in series], [p["y"] for p in series], "-o", color=colour,
                  linewidth=1.2, markersize=6, label=name, zorder=3)
        for p, text in grouped_labels(series):
            text = text.replace("1e-", "$10^{-").replace(" to", "}$ to") + "}$" * ("1e" in text)
            labels.append((p["x"], p["y"], f"{word} {text}", colour, "normal"))
    for p in by("arithmetic"):
        colour = {"float": VERMILION, "double": BLUE, "reference": INK}[p["label"]]
        axes.plot(p["x"], p["y"], "D", color=colour, markersize=9, zorder=4)
        text = {"float": "float", "double": "double",
                "reference": "113 bits: what all\nis measured by"}[p["label"]]
        labels.insert(0, (p["x"], p["y"], text, colour, "bold"))
    for family, colour, marker in (("embree", ORANGE, "s"), ("povray", PURPLE, "^")):
        for p in by(family):
            axes.plot(p["x"], p["y"], marker, color=colour, markersize=9, zorder=4)
            extra = "\n(a picture of 16 bits)" if family == "povray" else ""
            labels.insert(0, (p["x"], p["y"], p["label"] + extra, colour, "bold"))
    for p in by("default"):
        axes.plot(p["x"], p["y"], "*", color="#F0E442", markeredgecolor=INK, markersize=18,
                  zorder=5, label="the default: 6 levels, weight 0.001")
    top = max(positive) * 30
    axes.set_ylim(floor / 5, top)
    xs = [p["x"] for p in points if p["x"] > 0]
    axes.set_xlim(min(xs) / 2.5, max(xs) * 6)
    axes.set_xlabel("time for a pixel, in microseconds of one processor core  (faster is left)",
                    color=INK)
    axes.yaxis.set_major_locator(LogLocator(base=10, numticks=30))
    axes.yaxis.set_minor_locator(NullLocator())
    ticks = [10.0 ** e for e in range(-18, 4, 2) if 10.0 ** e < top]
    axes.set_yticks([floor] + ticks)
    axes.set_yticklabels(["exact"] + [f"$10^{{{e}}}$" for e in range(-18, 4, 2)
                                      if 10.0 ** e < top])
    axes.text(0, 1.015, "error of a pixel's intensity, root mean square  (better is down; "
              "1 is white)", transform=axes.transAxes, fontsize=9.5, color=GREY)
    axes.axhspan(floor / 5, 3e-19, color="#F3F4F6", zorder=0)
    axes.legend(loc="upper right", fontsize=9.5, frameon=True, framealpha=0.9, edgecolor=GRID)
    plan_labels(axes, labels)


def draw_bounces(axes, data):
    lowest, highest = 1e-17, 1e-6
    for r in data["rounding"]:
        colour, name = ARITHMETIC[r["arithmetic"]]
        worst = [max(d["worst"], lowest) for d in r["direction_after_bounces"]]
        rms = [max(d["rms"], lowest) for d in r["direction_after_bounces"]]
        axes.plot(range(len(worst)), worst, "-o", color=colour, markersize=5, label=name)
        axes.fill_between(range(len(worst)), rms, worst, color=colour, alpha=0.15, linewidth=0)
        highest = max(highest, max(worst))
    axes.set_yscale("log")
    axes.set_ylim(lowest, highest * (highest / lowest) ** 0.25)  # room for the legend
    bounces = max(len(r["direction_after_bounces"]) for r in data["rounding"]) - 1
    axes.set_xlim(-0.5, max(bounces, 1) + 0.5)
    axes.set_xlabel("bounces since the eye", color=INK)
    axes.xaxis.set_major_locator(matplotlib.ticker.MaxNLocator(integer=True))
    axes.text(0, 1.02, "error of a ray's direction, in radians: worst ray (line), typical ray "
              "(lower edge)", transform=axes.transAxes, fontsize=9.5, color=GREY)
    axes.legend(loc="upper left", fontsize=9.5, ncol=3, frameon=True, framealpha=0.9,
                edgecolor=GRID)


def draw_quantities(axes, data):
    kinds = [("distance", "hit distance\n(relative)"), ("point", "hit point\n(of scene's size)"),
             ("intensity", "pixel\nintensity")]
    lowest, highest = 1e-18, 1e-6
    for n, r in enumerate(data["rounding"]):
        colour, name = ARITHMETIC[r["arithmetic"]]
        for k, (key, _) in enumerate(kinds):
            at = k + (n - (len(data["rounding"]) - 1) / 2) * 0.22
            rms = max(r[key]["rms"] or lowest, lowest)
            worst = max(r[key]["worst"], lowest)
            axes.plot([at, at], [rms, worst], color=colour, linewidth=3, alpha=0.5)
            axes.plot(at, worst, "^", color=colour, markersize=8)
            axes.plot(at, rms, "o", color=colour, markersize=7)
            highest = max(highest, worst)
        of_other = r["pixels_of_other_shape"]
        share = f'{of_other:.0f} of {data["width"] * data["height"]}'
        axes.text(1.02, 0.86 - 0.26 * n, f"{r['arithmetic']}: {share}\npixels have a tree of\n"
                  "another shape", transform=axes.transAxes, fontsize=9.5, color=colour, va="top")
    axes.set_yscale("log")
    axes.set_ylim(lowest, highest * 30)
    axes.set_xlim(-0.5, 2.5)
    axes.set_xticks(range(len(kinds)), [label for _, label in kinds])
    axes.text(0, 1.02, "error of each number: worst (triangle), typical (dot, root mean square)",
              transform=axes.transAxes, fontsize=9.5, color=GREY)


def main(source, target):
    with open(source, encoding="utf-8") as file:
        data = json.load(file)
    plt.rcParams.update({"font.family": "DejaVu Sans", "text.color": INK, "axes.labelcolor": INK})
    figure = plt.figure(figsize=(16, 9), dpi=100, facecolor="white")
    grid = figure.add_gridspec(2, 2, width_ratios=(1.25, 1), left=0.05, right=0.885, top=0.84,
                               bottom=0.125, hspace=0.55, wspace=0.14)
    prices = figure.add_subplot(grid[:, 0])
    style(prices, "What a smaller error costs")
    draw_prices(prices, data)
    bounces = figure.add_subplot(grid[0, 1])
    style(bounces, "What rounding does, bounce by bounce")
    draw_bounces(bounces, data)
    quantities = figure.add_subplot(grid[1, 1])
    style(quantities, "What rounding does to each number")
    draw_quantities(quantities, data)
    figure.text(0.05, 0.945, data["scene"], fontsize=18, fontweight="bold")
    figure.text(0.05, 0.913, f'{data["width"]} x {data["height"]} pixels; the truth: 113 bits, '
                f'trees of {data["truth_depth"]} levels, no branch too light. '
                f'{data["machine"]}', fontsize=9.5, color=GREY)
    foot = data["verdict"][0].upper() + data["verdict"][1:] + "."
    for program in ("embree", "povray"):
        if data["without_" + program]:
            foot += f' {"Embree" if program == "embree" else "POV-Ray"} is not shown: '
            foot += data["without_" + program] + "."
    figure.text(0.05, 0.035, textwrap.fill(foot, 190), fontsize=10, color=INK)
    with tempfile.NamedTemporaryFile(dir=os.path.dirname(os.path.abspath(target)),
                                     suffix=".png", delete=False) as part:
        figure.savefig(part.name, facecolor="white")
    os.chmod(part.name, 0o644)
    os.replace(part.name, target)


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2])
