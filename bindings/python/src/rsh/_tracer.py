"""What happens between a scene's arrays and rsh_trace."""

from typing import Any

import numpy as np
import pyopencl as cl
import pyopencl.array as cla
from pyopencl.tools import ImmediateAllocator, MemoryPool

from rsh._arrays import is_on_device, on_device, on_host, require
from rsh._call import WaitFor
from rsh._context import Context
from rsh._mesh import Mesh
from rsh._rays import as_traced, check_rays, floats_in
from rsh.calls import trace

# In no plane that people build along.
_OUTWARDS = np.array([1.0, 2.0**0.5, 3.0**0.5], np.float32)


class Tracer:
    """Takes rays, with memory from a pool of its own."""

    def __init__(self, context: Context, queue: cl.CommandQueue, mesh: Mesh, engine: int) -> None:
        self.context, self.queue, self.mesh, self.engine = context, queue, mesh, engine
        self.pool = MemoryPool(ImmediateAllocator(queue))
        self._alignment = int(context.device.mem_base_addr_align) // 8

    def take(self, rays: Any) -> "Traced":
        """Take rays of 6 or 8 floats."""
        taken = self._taken("rays", rays)
        check_rays(taken)
        taken = self._sent(taken)
        return Traced(self, as_traced(taken, self._alignment), taken.shape[:-1], taken.events)

    def take_points(self, points: Any) -> "Traced":
        """Take a ray from each point, all in the same direction."""
        taken = self._taken("points", points)
        require(taken.ndim == 2 and taken.shape[1] == 3, "points", taken, "(n, 3)")
        taken = self._sent(taken)
        count = taken.shape[0]
        directions = self._sent(np.tile(_OUTWARDS, (count, 1)))
        told = {
            "width": count,
            "origins": floats_in(taken, 0),
            "directions": floats_in(directions, 0),
        }
        return Traced(self, told, (count,), taken.events + directions.events)

    def _taken(self, name: str, array: Any) -> Any:
        return on_device(name, array, self.queue) if is_on_device(array) else on_host(name, array)

    def _sent(self, array: Any) -> cla.Array:
        return array if is_on_device(array) else cla.to_device(self.queue, array, allocator=self.pool)


class Traced:
    """Rays on the device, and what rsh_trace is told of them."""

    def __init__(
        self, tracer: Tracer, told: dict[str, Any], shape: tuple[int, ...], events: list[cl.Event]
    ) -> None:
        self.shape = shape
        self._tracer, self._told, self._events = tracer, told, events

    def empty(self, shape: tuple[int, ...], dtype: Any) -> cla.Array:
        """Return an array for answers."""
        return cla.empty(self._tracer.queue, shape, dtype, allocator=self._tracer.pool)

    def run(self, wait_for: WaitFor, **asked: Any) -> None:
        """Enqueue rsh_trace; its event is one of each array in `asked`."""
        tracer = self._tracer
        outputs = [array for array in asked.values() if is_on_device(array)]
        waits = [*self._events, *(wait_for or ()), *(event for array in outputs for event in array.events)]
        if 0 in self.shape:
            return
        bounds = tracer.mesh.bounds()
        event = trace(
            tracer.context,
            tracer.queue,
            geometry=tracer.mesh.geometry,
            bounds=bounds,
            engine=tracer.engine,
            wait_for=[*tracer.mesh.events(), *waits],
            **self._told,
            **asked,
        )
        for array in outputs:
            array.add_event(event)
