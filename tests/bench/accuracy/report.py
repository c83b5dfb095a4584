"""Of rsh-bench accuracy: the table of the fronts, and the plot of error against milliseconds, a panel per
scene, a series per axis, and the front: the points that no other point beats in both."""
from accuracy import front
from reporting import drawing
from reporting.results import measured_on, wrapped

COLOURS = {"bounces": "tab:blue", "min_weight": "tab:orange", "size": "tab:green",
           "engine": "tab:gray", "tolerance": "tab:pink", "shadow": "tab:purple", "reflection": "tab:red",
           "refraction": "tab:cyan", "texture": "tab:olive"}


def key(case):
    return case["params"]["axis"], case["params"]["value"]


def cell(case, is_on_front):
    metrics = case["metrics"]
    text = f"{metrics['ms']:.1f} · {metrics['rmse']:.4f} · {metrics['flip']:.4f}"
    return f"**{text}**" if is_on_front else text


def table(results):
    """A row per point that is on the front of a scene, and the default."""
    scenes = front.by_scene(results.cases)
    fronts = {scene: {key(case) for case in front.front(cases)} for scene, cases in scenes.items()}
    by_key = {scene: {key(case): case for case in cases} for scene, cases in scenes.items()}
    lines = [f"| | {' | '.join(scenes)} |", "|---" * (len(scenes) + 1) + "|"]
    for point in dict.fromkeys(key(case) for case in results.cases):
        if point[0] != front.DEFAULT and not any(point in found for found in fronts.values()):
            continue
        cells = [cell(by_key[scene][point], point in fronts[scene]) if point in by_key[scene] else ""
                 for scene in scenes]
        name = next(front.label(case) for case in results.cases if key(case) == point)
        lines.append(f"| {name} | {' | '.join(cells)} |")
    return "\n".join(lines + ["", about(results)])


def about(results):
    scenes = front.by_scene(results.cases)
    first = results.cases[0]["params"]
    fronts = "; ".join(f"{scene}: {front.about(cases)}" for scene, cases in scenes.items())
    judged = {(scene, case["params"]["samples"]): case["metrics"]
              for scene, cases in scenes.items() for case in cases}.values()
    wrong = sum(metrics[name] for metrics in judged
                for name in ("missed", "spurious", "wrong_triangle"))
    centres = ", ".join(f"{cases[0]['metrics']['rmse_centres']:.4f}" for cases in scenes.values())
    return wrapped([
        f"- {first['width']}x{first['height']} pixels. The fronts, in bold: {fronts}.",
        f"- Most of the default's error is that of one ray per pixel: against a reference of one ray through "
        f"each centre its rmse is {centres}.",
        f"- Of {sum(metrics['judged'] for metrics in judged):,} hits of camera rays that the oracle judged, "
        f"{wrong} are missed, made up or of the wrong triangle.",
        measured_on(results)])


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


def plot(results):
    scenes = front.by_scene(results.cases)
    figure, axes = drawing.pyplot().subplots(1, len(scenes), figsize=(2 + 4 * len(scenes), 4.2), squeeze=False)
    entries = {}
    for panel, (scene, cases) in zip(axes.flat, scenes.items()):
        panel.set_title(scene)
        fill_panel(panel, cases)
        entries.update({name: handle for handle, name in zip(*panel.get_legend_handles_labels())})
    axes[0, 0].set_ylabel("rmse against 64 samples per pixel")
    figure.legend(entries.values(), entries.keys(), loc="center right", frameon=False)
    figure.tight_layout(rect=(0, 0, 1 - 1.5 / (2 + 4 * len(scenes)), 1))
    return figure
