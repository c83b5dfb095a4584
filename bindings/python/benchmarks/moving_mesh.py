#!/usr/bin/env python3
"""moving_mesh.py [--rounds N] [--quick] [--json FILE] - rsh beside embreex, on meshes that move.

All vertices are new in each frame, and 512 x 512 rays are traced, by both in turn in one process; needs
embreex where rsh is installed. Prints the CPU time of a frame, from NumPy's vertices to NumPy's hits: of
all threads, user and system, the median and in brackets quartiles; and embreex's by rsh's, above 1 where rsh
takes less. Answers are compared first: ends with 1 when more than one ray in 10000 has another t, a hit for a
miss or a miss for a hit, as rays near edges may.
"""

import sys
from typing import Any

import numpy as np
from contenders import Answer, Embreex, Rebuilt, Refitted
from meshes import Moving, camera_rays, random_rays, waving_sheet, waving_sphere
from rounds import options, run_in_turn, write

import rsh
from rsh._default import default

PHASES = (0.0, 0.1, 0.2, 0.3)
MOST_OTHER = 1e-4
RELATIVE_T = 1e-4  # both round; most where a ray grazes its triangle


def count_other(ours: Answer, theirs: Answer) -> int:
    """Count rays that hit on one side alone, or elsewhere."""
    is_hit, is_their_hit = ours[1] != rsh.NO_HIT, theirs[1] != rsh.NO_HIT
    is_far = np.abs(ours[0] - theirs[0]) > RELATIVE_T * theirs[0]
    return int(np.sum((is_hit != is_their_hit) | (is_hit & is_their_hit & is_far)))


def measure(mesh: Moving, kind: str, rounds: int) -> dict[str, Any]:
    """Compare the answers of a frame, then time all in turn."""
    rays = camera_rays() if kind == "coherent" else random_rays()
    frames = [mesh.vertices(phase) for phase in PHASES]
    contenders = {
        "refit": Refitted(frames[0], mesh.faces, rays),
        "rebuild": Rebuilt(frames[0], mesh.faces, rays),
        "embreex": Embreex(mesh.faces, rays, robust=True),
        "embreex, not robust": Embreex(mesh.faces, rays, robust=False),
    }
    theirs = contenders["embreex"].frame(frames[1])
    other = max(count_other(contenders[name].frame(frames[1]), theirs) for name in ("refit", "rebuild"))
    taken = run_in_turn(
        {name: lambda number, c=c: c.frame(frames[number % len(frames)]) for name, c in contenders.items()},
        rounds,
    )
    return {
        "mesh": mesh.name,
        "triangles": len(mesh.faces),
        "rays": kind,
        "ray_count": rays.size // 6,
        "hits": int(np.sum(theirs[1] != rsh.NO_HIT)),
        "other": other,
        "ratio_refit": taken["embreex"]["cpu_ms"] / taken["refit"]["cpu_ms"],
        "ratio_rebuild": taken["embreex"]["cpu_ms"] / taken["rebuild"]["cpu_ms"],
        "metrics": taken,
    }


def row(case: dict[str, Any]) -> str:
    """Return a case as a line of the table."""
    times = [
        f"{m['cpu_ms']:6.1f} ({m['cpu_ms_low']:.1f} to {m['cpu_ms_high']:.1f})"
        for m in case["metrics"].values()
    ]
    ratios = f"{case['ratio_refit']:5.2f} | {case['ratio_rebuild']:5.2f}"
    name = f"{case['mesh']}, {case['triangles']}, {case['rays']}"
    return f"| {name:24} | {' | '.join(times)} | {ratios} | {case['other']} |"


def main() -> int:
    """Print the table; 1 when answers differ."""
    parser = options(__doc__, 11)
    parser.add_argument("--quick", action="store_true", help="the smallest sheet alone")
    given = parser.parse_args()
    makers = [(waving_sheet, (100, 200, 400)), (waving_sphere, (5, 6, 7))]
    meshes = [make(size) for make, sizes in makers for size in sizes]
    ours, theirs = "refit | rebuild", "embreex | embreex, not robust"
    print(f"| mesh, triangles, rays | {ours} | {theirs} | by refit | by rebuild | other |")
    print("|---|--:|--:|--:|--:|--:|--:|--:|")
    cases = []
    for kind in "coherent", "random":
        for mesh in meshes[:1] if given.quick else meshes:
            cases.append(measure(mesh, kind, given.rounds))
            print(row(cases[-1]), flush=True)
    write(given.json, default()[0].device, ["embreex"], cases)
    return int(any(case["other"] > MOST_OTHER * case["ray_count"] for case in cases))


if __name__ == "__main__":
    sys.exit(main())
