// spheres_test.cpp - every sphere contains its triangle as stored; a triangle that is never hit
// has radius -1.
#include <gtest/gtest.h>

#include "bvh/types.h"
#include "oracle/containment.hpp"
#include "support/cases.hpp"
#include "support/compare.hpp"
#include "support/trace.hpp"

namespace {

void expect_contained(const test::Mesh& mesh, const std::vector<cl_float4>& spheres) {
    for (uint32_t t = 0; t < mesh.triangle_count(); ++t) {
        test::Corners c;
        const bool valid = mesh.corners(t, &c) && finite(c[0]) && finite(c[1]) && finite(c[2]);
        if (valid && spheres[t].s[3] == -1) {
            // Only a triangle without area may be left out.
            const auto area = cross(test::Double3(c[1]) - test::Double3(c[0]),
                                    test::Double3(c[2]) - test::Double3(c[0]));
            ASSERT_EQ(max_norm(area), 0) << "triangle " << t << " was left out";
            continue;
        }
        if (valid)
            ASSERT_TRUE(oracle::sphere_contains(spheres[t], c))
                << "triangle " << t << ", sphere " << spheres[t];
        else
            ASSERT_EQ(spheres[t].s[3], -1) << "triangle " << t << " is never hit";
    }
}

class Bound : public ::testing::TestWithParam<test::NamedCase> {};

TEST_P(Bound, ContainsEveryTriangle) {
    test::Random random(5);
    const test::Mesh mesh = GetParam().make(random).mesh;
    expect_contained(mesh, test::bound(test::DeviceMesh(mesh)));
}

// Tight enough to be of use: a sphere is at most twice as large as its triangle needs.
TEST_P(Bound, IsNotMuchLargerThanItsTriangle) {
    if (!GetParam().ordinary) return;
    test::Random random(5);
    const test::Mesh mesh = GetParam().make(random).mesh;
    const std::vector<cl_float4> spheres = test::bound(test::DeviceMesh(mesh));
    for (uint32_t t = 0; t < mesh.triangle_count(); ++t) {
        test::Corners c;
        mesh.corners(t, &c);
        const float longest =
            std::fmax(length(c[1] - c[0]), std::fmax(length(c[2] - c[0]), length(c[2] - c[1])));
        ASSERT_LE(spheres[t].s[3], longest) << "triangle " << t;
    }
}

INSTANTIATE_TEST_SUITE_P(All, Bound, ::testing::ValuesIn(test::all_cases()), test::case_name);

// Exactly, where the 2^-124 that each radius is given does not count.
TEST(BoundScale, ByPowersOfTwoScalesTheSpheres) {
    test::Random random(7);
    const test::Mesh mesh = test::random_soup(random, 300);
    const auto expected = test::bound(test::DeviceMesh(mesh));
    for (const int exponent : {-90, -60, 50, 90}) {
        const float scale = std::ldexp(1.0f, exponent);
        auto spheres = test::bound(test::DeviceMesh(scaled(mesh, scale)));
        for (cl_float4& sphere : spheres)
            for (float& component : sphere.s) component = std::ldexp(component, -exponent);
        EXPECT_TRUE(test::same_bits(spheres, expected, "spheres")) << "scale 2^" << exponent;
    }
}

TEST(BoundLayout, ReadsOffsetsAndStrides) {
    test::Random random(6);
    const test::Mesh mesh = test::random_soup(random, 300);
    std::vector<float> interleaved(5, NAN);  // 20 bytes before the first x
    for (const test::Float3& v : mesh.vertices)
        interleaved.insert(interleaved.end(), {v.x, v.y, v.z, NAN, NAN, NAN, NAN});
    std::vector<uint32_t> indices = {0xffffffffu, 0xffffffffu, 0xffffffffu};
    for (uint32_t i = 0; i < mesh.vertices.size(); ++i) indices.push_back(i);
    const test::Buffer<float> vertex_buffer(interleaved);
    const test::Buffer<uint32_t> index_buffer(indices);

    rsh_bound_desc desc = {};
    desc.struct_size = sizeof desc;
    desc.shape = RSH_SHAPE_CONE;
    desc.geometry.vertices = vertex_buffer.get();
    desc.geometry.vertices_offset = 20;
    desc.geometry.vertex_stride = 28;
    desc.geometry.vertex_count = cl_uint(mesh.vertices.size());
    desc.geometry.indices = index_buffer.get();
    desc.geometry.indices_offset = 12;
    desc.geometry.triangle_count = mesh.triangle_count();
    const size_t head = sizeof(spheres_head) / sizeof(cl_float4);
    const test::Buffer<cl_float4> bounds(head + mesh.triangle_count());
    desc.bounds = bounds.get();
    RSH_CHECK(
        rsh_bound(test::device().rsh, test::device().queue(), &desc, 0, nullptr, nullptr));
    std::vector<cl_float4> spheres = bounds.read();
    spheres.erase(spheres.begin(), spheres.begin() + head);
    EXPECT_TRUE(test::same_bits(spheres, test::bound(test::DeviceMesh(mesh)), "spheres"));
}

}  // namespace
