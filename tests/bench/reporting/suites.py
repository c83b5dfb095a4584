"""The list of suites: what is made of the results of each."""
from collections.abc import Callable
from dataclasses import dataclass, field

import ablation.report
import accuracy.report
import approximate.report
import budgets.report
import frame_memory.report
import hits.report
import mirrors.report
import moving.report
import paper.plots
import paper.report
import reduce.report
from reporting import plain


@dataclass(frozen=True)
class Suite:
    # Of results, printed, and in pages the section with the suite's name.
    table: Callable = plain.table
    # That section, if it keeps some of what stands there now: of results and that text.
    filled: Callable | None = None
    # Further sections, by name: of results.
    more: dict = field(default_factory=dict)
    # By file name: of results, the figure, or None where they have nothing to draw.
    plots: dict = field(default_factory=dict)

    def section(self, name, results, present):
        if name in self.more:
            return self.more[name](results)
        return self.filled(results, present) if self.filled else self.table(results)


SUITES = {
    "ablation": Suite(ablation.report.table, more={"ablation-costs": ablation.report.costs}),
    "accuracy": Suite(accuracy.report.table, plots={"accuracy.svg": accuracy.report.plot}),
    "approximate": Suite(approximate.report.table),
    "budgets": Suite(budgets.report.table, filled=budgets.report.filled),
    "frame": Suite(),
    "hits": Suite(hits.report.table, plots={"hits.svg": hits.report.plot}),
    "memory": Suite(frame_memory.report.table),
    "mirrors": Suite(mirrors.report.table, plots={"mirrors.png": mirrors.report.plot}),
    "moving": Suite(moving.report.table),
    "paper": Suite(paper.report.table, more=paper.report.SECTIONS, plots=paper.plots.PLOTS),
    "parity": Suite(),
    "programs": Suite(),
    "queries": Suite(),
    "reduce": Suite(reduce.report.table, plots=reduce.report.PLOTS),
    "stability": Suite(),
}


def suite_of_section(name):
    return next((suite for suite, known in SUITES.items() if name == suite or name in known.more), None)
