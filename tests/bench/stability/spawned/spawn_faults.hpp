// spawn_faults.hpp - what is wrong with spawned rays, before anything is traced. Knows no device.
#pragma once

#include <string>

#include "stability/spawned/spawned.hpp"

namespace bench::stability {

struct SpawnFaults {
    uint64_t missed = 0, spurious = 0, nan_out = 0;
    std::string first;
};

// `scene` has the rays that were made. Each is judged by oracle/leaving/spawned_ray.hpp; and of about
// `most` of them, whether those that go on inside of a mesh begin there, but for what rsh.h allows
// at edges.
SpawnFaults spawn_faults(const Scene& scene, const Spawned& spawned, size_t most);

}  // namespace bench::stability
