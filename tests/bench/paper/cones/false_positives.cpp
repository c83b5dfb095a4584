#include "paper/cones/false_positives.hpp"

#include <algorithm>

#include "support/rays.hpp"
#include "timing.hpp"

namespace bench::paper {
namespace {

size_t side_of(size_t level, const Pyramid& pyramid) {
    return size_t{1} << (pyramid.size() - 1 - level);
}

struct Descent {
    const Pyramid& pyramid;
    const Triangle& triangle;
    Sphere sphere;
    ConeTests& tests;

    // kept: whether a descent by triangles comes here as well.
    void visit(size_t level, size_t x, size_t y, bool kept) {
        const Cone& cone = pyramid[level][y * side_of(level, pyramid) + x];
        if (cone.is_empty()) return;
        ++tests.by_sphere;
        tests.by_triangle += kept;
        const bool is_met = meets(cone, triangle);
        if (!meets(cone, sphere)) {
            tests.missed += is_met;
            return;
        }
        ++tests.passed;
        tests.false_positives += !is_met;
        if (level == 0) {
            ++tests.rays_by_sphere;
            tests.rays_by_triangle += kept && is_met;
            return;
        }
        for (const size_t child : {0, 1, 2, 3})
            visit(level - 1, 2 * x + child % 2, 2 * y + child / 2, kept && is_met);
    }
};

std::vector<Cone> level_above(const std::vector<Cone>& below, size_t side) {
    std::vector<Cone> level;
    for (size_t y = 0; y < side; y += 2)
        for (size_t x = 0; x < side; x += 2)
            level.push_back(merge({below[y * side + x], below[y * side + x + 1],
                                   below[(y + 1) * side + x], below[(y + 1) * side + x + 1]}));
    return level;
}

struct Tested {
    const Cone* cone;
    Triangle triangle;
    Sphere sphere;
};

// Each triangle with a cone of each level, but those of single rays.
std::vector<Tested> pairs_to_time(const Pyramid& pyramid,
                                  const std::vector<glm::dvec3>& corners) {
    std::vector<Tested> all;
    for (size_t level = 1; level < pyramid.size(); ++level)
        for (size_t i = 0; i + 2 < corners.size(); i += 3) {
            const Cone& cone = pyramid[level][(7919 * i) % pyramid[level].size()];
            if (cone.is_empty() || cone.meets_all()) continue;
            Tested one = {&cone, {corners[i], corners[i + 1], corners[i + 2]}, {}};
            one.sphere = sphere_of(one.triangle);
            all.push_back(one);
        }
    return all;
}

}  // namespace

Pyramid make_pyramid(const std::vector<rsh_ray>& rays, size_t side) {
    Pyramid pyramid(1);
    for (const rsh_ray& ray : rays)
        pyramid[0].push_back(test::is_active(ray) ? cone_of(ray) : Cone());
    for (; side > 1; side /= 2) pyramid.push_back(level_above(pyramid.back(), side));
    return pyramid;
}

void descend(const Pyramid& pyramid, const Triangle& triangle, ConeTests& tests) {
    Descent{pyramid, triangle, sphere_of(triangle), tests}.visit(pyramid.size() - 1, 0, 0,
                                                                 true);
}

TestCosts time_tests(const Pyramid& pyramid, const std::vector<glm::dvec3>& corners) {
    const std::vector<Tested> all = pairs_to_time(pyramid, corners);
    size_t met = 0;
    const auto nanoseconds = [&](const auto& test) {
        constexpr int kRounds = 31;
        std::vector<double> rounds;
        for (int round = 0; round < kRounds; ++round)
            rounds.push_back(milliseconds([&] {
                for (const Tested& one : all) met += test(one);
            }));
        return 1e6 * spread(rounds).median / double(std::max<size_t>(all.size(), 1));
    };
    TestCosts costs;
    costs.sphere_ns =
        nanoseconds([](const Tested& one) { return meets(*one.cone, one.sphere); });
    costs.triangle_ns =
        nanoseconds([](const Tested& one) { return meets(*one.cone, one.triangle); });
    // Without a use of what was found, the tests could be left out.
    return met == SIZE_MAX ? TestCosts() : costs;
}

}  // namespace bench::paper
