"""Tables of rsh-bench ablation: what each feature costs, and what the dearest ones do."""
from reporting.results import measured_on, wrapped

STATES = ("left_out", "compiled_in", "general", "used")
# A program of its own that saves less than both is not worth it.
LEAST_TIME, LEAST_COMPILATION = 0.01, 0.05
DEAREST = 5  # features of the short table


def by_feature(results):
    """Of each feature, the metrics of its states."""
    found = {}
    for case in results.cases:
        params = case["params"]
        found.setdefault(params["feature"], {})[params["state"]] = case["metrics"]
    return found


def compilation(metrics):
    return metrics["compile_ms"] + metrics.get("finish_ms", 0)


def cell(metrics, is_first):
    if not metrics:
        return "–"
    ratio = "" if is_first else f" ({metrics['ratio']:.2f})"
    return (f"{metrics['ms']:.2f}{ratio} · {metrics['bytes'] / 2**20:.1f} · {metrics['launches']} · "
            f"{compilation(metrics) / 1000:.1f}")


def row(feature, states):
    first = next(state for state in STATES if state in states)
    cells = [cell(states.get(state), state == first) for state in STATES]
    return f"| {feature.replace('_', ' ')} | {' | '.join(cells)} |"


def saved(states):
    """Shares of time and compilation that leaving the feature out saves a scene that does not have it."""
    out, within = states["left_out"], states["compiled_in"]
    return 1 - 1 / within["ratio"], 1 - compilation(out) / compilation(within)


def verdicts(features):
    """Of features that can be both left out and compiled in."""
    both = {name: saved(states) for name, states in features.items()
            if "left_out" in states and "compiled_in" in states}
    described = "; ".join(f"{name.replace('_', ' ')} {time:.1%} and {compiled:.1%}"
                          for name, (time, compiled) in both.items())
    poor = [name.replace("_", " ") for name, (time, compiled) in both.items()
            if time < LEAST_TIME and compiled < LEAST_COMPILATION]
    return [f"- Leaving it out saves a scene without it, of time and of compilation: {described}.",
            f"- Less than {LEAST_TIME:.0%} and less than {LEAST_COMPILATION:.0%}: "
            f"{', '.join(poor) if poor else 'none'}."]


def table(results):
    features = by_feature(results)
    lines = ["| | left out | compiled in | general | used |", "|---|---|---|---|---|"]
    lines += [row(name, states) for name, states in features.items()]
    rounds = results.cases[0]["metrics"]["rounds"]
    about = [f"- ms, median of {rounds} rounds in turn (in parentheses over the first column that there "
             "is, round by round) · MiB of all buffers · launches · seconds of processor time to compile.",
             *verdicts(features), measured_on(results)]
    return "\n".join([*lines, "", wrapped(about)])


def cost_row(feature, states):
    out, used = states["left_out"], states["used"]
    ratio = f"{states['compiled_in']['ratio']:.2f}" if "compiled_in" in states else "–"
    return (f"| {feature.replace('_', ' ')} | {out['ms']:.2f} | {ratio} "
            f"| {used['ratio']:.2f} | {out['bytes'] / 2**20:.1f} → {used['bytes'] / 2**20:.1f} "
            f"| {out['launches']} → {used['launches']} "
            f"| {compilation(out) / 1000:.1f} → {compilation(used) / 1000:.1f} |")


def costs(results):
    """Of the features that can be left out, those that take most time, the dearest first."""
    features = {name: states for name, states in by_feature(results).items()
                if {"left_out", "used"} <= states.keys()}
    dearest = sorted(features, key=lambda name: features[name]["used"]["ratio"], reverse=True)[:DEAREST]
    lines = ["| | left out, ms | compiled in | used | MiB | launches | s to compile |",
             "|---|--:|--:|--:|--:|--:|--:|"]
    lines += [cost_row(name, features[name]) for name in dearest]
    return "\n".join([*lines, "", wrapped([measured_on(results)])])
