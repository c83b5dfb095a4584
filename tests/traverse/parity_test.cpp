// parity_test.cpp - closed meshes, crossed by rays at their corners and edges: an even number of times
// right through, an odd one from inside, however thin their triangles and whatever their unit.
#include <gtest/gtest.h>

#include <cmath>

#include "oracle/crossings/crossings.hpp"
#include "support/bodies.hpp"
#include "support/closed_meshes.hpp"
#include "support/compare.hpp"
#include "support/ways.hpp"

namespace {

using test::DeviceMesh;
using test::Float3;
using test::Mesh;
using test::Random;
using test::Rays;
using test::TraceOptions;

// A list of count rays from `from(i)` to corners and edges.
template <class From>
Rays rays_at(Random& random, const Mesh& mesh, uint32_t count, const From& from) {
    Rays rays{{}, count, 1};
    for (uint32_t i = 0; i < count; ++i) {
        const Float3 eye = from();
        rays.rays.push_back(test::make_ray(eye, test::point_on_edge(random, mesh) - eye));
    }
    return rays;
}

void expect_parity(const Mesh& mesh, const Rays& rays, uint32_t odd) {
    for (const TraceOptions& way : test::brute_force_and_all_ways()) {
        const auto counts = hit_counts(DeviceMesh(mesh), rays, way);
        for (size_t i = 0; i < counts.size(); ++i)
            ASSERT_EQ(counts[i] % 2, odd) << name_of(way) << ": ray " << i << " "
                                          << rays.rays[i] << " counts " << counts[i];
    }
}

struct Named {
    const char* name;
    Mesh mesh;
    Float3 inside;  // no nearer to the surface than rounding
};

void PrintTo(const Named& named, std::ostream* out) {
    *out << named.name;
}

std::vector<Named> closed_meshes() {
    Random random(71);
    const Mesh star = test::star(15, 16, 0.2f);
    return {{"Sphere", test::sphere(16, 9), {0.1f, 0.2f, -0.1f}},
            {"Torus", test::torus(12, 24), {1, 0.05f, 0.02f}},
            {"Trefoil", test::trefoil(8, 96), {0, -0.25f, 0}},
            {"Box", test::lattice_box(random, 4), {1, 0, -2}},
            {"Star", star, {0, 0, 0}},
            {"Needles", test::with_needles(random, star, 200), {0, 0, 0}},
            {"BoxOfNeedles",
             test::with_needles(random, test::lattice_box(random, 4), 200),
             {1, 0, -2}}};
}

class Parity : public ::testing::TestWithParam<Named> {
protected:
    static constexpr uint32_t kRays = 600;
    Random random_{72};
    const Mesh& mesh_ = GetParam().mesh;
};

TEST_P(Parity, IsEvenRightThrough) {
    const auto outside = [&] { return 10.0f * normalize(random_.direction()); };
    expect_parity(mesh_, rays_at(random_, mesh_, kRays, outside), 0);
}

TEST_P(Parity, IsOddFromInside) {
    const auto inside = [&] { return GetParam().inside; };
    expect_parity(mesh_, rays_at(random_, mesh_, kRays, inside), 1);
}

TEST_P(Parity, IsEvenAlongTheAxes) {
    Rays rays{{}, kRays, 1};
    for (uint32_t i = 0; i < kRays; ++i) {
        const uint32_t axis = random_.below(3);
        const float away = random_.chance(0.5f) ? 16.0f : -16.0f;
        Float3 from = test::point_on_edge(random_, mesh_), along;
        (&from.x)[axis] = away;
        (&along.x)[axis] = -away;
        rays.rays.push_back(test::make_ray(from, along));
    }
    expect_parity(mesh_, rays, 0);
}

// Directions as long as the scene is large, so that t stays, or as they were.
TEST_P(Parity, IsTheSameInEveryUnit) {
    const auto outside = [&] { return 10.0f * normalize(random_.direction()); };
    const Rays rays = rays_at(random_, mesh_, kRays / 4, outside);
    for (const float unit : {1e-30f, 1e-20f, 1e-10f, 1e10f, 1e20f, 1e30f}) {
        SCOPED_TRACE(unit);
        const Mesh mesh = test::scaled(mesh_, unit);
        Rays at_mesh = test::scaled(rays, unit);
        expect_parity(mesh, at_mesh, 0);
        for (size_t i = 0; i < rays.rays.size(); ++i)
            at_mesh.rays[i] =
                test::make_ray(test::origin(at_mesh.rays[i]), test::direction(rays.rays[i]));
        expect_parity(mesh, at_mesh, 0);
    }
}

INSTANTIATE_TEST_SUITE_P(All, Parity, ::testing::ValuesIn(closed_meshes()),
                         [](const auto& named) { return named.param.name; });

// From corners, edges and the middle of one face to those of an inner square of the opposite one.
TEST(CrossingsOfABox, AreTwoThroughCornersAndEdges) {
    Random random(73);
    for (const Mesh& box :
         {test::placed(test::box_body({4, 4, 4}), {}), test::lattice_box(random, 4)})
        for (uint32_t axis = 0; axis < 3; ++axis)
            for (const float side : {-4.0f, 4.0f}) {
                Rays rays{{}, 81, 1};
                for (int i = 0; i < 81; ++i) {
                    const auto at = [&](int digit) { return float(i / digit % 3 - 1); };
                    Float3 from, to;
                    (&from.x)[axis] = side;
                    (&to.x)[axis] = -side;
                    (&from.x)[(axis + 1) % 3] = 4 * at(1),
                                           (&from.x)[(axis + 2) % 3] = 4 * at(3);
                    (&to.x)[(axis + 1) % 3] = 2 * at(9), (&to.x)[(axis + 2) % 3] = 2 * at(27);
                    rays.rays.push_back(test::make_ray(2.0f * from - to, to - from));
                }
                for (const TraceOptions& way : test::brute_force_and_all_ways())
                    EXPECT_TRUE(test::same_bits(hit_counts(DeviceMesh(box), rays, way),
                                                std::vector<uint32_t>(81, 2), "counts"))
                        << name_of(way) << ", axis " << axis << ", from " << side;
            }
}

// Past an edge, and past a corner.
TEST(CrossingsOfABox, AreTwoOrNoneWhereARayGrazes) {
    const DeviceMesh box(test::placed(test::box_body({4, 4, 4}), {}));
    Rays rays{{}, 0, 1};
    for (uint32_t axis = 0; axis < 3; ++axis)
        for (const float u : {-4.0f, 4.0f})
            for (const float v : {-4.0f, 4.0f})
                for (const float w : {-4.0f, -1.0f, 0.0f, 2.0f, 4.0f})
                    for (const float tilt : {-1.0f, -0.3f, 0.0f, 0.5f, 1.0f}) {
                        Float3 at, d;
                        (&at.x)[axis] = w, (&d.x)[axis] = tilt;
                        (&at.x)[(axis + 1) % 3] = u, (&d.x)[(axis + 1) % 3] = u;
                        (&at.x)[(axis + 2) % 3] = v, (&d.x)[(axis + 2) % 3] = -v;
                        rays.rays.push_back(test::make_ray(at - 4.0f * d, d));
                    }
    rays.width = uint32_t(rays.rays.size());
    uint32_t none = 0, two = 0;
    for (const TraceOptions& way : test::brute_force_and_all_ways())
        for (const uint32_t count : hit_counts(box, rays, way)) {
            EXPECT_TRUE(count == 0 || count == 2) << name_of(way) << ": " << count;
            ++(count ? two : none);
        }
    EXPECT_GT(none, 100u);
    EXPECT_GT(two, 100u);
}

// A tetrahedron, whose edge from -1 to 1 along x has a slit that high beside it, closed by triangle 4.
Mesh with_slit(float height) {
    Mesh mesh;
    const Float3 a(-1, 0, 0), b(1, 0, 0), c(0, 1, -1), d(0, -1, -1), m(0, height, 0);
    mesh.add(a, m, c);
    mesh.add(m, b, c);
    mesh.add(a, c, d);
    mesh.add(b, d, c);
    mesh.add(a, b, m);
    mesh.add(b, a, d);
    return mesh;
}

TEST(CrossingsOfANeedle, CountHoweverThinItIs) {
    for (const int power : {-10, -24, -60, -62, -80, -102, -110, -124}) {
        SCOPED_TRACE("2^" + std::to_string(power));
        const float height = std::ldexp(1.0f, power);
        const DeviceMesh mesh(with_slit(height));
        Rays rays{{}, 0, 1};
        std::vector<bool> is_needle;
        for (const float x : {-0.5f, -0.25f, 0.0f, 0.25f, 0.5f})
            for (const float y : {-0.25f, 0.0f, 0.25f, 0.75f, 1.0f, 2.0f}) {
                rays.rays.push_back(test::make_ray({x, y * height, 4}, {0, 0, -1}));
                const float above = 1 - std::fabs(x) - y;  // below its other two sides
                is_needle.push_back(y >= 0 && (above > 0 || (above == 0 && x < 0)));
            }
        rays.width = uint32_t(rays.rays.size());
        for (const TraceOptions& way : test::brute_force_and_all_ways()) {
            const test::HitLists lists = all_hits(mesh, rays, way);
            for (size_t i = 0; i < rays.rays.size(); ++i) {
                bool has_needle = false;
                std::string crossed;
                for (uint64_t k = lists.offsets[i]; k < lists.offsets[i + 1]; ++k) {
                    has_needle |= lists.hits[k].primitive == 4;
                    crossed += " " + std::to_string(lists.hits[k].primitive);
                }
                EXPECT_EQ(lists.offsets[i + 1] - lists.offsets[i], 2u)
                    << name_of(way) << ": " << rays.rays[i] << " crosses" << crossed;
                EXPECT_EQ(has_needle, is_needle[i]) << name_of(way) << ": " << rays.rays[i];
            }
        }
    }
}

}  // namespace
