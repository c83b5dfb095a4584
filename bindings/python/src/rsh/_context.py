"""rsh_context as a Python object."""

import ctypes as ct
from collections import deque
from collections.abc import Callable
from typing import Any

import pyopencl as cl

from rsh._errors import check
from rsh._library import library
from rsh.structs import ContextDesc

_create = library.rsh_create_context
_create.argtypes = [ct.c_void_p, ct.c_void_p]
_release = library.rsh_release_context
_release.argtypes = [ct.c_void_p]
_release.restype = None
_find_device = library.rsh_find_device
_find_device.argtypes = [ct.c_char_p, ct.c_void_p, ct.c_void_p]


def find_device(name: str | None = None) -> tuple[cl.Platform, cl.Device]:
    """Pick a device, for programs that have no context of their own.

    Parameters
    ----------
    name : str, optional
        A part of the name of a device or of its platform; else RSH_DEVICE from the environment, else
        the first device there is.

    Returns
    -------
    platform : pyopencl.Platform
    device : pyopencl.Device

    Raises
    ------
    NoDeviceError
        None is called so, or there is none at all; the message says how to get one.
    """
    platform, device = ct.c_void_p(), ct.c_void_p()
    encoded = None if name is None else name.encode()
    check(_find_device(encoded, ct.byref(platform), ct.byref(device)))
    assert platform.value is not None
    assert device.value is not None
    return cl.Platform.from_int_ptr(platform.value), cl.Device.from_int_ptr(device.value)


class Context:
    """Programs, kernels and scratch memory of rsh for one device of an OpenCL context.

    Parameters
    ----------
    context : pyopencl.Context, optional
        Without it, one is made for the device that `find_device` picks.
    device : pyopencl.Device, optional
        Of that context; without it, its first one.
    vector_width : int, optional
        1, 4, 8 or 16 elements per work-item; 0: what suits the device.
    cache_dir : str, optional
        Folder of compiled programs; "": none. See rsh_create_context in rsh.h.
    kernel_dir : str, optional
        Kernel sources, while developing.
    log : callable, optional
        Is told, as a str, what takes long or falls back.
    cache_bytes : int, optional
        What the folder of compiled programs may take; 0: 256 MiB.
    max_variants : int, optional
        Variants that are compiled of one program, see rsh_create_context in rsh.h; 0: all.

    Attributes
    ----------
    context : pyopencl.Context
    device : pyopencl.Device

    Raises
    ------
    InvalidValueError
        The device is not of the context.
    NoDeviceError
        There is none.
    """

    def __init__(
        self,
        context: cl.Context | None = None,
        device: cl.Device | None = None,
        *,
        vector_width: int = 0,
        cache_dir: str | None = None,
        kernel_dir: str | None = None,
        log: Callable[[str], object] | None = None,
        cache_bytes: int = 0,
        max_variants: int = 0,
    ) -> None:
        self._handle = ct.c_void_p()
        self._kept: list[object] = []
        if context is None:
            device = device or find_device()[1]
            context = cl.Context([device])
        self.context = context
        self.device: cl.Device = device or context.devices[0]
        self._pending: deque[tuple[cl.Event, Any]] = deque()
        self._desc = ContextDesc(
            context=self.context,
            device=self.device,
            vector_width=vector_width,
            cache_dir=cache_dir,
            kernel_dir=kernel_dir,
            log=log,
            cache_bytes=cache_bytes,
            max_variants=max_variants,
        )
        check(_create(ct.byref(self._desc), ct.byref(self._handle)))

    @property
    def handle(self) -> ct.c_void_p:
        """rsh_context; NULL after `release`."""
        return self._handle

    def release(self) -> None:
        """Free programs and scratch memory once what was enqueued has ended, without waiting."""
        released, self._handle = self._handle, ct.c_void_p()
        _release(released)
        self._kept.clear()

    def __enter__(self) -> "Context":
        return self

    def __exit__(self, *_: object) -> None:
        self.release()

    def __del__(self) -> None:
        self.release()

    def keep_until_release(self, kept: object) -> None:
        """Keep an object that the library may call as long as the context is there."""
        self._kept.append(kept)

    def keep(self, event: cl.Event, kept: object) -> None:
        """Keep an object until the event has ended, which later calls find out.

        A callback of OpenCL could tell at once, but pyopencl starts a thread for each, and one without
        would wait for Python's lock while a driver holds its own.
        """
        self._pending.append((event, kept))
        for _ in range(len(self._pending)):
            try:
                entry = self._pending.popleft()
            except IndexError:  # another thread was quicker
                return
            if entry[0].command_execution_status > cl.command_execution_status.COMPLETE:
                self._pending.append(entry)
                return
