"""Hits as NumPy's record arrays."""

from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from rsh.constants import NO_HIT
from rsh.structs import Hit

HIT: Any = np.dtype(Hit)
Hits: TypeAlias = "np.recarray[Any, Any]"


def record_hits(raw: NDArray[Any], normal: NDArray[Any] | None, location: NDArray[Any] | None) -> Hits:
    """Put hits and what was asked for beside them into records; a miss gets t = inf."""
    raw["t"][raw["primitive"] == NO_HIT] = np.inf
    fields: list[tuple[str, Any, Any]] = []
    if normal is not None:
        fields.append(("normal", np.float32, 3))
    if location is not None:
        fields.append(("location", np.float64, 3))
    if not fields:
        return raw.view(np.recarray)
    hits = np.recarray(raw.shape, [*((name, HIT[name]) for name in HIT.names), *fields])
    for name in HIT.names:
        hits[name] = raw[name]
    for name, values in (("normal", normal), ("location", location)):
        if values is not None:
            hits[name] = values
    return hits


def find_locations(raw: NDArray[Any], vertices: NDArray[Any], faces: NDArray[Any]) -> NDArray[Any]:
    """Return where hits are on their triangles, in double precision; NaN for a miss."""
    is_hit = raw["primitive"] != NO_HIT
    hits = raw[is_hit]
    corners = vertices.astype(np.float64)[faces[hits["primitive"]]]
    first, second, third = corners[:, 0], corners[:, 1], corners[:, 2]
    u, v = (hits[name].astype(np.float64)[:, None] for name in "uv")
    locations = np.full((*raw.shape, 3), np.nan)
    locations[is_hit] = first + u * (second - first) + v * (third - first)
    return locations
