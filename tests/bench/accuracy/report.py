#!/usr/bin/env python3
"""report.py FILE [--plot SVG] [--readme PAGE] [--check PAGE] [--page HTML --pictures DIR] - from the JSON
of rsh-bench accuracy makes

  --plot    error against milliseconds, a panel per scene, a series per axis, and the front: the points
            that no other point beats in both
  --readme  the table between the two lines "<!-- accuracy: ... -->" of a page, in place
  --check   whether that page has the table that --readme would write; ends with 1 if not
  --page    a page of its own, with the pictures that rsh-bench accuracy --pictures DIR wrote

Without any of these the table is printed. Measures nothing.
"""
import argparse
import io
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
import front
import page
import page_section

COLOURS = {"bounces": "tab:blue", "min_weight": "tab:orange", "size": "tab:green",
           "engine": "tab:gray", "shadow": "tab:purple", "reflection": "tab:red",
           "refraction": "tab:cyan", "texture": "tab:olive"}


def key(case):
    return case["params"]["axis"], case["params"]["value"]


def cell(case, is_on_front):
    metrics = case["metrics"]
    text = f"{metrics['ms']:.1f} · {metrics['rmse']:.4f} · {metrics['flip']:.4f}"
    return f"**{text}**" if is_on_front else text


def table(document):
    """A row per point that is on the front of a scene, and the default."""
    scenes = front.by_scene(document)
    fronts = {scene: {key(case) for case in front.front(cases)} for scene, cases in scenes.items()}
    by_key = {scene: {key(case): case for case in cases} for scene, cases in scenes.items()}
    lines = [f"| | {' | '.join(scenes)} |", "|---" * (len(scenes) + 1) + "|"]
    for point in dict.fromkeys(key(case) for case in document["cases"]):
        if point[0] != front.DEFAULT and not any(point in found for found in fronts.values()):
            continue
        cells = [cell(by_key[scene][point], point in fronts[scene]) if point in by_key[scene] else ""
                 for scene in scenes]
        name = next(front.label(case) for case in document["cases"] if key(case) == point)
        lines.append(f"| {name} | {' | '.join(cells)} |")
    return "\n".join(lines + ["", about(document)])


def about(document):
    scenes = front.by_scene(document)
    first = document["cases"][0]["params"]
    fronts = "; ".join(f"{scene}: {front.about(cases)}" for scene, cases in scenes.items())
    judged = {(scene, case["params"]["samples"]): case["metrics"]
              for scene, cases in scenes.items() for case in cases}.values()
    wrong = sum(metrics[name] for metrics in judged
                for name in ("missed", "spurious", "wrong_triangle"))
    centres = ", ".join(f"{cases[0]['metrics']['rmse_centres']:.4f}" for cases in scenes.values())
    return page_section.wrapped([
        f"- {first['width']}x{first['height']} pixels. The fronts, in bold: {fronts}.",
        f"- Most of the default's error is that of one ray per pixel: against a reference of one ray through "
        f"each centre its rmse is {centres}.",
        f"- Of {sum(metrics['judged'] for metrics in judged):,} hits of camera rays that the oracle judged, "
        f"{wrong} are missed, made up or of the wrong triangle.",
        page_section.measured_on(document)])


def fill_panel(panel, cases):
    default = next(case for case in cases if case["params"]["axis"] == front.DEFAULT)

    def points(some):
        return ([case["metrics"]["ms"] for case in some],
                [case["metrics"]["rmse"] for case in some])

    panel.plot(*points(front.front(cases)), color="black", linewidth=1, zorder=1, label="front")
    for axis, found in front.by_axis(cases).items():
        if axis == front.DEFAULT:
            continue
        found = sorted(found + [default], key=lambda case: case["metrics"]["ms"])
        style = ":" if len(found) > 2 else ""
        panel.plot(*points(found), style or "none", marker="o", markersize=4, linewidth=1,
                   color=COLOURS.get(axis), label=axis.replace("_", " "))
    panel.plot(*points([default]), "o", markersize=10, fillstyle="none", color="black",
               label="default")
    panel.set(xscale="log", yscale="log", xlabel="ms per frame")
    panel.grid(alpha=0.3)


def plot(document):
    """The SVG as text, the same bytes again for the same document."""
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    matplotlib.rcParams.update({"svg.hashsalt": "rsh", "svg.fonttype": "none"})
    scenes = front.by_scene(document)
    figure, axes = plt.subplots(1, len(scenes), figsize=(2 + 4 * len(scenes), 4.2), squeeze=False)
    entries = {}
    for panel, (scene, cases) in zip(axes.flat, scenes.items()):
        panel.set_title(scene)
        fill_panel(panel, cases)
        entries.update({name: handle for handle, name in zip(*panel.get_legend_handles_labels())})
    axes[0, 0].set_ylabel("rmse against 64 samples per pixel")
    figure.legend(entries.values(), entries.keys(), loc="center right", frameon=False)
    figure.tight_layout(rect=(0, 0, 1 - 1.5 / (2 + 4 * len(scenes)), 1))
    text = io.StringIO()
    figure.savefig(text, format="svg", metadata={"Date": None})
    return text.getvalue()


def write(path, text):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("file", type=pathlib.Path)
    for option in ("--plot", "--readme", "--check", "--page", "--pictures"):
        parser.add_argument(option, type=pathlib.Path)
    options = parser.parse_args()
    if options.page and not options.pictures:
        parser.error("--page needs --pictures, the folder that rsh-bench wrote")
    document = front.load(options.file)
    text = table(document)
    if options.plot:
        write(options.plot, plot(document))
    if options.readme:
        options.readme.write_text(page_section.written(options.readme, "accuracy", text))
    if options.check:
        page_section.check(options.check, "accuracy", text, options.file)
    if options.page:
        svg = plot(document)
        write(options.page, page.make(document, svg[svg.index("<svg"):], options.pictures))
    if not (options.plot or options.readme or options.check or options.page):
        sys.stdout.write(text + "\n")


if __name__ == "__main__":
    main()
