"""Exact ray tracing of moving meshes, and stream reduction, on the buffers of pyopencl.

Functions have the names and meaning of those in rsh.h, without `rsh_`, and constants without `RSH_`;
`rsh.structs` has the structs.
"""

from rsh._compact import compact
from rsh._context import Context, find_device
from rsh._errors import Error, InvalidValueError, NoDeviceError, OutOfMemoryError
from rsh._rays import make_rays
from rsh._render import look_at, render
from rsh.calls import *
from rsh.calls import __all__ as _calls
from rsh.constants import *
from rsh.constants import __all__ as _constants
from rsh.scene import Scene

__all__ = [
    "Context",
    "Error",
    "InvalidValueError",
    "NoDeviceError",
    "OutOfMemoryError",
    "Scene",
    "compact",
    "find_device",
    "look_at",
    "make_rays",
    "render",
    *_calls,
    *_constants,
]
