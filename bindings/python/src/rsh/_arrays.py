"""Arrays of callers: on the host any real numbers, on the device what can be taken as it is."""

from collections.abc import Sequence
from typing import Any, TypeAlias

import numpy as np
import pyopencl as cl
import pyopencl.array as cla
from numpy.typing import ArrayLike, NDArray

Floats: TypeAlias = ArrayLike | cla.Array | cl.SVMPointer


def require(is_right: bool, name: str, array: Any, what: str) -> None:
    """Refuse an array of another shape."""
    if not is_right:
        raise ValueError(f"{name} has shape {tuple(array.shape)}, must be {what}")


def is_on_device(array: object) -> bool:
    """Whether the answers are to stay on the device as well."""
    return isinstance(array, cla.Array | cl.SVMPointer)


def queue_of(array: Any) -> cl.CommandQueue:
    """Return the queue of an array on the device, or one of its context."""
    if isinstance(array, cl.SVMPointer):
        raise ValueError("queue is None, must be given with shared virtual memory, which does not tell it")
    return array.queue or cl.CommandQueue(array.context)


def on_host(name: str, value: ArrayLike, dtype: type[Any] = np.float32) -> NDArray[Any]:
    """Return real numbers, or integers, C-contiguous and in the type that rsh takes."""
    array = np.asarray(value)
    kinds, what = ("fiu", "real numbers") if dtype is np.float32 else ("iu", "integers")
    if array.dtype.kind not in kinds:
        raise TypeError(f"{name} has dtype {array.dtype}, must be {what}")
    if dtype is not np.float32 and array.size and not 0 <= array.min() <= array.max() < 2**32:
        raise ValueError(f"{name} has values from {array.min()} to {array.max()}, must be 0 to 2^32 - 1")
    with np.errstate(over="ignore"):
        return np.asarray(array, dtype, order="C")


def on_device(
    name: str, array: Any, queue: cl.CommandQueue, dtypes: Sequence[type[Any]] = (np.float32,)
) -> cla.Array:
    """Return the array, which must be C-contiguous and of one of these types; of pyopencl.SVM one over it."""
    array = over_shared(name, array, queue)
    if array.dtype not in dtypes:
        raise TypeError(f"{name} has dtype {array.dtype}, must be {' or '.join(t.__name__ for t in dtypes)}")
    if not array.flags.c_contiguous:
        raise ValueError(f"{name} has strides {array.strides}, must be C-contiguous")
    return array  # type: ignore[no-any-return]


def over_shared(name: str, array: Any, queue: cl.CommandQueue) -> Any:
    """Return the array, or of shared virtual memory one over it."""
    if not isinstance(array, cl.SVMPointer):
        return array
    shaped = getattr(array, "mem", None)
    if not isinstance(shaped, np.ndarray):
        raise TypeError(f"{name} is {type(array).__name__}, must be a pyopencl.SVM of a NumPy array")
    return cla.Array(queue, shaped.shape, shaped.dtype, data=array, strides=shaped.strides)
