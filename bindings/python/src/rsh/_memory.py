"""Device memory of pyopencl as a handle of OpenCL, without a copy."""

from typing import Any, TypeAlias

import pyopencl as cl
from pyopencl.array import Array

from rsh._shared import Shared, allocation, part

Memory: TypeAlias = cl.MemoryObjectHolder | cl.SVMPointer | Array | None


def memory_object(value: Any) -> Any:
    """Return what has the handle of `value`, or None.

    Parameters
    ----------
    value : pyopencl.Buffer, pyopencl.SVMPointer, pyopencl.array.Array or None
        An array must be C-contiguous; one that begins inside of its memory becomes a sub-buffer, whose
        place must be aligned as the device asks.
    """
    if value is None or isinstance(value, cl.MemoryObjectHolder):
        return value
    if isinstance(value, cl.SVMPointer):
        _require_contiguous(getattr(value, "mem", None))
        if value.size is None:
            raise TypeError("is shared virtual memory of no known size")
        return Shared(value, 0, value.size)
    if not isinstance(value, Array):
        raise TypeError(
            f"is {type(value).__name__}, must be a pyopencl.Buffer, a pyopencl.array.Array, shared virtual "
            "memory (pyopencl.SVM, pyopencl.SVMAllocation) or None"
        )
    _require_contiguous(value)
    data: Any = value.base_data
    if isinstance(data, cl.SVMPointer):
        return Shared(data, value.offset, value.nbytes, value.context)
    if not isinstance(data, cl.MemoryObjectHolder | None):
        raise TypeError(f"is an array in {type(data).__name__}, must be one in a buffer or shared memory")
    if data is None or value.offset == 0:
        return data
    return part(cl.Buffer.from_int_ptr(data.int_ptr), value.offset, value.nbytes)  # pools have other types


def place_of(array: Array) -> tuple[Any, int]:
    """Return the memory that an array lies in, and its first byte there, which need not be aligned."""
    data: Any = array.base_data
    if not isinstance(data, cl.SVMPointer):
        return data, array.offset
    whole = allocation(data)
    return whole, data.svm_ptr - whole.svm_ptr + array.offset


def _require_contiguous(array: Any) -> None:
    flags = getattr(array, "flags", None)
    if flags is not None and not flags.c_contiguous:
        raise ValueError(f"has strides {array.strides}, must be C-contiguous")
