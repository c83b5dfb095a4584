"""The functions of rsh.h on pyopencl's arrays."""

import gc

import numpy as np
import pyopencl as cl
import pyopencl.array as cla
import pytest
from conftest import closest, crossings, trace

import rsh
from rsh.structs import Hit, Light, Material, Scene

ENGINES = [rsh.ENGINE_TILES, rsh.ENGINE_PAPER, rsh.ENGINE_PAPER_FAITHFUL, rsh.ENGINE_BRUTE_FORCE]


def test_closest_hits_are_those_of_double_precision(context, queue, mesh):
    hits = closest(context, queue, mesh)
    origins, directions = (mesh.rays[name][:, :3] for name in ("origin_tmin", "direction_tmax"))
    t, depth = crossings(mesh.vertices, mesh.faces, origins, directions)
    t = np.where((depth >= 0) & (t >= 0), t, np.inf)
    clear = np.all((np.abs(depth) > 1e-5) | (np.abs(t) == np.inf), axis=1)
    nearest = np.sort(t, axis=1)
    clear &= (nearest[:, 0] == np.inf) | (nearest[:, 1] > nearest[:, 0] + 1e-5)
    primitive = np.where(nearest[:, 0] < np.inf, np.argmin(t, axis=1), rsh.NO_HIT)
    assert clear.sum() > 450
    assert 100 < (primitive[clear] != rsh.NO_HIT).sum() < 450
    np.testing.assert_array_equal(hits["primitive"][clear], primitive[clear])
    np.testing.assert_allclose(hits["t"][clear], nearest[clear, 0], rtol=1e-4)


@pytest.mark.parametrize("engine", ENGINES)
def test_engines_find_the_same_bits(context, queue, mesh, engine):
    expected = closest(context, queue, mesh)
    assert closest(context, queue, mesh, engine=engine).tobytes() == expected.tobytes()


def test_counts_equal_the_lengths_of_lists(context, queue, mesh):
    n = len(mesh.rays)
    counts = cla.zeros(queue, n, np.uint32)
    trace(context, queue, mesh, query=rsh.QUERY_COUNT, hit_counts=counts).wait()
    offsets = cla.zeros(queue, n + 1, np.uint64)
    hits = cla.zeros(queue, 1 << 16, np.dtype(Hit))
    trace(
        context, queue, mesh, query=rsh.QUERY_ALL, hits=hits, hit_offsets=offsets, hit_capacity=len(hits)
    ).wait()
    assert counts.get().sum() > 500
    np.testing.assert_array_equal(np.diff(offsets.get()), counts.get())


def test_parts_of_buffers_are_taken_without_a_copy(context, queue):
    stream = cla.to_device(queue, np.arange(4096, dtype=np.uint32))
    flags = cla.to_device(queue, (np.arange(2048) % 3 == 0).astype(np.uint8))
    kept, count = cla.zeros(queue, 2048, np.uint32), cla.zeros(queue, 1, np.uint32)
    rsh.reduce(
        context,
        queue,
        input=stream[2048:],
        count=2048,
        element_bytes=4,
        flags=flags,
        output=kept,
        output_count=count.base_data,
    ).wait()
    assert count.get()[0] == 683
    np.testing.assert_array_equal(kept.get()[:683], np.arange(2048, 4096, 3))


def test_a_call_waits_for_events_and_returns_one(context, queue):
    unordered = cl.CommandQueue(
        context.context, properties=cl.command_queue_properties.OUT_OF_ORDER_EXEC_MODE_ENABLE
    )
    stream, flags = (cla.to_device(queue, np.ones(64, t)) for t in (np.uint32, np.uint8))
    kept, count = cla.zeros(queue, 64, np.uint32), cla.zeros(queue, 1, np.uint32)
    queue.finish()
    gate = cl.UserEvent(context.context)
    event = rsh.reduce(
        context,
        unordered,
        input=stream,
        count=64,
        element_bytes=4,
        flags=flags,
        output=kept,
        output_count=count,
        wait_for=[gate],
    )
    unordered.flush()
    assert event.command_execution_status != cl.command_execution_status.COMPLETE
    assert count.get(queue)[0] == 0
    gate.set_status(cl.command_execution_status.COMPLETE)
    event.wait()
    assert count.get(queue)[0] == 64


def test_features_are_found_of_arrays_on_the_host():
    materials = np.zeros(2, np.dtype(Material))
    materials["diffuse"][:, :3] = 1
    materials["texture"] = rsh.NO_TEXTURE
    materials["reflection"][1] = (0.5, 0.5, 0.5, 0)
    lights = np.zeros(1, np.dtype(Light))
    lights["colour"][:, :3] = 1
    lights["casts_shadow"] = 1
    scene = Scene(material_count=2, light_count=1, ambient=(0.1, 0.1, 0.1))
    rsh.find_features(scene, materials, lights)
    assert scene.features == rsh.FEATURE_REFLECTION | rsh.FEATURE_SHADOW
    assert scene.shadow_lights == 1
    assert list(scene.ambient) == pytest.approx([0.1, 0.1, 0.1, 0])


def test_names_statistics_and_the_self_test(context, queue, mesh):
    assert rsh.engine_from_name(rsh.engine_name(rsh.ENGINE_PAPER)) == rsh.ENGINE_PAPER
    assert rsh.strategy_name(999) is None
    assert rsh.strategy_is_stable(rsh.STRATEGY_CHUNK) is True
    assert rsh.version() == rsh.VERSION
    rsh.count_statistics(context, 1)
    closest(context, queue, mesh)
    statistics = rsh.get_statistics(context)
    rsh.count_statistics(context, 0)
    assert statistics.traversals == 1
    assert rsh.device_selftest(context, queue).wrong_arithmetic == 0
    rsh.device_status(context, queue)


def prepare(context, progress, background):
    """Prepare a reduction; nobody else keeps the callback."""
    rsh.prepare(
        context,
        reduce=rsh.structs.ReduceDesc(count=1000, element_bytes=4, strategy=rsh.STRATEGY_CHUNK),
        background=background,
        progress=progress,
    )


def test_programs_are_prepared_in_the_background():
    told = []
    with rsh.Context(cache_dir="") as context:
        prepare(context, lambda done, count: told.append((done, count)), True)
        gc.collect()
        rsh.wait_prepared(context)
    assert told
    assert told[-1] == (len(told) - 1, len(told) - 1)


def test_a_context_has_no_more_variants_than_there_are():
    with pytest.raises(rsh.InvalidValueError, match="max_variants"):
        rsh.Context(max_variants=rsh.MAX_VARIANTS + 1)
    rsh.Context(max_variants=rsh.NO_VARIANTS).release()


def test_what_progress_raises_is_raised_by_prepare(context):
    with pytest.raises(ZeroDivisionError):
        prepare(context, lambda done, count: 1 // 0, False)
