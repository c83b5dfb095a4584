// scene_oracle.cpp - a real scene against brute force in double precision:
//   rsh_scene_oracle SCENE... [--tests N]
// Traces the camera's rays at 256x256 and their mirror reflections with the default engine and
// lets the oracle judge them. N (default 2e10) bounds rays x triangles per wave: above it, rays
// are left out evenly. Ends with 1 when a hit is wrong. Renders nothing.
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>

#include "oracle/accepts.hpp"
#include "scene/scene_file.hpp"
#include "scene/world.hpp"
#include "support/scene.hpp"
#include "support/trace.hpp"

namespace {

constexpr uint32_t kSide = 256;

test::Float3 to_float3(glm::vec3 v) {
    return {v.x, v.y, v.z};
}

test::Mesh to_mesh(const render::Mesh& mesh) {
    test::Mesh made;
    for (const glm::vec3& v : mesh.positions) made.vertices.push_back(to_float3(v));
    for (const glm::uvec3& t : mesh.triangles)
        made.indices.insert(made.indices.end(), {t.x, t.y, t.z});
    return made;
}

test::Rays camera_rays(const render::Camera& camera) {
    const float half = std::tan(camera.vertical_degrees * 3.14159265f / 360);
    const test::Float3 eye = to_float3(camera.eye);
    const test::Float3 forward = normalize(to_float3(camera.at) - eye);
    const test::Float3 right = normalize(cross(forward, to_float3(camera.up)));
    const test::Float3 up = cross(right, forward);
    test::Rays rays = {{}, kSide, kSide};
    for (uint32_t y = 0; y < kSide; ++y)
        for (uint32_t x = 0; x < kSide; ++x) {
            const float u = half * (2 * (float(x) + 0.5f) / kSide - 1);
            const float v = half * (1 - 2 * (float(y) + 0.5f) / kSide);
            rays.rays.push_back(test::make_ray(eye, forward + u * right + v * up, camera.near));
        }
    return rays;
}

// As if every surface were a flat mirror. Starting exactly on the surface is on purpose: what
// the oracle calls ambiguous there is what a renderer has to live with.
test::Rays reflections(const test::Mesh& mesh, const test::Rays& rays,
                       const std::vector<rsh_hit>& hits) {
    test::Rays made = rays;
    for (size_t i = 0; i < hits.size(); ++i) {
        test::Corners c;
        made.rays[i] = test::inactive_ray();
        if (hits[i].primitive == RSH_NO_HIT || !mesh.corners(hits[i].primitive, &c)) continue;
        const test::Float3 d = normalize(test::direction(rays.rays[i]));
        const test::Float3 n = normalize(cross(c[1] - c[0], c[2] - c[0]));
        const test::Float3 at = c[0] + hits[i].u * (c[1] - c[0]) + hits[i].v * (c[2] - c[0]);
        made.rays[i] = test::make_ray(at, d - (2 * dot(d, n)) * n, 1e-4f);
    }
    return made;
}

bool judge(const char* wave, const test::Mesh& mesh, const test::Rays& rays,
           const std::vector<rsh_hit>& hits, double tests) {
    const size_t all = rays.rays.size();
    const size_t step = size_t(1 + double(all) * mesh.triangle_count() / tests);
    std::vector<rsh_ray> some;
    std::vector<rsh_hit> found;
    for (size_t i = 0; i < all; i += step) {
        some.push_back(rays.rays[i]);
        found.push_back(hits[i]);
    }
    const auto start = std::chrono::steady_clock::now();
    const auto answers = oracle::closest(mesh, some);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    const auto result = oracle::hits_are_correct(answers, mesh, some, found);
    std::printf("  %s: %zu of %zu rays, %.3f %% ambiguous, %.1f s: %s\n", wave, some.size(),
                all, 100 * oracle::ambiguous_share(answers), took.count(),
                result ? "correct" : result.message());
    return bool(result);
}

bool check_scene(const std::string& file, double tests) {
    const render::World world(render::read_scenes({file}));
    const test::Mesh mesh = to_mesh(world.mesh());
    std::printf("%s: %u triangles\n", file.c_str(), mesh.triangle_count());
    const test::DeviceMesh on_device(mesh);
    const test::Rays primary = camera_rays(world.camera());
    const auto hits = test::closest_hits(on_device, primary);
    const test::Rays secondary = reflections(mesh, primary, hits);
    const auto secondary_hits = test::closest_hits(on_device, secondary);
    const bool first = judge("primary", mesh, primary, hits, tests);
    return judge("reflected", mesh, secondary, secondary_hits, tests) && first;
}

}  // namespace

int main(int argc, char** argv) {
    double tests = 2e10;
    std::vector<std::string> files;
    for (int i = 1; i < argc; ++i) {
        if (std::string(argv[i]) == "--tests" && i + 1 < argc)
            tests = std::atof(argv[++i]);
        else
            files.emplace_back(argv[i]);
    }
    try {
        bool correct = true;
        for (const std::string& file : files) correct &= check_scene(file, tests);
        return correct && !files.empty() ? 0 : 1;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "rsh_scene_oracle: %s\n", error.what());
        return 1;
    }
}
