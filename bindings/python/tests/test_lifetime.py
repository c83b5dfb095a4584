"""What a call refers to lives until its event has ended, and no longer than that."""

import gc
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pyopencl as cl
import pyopencl.array as cla
from conftest import closest
from pyopencl.tools import ImmediateAllocator, MemoryPool

import rsh


class Stream:
    """64 numbers to reduce."""

    def __init__(self, context, queue):
        self.context, self.queue = context, queue
        self.numbers = cla.to_device(queue, np.arange(64, dtype=np.uint32))
        self.kept = cla.zeros(queue, 64, np.uint32)
        self.count = cla.zeros(queue, 1, np.uint32)
        queue.finish()

    def numbers_in(self, pool):
        numbers = cla.Array(self.queue, 64, np.uint32, allocator=pool)
        numbers.set(self.numbers.get(self.queue), queue=self.queue)
        return numbers

    def reduce(self, numbers, wait_for=None):
        return rsh.reduce(
            self.context,
            self.queue,
            input=numbers,
            count=64,
            element_bytes=4,
            keep=rsh.KEEP_NOT_NULL,
            output=self.kept,
            output_count=self.count,
            wait_for=wait_for,
        )


def test_buffers_are_kept_until_the_event_has_ended(context):
    queue = cl.CommandQueue(context.context)
    stream = Stream(context, queue)
    gate = cl.UserEvent(context.context)
    pool = MemoryPool(ImmediateAllocator(queue))
    event = stream.reduce(stream.numbers_in(pool), [gate])
    stream.reduce(stream.numbers, [gate])
    gc.collect()
    assert pool.active_blocks == 1
    gate.set_status(cl.command_execution_status.COMPLETE)
    event.wait()
    queue.finish()
    assert stream.count.get(queue)[0] == 64
    for _ in range(2):
        stream.reduce(stream.numbers).wait()
    gc.collect()
    assert pool.active_blocks == 0


def test_a_call_keeps_what_its_structs_referred_to_when_it_was_made(context, mesh):
    queue = cl.CommandQueue(context.context)
    pool = MemoryPool(ImmediateAllocator(queue))
    geometry = mesh.geometry.copy()
    geometry.vertices = cla.to_device(queue, mesh.vertices, allocator=pool)
    bounds = cl.Buffer(
        context.context, cl.mem_flags.READ_WRITE, rsh.bound_query(context, geometry=geometry).output_bytes
    )
    queue.finish()
    gate = cl.UserEvent(context.context)
    event = rsh.bound(context, queue, geometry=geometry, bounds=bounds, wait_for=[gate])
    geometry.vertices = mesh.device_vertices
    gc.collect()
    assert pool.active_blocks == 1
    gate.set_status(cl.command_execution_status.COMPLETE)
    event.wait()


def test_ten_thousand_calls_leave_nothing_behind(context):
    queue = cl.CommandQueue(context.context)
    stream = Stream(context, queue)

    def references():
        gc.collect()
        return stream.numbers.base_data.reference_count, queue.reference_count

    def call(times):
        for i in range(times):
            event = stream.reduce(stream.numbers)
            if i % 100 == 99:
                event.wait()
        queue.finish()
        for _ in range(3):
            stream.reduce(stream.numbers).wait()
        return references()

    assert call(10000) == call(100)
    assert len(context._pending) < 200


def test_threads_share_a_context(context, queue, mesh):
    expected = closest(context, queue, mesh).tobytes()

    def run(_):
        own = cl.CommandQueue(context.context)
        return all(closest(context, own, mesh).tobytes() == expected for _ in range(20))

    with ThreadPoolExecutor(4) as threads:
        assert all(threads.map(run, range(4)))


def test_threads_share_a_scene(mesh):
    scene = rsh.Scene(mesh.vertices, mesh.faces)
    rays = mesh.rays.view(np.float32).reshape(-1, 8)
    expected = scene.closest(rays).tobytes()
    with ThreadPoolExecutor(4) as threads:
        assert all(hits.tobytes() == expected for hits in threads.map(scene.closest, [rays] * 100))


def test_a_scene_takes_no_more_memory_as_it_is_used(mesh):
    scene = rsh.Scene(mesh.vertices, mesh.faces)
    rays = mesh.rays.view(np.float32).reshape(-1, 8)

    def use(times):
        for _ in range(times):
            scene.update(mesh.vertices)
            scene.closest(rays, normal=True)
        return scene._tracer.pool.managed_bytes, scene._mesh._pool.managed_bytes

    assert use(500) == use(10)
