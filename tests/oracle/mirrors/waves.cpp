#include "oracle/mirrors/waves.hpp"

namespace oracle {
namespace {

bool has_nan(const rsh_ray& ray, const rsh_hit& hit) {
    float sum = hit.t + hit.u + hit.v;
    for (int i = 0; i < 3; ++i) sum += ray.origin_tmin.s[i] + ray.direction_tmax.s[i];
    return std::isnan(sum);
}

bool is_seen_from_behind(const MirrorRay& ray, uint32_t triangle, const MirrorRoom& room,
                         const Mirrors& mirrors) {
    const bool is_against = dot(mirrors.plane_normal(triangle), ray.direction) < 0;
    return is_against != faces_the_room(room, triangle);
}

// True: it is counted, and the path is over.
bool count_fault(const Wave& wave, size_t i, const MirrorRoom& room, const Mirrors& mirrors,
                 Faults* faults) {
    const rsh_hit& hit = wave.hits[i];
    if (has_nan(wave.rays[i], hit))
        ++faults->nan;
    else if (hit.primitive == RSH_NO_HIT ||
             is_seen_from_behind(ray_of(wave, i), hit.primitive, room, mirrors))
        ++faults->leaks;
    else if (hit.primitive == wave.skip[i])
        ++faults->self_hits;
    else
        return false;
    return true;
}

}  // namespace

MirrorRay ray_of(const Wave& wave, size_t i) {
    return {Quad3(test::origin(wave.rays[i])), Quad3(test::direction(wave.rays[i])),
            wave.skip[i]};
}

std::vector<Wave> trace_waves(Tracer& tracer, const std::vector<rsh_ray>& start,
                              uint32_t bounces) {
    std::vector<Wave> waves = {{start, std::vector<uint32_t>(start.size(), RSH_NO_HIT), {}}};
    waves[0].hits = tracer.closest(waves[0].rays, waves[0].skip);
    while (waves.size() <= bounces) {
        Wave next = tracer.mirrored(waves.back());
        next.hits = tracer.closest(next.rays, next.skip);
        waves.push_back(std::move(next));
    }
    return waves;
}

Path path_of(const std::vector<Wave>& waves, size_t ray, const Mirrors& mirrors) {
    Path path;
    for (size_t k = 1; k < waves.size(); ++k) {
        const uint32_t triangle = waves[k].hits[ray].primitive;
        if (!test::is_active(waves[k].rays[ray]) || triangle == RSH_NO_HIT) break;
        const MirrorRay leaving = ray_of(waves[k], ray);
        path.push_back({leaving, {triangle, mirrors.point_in_plane(leaving, triangle)}});
    }
    return path;
}

Faults faults_of(const std::vector<Wave>& waves, const MirrorRoom& room,
                 const Mirrors& mirrors) {
    Faults faults;
    for (size_t i = 0; i < waves[0].rays.size(); ++i)
        for (const Wave& wave : waves)
            if (count_fault(wave, i, room, mirrors, &faults)) break;
    return faults;
}

}  // namespace oracle
