#include "oracle/leaving/spawned_ray.hpp"

#include <algorithm>
#include <cstring>

#include "oracle/exact.hpp"
#include "oracle/leaving/snell.hpp"

namespace oracle {
namespace {

using test::Float3;
using test::Long3;

// Directions that lead less to their side are turned to it (kernels/surface/grazing.h).
constexpr long double kGrazing = 0x1p-16L;
constexpr long double kUnitError = 16 * kFloatUnit;
// Near 0, a float routine does not know that there is something to reflect, or to let through.
constexpr long double kSomeLight = 0x1p-4L;

Verdict missed(const std::string& why) {
    return {Fault::kMissed, why};
}
Verdict spurious(const std::string& why) {
    return {Fault::kSpurious, why};
}

float largest_weight(const SpawnedRay& spawned) {
    return std::max({spawned.weight.s[0], spawned.weight.s[1], spawned.weight.s[2]});
}

// `away`: 1, the ray leaves to where the one that hit came from; -1: to the other side.
Verdict judge_start(const Sight& sight, const PlaneHit& at, int away, const rsh_ray& ray) {
    const Float3 origin = test::origin(ray);
    const int side = (at.is_outside ? away : -away);
    if (side_of_plane(origin, sight.corners) != side)
        return missed("starts in the plane of its triangle, or behind it");
    // Two ulp on each axis, and by twice the point's own error, which is 2^-21 of the extent at
    // worst; far less where the triangle is well-shaped (kernels/surface/departure.h).
    const long double height =
        std::fabs(dot(at.normal, Long3(origin) - Long3(sight.corners[0])));
    const long double share =
        at.is_well_shaped ? 0x1p-28L * (at.extent + at.reach) : 0x1p-19L * at.extent;
    const long double most = 4 * 0x1p-23L * max_norm(Long3(origin)) + share + 0x1p-120L;
    if (height > most)
        return spurious("starts " + std::to_string(double(height / most)) +
                        " times as far from its triangle as it may");
    return {};
}

Verdict judge_direction(const PlaneHit& at, int away, Long3 exact, long double error,
                        const rsh_ray& ray) {
    const Long3 d(test::direction(ray));
    if (std::fabs(length(d) - 1) > kUnitError) return spurious("has no unit direction");
    const Long3 side = (long double)(away)*at.normal;
    if (dot(d, side) < kGrazing / 2) return spurious("does not lead away from its triangle");
    const bool is_turned = dot(exact, side) < kGrazing + error;
    if (max_norm(d - exact) > error + (is_turned ? 4 * kGrazing : 0))
        return spurious("has a direction that is off by " +
                        std::to_string(double(max_norm(d - exact) / error)) +
                        " of what is allowed");
    return {};
}

Verdict judge_share(const Sight& sight, const SpawnedRay& spawned) {
    for (const float weight : {spawned.weight.s[0], spawned.weight.s[1], spawned.weight.s[2]})
        if (!(weight >= 0 && weight <= 1 + kUnitError))
            return spurious("weighs " + std::to_string(weight));
    if (spawned.skip != sight.hit.primitive) return spurious("names another triangle as left");
    if (spawned.ray.origin_tmin.s[3] != 0) return spurious("has a tmin that is not 0");
    return {};
}

Verdict judge_ray(const Sight& sight, const PlaneHit& at, int away, Long3 exact,
                  long double error, const SpawnedRay& spawned) {
    const Verdict share = judge_share(sight, spawned);
    if (share.fault != Fault::kNone || !at.is_sided) return share;
    if (!std::isinf(spawned.ray.direction_tmax.s[3])) return spurious("ends");
    const Verdict start = judge_start(sight, at, away, spawned.ray);
    if (start.fault != Fault::kNone) return start;
    return judge_direction(at, away, exact, error, spawned.ray);
}

float largest(const cl_float4& colour) {
    return std::max({colour.s[0], colour.s[1], colour.s[2]});
}

}  // namespace

bool has_nan(const SpawnedRay& spawned) {
    for (int i = 0; i < 4; ++i)
        if (std::isnan(spawned.ray.origin_tmin.s[i]) ||
            std::isnan(spawned.ray.direction_tmax.s[i]) || std::isnan(spawned.weight.s[i]))
            return true;
    return false;
}

bool is_none(const SpawnedRay& spawned) {
    rsh_ray none = {};
    none.direction_tmax.s[3] = -1;
    return std::memcmp(&none, &spawned.ray, sizeof none) == 0 && largest_weight(spawned) == 0 &&
           spawned.skip == RSH_NO_HIT;
}

Verdict judge_reflected(const Sight& sight, const SpawnedRay& spawned) {
    const PlaneHit at = plane_hit(sight.ray, sight.corners);
    const bool is_glass = largest(sight.material.transmission) > 0;
    const Snell snell = snell_at(at, sight.material.transmission.s[3]);
    const bool is_mirror = largest(sight.material.reflection) > 0;
    if (is_none(spawned)) {
        const bool must =
            is_mirror ||
            (is_glass && at.is_sided &&
             (snell.is_total || (snell.is_refracted && snell.reflectance > kSomeLight)));
        return must ? missed("is not reflected") : Verdict{};
    }
    if (!is_mirror && !is_glass) return spurious("is reflected, by what is no mirror");
    if (is_glass && at.is_sided && snell.is_total && largest_weight(spawned) != 1)
        return spurious("is totally reflected, with a weight of " +
                        std::to_string(largest_weight(spawned)));
    return judge_ray(sight, at, 1, mirrored(at), 4 * kFloatUnit, spawned);
}

Verdict judge_refracted(const Sight& sight, const SpawnedRay& spawned) {
    const PlaneHit at = plane_hit(sight.ray, sight.corners);
    const bool is_glass = largest(sight.material.transmission) > 0;
    const Snell snell = snell_at(at, sight.material.transmission.s[3]);
    if (is_none(spawned)) {
        const bool must = is_glass && at.is_sided && snell.is_refracted &&
                          1 - snell.reflectance > kSomeLight * kSomeLight;
        return must ? missed("is not refracted") : Verdict{};
    }
    if (!is_glass) return spurious("is refracted, by what is no glass");
    if (at.is_sided && snell.is_total)
        return spurious("is refracted beyond the critical angle");
    return judge_ray(sight, at, -1, refracted(at, snell), refracted_error(at, snell), spawned);
}

Verdict judge_shadow(const Sight& sight, const rsh_light& light, const SpawnedRay& spawned) {
    const PlaneHit at = plane_hit(sight.ray, sight.corners);
    const Float3 lamp(light.position.s[0], light.position.s[1], light.position.s[2]);
    const Long3 seen(test::origin(sight.ray));
    const Long3 point = seen + (long double)(sight.hit.t) * Long3(test::direction(sight.ray));
    const Long3 way = Long3(lamp) - point;
    const long double distance = length(way);
    // Of the cosine between normal and light: a unit vector and a normal as above, and the point,
    // which errs with t, and by its own rounding and that of the way.
    const long double error =
        40 * kFloatUnit + (16 * kFloatUnit * (at.extent + at.reach) +
                           4 * kFloatUnit * (max_norm(point) + max_norm(Long3(lamp)))) /
                              distance;
    const long double cosine = dot(at.normal, way) / distance;
    if (is_none(spawned))
        return at.is_sided && cosine > kGrazing + error ? missed("casts no shadow ray")
                                                        : Verdict{};
    if (at.is_sided && cosine < kGrazing - error)
        return spurious("casts a shadow ray, away from the light");
    const Verdict share = judge_share(sight, spawned);
    if (share.fault != Fault::kNone || !at.is_sided) return share;
    const Float3 exact = lamp - test::origin(spawned.ray), d = test::direction(spawned.ray);
    if (std::memcmp(&exact, &d, sizeof d) != 0) return spurious("does not end at the light");
    if (spawned.ray.direction_tmax.s[3] != 1 - 0x1p-16f)
        return spurious("does not end just before the light");
    return judge_start(sight, at, 1, spawned.ray);
}

}  // namespace oracle
