#include "stability/family.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <set>

#include "stability/tally.hpp"

namespace {

using namespace bench::stability;

Scene make(const Family& family, uint64_t salt) {
    test::Random random(salt);
    return family.make(random, {8, 64});
}

TEST(Families, AreTwentyAtLeastOfDifferentNames) {
    std::set<std::string> names;
    for (const Family& family : all_families())
        EXPECT_TRUE(names.insert(family.name).second) << family.name << " is there twice";
    EXPECT_GE(names.size(), 20u);
    for (const char* name : {"slivers", "needles", "caps", "zero_area"})
        EXPECT_EQ(names.count(name), 1u) << name;
}

TEST(Families, MakeSquaresOfRaysAndTriangles) {
    for (const Family& family : all_families()) {
        const Scene scene = make(family, 1);
        EXPECT_GE(scene.rays.width, 4u) << family.name;
        EXPECT_LE(scene.rays.width, 8u) << family.name;
        EXPECT_EQ(scene.rays.height, scene.rays.width) << family.name;
        EXPECT_EQ(scene.rays.rays.size(), scene.rays.width * scene.rays.height) << family.name;
        EXPECT_GE(scene.mesh.triangle_count(), 8u) << family.name;
    }
}

TEST(Families, ComeFromTheirRandomNumbersAlone) {
    const auto is_same = [](const Scene& a, const Scene& b) {
        return a.mesh.vertices.size() == b.mesh.vertices.size() &&
               std::memcmp(a.mesh.vertices.data(), b.mesh.vertices.data(),
                           a.mesh.vertices.size() * sizeof a.mesh.vertices[0]) == 0 &&
               std::memcmp(a.rays.rays.data(), b.rays.rays.data(),
                           a.rays.rays.size() * sizeof(rsh_ray)) == 0;
    };
    for (const Family& family : all_families()) {
        EXPECT_TRUE(is_same(make(family, 1), make(family, 1))) << family.name;
        EXPECT_FALSE(is_same(make(family, 1), make(family, 2))) << family.name;
    }
}

// A family whose rays meet nothing shows nothing.
TEST(Families, HaveRaysThatHit) {
    for (const Family& family : all_families()) {
        size_t possible = 0;
        for (uint64_t salt = 1; salt <= 8; ++salt)
            for (const oracle::Answer& answer :
                 expected_answers(make(family, salt), family.kind, 64).answers)
                possible += answer.possible;
        EXPECT_GT(possible, 8u) << family.name << ": of 512 rays";
    }
}

}  // namespace
