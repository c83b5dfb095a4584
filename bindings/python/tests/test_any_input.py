"""Whatever array is given, an answer is that for the same numbers as C-contiguous float32, or there is a
TypeError or ValueError; nothing else, and no crash."""

import numpy as np
import pyopencl as cl
import pyopencl.array as cla
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as hn

import rsh

RECORD = np.dtype([("x", np.float32), ("id", np.int32)])
NUMBERS = st.one_of(
    hn.floating_dtypes(endianness="?"),
    hn.integer_dtypes(endianness="?"),
    hn.unsigned_integer_dtypes(endianness="?"),
)
OTHERS = st.one_of(
    hn.boolean_dtypes(),
    hn.complex_number_dtypes(endianness="?"),
    hn.byte_string_dtypes(max_len=4),
    hn.unicode_string_dtypes(max_len=4),
    hn.datetime64_dtypes(),
    hn.timedelta64_dtypes(),
    st.sampled_from([RECORD, np.dtype(object)]),
)
SHAPES = st.one_of(
    hn.array_shapes(min_dims=0, max_dims=4, min_side=0, max_side=9),
    st.tuples(st.integers(0, 9), st.sampled_from([3, 4, 6, 8])),
)
ARRAYS = st.one_of(NUMBERS, NUMBERS, NUMBERS, OTHERS).flatmap(
    lambda dtype: hn.arrays(dtype, SHAPES, elements=st.none() if dtype.hasobject else None)
)


def read_only(array):
    array.setflags(write=False)
    return array


LAYOUTS = {
    "as it is": lambda array: array,
    "Fortran's": np.asfortranarray,
    "reversed": lambda array: np.flip(array),
    "with gaps": lambda array: array.repeat(2, 0)[::2] if array.ndim else array,
    "transposed": lambda array: array.T,
    "repeated": lambda array: (
        np.broadcast_to(array.flat[:1].reshape((1,) * array.ndim), array.shape) if array.size else array
    ),
    "read-only": lambda array: read_only(array.copy()),
    "not aligned": lambda array: (
        np.frombuffer(b"\0" + array.tobytes(), np.uint8, offset=1).view(array.dtype).reshape(array.shape)
        if array.size and not array.dtype.hasobject
        else array
    ),
    "list": lambda array: array.tolist(),
    "masked": np.ma.masked_array,
}
SETTINGS = settings(deadline=None, max_examples=100)


def floats(array):
    with np.errstate(over="ignore", invalid="ignore"):
        return np.array(array, np.float32, order="C")


def bytes_of(answer):
    parts = answer if isinstance(answer, tuple) else (answer,)
    return b"".join(np.asarray(part).tobytes() for part in parts)


def outcome(call, *arrays):
    """Bytes of the answer, or None where an array is refused."""
    try:
        return bytes_of(call(*arrays))
    except (TypeError, ValueError):
        return None


def is_real(array):
    return array.dtype.kind in "fiu"


@pytest.fixture(scope="module")
def scene(mesh):
    return rsh.Scene(mesh.vertices, mesh.faces)


@SETTINGS
@given(
    array=ARRAYS,
    layout=st.sampled_from(list(LAYOUTS)),
    name=st.sampled_from(["closest", "any", "count", "all", "contains"]),
)
def test_rays_and_points(scene, array, layout, name):
    made = LAYOUTS[layout](array)
    plain = np.asarray(made)
    widths, ndims = ((3,), (2,)) if name == "contains" else ((6, 8), (2, 3))
    is_right = is_real(plain) and plain.ndim in ndims and plain.shape[-1] in widths
    found = outcome(getattr(scene, name), made)
    assert (found is not None) == is_right
    if is_right:
        assert found == bytes_of(getattr(scene, name)(floats(plain)))


RAYS = np.random.default_rng(3).uniform(-9, 9, (40, 6))


@SETTINGS
@given(array=ARRAYS, layout=st.sampled_from(list(LAYOUTS)), moves=st.booleans())
def test_vertices(array, layout, moves):
    made = LAYOUTS[layout](array)
    plain = np.asarray(made)
    is_right = is_real(plain) and plain.ndim == 2 and plain.shape[1] in (3, 4) and len(plain) % 3 == 0

    def trace(vertices):
        scene = rsh.Scene(np.zeros((len(vertices), 3)) if moves else vertices)
        scene.update(vertices)
        return scene.closest(RAYS)

    found = outcome(trace, made)
    assert (found is not None) == is_right
    if is_right:
        assert found == bytes_of(trace(floats(plain)))


@SETTINGS
@given(array=ARRAYS, layout=st.sampled_from(list(LAYOUTS)))
def test_faces(mesh, array, layout):
    made = LAYOUTS[layout](array)
    plain = np.asarray(made)
    assume(made is not None)  # as a date that is none becomes in a list: then there are no faces
    is_right = plain.dtype.kind in "iu" and plain.ndim == 2 and plain.shape[1] == 3
    is_right = is_right and (plain.size == 0 or 0 <= int(plain.min()) <= int(plain.max()) < 2**32)

    def trace(faces):
        return rsh.Scene(mesh.vertices, faces).closest(RAYS)

    found = outcome(trace, made)
    assert (found is not None) == is_right
    if is_right:
        assert found == bytes_of(trace(np.array(plain, np.uint32, order="C")))


@SETTINGS
@given(
    array=ARRAYS,
    mask=ARRAYS,
    layout=st.sampled_from(list(LAYOUTS)),
    fits=st.booleans(),
    seed=st.integers(0, 9),
)
def test_rows_and_masks(array, mask, layout, fits, seed):
    made = LAYOUTS[layout](array)
    plain = np.asarray(made)
    if fits and plain.ndim:
        mask = np.random.default_rng(seed).integers(0, 2, len(plain)).astype(np.int8)
    is_right = plain.ndim > 0 and not plain.dtype.hasobject and plain.dtype.itemsize > 0
    is_right = is_right and mask.shape == plain.shape[:1] and mask.dtype in (np.bool_, np.int8, np.uint8)
    is_right = is_right and plain.dtype.itemsize * int(np.prod(plain.shape[1:])) in (4, 8, 12, 16)
    found = outcome(rsh.compact, made, mask)
    assert (found is not None) == is_right
    if is_right:
        assert found == plain[mask != 0].tobytes()


@SETTINGS
@given(arrays=st.lists(ARRAYS, min_size=4, max_size=4))
def test_parts_of_rays(arrays):
    found = outcome(rsh.make_rays, *arrays)
    if found is not None:
        assert all(is_real(array) for array in arrays)
        assert all(array.shape[-1] == 3 for array in arrays[:2])


ON_DEVICE = {
    "as it is": lambda array: array,
    "from row 1 on": lambda array: array[1:],
    "from row 3 on": lambda array: array[3:],
    "with gaps": lambda array: array[::2],
    "reversed": lambda array: array[::-1],
    "transposed": lambda array: array.T,
    "without a queue": lambda array: array.with_queue(None),
}


@pytest.fixture(scope="module")
def elsewhere(context):
    return cl.CommandQueue(cl.Context([context.device]))


@SETTINGS
@given(
    dtype=st.sampled_from([np.float32, np.float32, np.float64, np.uint32, np.int32, np.int8, np.complex64]),
    shape=st.one_of(
        hn.array_shapes(min_dims=1, max_dims=3, min_side=0, max_side=9),
        st.tuples(st.integers(0, 20), st.sampled_from([3, 4, 6, 8])),
    ),
    layout=st.sampled_from(list(ON_DEVICE)),
    name=st.sampled_from(["closest", "any", "count", "all", "contains", "vertices", "faces", "compact"]),
    is_foreign=st.integers(0, 4).map(lambda number: number == 0),
    seed=st.integers(0, 9),
)
def test_arrays_on_the_device(mesh, scene, elsewhere, dtype, shape, layout, name, is_foreign, seed):
    plain = np.random.default_rng(seed).uniform(0, 60, shape).astype(dtype)
    queue = elsewhere if is_foreign else scene.queue
    made = ON_DEVICE[layout](cla.to_device(queue, plain))
    queue.finish()
    same = plain if layout == "without a queue" else ON_DEVICE[layout](plain)

    def closest_of(vertices, faces):
        return rsh.Scene(vertices, faces, queue=scene.queue).closest(RAYS)

    def kept(array):
        mask = np.arange(len(same)) % 3 == 0
        is_there = isinstance(array, cla.Array)
        return rsh.compact(array, cla.to_device(scene.queue, mask.view(np.int8)) if is_there else mask)

    calls = {
        "vertices": lambda array: closest_of(array, None),
        "faces": lambda array: closest_of(mesh.vertices, array),
        "compact": kept,
    }
    call = calls.get(name) or getattr(scene, name)

    def fetched(array):
        answer = call(array)
        parts = answer if isinstance(answer, tuple) else (answer,)
        arrays = [part.get(scene.queue) if isinstance(part, cla.Array) else part for part in parts]
        return tuple(a.astype(np.uint32) if a.dtype == bool else a for a in arrays)

    found = outcome(fetched, made)
    if name in ("closest", "any", "count", "all") and dtype == np.float32 and not is_foreign:
        is_contiguous = made.flags.c_contiguous
        assert (found is not None) == (is_contiguous and same.ndim in (2, 3) and same.shape[-1] in (6, 8))
    if found is None:
        return
    expected = fetched(np.ascontiguousarray(same))
    if name in ("closest", "all") and isinstance(expected[0], np.recarray):
        raw = np.frombuffer(found[: expected[0].nbytes], expected[0].dtype)
        np.testing.assert_array_equal(raw["primitive"], expected[0].primitive.ravel())
    else:
        assert found == bytes_of(expected)
