"""counted_calls.py LAYER ROUNDS - makes all kinds of calls while a layer of OpenCL counts objects. Prints as
JSON what is alive before all, after a few rounds, after ROUNDS more, and behind all."""

import ctypes as ct
import gc
import json
import re
import sys
from pathlib import Path

import numpy as np
import pyopencl as cl
import pyopencl.array as cla
from pyopencl.tools import clear_first_arg_caches

import rsh
from rsh.structs import Geometry, Hit

HEADER = Path(__file__).parents[3] / "tests/support/layers/counts.hpp"
WORDS = re.findall(r"\bWORD\((\w+)\)", HEADER.read_text())


def alive(layer):
    gc.collect()
    counts = (ct.c_size_t * len(WORDS))()
    layer.rsh_read_counts(counts)
    return {name: count for name, count in zip(WORDS, counts, strict=True) if name.endswith("_alive")}


class Calls:
    """In a round, twelve calls answer and six fail."""

    def __init__(self):
        self.context = rsh.Context()
        self.queue = cl.CommandQueue(self.context.context)
        random = np.random.default_rng(5)
        self.vertices = random.uniform(-1, 1, (60, 3)).astype(np.float32)
        self.faces = random.integers(0, 60, (40, 3)).astype(np.uint32)
        self.rays = rsh.make_rays(random.uniform(-2, 2, (64, 3)), random.uniform(-1, 1, (64, 3)))
        self.scene = rsh.Scene(self.vertices, self.faces, queue=self.queue, context=self.context)
        self.sent = [cla.to_device(self.queue, a) for a in (self.vertices, self.faces, self.rays)]
        self.numbers = cla.arange(self.queue, 64, dtype=np.uint32)
        self.kept, self.count = cla.zeros(self.queue, 64, np.uint32), cla.zeros(self.queue, 1, np.uint32)
        self.shared = cl.csvm_empty(self.context.context, 64, np.uint32)
        self.hits = cla.zeros(self.queue, 64, np.dtype(Hit))
        self.queue.finish()

    def round(self):
        scene, vertices, rays = self.scene, self.sent[0], self.sent[2]
        scene.update(vertices)
        scene.closest(rays, normal=True)
        scene.update(self.vertices)
        scene.closest(self.rays, location=True)
        scene.any(self.rays)
        scene.count(rays)
        scene.all(self.rays)
        scene.contains(self.vertices)
        self.reduce(self.numbers)
        self.reduce(cl.SVM(self.shared))
        self.reduce(self.numbers[32:], count=32)
        self.traverse()
        self.fail()

    def reduce(self, numbers, count=64):
        desc = {"count": count, "element_bytes": 4, "keep": rsh.KEEP_NOT_NULL, "output_count": self.count}
        return rsh.reduce(self.context, self.queue, input=numbers, output=self.kept, **desc)

    def traverse(self, **desc):
        geometry = Geometry(vertices=self.sent[0], vertex_count=60, indices=self.sent[1], triangle_count=40)
        scene = {"geometry": geometry, "shape": rsh.SHAPE_BOX}
        rays = {"rays": self.sent[2], "width": 64}
        bounds = self.allocate(rsh.bound_query(self.context, **scene))
        nodes = self.allocate(rsh.build_query(self.context, **rays, shape=rsh.SHAPE_BOX))
        bounded = rsh.bound(self.context, self.queue, **scene, bounds=bounds)
        built = rsh.build(self.context, self.queue, **rays, shape=rsh.SHAPE_BOX, nodes=nodes)
        waits = {"wait_for": [bounded, built]}
        what = {"bounds": bounds, "nodes": nodes, "hits": self.hits, **waits, **desc}
        return rsh.traverse(self.context, self.queue, **scene, **rays, engine=rsh.ENGINE_TILES, **what)

    def allocate(self, sizes):
        return cl.Buffer(self.context.context, cl.mem_flags.READ_WRITE, sizes.output_bytes)

    def fail(self):
        failed = cl.UserEvent(self.context.context)
        failed.set_status(-5)
        calls = [
            lambda: self.traverse(progress=lambda batch, count: 1 // batch),
            lambda: self.traverse(progress=lambda batch, count: True),
            lambda: self.traverse(hits=None),
            lambda: self.traverse(wait_for=[failed]),
            lambda: self.reduce(self.numbers[1:]),
            lambda: self.scene.closest(self.rays[:, :5]),
        ]
        for call in calls:
            try:
                call()
            except (rsh.Error, ValueError, ZeroDivisionError):
                continue
            raise AssertionError("a call that must fail did not")

    def settle(self):
        """Let later calls find that all others have ended."""
        for _ in range(3):
            self.queue.finish()
            self.reduce(self.numbers).wait()


def main():
    layer, rounds = ct.CDLL(sys.argv[1]), int(sys.argv[2])
    found = [alive(layer)]
    calls = Calls()
    for times in 20, rounds:
        for _ in range(times):
            calls.round()
        calls.settle()
        found.append(alive(layer))
    del calls
    clear_first_arg_caches()  # kernels of pyopencl's own, for arrays
    found.append(alive(layer))
    print(json.dumps(found))


if __name__ == "__main__":
    main()
