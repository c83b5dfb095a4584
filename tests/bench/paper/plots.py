"""Plots of rsh-bench paper: where a frame's time goes, times over triangles and pixels, frames of animations."""
from paper.cases import ENGINES, TITLES, by_row, of_engine, series
from paper.report import STAGES
from reporting import drawing

COLOURS = dict(zip(ENGINES, ("tab:red", "tab:orange", "tab:blue")))
PIE_ROW = "several"


def case_of(results, row, engine):
    """The first that has shares; the frame of 512x512 that the paper tells of."""
    return next((case for case in of_engine(by_row(results).get(row, []), engine)
                 if "share_build" in case["metrics"]), None)


def draw_pie(axes, case):
    shares = [max(0, case["metrics"][share]) for share in STAGES]
    axes.pie(shares, labels=[label if share > 0.01 else "" for label, share in zip(STAGES.values(), shares)],
             autopct=lambda percent: f"{percent:.0f} %" if percent > 3 else "", startangle=90,
             textprops={"fontsize": 8})
    axes.set_title(f"{case['params']['engine']}: {case['metrics']['frame_ms']:.0f} ms", fontsize=10)


def pie(results):
    cases = [case_of(results, PIE_ROW, engine) for engine in ("paper_faithful", "tiles")]
    if None in cases:
        return None
    figure, axes = drawing.pyplot().subplots(1, 2, figsize=(10, 4.5))
    for panel, case in zip(axes, cases):
        draw_pie(panel, case)
    figure.suptitle("Where the time of a frame goes: several reflectors, 83 K triangles, 512x512", fontsize=10)
    figure.tight_layout()
    return figure


def draw_lines(axes, results, row, parameter):
    for engine in ENGINES:
        points = series(results, row, parameter, engine)
        if points:
            axes.plot(*zip(*points), "o-", color=COLOURS[engine], label=engine, markersize=4)
    axes.set(xscale="log", yscale="log", xlabel=parameter, ylabel="ms")
    axes.grid(alpha=0.3)


def draw_paper(axes, results, row):
    """The paper's figure, a cross at the size it is told for."""
    for case in by_row(results).get(row, []):
        if "paper_ms" in case["metrics"]:
            axes.plot(case["params"]["triangles"], case["metrics"]["paper_ms"], "kx", label="paper, 2007")
            return


def growth(results):
    if not any(series(results, row, "triangles", "tiles") for row in TITLES):
        return None
    figure, axes = drawing.pyplot().subplots(2, 2, figsize=(10, 7.5))
    for panel, (row, title) in zip(axes.flat, TITLES.items()):
        draw_lines(panel, results, row, "triangles")
        draw_paper(panel, results, row)
        panel.set_title(title, fontsize=10)
    draw_lines(axes[1][1], results, "resolution", "width")
    axes[1][1].set_title("a mirror floor, pictures of width x width", fontsize=10)
    axes[0][0].legend(fontsize=8)
    figure.suptitle("Bound, build and traversal of a frame", fontsize=10)
    figure.tight_layout()
    return figure


def animation(results):
    rows = [row for row in ("museum3", "museum8") if by_row(results).get(row)]
    if not rows:
        return None
    figure, axes = drawing.pyplot().subplots(1, len(rows), figsize=(5 * len(rows), 3.8), squeeze=False)
    for panel, row in zip(axes[0], rows):
        for case in by_row(results)[row]:
            times, engine = case["metrics"].get("ms_by_frame", []), case["params"]["engine"]
            moments = [(i + 0.5) / len(times) for i in range(len(times))]
            panel.plot(moments, times, ".-", color=COLOURS[engine], label=engine)
        panel.axhline(by_row(results)[row][0]["metrics"]["paper_ms"], color="k", dashes=(4, 3), linewidth=1,
                      label="paper, 2007")
        panel.set(yscale="log", xlabel="animation, 0 to 1", ylabel="ms", title=row)
        panel.grid(alpha=0.3)
    axes[0][0].legend(fontsize=8)
    figure.tight_layout()
    return figure


PLOTS = {"paper_pie.svg": pie, "paper_growth.svg": growth, "paper_frames.svg": animation}
