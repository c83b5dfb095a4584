"""Whether new results are worse than old ones of the same suite and device."""
import math
import statistics
from dataclasses import dataclass

from reporting.metrics import COSTS, FAULTS, is_peer
from reporting.results import commit_of, other_device

FORMAT = 1  # of files that were written before there was a number


@dataclass(frozen=True)
class Change:
    case: str
    metric: str
    old: float
    new: float
    worse: float  # by this share; below 0 it is better. Half the speed and twice the time both are 1
    is_noise: bool  # the quartiles overlap


class Comparison:
    """Of cases with the same name and parameters in both."""

    def __init__(self, old, new):
        self.suite = old.suite
        self.old, self.new = keyed(old), keyed(new)
        both = self.old.keys() & self.new.keys()
        if not both:
            raise SystemExit(f"{old.names()} and {new.names()} have no case in common")
        self.only_old = [case["name"] for key, case in self.old.items() if key not in both]
        self.only_new = [case["name"] for key, case in self.new.items() if key not in both]
        self.changes = sorted((change for key in self.old if key in both
                               for change in changes(self.suite, self.old[key], self.new[key])),
                              key=lambda change: -change.worse)
        self.faults = [text for key, case in self.new.items() for text in new_faults(self.old.get(key), case)]

    def beyond(self, threshold):
        return [change for change in self.changes if change.worse > threshold and not change.is_noise]

    def medians(self):
        """(metric, median of its changes, how many)."""
        found = {}
        for change in self.changes:
            found.setdefault(change.metric, []).append(change.worse)
        return [(metric, statistics.median(values), len(values)) for metric, values in found.items()]


def keyed(results):
    return {(case["name"], *sorted((field, str(value)) for field, value in case["params"].items())): case
            for case in results.cases if not is_peer(case)}


def refusal(old, new, any_device):
    """Why files cannot be compared, or nothing."""
    mine, its = old.documents[0], new.documents[0]
    if old.suite != new.suite:
        return f"suites differ: {old.suite} and {new.suite}"
    if old.suite not in COSTS:
        return f"suite {old.suite} has no metrics to compare, must be one of {', '.join(COSTS)}"
    for field, default in (("format_version", FORMAT), ("quick", False)):
        if mine.get(field, default) != its.get(field, default):
            return f"{field} differs: is {mine.get(field, default)} and {its.get(field, default)}"
    device = None if any_device else other_device(mine, its)
    return f"devices differ: {device}; --any-device compares them all the same" if device else None


def number(value):
    """What is not finite is null in the files."""
    return math.inf if value is None else float(value)


def worse_by(old, new, more_is_better):
    if more_is_better:
        old, new = new, old
    if old == new:
        return 0.0
    return math.inf if old == 0 or new == math.inf else new / old - 1


def overlap(spread, old, new):
    """Whether the quartiles do, where both have them."""
    low, high = f"{spread}_low", f"{spread}_high"
    if not spread or any(end not in metrics for end in (low, high) for metrics in (old, new)):
        return False
    return old[low] <= new[high] and new[low] <= old[high]


def changes(suite, old, new):
    old, new, where = old["metrics"], new["metrics"], old["name"]
    for metric, kind in COSTS[suite].items():
        if metric in old and metric in new:
            a, b = number(old[metric]), number(new[metric])
            yield Change(where, metric, a, b, worse_by(a, b, kind.more_is_better),
                         overlap(kind.spread, old, new))


def new_faults(old, new):
    """What is wrong now and was not, or was less. `old` may be None: no case of before."""
    before = old["metrics"] if old else {}
    for metric in FAULTS:
        was, now = int(before.get(metric) or 0), int(new["metrics"].get(metric) or 0)
        if now > was:
            yield f"{new['name']}: {metric} is {now}, was {was if old else 'not measured'}"
    if not new["ok"] and (not old or old["ok"]):
        why = new["metrics"].get("why") or new["metrics"].get("error")
        yield f"{new['name']}: is wrong" + (f": {why}" if why else "")


def line(change, is_beyond):
    mark = "  BEYOND THE THRESHOLD" if is_beyond else "  quartiles overlap" if change.is_noise else ""
    return (f"{change.worse:>+10.1%}  {change.metric:<22} {change.old:>11.5g} {change.new:>11.5g}  "
            f"{change.case}{mark}")


def text(old, new, comparison, threshold):
    beyond = comparison.beyond(threshold)
    lines = [f"{comparison.suite}: {old.names()} (commit {commit_of(old.documents[0])}) and "
             f"{new.names()} (commit {commit_of(new.documents[0])})",
             f"{'worse by':>10}  {'metric':<22} {'old':>11} {'new':>11}  case"]
    lines += [line(change, change in beyond) for change in comparison.changes]
    lines += [f"median: {metric} {median:+.1%} of {count}" for metric, median, count in comparison.medians()]
    lines += [f"only in {old.names()}: {case}" for case in comparison.only_old]
    lines += [f"only in {new.names()}: {case}" for case in comparison.only_new]
    lines += [f"WRONG: {fault}" for fault in comparison.faults]
    lines.append(f"{len(comparison.changes)} compared, "
                 f"{len(beyond)} worse by more than {100 * threshold:g} %, "
                 f"{len(comparison.faults)} new faults")
    return "\n".join(lines)


def run(old, new, threshold, any_device):
    """The text, and whether nothing is worse."""
    why = refusal(old, new, any_device)
    if why:
        raise SystemExit(f"{old.names()} and {new.names()}: {why}")
    comparison = Comparison(old, new)
    return text(old, new, comparison, threshold), not (comparison.beyond(threshold) or comparison.faults)
