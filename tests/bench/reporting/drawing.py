"""Plots by matplotlib, which is imported when there is something to draw, and their files."""


def pyplot():
    try:
        import matplotlib
    except ImportError:
        raise SystemExit("plots need matplotlib: tests/install_packages.sh bench installs it for "
                         "/usr/bin/python3") from None
    matplotlib.use("Agg")
    import matplotlib.pyplot
    # The same bytes again for the same results, with text as text.
    matplotlib.rcParams.update({"svg.hashsalt": "rsh", "svg.fonttype": "none"})
    return matplotlib.pyplot


def save(figure, path, results):
    """Writes what the plot was made of into it, so that a plot of older results is noticed without drawing."""
    path.parent.mkdir(parents=True, exist_ok=True)
    dateless = {"Date": None} if path.suffix == ".svg" else {"Software": None}
    figure.savefig(path, dpi=90, metadata={"Description": results.digest(), **dateless})
    pyplot().close(figure)


def is_of(path, results):
    return path.exists() and results.digest().encode() in path.read_bytes()
