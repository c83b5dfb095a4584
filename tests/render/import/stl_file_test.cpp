// stl_file_test.cpp - STL as text and binary; welding that loses nothing.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "import/mesh_file.hpp"
#include "temporary_folder.hpp"

namespace render {
namespace {

std::string binary(std::initializer_list<float> coordinates) {
    std::string bytes = "solid but binary";
    bytes.resize(80, ' ');
    bytes += bytes_of<uint32_t>({static_cast<uint32_t>(coordinates.size() / 9)});
    for (const float* at = coordinates.begin(); at != coordinates.end(); at += 9) {
        bytes += std::string(12, '\0');
        bytes.append(reinterpret_cast<const char*>(at), 36);
        bytes += std::string(2, '\0');
    }
    return bytes;
}

TEST(StlFile, WeldsEqualVerticesOnly) {
    // The second triangle is of denormal size, the third has a NaN.
    const float d = 1e-40f, nan = std::numeric_limits<float>::quiet_NaN();
    const TemporaryFolder folder;
    const Mesh mesh = load_mesh(folder.write("a.stl", binary({0,   0, 0, 1, 0, 0, 0, 1, 0,  //
                                                              0,   0, 0, d, 0, 0, 0, d, 0,  //
                                                              nan, 0, 0, 1, 0, 0, 0, 1, 0,  //
                                                              1,   0, 0, 1, 0, 0, 0, 1, 0})))
                          .mesh;
    ASSERT_EQ(mesh.triangles.size(), 4u) << "the last one has no area, and stays";
    EXPECT_EQ(mesh.positions.size(), 6u);
    EXPECT_EQ(mesh.positions[mesh.triangles[1].y].x, d);
    EXPECT_TRUE(std::isnan(mesh.positions[mesh.triangles[2].x].x));
    EXPECT_EQ(mesh.triangles[2].y, mesh.triangles[0].y);
}

TEST(StlFile, ReadsSeveralSolidsAsText) {
    const std::string solid =
        "solid a b\n facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n   vertex 1 0 0\n"
        "   vertex 0 1e0 0\n  endloop\n endfacet\nendsolid\n";
    const TemporaryFolder folder;
    EXPECT_EQ(load_mesh(folder.write("a.stl", solid + "solid empty\nendsolid\n" + solid))
                  .mesh.triangles.size(),
              2u);
    EXPECT_NE(
        error_of_mesh(folder.write("b.stl", solid.substr(0, solid.find("   vertex 0 1e0"))))
            .find("promises 1 facets"),
        std::string::npos);
}

TEST(StlFile, WordsCountNotLines) {
    const std::string facet =
        "facet normal 0 0 1 outer loop vertex 0 0 0 vertex 1\n0 0 VERTEX 0 1 0 endloop "
        "endfacet ";
    const TemporaryFolder folder;
    for (const std::string start : {"solid ", "SOLID a vertex\n", "solid a loop "})
        EXPECT_EQ(load_mesh(folder.write("a.stl", start + facet + facet + "endsolid a facet"))
                      .mesh.triangles.size(),
                  2u)
            << start;
    EXPECT_NE(error_of_mesh(folder.write("b.stl", "solid\n" + facet + "vertex 1 y 0"))
                  .find("b.stl, facet 1: a vertex needs 3 numbers, but has 'y'"),
              std::string::npos);
}

TEST(StlFile, CountsThatAreTooSmallAreAWarning) {
    const std::string whole = binary({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, 0, 1, 1});
    const TemporaryFolder folder;
    for (const auto& [count, triangles] : {std::pair(0u, 2u), std::pair(1u, 1u)}) {
        std::string changed = whole;
        changed.replace(80, 4, bytes_of<uint32_t>({count}));
        const Model model = load_mesh(folder.write("a.stl", changed));
        EXPECT_EQ(model.mesh.triangles.size(), triangles) << "count " << count;
        EXPECT_EQ(model.warnings.size(), 1u) << "count " << count;
    }
    std::string changed = whole;
    changed.replace(80, 4, "\xff\xff\xff\xff");
    EXPECT_NE(error_of_mesh(folder.write("a.stl", changed)).find("promises 4294967295"),
              std::string::npos);
}

TEST(StlFile, EveryTruncationOfABinaryFileIsAnError) {
    const std::string whole = binary({0, 0, 0, 1, 0, 0, 0, 1, 0});
    const TemporaryFolder folder;
    for (size_t size = 0; size < whole.size(); ++size)
        EXPECT_FALSE(error_of_mesh(folder.write("a.stl", whole.substr(0, size))).empty())
            << "first " << size << " of " << whole.size() << " bytes";
}

}  // namespace
}  // namespace render
