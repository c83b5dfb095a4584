"""Arrays of callers: on the host any real numbers, on the device what can be taken as it is."""

from collections.abc import Sequence
from typing import Any, TypeAlias

import numpy as np
import pyopencl.array as cla
from numpy.typing import ArrayLike, NDArray

Floats: TypeAlias = ArrayLike | cla.Array


def require(is_right: bool, name: str, array: Any, what: str) -> None:
    """Refuse an array of another shape."""
    if not is_right:
        raise ValueError(f"{name} has shape {tuple(array.shape)}, must be {what}")


def is_on_device(array: object) -> bool:
    """Whether the answers are to stay on the device as well."""
    return isinstance(array, cla.Array)


def on_host(name: str, value: ArrayLike, dtype: type[Any] = np.float32) -> NDArray[Any]:
    """Return real numbers, or integers, C-contiguous and in the type that rsh takes."""
    array = np.asarray(value)
    kinds, what = ("fiu", "real numbers") if dtype is np.float32 else ("iu", "integers")
    if array.dtype.kind not in kinds:
        raise TypeError(f"{name} has dtype {array.dtype}, must be {what}")
    if dtype is not np.float32 and array.size and not 0 <= array.min() <= array.max() < 2**32:
        raise ValueError(f"{name} has values from {array.min()} to {array.max()}, must be 0 to 2^32 - 1")
    with np.errstate(over="ignore"):
        return np.ascontiguousarray(array, dtype)


def on_device(name: str, array: cla.Array, dtypes: Sequence[type[Any]] = (np.float32,)) -> cla.Array:
    """Return the array, which must be C-contiguous and of one of these types."""
    if array.dtype not in dtypes:
        raise TypeError(f"{name} has dtype {array.dtype}, must be {' or '.join(t.__name__ for t in dtypes)}")
    if not array.flags.c_contiguous:
        raise ValueError(f"{name} has strides {array.strides}, must be C-contiguous")
    return array
