#!/usr/bin/env python3
"""reduction.py [--rounds N] [--count N] [--json FILE] - rsh.reduce beside pyopencl.algorithm.copy_if.

Both pack elements of 4 and of 8 bytes, half of which are kept, in turn in one process, on one device and
queue; copy_if needs mako. Prints the CPU time of a call and in brackets the clock's, medians, and copy_if's
by rsh's. Answers are compared with NumPy's first; ends with 1 when one is wrong. rsh.reduce reads a byte per
element that says whether it is kept, copy_if computes an expression.
"""

import sys
from collections.abc import Callable
from typing import Any

import numpy as np
import pyopencl as cl
import pyopencl.algorithm
import pyopencl.array as cla
from rounds import options, run_in_turn, write

import rsh
from rsh._default import default

TYPES = {4: np.uint32, 8: np.uint64}


def our_call(elements: cla.Array, flags: cla.Array) -> Callable[[], Any]:
    """Return what packs the elements with rsh.reduce."""
    context, queue = default()
    output, count = cla.empty_like(elements), cla.zeros(queue, 1, np.uint32)
    asked = {"input": elements, "count": len(elements), "element_bytes": elements.dtype.itemsize}

    def call() -> Any:
        rsh.reduce(context, queue, **asked, flags=flags, output=output, output_count=count).wait()
        return output, count

    return call


def their_call(elements: cla.Array) -> Callable[[], Any]:
    """Return what packs them with copy_if."""

    def call() -> Any:
        output, count, event = cl.algorithm.copy_if(elements, "(ary[i] & 1) != 0")
        event.wait()
        return output, count

    return call


def measure(count: int, size: int, rounds: int) -> dict[str, Any]:
    """Compare both answers with NumPy's, then time both in turn."""
    _, queue = default()
    numbers = np.random.default_rng(1).integers(0, 2**32, count).astype(TYPES[size])
    elements = cla.to_device(queue, numbers)
    flags = cla.to_device(queue, (numbers & 1).astype(np.uint8))
    calls = {"rsh.reduce": our_call(elements, flags), "copy_if": their_call(elements)}
    expected = numbers[(numbers & 1) != 0]
    is_right = True
    for call in calls.values():
        output, kept = call()
        found = output.get(queue)[: int(kept.get(queue).ravel()[0])]
        is_right &= np.array_equal(found, expected)
    taken = run_in_turn({name: lambda _, call=call: call() for name, call in calls.items()}, rounds)
    ours, theirs = taken.values()
    return {
        "count": count,
        "bytes": size,
        "kept": len(expected),
        "ok": bool(is_right),
        "ratio_cpu": theirs["cpu_ms"] / ours["cpu_ms"],
        "ratio_wall": theirs["wall_ms"] / ours["wall_ms"],
        "metrics": taken,
    }


def main() -> int:
    """Print a line for each size; 1 when an answer is wrong."""
    parser = options(__doc__, 21)
    parser.add_argument("--count", type=int, default=2**22, help="elements; 4194304")
    given = parser.parse_args()
    cases = [measure(given.count, size, given.rounds) for size in TYPES]
    for case in cases:
        told = [f"{name} {m['cpu_ms']:.1f} ms ({m['wall_ms']:.1f})" for name, m in case["metrics"].items()]
        ratios = f"ratio {case['ratio_cpu']:.1f} ({case['ratio_wall']:.1f})"
        verdict = "" if case["ok"] else ", WRONG"
        print(f"{case['count']} elements of {case['bytes']} bytes: {', '.join(told)}, {ratios}{verdict}")
    write(given.json, default()[0].device, [], cases)
    return int(not all(case["ok"] for case in cases))


if __name__ == "__main__":
    sys.exit(main())
