#include "paper/cones/sphere_row.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "frame/ray_maker.hpp"
#include "paper/cones/false_positives.hpp"

namespace bench::paper {
namespace {

constexpr cl_uint kSide = 256;
constexpr size_t kSampled = 400;  // triangles
constexpr int64_t kTriangles = 20000;

struct Scene {
    const char* name;
    Reflector reflector;
};
constexpr Scene kScenes[] = {{"one reflector", Reflector::kSphere},
                             {"mirror floor", Reflector::kFloor},
                             {"several reflectors", Reflector::kSeveral}};

std::string case_name(const Scene& scene) {
    std::string name = scene.name;
    std::replace(name.begin(), name.end(), ' ', '_');
    return "paper/row:sphere_for_triangle/scene:" + name;
}

// Evenly over the mesh: three corners each.
std::vector<glm::dvec3> sample(const render::Mesh& mesh) {
    std::vector<glm::dvec3> corners;
    const size_t step = std::max<size_t>(1, mesh.triangles.size() / kSampled);
    for (size_t i = step / 2; i < mesh.triangles.size(); i += step)
        for (int corner = 0; corner < 3; ++corner)
            corners.emplace_back(mesh.positions[mesh.triangles[i][corner]]);
    return corners;
}

ConeTests count(const Pyramid& pyramid, const std::vector<glm::dvec3>& corners) {
    ConeTests tests;
    for (size_t i = 0; i + 2 < corners.size(); i += 3)
        descend(pyramid, {corners[i], corners[i + 1], corners[i + 2]}, tests);
    return tests;
}

double ratio(size_t a, size_t b) {
    return double(a) / double(std::max<size_t>(b, 1));
}

// How many times as long the descent by triangles takes as that by spheres: what spheres leave is tested
// once more, a ray against a triangle, which is taken to cost as much as a cone against one.
double exact_over_sphere(const ConeTests& tests, const TestCosts& costs) {
    return double(tests.by_triangle) * costs.triangle_ns /
           (double(tests.by_sphere) * costs.sphere_ns +
            double(tests.rays_by_sphere) * costs.triangle_ns);
}

Case measure(const Device& device, const Scene& scene) {
    const FrameScene frame_scene(SceneSpec{scene.name, scene.reflector, kTriangles, "", false});
    const SceneOnDevice on_device(device, frame_scene);
    RayMaker rays(device, {kSide, kSide});
    rays.make(on_device, RayKind::kReflection);
    const Pyramid pyramid = make_pyramid(rays.rays(), kSide);
    const std::vector<glm::dvec3> corners = sample(frame_scene.mesh());
    const ConeTests tests = count(pyramid, corners);
    const TestCosts costs = time_tests(pyramid, corners);
    return {case_name(scene),
            {{"row", "sphere_for_triangle"},
             {"scene", scene.name},
             {"triangles", frame_scene.mesh().triangles.size()},
             {"sampled_triangles", corners.size() / 3},
             {"width", kSide},
             {"height", kSide},
             {"bounces", 1},
             {"spawn_share", ratio(rays.active_count(), rays.size().pixels())}},
            {{"tests_by_sphere", tests.by_sphere},
             {"tests_by_triangle", tests.by_triangle},
             {"break_even", ratio(tests.by_sphere, tests.by_triangle)},
             {"false_positives", ratio(tests.false_positives, tests.passed)},
             {"missed", tests.missed},
             {"ray_tests_by_sphere", tests.rays_by_sphere},
             {"ray_tests_ratio", ratio(tests.rays_by_sphere, tests.rays_by_triangle)},
             {"exact_over_sphere", exact_over_sphere(tests, costs)},
             {"sphere_ns", costs.sphere_ns},
             {"triangle_ns", costs.triangle_ns}},
            tests.missed == 0};
}

}  // namespace

std::vector<std::string> sphere_case_names() {
    std::vector<std::string> names;
    for (const Scene& scene : kScenes) names.push_back(case_name(scene));
    return names;
}

void measure_spheres(const Run& run, const std::vector<std::string>& names) {
    for (const Scene& scene : kScenes) {
        if (std::find(names.begin(), names.end(), case_name(scene)) == names.end()) continue;
        const Case done = measure(run.device, scene);
        const nlohmann::json& m = done.metrics;
        fmt::print(
            "{}\n    {:.1f} % of the cones that a triangle's sphere meets do not meet the "
            "triangle;\n    the descent by triangles takes {:.2f} times as long\n",
            done.name, 100 * m["false_positives"].get<double>(),
            m["exact_over_sphere"].get<double>());
        run.results.add(done);
    }
}

}  // namespace bench::paper
