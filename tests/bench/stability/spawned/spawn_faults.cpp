#include "stability/spawned/spawn_faults.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "oracle/exact.hpp"
#include "oracle/leaving/inside.hpp"
#include "oracle/leaving/snell.hpp"
#include "oracle/leaving/spawned_ray.hpp"

namespace bench::stability {
namespace {

using oracle::Fault;
using oracle::Verdict;
using test::Corners;
using test::Float3;
using test::Long3;

class Judge {
public:
    Judge(const Scene& scene, const Spawned& spawned) : scene_(scene), spawned_(spawned) {}

    SpawnFaults faults(size_t most) {
        const size_t count = scene_.rays.rays.size();
        const size_t step = std::max<size_t>(count / std::max<size_t>(most, 1), 1);
        for (size_t i = 0; i < count; ++i) {
            const oracle::SpawnedRay ray = ray_of(i);
            faults_.nan_out += oracle::has_nan(ray);
            Verdict verdict = judge(i, ray);
            if (verdict.fault == Fault::kNone && i % step == 0) verdict = judge_place(i, ray);
            add(i, verdict);
        }
        return faults_;
    }

private:
    oracle::SpawnedRay ray_of(size_t i) const {
        return {scene_.rays.rays[i], spawned_.weights[i], scene_.rays.skip[i]};
    }

    Corners corners_of(uint32_t triangle) const {
        Corners corners = {};
        scene_.mesh.corners(triangle, &corners);
        return corners;
    }

    Verdict judge(size_t i, const oracle::SpawnedRay& ray) const {
        const uint32_t hit = spawned_.hits[i].primitive;
        if (hit == RSH_NO_HIT)
            return oracle::is_none(ray) ? Verdict{}
                                        : Verdict{Fault::kSpurious, "has hit nothing"};
        const Spawning& spawning = *scene_.spawning;
        const oracle::Sight sight = {spawned_.seen.rays[i], spawned_.hits[i], corners_of(hit),
                                     spawning.materials[spawning.material_ids[hit]]};
        switch (spawning.kinds[i]) {
            case RSH_SPAWN_REFLECTION:
                return oracle::judge_reflected(sight, ray);
            case RSH_SPAWN_REFRACTION:
                return oracle::judge_refracted(sight, ray);
            default:
                return oracle::judge_shadow(sight, spawning.light, ray);
        }
    }

    // A ray on the inner side of its triangle begins inside, or near another triangle.
    Verdict judge_place(size_t i, const oracle::SpawnedRay& ray) const {
        if (!test::is_active(ray.ray)) return {};
        const Float3 origin = test::origin(ray.ray);
        const Corners left = corners_of(ray.skip);
        const rsh_ray& seen = spawned_.seen.rays[i];
        const oracle::PlaneHit at = oracle::plane_hit(seen, left);
        if (!at.is_sided) return {};
        if (oracle::side_of_plane(origin, left) >= 0 || oracle::is_inside(scene_.mesh, origin))
            return {};
        // Two ulp per axis, what the hit may lie beside its triangle, and along a ray that grazes
        // it, or on a sliver, what the point may be off the plane.
        const long double along = at.is_well_shaped ? 0 : 0x1p-21L * at.extent / at.cosine;
        const auto room =
            float(0x1p-21L * max_norm(Long3(origin)) + 0x1p-19L * at.reach + along);
        for (uint32_t k = 0; k < scene_.mesh.triangle_count(); ++k)
            if (k != ray.skip && is_near(origin, corners_of(k), room)) return {};
        return {Fault::kMissed, "begins outside of the mesh, and near no edge"};
    }

    static bool is_near(Float3 point, const Corners& c, float room) {
        const auto between = [&](float x, float a, float b, float d) {
            return x >= std::min({a, b, d}) - room && x <= std::max({a, b, d}) + room;
        };
        if (!between(point.x, c[0].x, c[1].x, c[2].x) ||
            !between(point.y, c[0].y, c[1].y, c[2].y) ||
            !between(point.z, c[0].z, c[1].z, c[2].z))
            return false;
        const Long3 a(c[0]), normal = normalize(cross(Long3(c[1]) - a, Long3(c[2]) - a));
        return std::fabs(dot(normal, Long3(point) - a)) <= room;
    }

    void add(size_t i, const Verdict& verdict) {
        faults_.missed += verdict.fault == Fault::kMissed;
        faults_.spurious += verdict.fault == Fault::kSpurious;
        if (verdict.fault == Fault::kNone || !faults_.first.empty()) return;
        faults_.first =
            fmt::format("spawned {} (kind {}, of triangle {}) {}", i, scene_.spawning->kinds[i],
                        spawned_.hits[i].primitive, verdict.why);
    }

    const Scene& scene_;
    const Spawned& spawned_;
    SpawnFaults faults_;
};

}  // namespace

SpawnFaults spawn_faults(const Scene& scene, const Spawned& spawned, size_t most) {
    return Judge(scene, spawned).faults(most);
}

}  // namespace bench::stability
