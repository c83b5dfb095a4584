"""The bundled library, loaded.

It names no loader of OpenCL: it gets the one that pyopencl was built with, so that a process has a
single one and objects of either side are good on the other.
"""

import ctypes as ct
from pathlib import Path

import pyopencl


class _Place(ct.Structure):
    """Dl_info of dladdr."""

    _fields_ = [
        ("file", ct.c_char_p),
        ("base", ct.c_void_p),
        ("name", ct.c_char_p),
        ("address", ct.c_void_p),
    ]


def _loader() -> str:
    """File of the loader that pyopencl calls."""
    known = ct.CDLL(pyopencl._cl.__file__).clGetPlatformIDs
    place = _Place()
    if not ct.CDLL(None).dladdr(ct.cast(known, ct.c_void_p), ct.byref(place)):
        raise ImportError("rsh: cannot tell which file pyopencl's clGetPlatformIDs is in")
    return bytes(place.file).decode()


ct.CDLL(_loader(), ct.RTLD_GLOBAL)
library = ct.CDLL(str(Path(__file__).with_name("librsh.so")))
