"""Device memory of pyopencl as a handle of OpenCL, without a copy."""

from typing import Any, TypeAlias

import pyopencl as cl
from pyopencl.array import Array

Memory: TypeAlias = cl.MemoryObjectHolder | Array | None


def memory_object(value: Any) -> Any:
    """Return what has the handle of `value`, or None.

    Parameters
    ----------
    value : pyopencl.Buffer, pyopencl.array.Array or None
        An array must be C-contiguous; one that begins inside of a buffer becomes a sub-buffer, whose
        place must be aligned as the device asks.
    """
    if value is None or isinstance(value, cl.MemoryObjectHolder):
        return value
    if not isinstance(value, Array):
        raise TypeError(
            f"is {type(value).__name__}, must be a pyopencl.Buffer, a pyopencl.array.Array or None"
        )
    if not value.flags.c_contiguous:
        raise ValueError(f"has strides {value.strides}, must be C-contiguous")
    data: Any = value.base_data
    if not isinstance(data, cl.MemoryObjectHolder | None):
        raise TypeError(f"is an array in {type(data).__name__}, must be one in a buffer")
    if data is None or value.offset == 0:
        return data
    whole: Any = cl.Buffer.from_int_ptr(data.int_ptr)  # pools have buffers of another type
    return whole[value.offset : value.offset + value.nbytes]
