"""Stream reduction of whole arrays."""

from typing import Any

import numpy as np
import pyopencl as cl
import pyopencl.array as cla

from rsh._arrays import Floats, is_on_device, over_shared, queue_of
from rsh._default import context_of, default
from rsh.calls import reduce

_ELEMENTS = (4, 8, 12, 16)


def compact(array: Floats, mask: Floats, *, queue: cl.CommandQueue | None = None) -> Any:
    """Keep the rows of an array where a mask is not 0, in their order; BLOCKS to learn how many.

    Parameters
    ----------
    array : array_like or pyopencl.array.Array, (n, ...)
        Rows of 4, 8, 12 or 16 bytes of any type, such as (n, 3) floats or (n,) doubles.
    mask : array_like or pyopencl.array.Array, (n,)
        Bool or 8-bit integers; where `array` is, on the host or the device.
    queue : pyopencl.CommandQueue, optional
        Without it that of `array`, else one that the process has for it.

    Returns
    -------
    ndarray or pyopencl.array.Array, (kept, ...)

    Raises
    ------
    TypeError, ValueError
        Shapes, types or the rows' size are others.
    """
    stays = is_on_device(array)
    if stays != is_on_device(mask):
        raise TypeError(f"mask is {type(mask).__name__}, must be where array is, {type(array).__name__}")
    queue = queue or (queue_of(array) if stays else default()[1])
    rows: Any = over_shared("array", array, queue) if stays else np.asarray(array, order="C")
    kept: Any = over_shared("mask", mask, queue) if stays else np.asarray(mask, order="C")
    size = _checked(rows, kept)
    if rows.shape[0] == 0:
        return rows.copy()
    if not stays:
        rows, kept = cla.to_device(queue, rows), cla.to_device(queue, kept.view(np.uint8))
    output, count = cla.empty(queue, rows.shape, rows.dtype), cla.empty(queue, 1, np.uint32)
    event = reduce(
        context_of(queue),
        queue,
        element_bytes=size,
        count=rows.shape[0],
        input=rows,
        flags=kept,
        output=output,
        output_count=count,
        wait_for=[*rows.events, *kept.events],
    )
    output.add_event(event)
    count.add_event(event)
    packed = output[: int(count.get(queue)[0])]
    return packed if stays else packed.get(queue)


def _checked(rows: Any, kept: Any) -> int:
    """Return the bytes of a row."""
    if rows.ndim == 0 or rows.dtype.hasobject:
        raise TypeError(f"array has shape {rows.shape} and dtype {rows.dtype}, must be rows of plain bytes")
    if kept.shape != rows.shape[:1]:
        raise ValueError(f"mask has shape {kept.shape}, must be {rows.shape[:1]}")
    if kept.dtype not in (np.bool_, np.uint8, np.int8):
        raise TypeError(f"mask has dtype {kept.dtype}, must be bool or 8-bit integers")
    size = int(rows.dtype.itemsize) * int(np.prod(rows.shape[1:]))
    if size not in _ELEMENTS:
        raise ValueError(f"a row of array has {size} bytes, must have 4, 8, 12 or 16")
    return size
