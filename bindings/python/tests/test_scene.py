"""Scene against double precision, brute force and its own other ways."""

import numpy as np
import pyopencl as cl
import pyopencl.array as cla
import pytest
from conftest import crossings
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as hn

import rsh

BOX = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], float)
BOX_FACES = np.array(
    [
        [0, 1, 3],
        [0, 3, 2],
        [4, 6, 7],
        [4, 7, 5],
        [0, 4, 5],
        [0, 5, 1],
        [2, 3, 7],
        [2, 7, 6],
        [0, 2, 6],
        [0, 6, 4],
        [1, 5, 7],
        [1, 7, 3],
    ]
)


@pytest.fixture(scope="module")
def scene(mesh):
    return rsh.Scene(mesh.vertices, mesh.faces)


@pytest.fixture(scope="module")
def rays(mesh):
    return mesh.rays.view(np.float32).reshape(-1, 8)


def test_all_ways_to_give_rays_find_the_same(scene, rays):
    expected = scene.closest(rays)
    assert 100 < (expected.primitive != rsh.NO_HIT).sum() < 450
    assert np.all((expected.t == np.inf) == (expected.primitive == rsh.NO_HIT))
    short = rays[:, [0, 1, 2, 4, 5, 6]]
    for given_rays in (short, short.astype(float), np.asfortranarray(short), short.tolist()):
        assert scene.closest(given_rays).tobytes() == expected.tobytes()
    assert scene.closest(short.reshape(20, 25, 6)).tobytes() == expected.tobytes()
    assert scene.closest_hits(rays[:, :3], rays[:, 4:7]).tobytes() == expected.tobytes()


def test_rays_on_the_device_stay_there(scene, rays):
    expected = scene.closest(rays, normal=True)
    hits, normals = scene.closest(cla.to_device(scene.queue, rays), normal=True)
    np.testing.assert_array_equal(hits.get()["primitive"], expected.primitive)
    np.testing.assert_array_equal(normals.get(), expected.normal)
    assert isinstance(hits.events[-1], cl.Event)
    six = cla.to_device(scene.queue, np.ascontiguousarray(rays[:, [0, 1, 2, 4, 5, 6]]))
    assert scene.closest(six[100:]).get()["primitive"].tolist() == expected.primitive[100:].tolist()
    np.testing.assert_array_equal(scene.any(six).get(), scene.any(rays))
    np.testing.assert_array_equal(scene.count(six).get(), scene.count(rays))
    for of_device, of_host in zip(scene.all(six), scene.all(rays), strict=True):
        np.testing.assert_array_equal(of_device.get(), of_host.view(np.ndarray))
    inside = scene.contains(cla.to_device(scene.queue, rays[:, :3].copy()))
    np.testing.assert_array_equal(inside.get(), scene.contains(rays[:, :3]))


def test_locations_of_rays_on_the_device_stay_there(scene, rays):
    sent = cla.to_device(scene.queue, rays)
    expected = scene.closest(rays, normal=True, location=True)
    _, alone = scene.closest(sent, location=True)
    hits, normals, locations = scene.closest(sent.reshape(20, 25, 8), normal=True, location=True)
    assert (locations.shape, locations.dtype) == ((20, 25, 3), np.float32)
    assert alone.get().tobytes() == locations.get().tobytes()
    np.testing.assert_array_equal(normals.get().reshape(-1, 3), expected.normal)
    np.testing.assert_allclose(alone.get(), expected.location, atol=2e-6)
    assert np.all(np.isnan(alone.get()) == (expected.primitive == rsh.NO_HIT)[:, None])
    (hits, listed), offsets = scene.all(sent, location=True)
    of_host, _ = scene.all(rays, location=True)
    assert listed.shape == (int(offsets.get()[-1]), 3)
    np.testing.assert_array_equal(hits.get()["primitive"], of_host.primitive)
    np.testing.assert_allclose(listed.get(), of_host.location, atol=2e-6)


def test_engines_agree(mesh, scene, rays):
    other = rsh.Scene(mesh.vertices, mesh.faces, engine=rsh.ENGINE_BRUTE_FORCE)
    assert other.closest(rays).tobytes() == scene.closest(rays).tobytes()
    np.testing.assert_array_equal(other.count(rays), scene.count(rays))


def test_all_hits_are_those_of_double_precision(mesh, scene, rays):
    t, depth = crossings(mesh.vertices, mesh.faces, rays[:, :3], rays[:, 4:7])
    is_clear = np.all((np.abs(depth) > 1e-5) & (np.abs(t) > 1e-5) | (depth == -np.inf), axis=1)
    hits, offsets = scene.all(rays, location=True)
    expected = (depth >= 0) & (t >= 0)
    assert is_clear.sum() > 450
    for ray in np.flatnonzero(is_clear):
        mine = hits[offsets[ray] : offsets[ray + 1]]
        np.testing.assert_array_equal(np.sort(mine.primitive), np.flatnonzero(expected[ray]))
        assert np.all(np.diff(mine.t) >= 0)
        at = rays[ray, :3] + mine.t[:, None].astype(float) * rays[ray, 4:7]
        np.testing.assert_allclose(mine.location, at, atol=1e-5)
    np.testing.assert_array_equal(np.diff(offsets), scene.count(rays))
    np.testing.assert_array_equal(scene.any(rays), np.diff(offsets) > 0)


def test_lists_grow_when_there_are_more_hits_than_expected():
    layers = np.tile(np.array([[-9, -9, 0], [9, -9, 0], [0, 9, 0]], np.float32), (3000, 1))
    layers[:, 2] = np.repeat(np.arange(3000), 3)
    hits, offsets = rsh.Scene(layers).all([[0, 0, -1, 0, 0, 1]])
    np.testing.assert_array_equal(hits.primitive, np.arange(3000))
    np.testing.assert_array_equal(offsets, [0, 3000])


def test_vertices_move(mesh, rays):
    scene = rsh.Scene(mesh.vertices, mesh.faces)
    scene.closest(rays, location=True)
    moved = mesh.vertices @ np.array([[0, 1, 0], [-1, 0, 0], [0, 0, 2]], np.float32)
    scene.update(moved)
    expected = rsh.Scene(moved, mesh.faces).closest(rays, location=True)
    found = scene.closest(rays, location=True)
    assert found.tobytes() == expected.tobytes()
    padded = np.full((300, 4), np.nan, np.float32)
    padded[:, :3] = mesh.vertices
    scene.update(cla.to_device(scene.queue, padded))
    assert scene.closest(rays).tobytes() == rsh.Scene(mesh.vertices, mesh.faces).closest(rays).tobytes()
    with pytest.raises(ValueError, match=r"vertices has shape \(299, 3\), must be \(300, 3\) as before"):
        scene.update(mesh.vertices[1:])


def test_faces_that_stand_still_are_left_alone(mesh, rays):
    still = len(mesh.faces) // 2
    moves = np.setdiff1d(np.arange(len(mesh.vertices)), mesh.faces[:still])
    assert len(moves) > 10
    scene = rsh.Scene(mesh.vertices, mesh.faces, still_faces=still)
    assert scene._mesh.geometry.still_triangles == still
    moved = np.array(mesh.vertices)
    for _ in range(3):
        scene.closest(rays)
        moved[moves] += np.float32(0.1)
        scene.update(moved)
        assert scene.closest(rays).tobytes() == rsh.Scene(moved, mesh.faces).closest(rays).tobytes()
    for wrong in (-1, len(mesh.faces) + 1):
        with pytest.raises(ValueError, match=f"still_faces is {wrong}, must be 0 .. {len(mesh.faces)}"):
            rsh.Scene(mesh.vertices, mesh.faces, still_faces=wrong)


def test_a_box_contains_what_is_inside(queue):
    points = np.random.default_rng(1).uniform(-0.5, 1.5, (2000, 3))
    inside = np.all((points > 0) & (points < 1), axis=1)
    box = rsh.Scene(BOX, BOX_FACES, queue=queue)
    np.testing.assert_array_equal(box.contains(points), inside)
    assert box.context is rsh.Scene(BOX, BOX_FACES, queue=queue).context
    outwards = np.sum(box.closest_hits([[2, 0.3, 0.6]], [[-1, 0, 0]], normal=True).normal, axis=0)
    np.testing.assert_array_equal(outwards, [1, 0, 0])


def test_rays_through_corners_and_edges_cross_a_box_twice():
    grid = np.stack(np.meshgrid(*[np.linspace(0.25, 0.75, 3)] * 3), -1).reshape(-1, 3)
    targets = np.vstack([BOX, (BOX[:, None] + BOX[None])[np.triu_indices(8, 1)] / 2])
    origins = grid.repeat(len(targets), 0)
    directions = np.tile(targets, (len(grid), 1)) - origins
    is_ray = np.any(directions != 0, axis=1)
    rays = rsh.make_rays((origins - 8 * directions)[is_ray], directions[is_ray])
    np.testing.assert_array_equal(rsh.Scene(BOX, BOX_FACES).count(rays), 2)


def test_ranges_tell_meshes(queue):
    ranges = np.zeros(2, np.dtype(rsh.structs.MeshRange))
    ranges["first_triangle"], ranges["id"], ranges["mask"] = (0, 6), (7, 9), 0xFFFFFFFF
    scene = rsh.Scene(BOX, BOX_FACES, ranges=ranges)
    assert scene._mesh.geometry.range_count == 2
    with pytest.raises(TypeError, match="ranges has dtype"):
        rsh.Scene(BOX, BOX_FACES, ranges=np.zeros(2))


def test_what_does_not_fit_is_refused(scene, queue):
    with pytest.raises(ValueError, match=r"rays has shape \(7,\), must be \(n, 6\)"):
        scene.closest(np.zeros(7))
    with pytest.raises(TypeError, match="rays has dtype complex128, must be real numbers"):
        scene.closest(np.zeros((3, 6), complex))
    with pytest.raises(TypeError, match="rays has dtype float64, must be float32"):
        scene.closest(cla.zeros(queue, (3, 6), np.float64))
    with pytest.raises(ValueError, match="faces has values from -1 to 0"):
        rsh.Scene(BOX, [[0, 0, -1]])
    with pytest.raises(TypeError, match="faces has dtype float64, must be integers"):
        rsh.Scene(BOX, [[0.0, 1.0, 2.0]])
    with pytest.raises(ValueError, match=r"vertices has shape \(8, 3\), must be \(3 n, 3\) without faces"):
        rsh.Scene(BOX)
    with pytest.raises(ValueError, match="directions has shape"):
        rsh.make_rays(np.zeros(3), np.zeros(2))
    with pytest.raises(ValueError, match="shape mismatch"):
        rsh.make_rays(np.zeros((2, 3)), np.zeros((3, 3)))


DTYPES = st.one_of(hn.floating_dtypes(), hn.integer_dtypes(), hn.boolean_dtypes(), hn.complex_number_dtypes())
ARRAYS = hn.arrays(DTYPES, hn.array_shapes(min_dims=0, max_dims=4, min_side=0, max_side=8))


@settings(deadline=None, max_examples=150)
@given(array=ARRAYS, is_wide=st.booleans(), order=st.sampled_from(["C", "F", "reversed", "strided"]))
def test_any_array_is_right_or_refused(scene, array, is_wide, order):
    if is_wide and array.ndim:
        array = np.resize(array, (*array.shape[:-1], 6))
    if order == "F":
        array = np.asfortranarray(array)
    elif array.ndim and order == "reversed":
        array = array[::-1]
    elif array.ndim and order == "strided":
        array = array.repeat(2, 0)[::2]
    if array.dtype.kind in "bc" or array.ndim not in (2, 3) or array.shape[-1] not in (6, 8):
        with pytest.raises((TypeError, ValueError), match="rays has"):
            scene.closest(array)
        return
    hits = scene.closest(array)
    with np.errstate(over="ignore"):
        copy = np.array(array, np.float32, order="C")
    assert hits.shape == array.shape[:-1]
    assert hits.tobytes() == scene.closest(copy).tobytes()
    assert scene.all(array)[1].shape == (hits.size + 1,)


@pytest.mark.parametrize("engine", [rsh.ENGINE_TILES, rsh.ENGINE_BRUTE_FORCE])
def test_what_arrays_wait_for_is_waited_for(context, mesh, scene, rays, engine):
    properties = cl.command_queue_properties.OUT_OF_ORDER_EXEC_MODE_ENABLE
    queue = cl.CommandQueue(context.context, properties=properties)
    other = rsh.Scene(mesh.vertices, mesh.faces, queue=queue, context=context, engine=engine)
    moved, sent = cla.to_device(queue, mesh.vertices), cla.to_device(queue, rays)
    queue.finish()
    for waiting in moved, sent:
        gate = cl.UserEvent(context.context)
        waiting.add_event(gate)
        other.update(moved)
        hits = other.closest(sent)
        queue.flush()
        assert hits.events[-1].command_execution_status > cl.command_execution_status.COMPLETE
        gate.set_status(cl.command_execution_status.COMPLETE)
        assert hits.get().tobytes() == scene.closest(rays).tobytes()
