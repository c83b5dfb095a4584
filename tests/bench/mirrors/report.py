"""Of rsh-bench mirrors: tables and plot of the errors of position and direction over bounces, smooth and flat
normals, a line for each way to trace."""
from reporting import drawing
from reporting.results import device_text, commit_of, measured_on, wrapped

LINES = {"rsh": ("rsh", "C3", "-"),
         "best_floats": ("best that floats can tell", "C0", "--"),
         "offset_alone": ("rsh's offset, all else exact", "C2", "-."),
         "one_rounding": ("first state rounded, all else exact", "0.35", ":")}
ROWS = {"rsh": "rsh", "best_floats": "best that floats can tell", "offset_alone": "rsh's offset",
        "one_rounding": "what the geometry forces"}
ERRORS = {"position_error": "position, radii of the room",
          "direction_error": "direction, radians"}
NORMALS = ("smooth", "flat")
COLUMNS = {"smooth": (1, 8, 16, 24, 32), "flat": (1, 8, 16, 32, 64)}
LEGENDS = ("lower right", "upper right")
MOST = 2  # no error is larger
LEAST = 3e-9


def by_line(results):
    """(normals, line) -> metrics by bounce, of which "all" is the summary."""
    found = {}
    for case in results.cases:
        p = case["params"]
        found.setdefault((p["normals"], p["line"]), {})[p["bounce"]] = case["metrics"]
    for normals in NORMALS:
        for line in LINES:
            if "all" not in found.get((normals, line), {}):
                raise SystemExit(f"{results.names()}: no summary of {normals} normals, line {line}")
    return found


def small(value):
    """Two digits; lost paths err infinitely."""
    return "lost" if value is None else f"{value:.1e}".replace("e-0", "e-") if value else "0"


def share_lost(metrics):
    return f"{100 * metrics['lost'] / metrics['paths']:.1f} %"


def rows(found, normals):
    """The last column is told once for each line, beside the positions."""
    last = {line: found[normals, line]["all"] for line in ROWS}
    for name in ("position", "direction"):
        for line, label in ROWS.items():
            cells = [small(found[normals, line][b][f"{name}_error_median"]) for b in COLUMNS[normals]]
            end = last_cell(normals, last[line]) if name == "position" else ""
            yield f"| {label}: {name} | {' | '.join(cells)} | {end} |"
    if normals == "flat":
        return
    for line, label in ROWS.items():
        cells = [share_lost(found[normals, line][b]) for b in COLUMNS[normals]]
        yield f"| {label}: lost | {' | '.join(cells)} | |"


def last_cell(normals, summary):
    return str(summary["half_lost_at"] or "none") if normals == "smooth" else share_lost(summary)


def table(results):
    found = by_line(results)
    lines = []
    for normals, last in (("smooth", "half are lost at"), ("flat", "lost by 64")):
        first, *others = COLUMNS[normals]
        lines += [f"| medians, {normals} normals | bounce {first} | {' | '.join(map(str, others))} | {last} |",
                  "|---" * (len(others) + 3) + "|", *rows(found, normals), ""]
    return "\n".join([*lines, wrapped(["- Positions are in radii of the room, directions in radians.",
                                       measured_on(results)])])


def curve(metrics, bounces, name):
    """Lost ones lie above all; an error of 0 has no place on the axis."""
    values = [metrics[b][name] for b in bounces]
    return [MOST if value is None else value or float("nan") for value in values]


def draw_line(axes, metrics, error, style):
    """The median, and a band that holds 10 to 90 % of the paths; it ends, with a mark, where half are lost."""
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


def plot(results):
    found = by_line(results)
    figure, axes = drawing.pyplot().subplots(2, 2, figsize=(12, 8), sharex=True, sharey=True)
    for column, normals in enumerate(NORMALS):
        for row, error in enumerate(ERRORS):
            draw_panel(axes[row][column], found, normals, error)
        axes[0][column].set_title(f"{normals} normals", fontsize=10)
        axes[0][column].legend(fontsize=8, title="half of the paths are lost at bounce",
                               title_fontsize=8, loc=LEGENDS[column])
        axes[1][column].set_xlabel("bounce")
    figure.suptitle(
        f"Errors between curved mirrors beside a trace in 113 bits: medians of "
        f"{found['smooth', 'rsh']['all']['paths']} paths, 10 to 90 % shaded\n"
        f"{device_text(results.documents[-1])}; rsh {commit_of(results.documents[-1])}", fontsize=10)
    figure.tight_layout()
    return figure
