"""What the metrics of each suite mean: which way is better, and what tells how far they may be trusted."""
from dataclasses import dataclass


@dataclass(frozen=True)
class Metric:
    """What something costs, or, where more is better, yields. `spread` begins the names of the quartiles by
    which a change is told from noise: those of the time itself where a ratio has none of its own."""

    more_is_better: bool = False
    spread: str = ""


# What is reported and compared, the telling ones first.
COSTS = {
    "ablation": {"ms": Metric(spread="ms"), "ratio": Metric(spread="ratio"), "bytes": Metric(),
                 "launches": Metric(), "compile_ms": Metric(), "finish_ms": Metric()},
    "accuracy": {"ms": Metric(spread="ms"), "ratio": Metric(more_is_better=True, spread="ms"),
                 "rmse": Metric(), "flip": Metric(), "wrong_pixels": Metric()},
    "approximate": {"ratio": Metric(more_is_better=True, spread="ratio"),
                    "ratio_cpu": Metric(more_is_better=True), "ms": Metric(spread="ms"),
                    "flip": Metric(), "flip_above": Metric(), "rmse": Metric(), "traced": Metric()},
    "budgets": {"measured_u": Metric()},
    "frame": {"ms_total": Metric(spread="ms_total"), "ms_bound": Metric(), "ms_build": Metric(),
              "ms_traverse": Metric(), "ratio_embree": Metric(more_is_better=True, spread="ratio_embree"),
              "ratio_embree_refit": Metric(more_is_better=True, spread="ms_total"),
              "build_over_copy": Metric(spread="build_over_copy"), "tests_per_ray": Metric(),
              "pairs_peak": Metric(), "launches": Metric(), "bytes_peak": Metric()},
    "hits": {"ms_total": Metric(spread="ms"),
             "ratio_embree_default": Metric(more_is_better=True, spread="ms"),
             "ratio_embree_robust": Metric(more_is_better=True, spread="ms")},
    "memory": {"slowdown": Metric(spread="slowdown"), "ms": Metric(spread="ms"), "bytes_peak": Metric(),
               "batches": Metric(), "budget": Metric()},
    "mirrors": {"times_the_best": Metric(), "position_error_median": Metric(),
                "direction_error_median": Metric(), "next_hit_error_median": Metric(), "lost": Metric(),
                "half_lost_at": Metric(more_is_better=True), "tenth_lost_at": Metric(more_is_better=True)},
    "moving": {"bound_ratio": Metric(spread="bound_ratio"), "bound_cpu_ratio": Metric(),
               "traverse_ratio": Metric(spread="traverse_ratio"), "traverse_cpu_ratio": Metric(),
               "bound_ms": Metric(), "traverse_ms": Metric(), "ms": Metric(spread="ms"),
               "grown_kib": Metric()},
    "paper": {"ms": Metric(spread="ms"), "frame_ms": Metric(spread="frame_ms"),
              "build_over_copy": Metric(spread="build_over_copy"), "bytes_peak": Metric(),
              "pairs_peak": Metric(), "node_tests": Metric(), "ray_tests": Metric()},
    "parity": {"near": Metric()},
    "programs": {"seconds": Metric()},
    "queries": {f"{kind}_{query}": Metric() for kind in ("ms", "ratio", "ms_traverse", "ratio_traverse")
                for query in ("closest", "any", "count", "all")},
    "reduce": {"ms": Metric(spread="ms"), "elements_per_s": Metric(more_is_better=True, spread="ms"),
               "ratio_to_copy": Metric(more_is_better=True, spread="ratio"), "launches": Metric()},
    "stability": {"t_error_of_budget": Metric()},
}

# Answers that are wrong, or that differ where none may.
FAULTS = ("mismatches", "columns_disagree", "missed", "spurious", "wrong_triangle", "wrong", "inexact", "leaks",
          "differ", "unsteady", "nan_out", "self_hits")


def is_peer(case):
    """Another program, whose times and errors are not rsh's."""
    params = case["params"]
    return bool(params.get("peer")) or str(params.get("strategy", "")).startswith("peer:")
