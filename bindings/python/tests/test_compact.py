"""compact against NumPy's own."""

import numpy as np
import pyopencl.array as cla
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import rsh


@settings(deadline=None, max_examples=40)
@given(
    count=st.one_of(st.integers(0, 70), st.sampled_from([4096, 70001])),
    row=st.sampled_from([(), (1,), (2,), (3,), (4,), (2, 2)]),
    dtype=st.sampled_from([np.float32, np.uint32, np.int16, np.float64, np.complex64]),
    keep=st.sampled_from([0, 0.1, 0.5, 1]),
    seed=st.integers(0, 9),
)
def test_it_equals_indexing_by_the_mask(queue, count, row, dtype, keep, seed):
    random = np.random.default_rng(seed)
    array = random.integers(0, 9999, (count, *row)).astype(dtype)
    mask = random.random(count) < keep
    size = array.itemsize * int(np.prod(row))
    if size not in (4, 8, 12, 16):
        with pytest.raises(ValueError, match=f"a row of array has {size} bytes, must have"):
            rsh.compact(array, mask)
        return
    np.testing.assert_array_equal(rsh.compact(array, mask), array[mask])
    np.testing.assert_array_equal(rsh.compact(array[::-1], mask[::-1]), array[::-1][mask[::-1]])
    if count:
        on_device = rsh.compact(cla.to_device(queue, array), cla.to_device(queue, mask.view(np.int8)))
        np.testing.assert_array_equal(on_device.get(), array[mask])


def test_what_does_not_fit_is_refused(queue):
    numbers = np.arange(4, dtype=np.float32)
    with pytest.raises(ValueError, match=r"mask has shape \(3,\), must be \(4,\)"):
        rsh.compact(numbers, np.ones(3, bool))
    with pytest.raises(TypeError, match="mask has dtype float64, must be bool"):
        rsh.compact(numbers, np.ones(4))
    with pytest.raises(TypeError, match="must be rows of plain bytes"):
        rsh.compact(np.array([None] * 4), np.ones(4, bool))
    with pytest.raises(TypeError, match="mask is ndarray, must be where array is"):
        rsh.compact(cla.to_device(queue, numbers), np.ones(4, bool))
    with pytest.raises(ValueError, match="must be C-contiguous"):
        rsh.compact(cla.zeros(queue, (4, 4), np.float32)[:, 1], cla.zeros(queue, 4, np.int8))
