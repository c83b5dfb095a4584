"""Statuses of the library as exceptions."""

import ctypes as ct

from rsh._library import library
from rsh.constants import BUFFER_TOO_SMALL, INVALID_VALUE, NO_DEVICE, OUT_OF_MEMORY, SUCCESS

_last_error = library.rsh_last_error
_last_error.restype = ct.c_char_p
_status_string = library.rsh_status_string
_status_string.restype = ct.c_char_p

_HOW_TO_GET_A_DEVICE = (
    "PoCL makes one of any CPU: pip install 'pyopencl[pocl]', or on Debian apt install pocl-opencl-icd"
)


class Error(RuntimeError):
    """A call of the library failed.

    Attributes
    ----------
    status : int
        `rsh.INVALID_VALUE` and the like, or one of OpenCL's own codes.
    """

    def __init__(self, status: int, message: str) -> None:
        super().__init__(message)
        self.status = status


class InvalidValueError(Error, ValueError):
    """An argument is wrong; the message names it, with its value and the required one."""


class NoDeviceError(Error):
    """There is no OpenCL device."""


class OutOfMemoryError(Error, MemoryError):
    """The host is out of memory."""


_CLASSES: dict[int, type[Error]] = {
    INVALID_VALUE: InvalidValueError,
    BUFFER_TOO_SMALL: InvalidValueError,
    NO_DEVICE: NoDeviceError,
    OUT_OF_MEMORY: OutOfMemoryError,
}


def check(status: int) -> None:
    """Raise what the last call of this thread found wrong."""
    if status == SUCCESS:
        return
    message = _last_error().decode(errors="replace")
    if status == NO_DEVICE:
        end = "" if message.endswith(("?", ".")) else "."
        message = f"{message}{end} {_HOW_TO_GET_A_DEVICE}"
    raise _CLASSES.get(status, Error)(status, f"{message} [{_status_string(status).decode()}]")
