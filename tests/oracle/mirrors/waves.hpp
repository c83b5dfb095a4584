// waves.hpp - many paths at once by a tracer under test: its rays and hits, bounce by bounce, and
// what is wrong with them whatever the right path is.
#pragma once

#include "oracle/mirrors/path.hpp"
#include "oracle/mirrors/room.hpp"

namespace oracle {

struct Wave {
    std::vector<rsh_ray> rays;
    std::vector<uint32_t> skip;  // what each ray has left
    std::vector<rsh_hit> hits;
};

MirrorRay ray_of(const Wave& wave, size_t i);

class Tracer {
public:
    virtual ~Tracer() = default;
    virtual std::vector<rsh_hit> closest(const std::vector<rsh_ray>& rays,
                                         const std::vector<uint32_t>& skip) = 0;
    // The rays mirrored where a wave hits, and what they leave; no hits yet.
    virtual Wave mirrored(const Wave& wave) = 0;
};

// One wave more than bounces: the first one are the rays that start.
std::vector<Wave> trace_waves(Tracer& tracer, const std::vector<rsh_ray>& start,
                              uint32_t bounces);

// One ray's path. Ends early where the ray is inactive or hits nothing.
Path path_of(const std::vector<Wave>& waves, size_t ray, const Mirrors& mirrors);

struct Faults {
    uint64_t nan = 0;        // paths with NaN in a ray or a hit
    uint64_t self_hits = 0;  // that meet the triangle they leave
    uint64_t leaks = 0;      // that end, hit nothing, or meet a mirror from behind
};

// Each path is counted once, for the first thing that is wrong with it.
Faults faults_of(const std::vector<Wave>& waves, const MirrorRoom& room,
                 const Mirrors& mirrors);

}  // namespace oracle
