#!/usr/bin/env python3
"""aff_check.py PROGRAM FILE... - AFF files in motion against an evaluation of their own, with NumPy: PROGRAM
(rsh_moments) writes what rsh-render renders of every FILE at some times, and of a file that is made here.
Triangles, lights and the camera's eye must be within 1e-5 of the scene's size, unit vectors within 1e-5."""
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

from aff_made import make_file
from aff_scene import CONE_TRIANGLES, SPHERE_TRIANGLES, Moment, Scene

TIMES = 9
TOLERANCE = 1e-5


class Rendered:
    """One time of what the program wrote."""

    def __init__(self, floats):
        self.floats, self.at = floats, 0
        self.eye, self.looks_at, self.up = self.take(9).reshape(3, 3)
        self.lights = self.take(6 * int(self.take(1)[0])).reshape(-1, 6)
        self.triangles = self.take(18 * int(self.take(1)[0])).reshape(-1, 2, 3, 3)

    def take(self, count):
        self.at += count
        return self.floats[self.at - count:self.at].astype(np.float64)


class Worst:
    """The greatest distances so far."""

    def __init__(self):
        self.place = self.direction = 0.0

    def places(self, a, b, size):
        self.place = max(self.place, float(np.abs(a - b).max(initial=0.0)) / size)

    def directions(self, a, b):
        self.direction = max(self.direction, float(np.abs(a - b).max(initial=0.0)))

    def is_good(self):
        return self.place <= TOLERANCE and self.direction <= TOLERANCE


def compare_thing(moment, thing, found, size, worst):
    kind, node, what = thing
    if not moment.visible[node]:
        worst.places(found[:, 0], found[:, 0, :1], size)  # a point
    elif kind in ("sphere", "cone"):
        distances = moment.surface_distance(kind, node, what, found[:, 0])
        worst.places(distances, np.zeros_like(distances), size)
    else:
        expected = moment.triangles(node, moment.local(what) if kind == "morph" else what)
        worst.places(found[:, 0], expected[:, 0], size)
        worst.directions(found[:, 1], expected[:, 1])


def compare(moment, rendered, worst):
    corners = rendered.triangles[:, 0].reshape(-1, 3)
    size = np.linalg.norm(corners.max(axis=0) - corners.min(axis=0))
    counts = {"sphere": SPHERE_TRIANGLES, "cone": CONE_TRIANGLES, "morph": 1}
    first = 0
    for thing in moment.scene.things:
        count = counts.get(thing[0]) or len(thing[2])
        compare_thing(moment, thing, rendered.triangles[first:first + count], size, worst)
        first += count
    if first != len(rendered.triangles):
        raise SystemExit(f"{len(rendered.triangles)} triangles are rendered, must be {first}")
    eye, direction, up = moment.camera()
    worst.places(rendered.eye, eye, size)
    worst.directions(rendered.looks_at - rendered.eye,
                     direction * np.linalg.norm(rendered.looks_at - rendered.eye))
    worst.directions(rendered.up, up)
    lights = moment.lights()
    worst.places(rendered.lights[:, :3], lights[:, :3], size)
    worst.directions(rendered.lights[:, 3:], lights[:, 3:])


def check(program, path, folder):
    scene = Scene(path)
    # Neither the first nor the last time is of any help to who forgets to interpolate.
    times = [float(scene.start + (scene.end - scene.start) * (i + 0.37) / TIMES) for i in range(TIMES)]
    out = Path(folder) / "moments"
    subprocess.run([program, path, out, *map(repr, times)], check=True)
    floats, worst = np.fromfile(out, "<f4"), Worst()
    for time in times:
        rendered = Rendered(floats)
        compare(Moment(scene, time), rendered, worst)
        floats = floats[rendered.at:]
    print(f"{'passed' if worst.is_good() else 'FAILED'} {path}: {len(rendered.triangles)} triangles, "
          f"{len(rendered.lights)} lights and the camera at {TIMES} times, off by at most {worst.place:.2g} of "
          f"the size, directions and colours by {worst.direction:.2g}")
    return worst.is_good()


def main():
    program, *paths = sys.argv[1:]
    with tempfile.TemporaryDirectory() as folder:
        results = [check(program, path, folder) for path in [make_file(Path(folder) / "made.aff"), *paths]]
    return 0 if all(results) else 1


if __name__ == "__main__":
    sys.exit(main())
