"""pyopencl_peer.py REQUEST REPLY - pyopencl's copy_if, called as its users call it.

REQUEST  JSON: platform, device, budget_ms, jobs: [{file, bytes}]; the file holds the elements,
         dropped ones begin with 0xffffffff
REPLY    JSON: one {ok, metrics} per job

Checks each answer with numpy, then times copy_if in pairs with a copy of the same bytes. Does
not choose the streams.
"""
import json
import sys
import time

import numpy as np
import pyopencl as cl
import pyopencl.algorithm
import pyopencl.array
import pyopencl.cltypes

NULL = 0xFFFFFFFF
TYPES = {4: np.uint32, 8: cl.cltypes.uint2, 16: cl.cltypes.uint4}
PREDICATES = {4: "ary[i] != 0xffffffffu", 8: "ary[i].x != 0xffffffffu",
              16: "ary[i].x != 0xffffffffu"}


def find_device(platform_name, device_name):
    for platform in cl.get_platforms():
        if platform.name.strip() == platform_name.strip():
            for device in platform.get_devices():
                if device.name.strip() == device_name.strip():
                    return device
    raise SystemExit(f"no device {device_name} of {platform_name}")


def milliseconds(work):
    start = time.perf_counter()
    work()
    return (time.perf_counter() - start) * 1e3


def measure(base, work, budget_ms):
    """Times of base and work in turn: at least 3 pairs, at most 50."""
    base(), work()
    pairs, used = [], 0.0
    while len(pairs) < 3 or (len(pairs) < 50 and used < budget_ms):
        pairs.append((milliseconds(base), milliseconds(work)))
        used += sum(pairs[-1])
    return np.array(pairs)


def run_job(queue, job, budget_ms):
    words = np.fromfile(job["file"], np.uint32).reshape(-1, job["bytes"] // 4)
    elements = words.view(TYPES[job["bytes"]]).reshape(-1)
    array = cl.array.to_device(queue, elements)
    copied = cl.array.empty_like(array)
    predicate = PREDICATES[job["bytes"]]

    def copy_if():
        result = cl.algorithm.copy_if(array, predicate, queue=queue)
        queue.finish()
        return result

    def copy():
        cl.enqueue_copy(queue, copied.data, array.data)
        queue.finish()

    out, count, _ = copy_if()
    kept = int(count.get())
    expected = words[words[:, 0] != NULL]
    found = out.get()[:kept].view(np.uint32).reshape(-1, words.shape[1])
    if kept != len(expected) or not np.array_equal(found, expected):
        return {"ok": False}
    pairs = measure(copy, copy_if, budget_ms)
    low, median, high = np.percentile(pairs[:, 1], (25, 50, 75))
    ratio_low, ratio, ratio_high = np.percentile(pairs[:, 0] / pairs[:, 1], (25, 50, 75))
    return {"ok": True, "metrics": {
        "ms": median, "ms_low": low, "ms_high": high,
        "elements_per_s": len(words) / median * 1e3, "ratio_to_copy": ratio,
        "ratio_low": ratio_low, "ratio_high": ratio_high,
        "copy_ms": float(np.median(pairs[:, 0])), "pairs": len(pairs), "kept": kept}}


def main():
    request_path, reply_path = sys.argv[1:]
    with open(request_path) as file:
        request = json.load(file)
    device = find_device(request["platform"], request["device"])
    queue = cl.CommandQueue(cl.Context([device]))
    replies = [run_job(queue, job, request["budget_ms"]) for job in request["jobs"]]
    with open(reply_path, "w") as file:
        json.dump(replies, file)


if __name__ == "__main__":
    main()
