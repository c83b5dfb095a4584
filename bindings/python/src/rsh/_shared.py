"""Shared virtual memory (SVM) as buffers of OpenCL, without a copy.

Of clCreateBuffer with CL_MEM_USE_HOST_PTR and memory of clSVMAlloc, OpenCL 2.0 says that the buffer has that
memory for its own, and leaves undefined what commands on several buffers over the same memory do. So an
allocation has one buffer in each context, as long as anything uses it; what lies inside is a sub-buffer.
"""

from threading import Lock
from typing import Any
from weakref import WeakValueDictionary

import numpy as np
import pyopencl as cl

_SYSTEM: int = cl.device_svm_capabilities.FINE_GRAIN_SYSTEM


class _Whole:
    """An allocation as a buffer of a context; keeps both."""

    def __init__(self, context: cl.Context, memory: cl.SVMPointer) -> None:
        self.memory, self.buffer = memory, memory.as_buffer(context)


_wholes: WeakValueDictionary[tuple[int, int, int], _Whole] = WeakValueDictionary()
_lock = Lock()


class Shared:
    """A part of an allocation; a buffer as soon as the context is known, which is when it is used."""

    def __init__(self, memory: Any, offset: int, size: int, context: cl.Context | None = None) -> None:
        self._allocation = allocation(memory)
        self._begin = memory.svm_ptr - self._allocation.svm_ptr + offset
        self._size, self._context = size, context

    @property
    def int_ptr(self) -> int:
        """Stand for the handle of the buffer where a call asks no more than whether there is one."""
        return int(self._allocation.svm_ptr)

    def buffer(self, context: cl.Context, device: cl.Device) -> "SharedBuffer":
        """Return the buffer for a call on that device."""
        if self._context not in (None, context):
            raise ValueError("is shared virtual memory of another pyopencl.Context than the call's")
        require_shared(self._allocation, device)
        key = context.int_ptr, self.int_ptr, self._allocation.size
        with _lock:
            whole = _wholes.get(key)
            if whole is None:
                whole = _wholes[key] = _Whole(context, self._allocation)
        return SharedBuffer(whole, self._begin, self._size)


class SharedBuffer:
    """The buffer of a part of an allocation."""

    def __init__(self, whole: _Whole, begin: int, size: int) -> None:
        self._whole = whole
        is_whole = (begin, size) == (0, whole.memory.size)
        self._buffer = whole.buffer if is_whole else part(whole.buffer, begin, size)

    @property
    def int_ptr(self) -> int:
        """Return its handle."""
        return int(self._buffer.int_ptr)


def allocation(memory: Any) -> Any:
    """Return what clSVMAlloc gave, of which pyopencl.SVM may be a part; else the argument."""
    owner = getattr(memory, "mem", None)
    while isinstance(owner, np.ndarray):
        owner = owner.base
    return owner if isinstance(owner, cl.SVMPointer) else memory


def part(buffer: Any, begin: int, size: int) -> Any:
    """Return a sub-buffer, whose place must be aligned as the device asks."""
    if size == 0:
        raise ValueError("holds 0 bytes, must hold some")
    try:
        return buffer.get_sub_region(begin, size, 0)
    except cl.Error as error:
        if error.code != cl.status_code.MISALIGNED_SUB_BUFFER_OFFSET:
            raise
        bits = max(device.mem_base_addr_align for device in buffer.context.devices)
        raise ValueError(
            f"begins {begin} bytes into its memory, must be a multiple of {bits // 8} on this device"
        ) from None


def require_shared(memory: Any, device: cl.Device) -> None:
    """Refuse memory that the device cannot share with the host."""
    found = capabilities(device)
    if not found:
        raise TypeError(f"is shared virtual memory, must be a buffer: {device.name} shares none")
    if hasattr(memory, "mem") and not found & _SYSTEM:
        raise TypeError(
            f"is memory of {type(memory.mem).__name__}, must be of clSVMAlloc, as pyopencl.csvm_empty makes "
            f"it: {device.name} shares no other"
        )


def capabilities(device: cl.Device) -> int:
    """Return CL_DEVICE_SVM_CAPABILITIES, which older devices do not know of."""
    try:
        return int(device.svm_capabilities)
    except cl.Error:
        return 0
