"""Shared virtual memory in place of buffers and arrays, without a copy."""

import gc

import numpy as np
import pyopencl as cl
import pyopencl.array as cla
import pytest
from conftest import allocate
from pyopencl.tools import SVMAllocator, SVMPool

import rsh
from rsh import _shared
from rsh.structs import Geometry, RayFloats


@pytest.fixture
def share(context, queue):
    """Return what makes a NumPy array in shared virtual memory."""

    def made(array):
        shared = cl.csvm_empty(context.context, array.shape, array.dtype)
        with cl.SVM(shared).map_rw(queue) as mapped:
            mapped[...] = array
        return shared

    return made


def reduced(context, queue, numbers, output, count, **desc):
    return rsh.reduce(
        context,
        queue,
        input=numbers,
        count=64,
        element_bytes=4,
        keep=rsh.KEEP_NOT_NULL,
        output=output,
        output_count=count,
        **desc,
    )


NUMBERS = np.where(np.arange(64) % 3 == 0, np.arange(64), rsh.NO_HIT).astype(np.uint32)
KEPT = NUMBERS[NUMBERS != rsh.NO_HIT]


def test_results_are_in_the_memory_itself(context, queue, share):
    numbers, count = share(NUMBERS), share(np.zeros(1, np.uint32))
    allocation = cl.SVMAllocation(context.context, 256, 0, cl.svm_mem_flags.READ_WRITE)
    reduced(context, queue, cl.SVM(numbers), allocation, cl.SVM(count)).wait()
    with allocation.map_ro(queue) as found, cl.SVM(count).map_ro(queue) as counted:
        np.testing.assert_array_equal(np.frombuffer(found, np.uint32)[: counted[0]], KEPT)


def test_arrays_may_lie_in_it(context, queue):
    pool = SVMPool(SVMAllocator(context.context, queue=queue))
    numbers = cla.to_device(queue, NUMBERS, allocator=pool)
    kept, count = (cla.zeros(queue, n, np.uint32, allocator=pool) for n in (64, 1))
    queue.finish()
    reduced(context, queue, numbers, kept, count).wait()
    np.testing.assert_array_equal(kept.get()[: count.get()[0]], KEPT)


def test_a_scene_takes_it_at_any_place(context, queue, mesh, share):
    floats = mesh.rays.view(np.float32).reshape(-1, 8)
    expected = rsh.Scene(mesh.vertices, mesh.faces).closest(floats).primitive
    padded = share(np.pad(mesh.vertices, ((1, 0), (0, 0))))
    faces, rays = share(mesh.faces), share(floats)
    scene = rsh.Scene(cl.SVM(padded[1:]), cl.SVM(faces), queue=queue, context=context)
    hits = scene.closest(cl.SVM(rays))
    assert isinstance(hits, cla.Array)
    np.testing.assert_array_equal(hits.get()["primitive"], expected)
    np.testing.assert_array_equal(scene.closest(cl.SVM(rays[3:])).get()["primitive"], expected[3:])
    six = share(floats[:, [0, 1, 2, 4, 5, 6]])
    np.testing.assert_array_equal(scene.closest(cl.SVM(six[1:])).get()["primitive"], expected[1:])
    points = share(floats[:, :3])
    np.testing.assert_array_equal(scene.contains(cl.SVM(points)).get(), scene.contains(points))
    with cl.SVM(padded).map_rw(queue) as mapped:
        mapped *= 2
    scene.update(cl.SVM(padded[1:]))
    moved = rsh.Scene(2 * mesh.vertices, mesh.faces).closest(floats).primitive
    np.testing.assert_array_equal(scene.closest(cl.SVM(rays)).get()["primitive"], moved)


def test_rows_are_kept_of_it(queue, share):
    rows = share(np.arange(60, dtype=np.float32).reshape(20, 3))
    mask = share((np.arange(20) % 4 == 0).astype(np.uint8))
    kept = rsh.compact(cl.SVM(rows), cl.SVM(mask), queue=queue)
    np.testing.assert_array_equal(kept.get(), rows[mask != 0])


def test_parts_of_one_allocation_are_compared(context, queue, share):
    numbers, count = share(np.zeros(128, np.uint32)), share(np.zeros(1, np.uint32))
    first, second = cl.SVM(numbers[:64]), cl.SVM(numbers[64:])
    reduced(context, queue, first, second, cl.SVM(count)).wait()
    with pytest.raises(rsh.InvalidValueError, match="overlap"):
        reduced(context, queue, first, cl.SVM(numbers[32:96]), cl.SVM(count))


def test_it_is_kept_until_the_event_has_ended(context):
    queue = cl.CommandQueue(context.context)
    pool = SVMPool(SVMAllocator(context.context, queue=queue))
    kept, count = cla.zeros(queue, 64, np.uint32), cla.zeros(queue, 1, np.uint32)
    queue.finish()
    gate = cl.UserEvent(context.context)
    numbers = pool(256)
    event = reduced(context, queue, numbers, kept, count, wait_for=[gate])
    del numbers
    gc.collect()
    assert pool.active_blocks == 1
    gate.set_status(cl.command_execution_status.COMPLETE)
    event.wait()
    for _ in range(2):
        reduced(context, queue, kept, allocate(context, 256), count).wait()
    gc.collect()
    assert pool.active_blocks == 0
    assert not _shared._wholes


def test_queries_take_it_and_structs_stay_as_they_are(context, queue, mesh, share):
    vertices = share(mesh.vertices)
    geometry = Geometry(
        vertices=cl.SVM(vertices), vertex_count=300, indices=mesh.device_faces, triangle_count=200
    )
    before = bytes(geometry)
    size = rsh.bound_query(context, geometry=geometry).output_bytes
    rsh.bound(context, queue, geometry=geometry, bounds=allocate(context, size)).wait()
    rsh.prepare(context, bound=rsh.structs.BoundDesc(geometry=geometry))
    assert bytes(geometry) == before


def test_what_cannot_be_shared_is_refused(context, queue, share, monkeypatch):
    kept, count = share(np.zeros(64, np.uint32)), share(np.zeros(1, np.uint32))
    plain = cl.SVM(np.zeros(64, np.uint32))
    with pytest.raises(TypeError, match=r"ReduceDesc.input is memory of ndarray, must be of clSVMAlloc"):
        reduced(context, queue, plain, cl.SVM(kept), cl.SVM(count))
    with pytest.raises(ValueError, match=r"RayFloats.buffer has strides .*, must be C-contiguous"):
        RayFloats(buffer=cl.SVM(share(np.zeros((4, 4), np.float32)).T))
    with pytest.raises(ValueError, match=r"ReduceDesc.output begins 4 bytes into its memory, must be a mult"):
        reduced(context, queue, cl.SVM(kept), cl.SVM(share(np.zeros(65, np.uint32))[1:]), cl.SVM(count))
    other = cl.CommandQueue(cl.Context([context.device]))
    elsewhere = cla.zeros(other, 64, np.uint32, allocator=SVMAllocator(other.context, queue=other))
    with pytest.raises(ValueError, match=r"ReduceDesc.input is shared virtual memory of another pyopencl"):
        reduced(context, queue, elsewhere, cl.SVM(kept), cl.SVM(count))
    monkeypatch.setattr(_shared, "capabilities", lambda device: 0)
    with pytest.raises(TypeError, match=r"ReduceDesc.input is shared virtual memory, must be a buffer"):
        reduced(context, queue, cl.SVM(share(NUMBERS)), cl.SVM(kept), cl.SVM(count))
    monkeypatch.setattr(_shared, "capabilities", lambda device: _shared._SYSTEM)
    reduced(context, queue, cl.SVM(NUMBERS.copy()), cl.SVM(kept), cl.SVM(count)).wait()
    np.testing.assert_array_equal(kept[: count[0]], KEPT)


def test_a_scene_must_be_told_where_it_is(context, queue, mesh, share):
    vertices = cl.SVM(share(mesh.vertices))
    with pytest.raises(ValueError, match="queue is None, must be given with shared virtual memory"):
        rsh.Scene(vertices, mesh.faces)
    allocation = cl.SVMAllocation(context.context, 256, 0, cl.svm_mem_flags.READ_WRITE)
    with pytest.raises(TypeError, match=r"vertices is SVMAllocation, must be a pyopencl.SVM of"):
        rsh.Scene(allocation, mesh.faces, queue=queue)
