"""Rays of a pinhole camera, as Open3D takes one: x and y of the camera follow columns and rows."""

import numpy as np
from numpy.typing import ArrayLike, NDArray


def pinhole_rays(
    intrinsic_matrix: ArrayLike, extrinsic_matrix: ArrayLike, width_px: int, height_px: int
) -> NDArray[np.float32]:
    """Return rays (height_px, width_px, 6) whose directions are 1 long along the camera's axis."""
    intrinsic = _matrix("intrinsic_matrix", intrinsic_matrix, (3, 3))
    extrinsic = _matrix("extrinsic_matrix", extrinsic_matrix, (4, 4))
    x, y = np.meshgrid(np.arange(width_px) + 0.5, np.arange(height_px) + 0.5)
    seen = np.stack([x, y, np.ones_like(x)], -1) @ np.linalg.inv(intrinsic).T
    rotation = extrinsic[:3, :3]
    rays = np.empty((height_px, width_px, 6), np.float32)
    rays[..., :3] = -rotation.T @ extrinsic[:3, 3]
    rays[..., 3:] = seen @ rotation
    return rays


def look_at(
    fov_deg: float, center: ArrayLike, eye: ArrayLike, up: ArrayLike, width_px: int, height_px: int
) -> NDArray[np.float32]:
    """Return the rays of a camera at `eye` that looks at `center`; rows go along `up`."""
    middle, origin, upwards = (
        _matrix(name, vector, (3,)) for name, vector in (("center", center), ("eye", eye), ("up", up))
    )
    forward = middle - origin
    sideways = np.cross(upwards, forward)
    axes = np.stack([sideways, np.cross(forward, sideways), forward])
    lengths = np.linalg.norm(axes, axis=1, keepdims=True)
    if not np.all(lengths > 0):
        raise ValueError(f"up is {upwards}, must have another direction than center - eye, {forward}")
    extrinsic = np.eye(4)
    extrinsic[:3, :3] = axes / lengths
    extrinsic[:3, 3] = -extrinsic[:3, :3] @ origin
    focal = width_px / 2 / np.tan(np.deg2rad(fov_deg) / 2)
    intrinsic = [[focal, 0, width_px / 2], [0, focal, height_px / 2], [0, 0, 1]]
    return pinhole_rays(intrinsic, extrinsic, width_px, height_px)


def _matrix(name: str, value: ArrayLike, shape: tuple[int, ...]) -> NDArray[np.float64]:
    """Return it in double precision; Open3D's tensors know how to become arrays."""
    array = np.asarray(value.numpy() if hasattr(value, "numpy") else value, np.float64)
    if array.shape != shape:
        raise ValueError(f"{name} has shape {array.shape}, must be {shape}")
    return array
