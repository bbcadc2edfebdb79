"""Draws the plots of a benchmark's JSON: plot.py NAME.json; writes NAME-PLOT.svg beside it.

Run by the benchmarks themselves; needs Debian's python3-matplotlib.
"""

import json
import os
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

from accuracy_plot import style

# Okabe & Ito's colours, which the colour-blind can tell apart, and markers beside them.
COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#2B3440")
MARKERS = "osD^vPX"


def draw(plot, target):
    figure, axes = plt.subplots(figsize=(8, 5), layout="constrained")
    style(axes, plot["title"])
    for k, series in enumerate(plot["series"]):
        points = [(x, y) for x, y in zip(series["x"], series["y"]) if x and y]
        if points:
            axes.loglog(*zip(*points), color=COLOURS[k % len(COLOURS)],
                        marker=MARKERS[k % len(MARKERS)], label=series["name"])
    axes.set_xlabel(plot["x_axis"])
    axes.set_ylabel(plot["y_axis"])
    axes.legend(frameon=False)
    part = target + ".part"
    figure.savefig(part, format="svg")
    os.replace(part, target)
    plt.close(figure)


def main(source):
    with open(source, encoding="utf-8") as file:
        document = json.load(file)
    for plot in document["plots"]:
        draw(plot, f"{os.path.splitext(source)[0]}-{plot['file']}.svg")


if __name__ == "__main__":
    main(sys.argv[1])
