"""Contenders in turn, what they take of the processor and of the clock, and the file of it."""

import argparse
import json
import os
import platform
import statistics
import sys
import time
from collections.abc import Callable
from importlib import metadata
from pathlib import Path
from typing import Any

import pyopencl as cl

# Threads of a pool may spin before they sleep: that belongs to what they worked for.
_SETTLE_SECONDS = 0.003


def run_in_turn(contenders: dict[str, Callable[[int], object]], rounds: int) -> dict[str, dict[str, float]]:
    """Call each of them with the number of the round, and return milliseconds by name.

    `cpu_ms` counts all threads of the process, user and system; `wall_ms` is the clock. Both are medians,
    `cpu_ms_low` and `cpu_ms_high` quartiles. A first round is not counted.
    """
    taken: dict[str, list[tuple[float, float]]] = {name: [] for name in contenders}
    for number in range(rounds + 1):
        for name, call in contenders.items():
            cpu, wall = time.process_time(), time.perf_counter()
            call(number)
            wall = time.perf_counter() - wall
            time.sleep(_SETTLE_SECONDS)
            taken[name].append((1000 * (time.process_time() - cpu), 1000 * wall))
    return {name: _summary(pairs[1:]) for name, pairs in taken.items()}


def _summary(pairs: list[tuple[float, float]]) -> dict[str, float]:
    cpu, wall = zip(*pairs, strict=True)
    low, median, high = statistics.quantiles(cpu, n=4, method="inclusive")
    return {"cpu_ms": median, "cpu_ms_low": low, "cpu_ms_high": high, "wall_ms": statistics.median(wall)}


def options(description: str | None, rounds: int) -> argparse.ArgumentParser:
    """Return a parser of what all benchmarks take."""
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("--rounds", type=int, default=rounds, help=f"counted rounds, at least 2; {rounds}")
    parser.add_argument("--json", type=Path, help="write all figures to this file")
    return parser


def write(path: Path | None, device: cl.Device, packages: list[str], cases: list[dict[str, Any]]) -> None:
    """Write cases beside what they depend on."""
    if path is None:
        return
    document = {
        "command": sys.argv,
        "device": device.name.strip(),
        "platform": device.platform.version.strip(),
        "instruction_set": _instruction_set(),
        "threads": len(os.sched_getaffinity(0)),
        "python": platform.python_version(),
        "packages": {name: metadata.version(name) for name in ["rsh", "pyopencl", "numpy", *packages]},
        "cases": cases,
    }
    path.write_text(json.dumps(document, indent=1) + "\n")


def _instruction_set() -> str:
    info = Path("/proc/cpuinfo")
    words = info.read_text().split() if info.exists() else []
    return next((name for name in ("avx512f", "avx2") if name in words), platform.machine())
