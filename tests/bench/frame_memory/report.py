"""Of rsh-bench memory: for frames and for traces, what each budget costs, from the least one upward."""
from reporting.results import measured_on, wrapped

WITHOUT = "none"
HEADS = {"frame": ("Frames", "of all scratch memory of the frame"),
         "trace": ("Rays", "of the streams of pairs alone")}
MIB = 1 << 20


def by_subject(results, call):
    """(scene, size, engine) -> budget -> metrics, of one call; without what a run that was cut short left."""
    found = {}
    for case in results.cases:
        params = case["params"]
        if params["call"] == call:
            size = f"{params['width']}x{params['height']}"
            found.setdefault((params["scene"], size, params["engine"]), {})[params["budget"]] = case["metrics"]
    return {subject: budgets for subject, budgets in found.items() if {WITHOUT, "least"} <= budgets.keys()}


def measured(budgets):
    """Those that were rendered with: one byte below the least is an error."""
    return {name: metrics for name, metrics in budgets.items() if name != "below"}


def columns(subjects):
    """Names of budgets in the order of their sizes: least, multiples, whole, none."""
    names = {name for budgets in subjects.values() for name in measured(budgets)}
    order = {"least": 1, "whole": float("inf")}
    return sorted(names - {WITHOUT}, key=lambda name: order.get(name) or int(name.removesuffix("x")))


def cell(metrics):
    if not metrics:
        return "–"
    return f"{metrics['slowdown']:.2f} · {metrics['batches']} · {metrics['bytes_peak'] / MIB:.1f}"


def row(subject, budgets, names):
    scene, size, engine = subject
    free = budgets[WITHOUT]
    cells = [f"{budgets['least']['budget'] / MIB:.2f}", *(cell(budgets.get(name)) for name in names),
             f"{free['ms']:.0f} ms · {free['batches']} · {free['bytes_peak'] / MIB:.1f}"]
    return f"| {scene} {size}, {engine} | {' | '.join(cells)} |"


def call_table(results, call):
    subjects = by_subject(results, call)
    if not subjects:
        return []
    names = columns(subjects)
    title, meaning = HEADS[call]
    return [f"{title}; the budget is {meaning}.", "",
            f"| | least, MiB | {' | '.join(names)} | without |", "|---" * (len(names) + 3) + "|",
            *(row(subject, budgets, names) for subject, budgets in subjects.items()), ""]


def verdict(results):
    """What all cases together show."""
    cases = [case["metrics"] for case in results.cases if case["params"]["budget"] != "below"]
    highest = max((metrics["bytes_peak"] / metrics["bytes_allowed"] for metrics in cases), default=0)
    return (f"- {sum(metrics['mismatches'] for metrics in cases)} mismatches in {len(cases)} cases. Allocated at once "
            f"is at most {highest:.4f} of what is allowed. A byte less than the least is an error that names the "
            f"least, {len(results.cases) - len(cases)} times of as many.")


def table(results):
    lines = [line for call in HEADS for line in call_table(results, call)]
    about = ["- Cells: the time over that without a budget in the same round, median · batches of triangles, all "
             "traversals together · most MiB that were allocated at once, by a layer that counts. Last column: the "
             "time itself.", verdict(results), measured_on(results)]
    return "\n".join([*lines, wrapped(about)])
