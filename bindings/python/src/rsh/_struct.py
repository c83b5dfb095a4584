"""What the structs of rsh.h have in common as Python objects."""

import ctypes as ct
from collections.abc import Callable, Mapping, Sequence
from typing import Any, ClassVar, TypeAlias, TypeVar

import numpy as np
import pyopencl as cl
from numpy.typing import NDArray

from rsh._memory import memory_object
from rsh._shared import Shared

Vector: TypeAlias = Sequence[float] | NDArray[Any] | None
Conversion: TypeAlias = Callable[["Struct", str, Any], Any]
Kind = TypeVar("Kind", bound="Struct")


class Struct(ct.Structure):
    """A struct of rsh.h. It keeps alive what its members refer to; 0 and None mean the default."""

    _names_: ClassVar[frozenset[str]]
    _convert_: ClassVar[Mapping[str, Conversion]] = {}

    def __init_subclass__(cls) -> None:
        cls._names_ = frozenset(field[0] for field in cls._fields_ if field[0][0] != "_")

    def __init__(self, **members: Any) -> None:
        super().__init__()
        self.__dict__["_kept"] = {}
        if "struct_size" in self._names_:
            super().__setattr__("struct_size", ct.sizeof(self))
        for name, value in members.items():
            if value is not None:
                setattr(self, name, value)

    def __setattr__(self, name: str, value: Any) -> None:
        """Set a member: handles by their objects, vectors by sequences, text by str."""
        convert = self._convert_.get(name)
        if convert is not None:
            if "_kept" not in self.__dict__:
                raise AttributeError(
                    f"{name} is in a struct that is a part of another; assign the whole part"
                )
            value = convert(self, name, value)
        elif name not in self._names_:
            raise AttributeError(f"{type(self).__name__} has no member {name}")
        try:
            super().__setattr__(name, value)
        except TypeError as error:
            raise TypeError(f"{type(self).__name__}.{name}: {error}") from None

    def copy(self: Kind) -> Kind:
        """Return another one of the same members, which keeps alive what they refer to."""
        copied = type(self).from_buffer_copy(self)
        copied.__dict__["_kept"] = dict(self.__dict__.get("_kept", {}))
        return copied

    def calls_back(self) -> bool:
        """Whether a member is a function of Python's that may report progress."""
        return "progress" in self.__dict__["_kept"]

    def __repr__(self) -> str:
        members = (f"{name}={getattr(self, name)!r}" for name in sorted(self._names_))
        return f"{type(self).__name__}({', '.join(members)})"


def _keep(struct: Struct, name: str, value: Any) -> None:
    struct.__dict__["_kept"][name] = value


def memory(struct: Struct, name: str, value: Any) -> int | None:
    """Convert a cl_mem."""
    try:
        found = memory_object(value)
    except (TypeError, ValueError) as error:
        raise type(error)(f"{type(struct).__name__}.{name} {error}") from None
    _keep(struct, name, (value, found))
    return None if found is None else found.int_ptr


def handle(struct: Struct, name: str, value: Any) -> int:
    """Convert another object of pyopencl."""
    _keep(struct, name, value)
    return int(value.int_ptr)


def nested(struct: Struct, name: str, value: Any) -> Any:
    """Convert a struct in a struct: a copy, that what it refers to is kept when `value` changes."""
    copied = value.copy() if isinstance(value, Struct) else value
    _keep(struct, name, copied)
    return copied


def pointed(struct: Struct, name: str, value: Any) -> int | None:
    """Convert a pointer to a struct: to a copy, for the same reason."""
    if value is not None and not isinstance(value, Struct):
        raise TypeError(f"{type(struct).__name__}.{name} is {type(value).__name__}, must be a struct of rsh")
    copied = None if value is None else value.copy()
    _keep(struct, name, copied)
    return None if copied is None else ct.addressof(copied)


def vector(struct: Struct, name: str, value: Any) -> Any:
    """Convert 3 or 4 numbers to an rsh_float4; w is 0 unless given."""
    numbers = [float(number) for number in value]
    if len(numbers) not in (3, 4):
        raise ValueError(f"{type(struct).__name__}.{name} has {len(numbers)} numbers, must have 3 or 4")
    return (ct.c_float * 4)(*numbers)


def text(struct: Struct, name: str, value: str | None) -> bytes | None:
    """Convert a string."""
    return None if value is None else value.encode()


def in_context(struct: Struct, context: cl.Context, device: cl.Device) -> Struct:
    """Return the struct, or where it refers to shared virtual memory, a copy that has buffers for it."""
    found: dict[str, Any] = {}
    for name, kept in struct.__dict__.get("_kept", {}).items():
        if isinstance(kept, Struct):
            inner = in_context(kept, context, device)
            if inner is not kept:
                found[name] = inner
        elif isinstance(kept, tuple) and isinstance(kept[1], Shared):
            try:
                found[name] = kept[1].buffer(context, device)
            except (TypeError, ValueError) as error:
                raise type(error)(f"{type(struct).__name__}.{name} {error}") from None
    if not found:
        return struct
    copied = struct.copy()
    for name, value in found.items():
        if isinstance(value, Struct):
            setattr(copied, name, value)
        else:
            ct.Structure.__setattr__(copied, name, value.int_ptr)
            _keep(copied, name, value)
    return copied


_LOG = ct.CFUNCTYPE(None, ct.c_char_p, ct.c_void_p)
_PROGRESS = ct.CFUNCTYPE(ct.c_int, ct.c_uint32, ct.c_uint32, ct.c_void_p)


def log(struct: Struct, name: str, value: Callable[[str], object] | None) -> Any:
    """Convert a function that takes a line of text."""
    if value is None:
        return None

    def called(message: bytes, _user: int | None) -> None:
        value(message.decode(errors="replace"))

    _keep(struct, name, function := _LOG(called))
    return ct.cast(function, ct.c_void_p)


def progress(struct: Struct, name: str, value: Callable[[int, int], object] | None) -> Any:
    """Convert a function that takes batch and batch count and cancels by a true value.

    What it raises cancels as well, and is raised by the call.
    """
    if value is None:
        return None

    def called(batch: int, batch_count: int, _user: int | None) -> int:
        try:
            return 1 if value(batch, batch_count) else 0
        except BaseException as error:
            _keep(struct, "raised", error)
            return 1

    _keep(struct, name, function := _PROGRESS(called))
    return ct.cast(function, ct.c_void_p)


def host_array(name: str, value: Any, struct: type[Struct], count: int) -> int:
    """Address of an array of structs on the host."""
    array: NDArray[Any] = value
    if not (isinstance(array, np.ndarray) and array.dtype == np.dtype(struct)):
        raise TypeError(f"{name} must be a NumPy array of dtype numpy.dtype({struct.__name__})")
    if array.shape != (count,) or not array.flags.c_contiguous:
        raise ValueError(f"{name} has shape {array.shape}, must be C-contiguous and ({count},)")
    return array.ctypes.data
