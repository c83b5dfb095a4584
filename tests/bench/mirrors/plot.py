#!/usr/bin/env python3
"""plot.py FILE [--out PNG] - draws the JSON of rsh-bench mirrors: the errors of position and direction
over bounces, smooth and flat normals, a line for each way to trace. Lines are medians, bands hold 10 to
90 % of the paths; a line ends, with a mark, where half of its paths are lost. Measures nothing.
"""
import argparse
import json
import pathlib

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

LINES = {"rsh": ("rsh", "C3", "-"),
         "best_floats": ("best that floats can tell", "C0", "--"),
         "offset_alone": ("rsh's offset, all else exact", "C2", "-."),
         "one_rounding": ("first state rounded, all else exact", "0.35", ":")}
ERRORS = {"position_error": "position, radii of the room",
          "direction_error": "direction, radians"}
NORMALS = ("smooth", "flat")
LEGENDS = ("lower right", "upper right")
MOST = 2  # no error is larger
LEAST = 3e-9


def load(path):
    """(normals, line) -> metrics by bounce, of which "all" is the summary; and the file's head."""
    document = json.loads(path.read_text())
    if document["suite"] != "mirrors":
        raise SystemExit(f"{path}: suite is {document['suite']}, must be mirrors")
    found = {}
    for case in document["cases"]:
        if not case["ok"]:
            raise SystemExit(f"{path}: {case['name']} is wrong: {case['metrics'].get('why')}")
        p = case["params"]
        found.setdefault((p["normals"], p["line"]), {})[p["bounce"]] = case["metrics"]
    for normals in NORMALS:
        for line in LINES:
            if "all" not in found.get((normals, line), {}):
                raise SystemExit(f"{path}: no summary of {normals} normals, line {line}")
    return found, document


def curve(metrics, bounces, name):
    """Lost ones lie above all; an error of 0 has no place on the axis."""
    values = [metrics[b][name] for b in bounces]
    return [MOST if value is None else value or float("nan") for value in values]


def draw_line(axes, metrics, error, style):
    label, colour, dashes = style
    half = metrics["all"]["half_lost_at"]
    bounces = sorted(b for b in metrics if b != "all" and (half is None or b < half))
    median = curve(metrics, bounces, error + "_median")
    axes.fill_between(bounces, curve(metrics, bounces, error + "_p10"),
                      curve(metrics, bounces, error + "_p90"), color=colour, alpha=0.1, linewidth=0)
    axes.plot(bounces, median, dashes, color=colour, label=f"{label}: {half or 'none'}")
    if half is not None:
        axes.plot(bounces[-1], median[-1], "x", color=colour, markersize=8, markeredgewidth=2)


def draw_panel(axes, found, normals, error):
    for line, style in LINES.items():
        draw_line(axes, found[normals, line], error, style)
    axes.set(yscale="log", ylim=(LEAST, MOST), xlim=(1, 64), ylabel=ERRORS[error])
    axes.set_xticks([1, *range(8, 65, 8)])
    axes.grid(alpha=0.3)


def draw(found, document, path):
    figure, axes = plt.subplots(2, 2, figsize=(12, 8), sharex=True, sharey=True)
    for column, normals in enumerate(NORMALS):
        for row, error in enumerate(ERRORS):
            draw_panel(axes[row][column], found, normals, error)
        axes[0][column].set_title(f"{normals} normals", fontsize=10)
        axes[0][column].legend(fontsize=8, title="half of the paths are lost at bounce",
                               title_fontsize=8, loc=LEGENDS[column])
        axes[1][column].set_xlabel("bounce")
    device = document["device"]
    paths = found["smooth", "rsh"]["all"]["paths"]
    figure.suptitle(
        f"Errors between curved mirrors beside a trace in 113 bits: medians of {paths} paths, "
        f"10 to 90 % shaded\n{device['name']}, {device['platform']} {device['driver']}; "
        f"rsh {document['rsh']['version']} ({document['rsh']['commit']})", fontsize=10)
    figure.tight_layout()
    figure.savefig(path, dpi=90)
    plt.close(figure)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("file", type=pathlib.Path)
    parser.add_argument("--out", type=pathlib.Path, default=pathlib.Path("mirrors.png"))
    options = parser.parse_args()
    draw(*load(options.file), options.out)


if __name__ == "__main__":
    main()
