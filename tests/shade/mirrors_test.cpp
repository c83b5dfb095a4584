// mirrors_test.cpp - chains of mirrored rays between curved mirrors, where each error grows
// from bounce to bounce: beside paths in 113 bits, and beside the best that a state of floats
// can do.
#include <gtest/gtest.h>

#include <algorithm>

#include "oracle/mirrors.hpp"
#include "shade/mirror_room.hpp"
#include "support/render.hpp"
#include "support/trace.hpp"

namespace {

using oracle::MirrorHit;
using oracle::MirrorRay;
using oracle::Quad3;
using test::Double3;
using test::Float3;
using test::Scene;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// A ray after a bounce: where it starts, and where exactly it goes.
struct Step {
    uint32_t triangle;
    Quad3 origin;
    uint32_t next_triangle;
    Quad3 next;
};
using Path = std::vector<Step>;

Quad3 rounded(const Quad3& v) {
    return Quad3(Float3(v));
}

// In 113 bits, between bounces as well or not.
Path trace(const oracle::Mirrors& mirrors, const rsh_ray& start, uint32_t bounces,
           bool is_rounded) {
    MirrorRay ray = {Quad3(test::origin(start)), Quad3(test::direction(start)), RSH_NO_HIT};
    MirrorHit hit = mirrors.nearest(ray);
    Path path;
    while (path.size() < bounces && hit.triangle != RSH_NO_HIT) {
        ray = mirrors.reflected(ray, hit);
        if (is_rounded) ray = {rounded(ray.origin), rounded(ray.direction), ray.skip};
        hit = mirrors.nearest(ray);
        path.push_back({ray.skip, ray.origin, hit.triangle, hit.point});
    }
    return path;
}

// By rsh_traverse and rsh_spawn.
std::vector<Path> trace_by_rsh(const oracle::Mirrors& mirrors, const Scene& scene,
                               const std::vector<rsh_ray>& start, uint32_t bounces) {
    const test::DeviceScene shaded(scene);
    const test::DeviceMesh mesh(scene.mesh);
    test::Rays rays{start, uint32_t(start.size()), 1, {}};
    std::vector<rsh_hit> hits = closest_hits(mesh, rays);
    std::vector<Path> paths(start.size());
    for (uint32_t k = 0; k < bounces; ++k) {
        const auto spawned = test::spawn(shaded, rays.rays, hits, {});
        rays.rays = spawned.rays;
        rays.skip = spawned.skip;
        hits = closest_hits(mesh, rays);
        for (size_t i = 0; i < start.size(); ++i) {
            if (!test::is_active(rays.rays[i]) || hits[i].primitive == RSH_NO_HIT) continue;
            const MirrorRay ray = {Quad3(test::origin(rays.rays[i])),
                                   Quad3(test::direction(rays.rays[i])), rays.skip[i]};
            paths[i].push_back({ray.skip, ray.origin, hits[i].primitive,
                                mirrors.point_in_plane(ray, hits[i].primitive)});
        }
    }
    return paths;
}

std::vector<rsh_ray> rays_in_mirror_room(test::Random& random, uint32_t count) {
    std::vector<rsh_ray> rays;
    while (rays.size() < count) {
        const Float3 origin = random.in_cube();
        if (test::is_in_mirror_room(origin))
            rays.push_back(test::make_ray(origin, normalize(random.direction())));
    }
    return rays;
}

struct Errors {
    double origin = kInfinity, next = kInfinity;
};

double distance(const Quad3& a, const Quad3& b) {
    return length(Double3(a - b));
}

// Infinite from where the path meets another triangle on.
Errors errors_after(uint32_t bounce, const Path& exact, const Path& path) {
    Errors errors;
    if (exact.size() < bounce || path.size() < bounce) return errors;
    for (uint32_t k = 0; k < bounce; ++k)
        if (path[k].triangle != exact[k].triangle) return errors;
    const Step &step = path[bounce - 1], &right = exact[bounce - 1];
    errors.origin = distance(step.origin, right.origin);
    if (step.next_triangle == right.next_triangle)
        errors.next = distance(step.next, right.next);
    return errors;
}

double median(std::vector<double> all) {
    const auto middle = all.begin() + std::ptrdiff_t(all.size() / 2);
    std::nth_element(all.begin(), middle, all.end());
    return *middle;
}

Errors median_errors(uint32_t bounce, const std::vector<Path>& exact,
                     const std::vector<Path>& paths) {
    std::vector<double> origin, next;
    for (size_t i = 0; i < paths.size(); ++i) {
        const Errors errors = errors_after(bounce, exact[i], paths[i]);
        origin.push_back(errors.origin);
        next.push_back(errors.next);
    }
    return {median(origin), median(next)};
}

void expect_near_the_best(const Scene& scene, const std::vector<rsh_ray>& start) {
    const std::vector<uint32_t> bounces =
        test::small() ? std::vector<uint32_t>{1, 4} : std::vector<uint32_t>{1, 4, 8, 16};
    const oracle::Mirrors mirrors(scene);
    std::vector<Path> exact, best;
    for (const rsh_ray& ray : start) {
        exact.push_back(trace(mirrors, ray, bounces.back(), false));
        best.push_back(trace(mirrors, ray, bounces.back(), true));
    }
    const std::vector<Path> paths = trace_by_rsh(mirrors, scene, start, bounces.back());
    for (const uint32_t bounce : bounces) {
        const Errors least = median_errors(bounce, exact, best);
        const Errors errors = median_errors(bounce, exact, paths);
        ASSERT_LT(std::max(least.origin, least.next), kInfinity)
            << "half of the best paths have parted by bounce " << bounce;
        EXPECT_LE(errors.origin, 2 * least.origin)
            << "origins after bounce " << bounce << ", " << errors.origin / least.origin
            << " times the error of the best floats, of " << start.size() << " paths";
        EXPECT_LE(errors.next, 2 * least.next)
            << "hits of the rays after bounce " << bounce << ", " << errors.next / least.next
            << " times the error of the best floats, of " << start.size() << " paths";
    }
}

// In another place and unit as well; `offset` is in radii of the room.
void expect_near_the_best(bool is_smooth, float scale = 1, Float3 offset = {}) {
    test::Random random(12);
    const std::vector<rsh_ray> start = rays_in_mirror_room(random, test::small() ? 32 : 256);
    Scene scene = test::mirror_room(test::small() ? 1 : 3, is_smooth);
    scene.mesh = test::scaled(scene.mesh, scale, scale * offset);
    expect_near_the_best(
        scene,
        test::scaled({start, uint32_t(start.size()), 1, {}}, scale, scale * offset).rays);
}

TEST(Mirrors, KeepToThePathAsTheBestFloatsDo) {
    expect_near_the_best(true);
}

TEST(Mirrors, KeepToThePathWithoutNormals) {
    expect_near_the_best(false);
}

TEST(Mirrors, KeepToThePathFarFromTheOrigin) {
    expect_near_the_best(true, 1, {3, -5, 2});
}

TEST(Mirrors, KeepToThePathAtAnyScale) {
    for (const float scale : {3e-12f, 7e10f}) {
        SCOPED_TRACE("scale " + std::to_string(scale));
        expect_near_the_best(true, scale);
    }
}

}  // namespace
