"""Rays as arrays of 6 or 8 floats."""

from typing import Any

import numpy as np
import pyopencl.array as cla
from numpy.typing import ArrayLike, NDArray

from rsh._arrays import on_host, require
from rsh._memory import place_of
from rsh.structs import RayFloats


def make_rays(
    origins: ArrayLike, directions: ArrayLike, tmin: ArrayLike = 0.0, tmax: ArrayLike = np.inf
) -> NDArray[np.float32]:
    """Put rays together: the points origin + t * direction with tmin <= t <= tmax.

    Parameters
    ----------
    origins, directions : array_like, (..., 3)
        In world units; a direction has any length but zero, and t counts in units of it.
    tmin, tmax : array_like, (...)
        All four are broadcast against each other.

    Returns
    -------
    ndarray, (..., 8), float32
        Origin, tmin, direction, tmax.

    Raises
    ------
    TypeError, ValueError
        Something is not real numbers, or the shapes do not fit.
    """
    parts = [on_host("origins", origins), on_host("directions", directions)]
    for name, part in zip(("origins", "directions"), parts, strict=True):
        require(part.ndim > 0 and part.shape[-1] == 3, name, part, "(..., 3)")
    ends = [on_host("tmin", tmin), on_host("tmax", tmax)]
    shape = np.broadcast_shapes(*(part.shape[:-1] for part in parts), *(end.shape for end in ends))
    rays = np.empty((*shape, 8), np.float32)
    rays[..., 0:3], rays[..., 3], rays[..., 4:7], rays[..., 7] = parts[0], ends[0], parts[1], ends[1]
    return rays


def check_rays(rays: Any) -> None:
    """Refuse what is not (n, 6), (n, 8), (h, w, 6) or (h, w, 8)."""
    is_right = rays.ndim in (2, 3) and rays.shape[-1] in (6, 8)
    require(is_right, "rays", rays, "(n, 6), (n, 8), (h, w, 6) or (h, w, 8)")


def as_traced(rays: cla.Array, alignment: int) -> dict[str, Any]:
    """Return what rsh_trace is told of rays on the device: a screen or a list, where the floats are.

    Whole rays must begin at a multiple of `alignment` in their memory; of others the floats are told.
    """
    shape = rays.shape[:-1]
    told: dict[str, Any] = {"width": shape[-1], "height": shape[0] if len(shape) > 1 else 0}
    if rays.shape[-1] == 6:
        return {**told, "origins": floats_in(rays, 0), "directions": floats_in(rays, 3)}
    if place_of(rays)[1] % alignment == 0:
        return {**told, "rays": rays}
    columns = {"origins": 0, "tmin": 3, "directions": 4, "tmax": 7}
    return {**told, **{name: floats_in(rays, first) for name, first in columns.items()}}


def floats_in(array: cla.Array, first: int) -> RayFloats:
    """Return where three floats of each row are, from column `first` on."""
    memory, begin = place_of(array)
    return RayFloats(buffer=memory, offset=begin + 4 * first, stride=4 * array.shape[-1])
