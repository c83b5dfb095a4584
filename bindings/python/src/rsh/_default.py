"""The context of a queue, and both for those who bring none."""

from functools import cache
from weakref import WeakValueDictionary

import pyopencl as cl

from rsh._context import Context

_contexts: WeakValueDictionary[tuple[int, int], Context] = WeakValueDictionary()


@cache
def default() -> tuple[Context, cl.CommandQueue]:
    """Return those of the process, on the device that `find_device` picks."""
    context = Context()
    queue = cl.CommandQueue(context.context)
    _contexts[_key(queue)] = context
    return context, queue


def context_of(queue: cl.CommandQueue) -> Context:
    """Return the context that the scenes on this queue's device share, while there are any."""
    context = _contexts.get(_key(queue))
    if context is None:
        context = _contexts[_key(queue)] = Context(queue.context, queue.device)
    return context


def _key(queue: cl.CommandQueue) -> tuple[int, int]:
    return queue.context.int_ptr, queue.device.int_ptr
