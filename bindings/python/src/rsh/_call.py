"""How functions of the library are called."""

import ctypes as ct
from collections.abc import Callable, Iterable
from typing import Any, TypeAlias

import pyopencl as cl

from rsh._context import Context
from rsh._errors import check
from rsh._library import library
from rsh._struct import Struct, in_context

WaitFor: TypeAlias = Iterable[cl.Event] | None


def declare(name: str, result: Any, parameters: list[Any]) -> Callable[..., Any]:
    """Return the function of the library, with its types."""
    function = getattr(library, name)
    function.restype = result
    function.argtypes = parameters
    return function  # type: ignore[no-any-return]


def checked(status: int, desc: Struct | None = None) -> None:
    """Raise what a progress callback raised, or else what the library found wrong."""
    raised = None if desc is None else desc.__dict__["_kept"].pop("raised", None)
    if raised is not None:
        raise raised
    check(status)


def enqueue(
    function: Callable[..., int],
    context: Context,
    queue: cl.CommandQueue,
    desc: Struct,
    wait_for: WaitFor,
) -> cl.Event:
    """Enqueue a call; what `desc` refers to is kept until the event has ended."""
    passed = in_context(desc, context.context, context.device)
    events = [] if wait_for is None else [event.int_ptr for event in wait_for]
    waits = (ct.c_void_p * len(events))(*events) if events else None
    done = ct.c_void_p()
    status = function(
        context.handle,
        queue.int_ptr,
        ct.byref(passed),
        len(events),
        waits,
        ct.byref(done),
    )
    event = None if done.value is None else cl.Event.from_int_ptr(done.value, retain=False)
    if event is not None:
        context.keep(event, passed)
    checked(status, desc)
    assert event is not None
    return event


def run(function: Callable[..., int], context: Context, desc: Struct) -> None:
    """Make a call that enqueues nothing, and may go on to call back from a thread of the context."""
    if desc.calls_back():
        context.keep_until_release(desc)
    checked(function(context.handle, ct.byref(desc)), desc)


def decoded(text: bytes | None) -> str | None:
    """Return a name of the library as str."""
    return None if text is None else text.decode()
