"""python -m rsh [SECONDS]: which devices there are, whether rsh's is fit for it, and how quick it is.

The benchmark moves all vertices of a wavy sheet in each frame and traces 512 x 512 rays of a camera, or as
many at random; it takes 10 seconds, or as many as are given.
"""

import sys
import time
from collections.abc import Iterator
from itertools import count

import numpy as np
import pyopencl as cl
from numpy.typing import NDArray

from rsh._default import default
from rsh._errors import NoDeviceError
from rsh.calls import arithmetic_name, default_engine, device_selftest, engine_name, strategy_name, version
from rsh.constants import NO_HIT
from rsh.progress import watched
from rsh.scene import Scene

_SIDE = 512


def sheet(cells: int, phase: float) -> tuple[NDArray[np.float32], NDArray[np.int64]]:
    """Return vertices and 2 * cells^2 faces of a sheet over (-1, 1)^2 with waves in it."""
    x, y = np.meshgrid(*[np.linspace(-1, 1, cells + 1)] * 2)
    vertices = np.stack([x, y, 0.1 * np.sin(5 * x + phase) * np.cos(5 * y)], -1).reshape(-1, 3)
    first = (np.arange(cells)[:, None] * (cells + 1) + np.arange(cells)).ravel()
    lower = np.stack([first, first + 1, first + cells + 1], 1)
    upper = np.stack([first + 1, first + cells + 2, first + cells + 1], 1)
    return vertices.astype(np.float32), np.concatenate([lower, upper])


def _rays() -> Iterator[tuple[str, NDArray[np.float32]]]:
    x, y = np.meshgrid(*[(np.arange(_SIDE) + 0.5) / _SIDE * 2 - 1] * 2)
    view = np.zeros((_SIDE, _SIDE, 6), np.float32)
    view[..., 2], view[..., 3], view[..., 4], view[..., 5] = 1.2, x, y, -1.2
    yield "camera", view
    random = np.random.default_rng(1)
    origins, targets = (random.uniform(-1, 1, (_SIDE * _SIDE, 3)) for _ in range(2))
    origins[:, 2] += 1.5
    targets[:, 2] *= 0.1
    yield "random", np.hstack([origins, targets - origins]).astype(np.float32)


def _names(mask: int, name_of: object) -> str:
    names = [name_of(bit) for bit in range(32) if mask >> bit & 1]  # type: ignore[operator]
    return ", ".join(map(str, names)) or "none"


def tell_devices() -> None:
    """Print the devices of OpenCL, and that of rsh."""
    context, _ = default()
    number = version()
    print(f"rsh {number // 1000000}.{number // 1000 % 1000}.{number % 1000}, pyopencl {cl.VERSION_TEXT}")
    for platform in cl.get_platforms():
        for device in platform.get_devices():
            mark = "->" if device == context.device else "  "
            print(f"{mark} {device.name.strip()} ({platform.name.strip()}, {platform.version.strip()})")
    print(f"engine: {engine_name(default_engine(context))}")


def test_device() -> bool:
    """Print what the self-test finds."""
    context, queue = default()
    report = device_selftest(context, queue)
    print(f"self-test: {report.cases} reductions, {report.arithmetic_cases} results of arithmetic")
    print(f"  unsafe strategies: {_names(report.unsafe_strategies, strategy_name)}")
    print(f"  wrong arithmetic: {_names(report.wrong_arithmetic, arithmetic_name)}")
    return bool(report.unsafe_strategies == 0 and report.wrong_arithmetic == 0)


def _until(end: float) -> Iterator[int]:
    """Count from 0 until it is that late, at least to 1."""
    for number in count():
        if number >= 2 and time.perf_counter() >= end:
            return
        yield number


def measure(seconds: float) -> None:
    """Print the milliseconds of frames in which all vertices move, the median."""
    print(f"{_SIDE * _SIDE} rays, NumPy's arrays, all vertices new in each frame:")
    kinds = list(_rays())
    for cells in 100, 200, 400:
        frames = [sheet(cells, phase) for phase in (0.0, 0.1, 0.2, 0.3)]
        scene = Scene(*frames[0])
        for name, rays in kinds:
            hits = scene.closest(rays)  # compiles, too
            times: list[float] = []
            for number in watched(_until(time.perf_counter() + seconds / 6), f"{name}, frames"):
                begin = time.perf_counter()
                scene.update(frames[number % 4][0])
                hits = scene.closest(rays)
                times.append(time.perf_counter() - begin)
            share = np.mean(hits.primitive != NO_HIT)
            print(
                f"  {2 * cells * cells:6} triangles, {name}: {1000 * np.median(times):7.1f} ms"
                f" ({100 * share:.0f} % of the rays hit)"
            )


def main() -> int:
    """Run all three; 1 when the device is not fit, or there is none."""
    try:
        tell_devices()
    except NoDeviceError as error:
        print(error, file=sys.stderr)
        return 1
    is_fit = test_device()
    measure(float(sys.argv[1]) if len(sys.argv) > 1 else 10.0)
    return 0 if is_fit else 1


if __name__ == "__main__":
    sys.exit(main())
