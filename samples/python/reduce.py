#!/usr/bin/env python3
"""reduce.py - stream reduction on the device: the numbers that a flag keeps, in their order."""

import numpy as np
import pyopencl as cl
import pyopencl.array as cla

import rsh

context = rsh.Context()
queue = cl.CommandQueue(context.context)
numbers = cla.arange(queue, 1 << 20, dtype=np.uint32)
flags = ((numbers & 1023) == 5).astype(np.uint8)
kept, count = cla.empty_like(numbers), cla.zeros(queue, 1, np.uint32)
rsh.reduce(
    context,
    queue,
    element_bytes=4,
    count=numbers.size,
    input=numbers,
    flags=flags,
    output=kept,
    output_count=count,
    wait_for=[*numbers.events, *flags.events],
)
print(kept[: int(count.get()[0])])
