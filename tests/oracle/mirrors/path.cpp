#include "oracle/mirrors/path.hpp"

namespace oracle {

Path exact_path(const Mirrors& mirrors, const MirrorRay& start, uint32_t bounces) {
    MirrorRay ray = start;
    MirrorHit hit = mirrors.nearest(ray);
    Path path;
    while (path.size() < bounces && hit.triangle != RSH_NO_HIT) {
        ray = mirrors.reflected(ray, hit);
        hit = mirrors.nearest(ray);
        path.push_back({ray, hit});
    }
    return path;
}

Path path_with(const State& state, uint32_t state_count, const Mirrors& mirrors,
               const MirrorRay& start, const Path& exact) {
    MirrorRay ray = start;
    MirrorHit hit = mirrors.nearest(ray);
    Path path;
    for (const Step& right : exact) {
        ray = mirrors.reflected(ray, hit);
        if (path.size() < state_count) ray = state(ray, mirrors.normal_towards(ray));
        hit = mirrors.nearest(ray);
        path.push_back({ray, hit});
        if (hit.triangle != right.next.triangle) break;
    }
    return path;
}

}  // namespace oracle
