// far_mesh_test.cpp - meshes whose coordinates are too large for floats, and that the scene moves
// back: every position against the same in double precision.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include "scene/scene_file.hpp"
#include "scene/world.hpp"
#include "temporary_folder.hpp"

namespace render {
namespace {

constexpr int kSide = 21;  // vertices of a bent sheet, 0.1 apart

glm::dvec3 sheet(int i) {
    const double x = 0.1 * (i % kSide), y = 0.1 * (i / kSide);
    return {x, y, 0.25 * (x - 1.0) * (x - 1.0)};
}

std::string lines(glm::dvec3 far, const char* start) {
    std::string text;
    for (int i = 0; i < kSide * kSide; ++i) {
        const glm::dvec3 p = far + sheet(i);
        text += fmt::format("{}{:.4f} {:.4f} {:.4f}\n", start, p.x, p.y, p.z);
    }
    return text;
}

std::string faces(const char* start, int first) {
    std::string text;
    for (int i = 0; i + kSide < kSide * kSide; ++i)
        if (i % kSide != kSide - 1)
            text += fmt::format("{} {} {} {}\n{} {} {} {}\n", start, i + first, i + 1 + first,
                                i + kSide + first, start, i + 1 + first, i + kSide + 1 + first,
                                i + kSide + first);
    return text;
}

std::string ply(glm::dvec3 far) {
    return fmt::format(
               "ply\nformat ascii 1.0\nelement vertex {}\nproperty double x\nproperty double "
               "y\nproperty double z\nelement face {}\nproperty list uchar int "
               "vertex_indices\nend_header\n",
               kSide * kSide, 2 * (kSide - 1) * (kSide - 1)) +
           lines(far, "") + faces("3", 0);
}

std::string off(glm::dvec3 far) {
    return fmt::format("OFF {} {} 0\n", kSide * kSide, 2 * (kSide - 1) * (kSide - 1)) +
           lines(far, "") + faces("3", 0);
}

std::string obj(glm::dvec3 far) {
    return lines(far, "v ") + faces("f", 1);
}

World world_of(const std::string& file, const std::string& placing) {
    return World(parse_scene(
        fmt::format("{{\"meshes\": [{{\"file\": \"{}\"{}}}]}}", file, placing), "scene.json"));
}

void expect_placed(const World& world, const glm::dmat4& matrix, glm::dvec3 far,
                   double tolerance, size_t first = 0) {
    ASSERT_EQ(world.mesh().positions.size(), first + kSide * kSide);
    for (int i = 0; i < kSide * kSide; ++i) {
        const glm::dvec3 exact(matrix * glm::dvec4(far + sheet(i), 1.0));
        const glm::dvec3 found(world.mesh().positions[first + static_cast<size_t>(i)]);
        ASSERT_LT(glm::distance(found, exact), tolerance)
            << "vertex " << i << ": " << found.x << " " << found.y << " " << found.z;
    }
}

glm::dmat4 moved(glm::dvec3 by) {
    glm::dmat4 matrix(1.0);
    matrix[3] = glm::dvec4(by, 1.0);
    return matrix;
}

std::string translate(glm::dvec3 by) {
    return fmt::format("{{\"translate\": [{:.4f}, {:.4f}, {:.4f}]}}", by.x, by.y, by.z);
}

const glm::dvec3 kPlaces[] = {{528980.85, 5183527.1, 0},
                              {-7.5, 20, 5183526.3},
                              {4e7 + 0.3, -4e7 - 0.7, 1e7},
                              {0, 6378137.2, 0},
                              {1234.5, -98765.4, 0.1}};

TEST(FarMesh, IsAsFineAsItsFileWhenItIsMovedBack) {
    const TemporaryFolder folder;
    for (const glm::dvec3& far : kPlaces)
        for (const std::string& file :
             {folder.write("a.obj", obj(far)), folder.write("a.off", off(far)),
              folder.write("a.ply", ply(far))}) {
            SCOPED_TRACE(fmt::format("{} at {} {} {}", file, far.x, far.y, far.z));
            const glm::dvec3 back = -far + glm::dvec3(0.25, -1, 3);
            const World world = world_of(file, ", \"transform\": " + translate(back));
            expect_placed(world, moved(back), far, 1e-6);
            EXPECT_TRUE(world.warnings().empty()) << world.warnings()[0];
        }
}

TEST(FarMesh, MayBeTurnedAndScaledOnTheWay) {
    const TemporaryFolder folder;
    const glm::dvec3 far = kPlaces[0];
    const std::string file = folder.write("a.obj", obj(far));
    glm::dmat4 turn_and_scale(0.0);  // x -> 2 z, y -> 2 x, z -> 2 y
    turn_and_scale[0][2] = turn_and_scale[1][0] = turn_and_scale[2][1] = 2.0;
    turn_and_scale[3][3] = 1.0;
    const glm::dvec3 back(-2 * far.y, -2 * far.z, -2 * far.x);
    const glm::dmat4 whole = moved(back) * turn_and_scale;
    const std::string steps[] = {
        "[{\"rotate\": {\"axis\": [1, 1, 1], \"degrees\": -120}}, {\"scale\": 2}, " +
            translate(back) + "]",
        "[{\"matrix\": [[0, 1, 0, 0], [0, 0, 1, 0], [1, 0, 0, 0], [0, 0, 0, 1]]}, {\"scale\": "
        "[2, 2, 2]}, " +
            translate(back) + "]",
        fmt::format(
            "{{\"matrix\": [[0, 2, 0, {:.4f}], [0, 0, 2, {:.4f}], [2, 0, 0, {:.4f}], [0, "
            "0, 0, 1]]}}",
            back.x, back.y, back.z)};
    for (const std::string& step : steps) {
        SCOPED_TRACE(step);
        expect_placed(world_of(file, ", \"transform\": " + step), whole, far, 1e-5);
    }
}

TEST(FarMesh, MayBeMovedBackByStandOrKeys) {
    const TemporaryFolder folder;
    const glm::dvec3 far = kPlaces[0];
    const std::string file = folder.write("a.obj", obj(far));
    const glm::dvec3 foot(1, 0, 0.125);
    expect_placed(world_of(file, ", \"stand\": {\"at\": [0, 0, 0], \"height\": 2}"),
                  moved(-far - foot), far, 1e-6);
    World world = world_of(
        file, fmt::format(", \"keys\": [{{\"time\": 0, \"translate\": [{0}, {1}, 0]}}, "
                          "{{\"time\": 2, \"translate\": [{0}, {1}, 2]}}]",
                          -far.x, -far.y));
    world.move_to(1.0);
    expect_placed(world, moved({-far.x, -far.y, 1}), far, 1e-6);
}

TEST(FarMesh, HasTheNormalsThatItWouldHaveAtTheOrigin) {
    const TemporaryFolder folder;
    const glm::dvec3 far = kPlaces[0];
    const std::string smooth = ", \"smooth\": 20, \"transform\": ";
    const World near =
        world_of(folder.write("near.obj", obj({0, 0, 0})), smooth + translate({0, 0, 0}));
    const World there = world_of(folder.write("far.obj", obj(far)), smooth + translate(-far));
    ASSERT_EQ(near.mesh().triangles, there.mesh().triangles);
    for (size_t i = 0; i < near.mesh().normals.size(); ++i)
        ASSERT_LT(glm::distance(near.mesh().normals[i], there.mesh().normals[i]), 1e-5f) << i;
}

// Exporters write a vertex at the origin that no face uses, or a face or two that lie astray.
TEST(FarMesh, MayHaveSomethingAstray) {
    const TemporaryFolder folder;
    const glm::dvec3 far = kPlaces[0];
    const std::string stray = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    for (const char* face : {"", "f 1 2 3\n"}) {
        const std::string file =
            folder.write("a.obj", stray + lines(far, "v ") + face + faces("f", 4));
        expect_placed(world_of(file, ", \"transform\": " + translate(-far)), moved(-far), far,
                      1e-6, 3);
    }
}

// Coordinates of a text STL are rounded when they are read, but not once more.
TEST(FarMesh, OfFloatsStaysExact) {
    const TemporaryFolder folder;
    std::string text = "solid\n";
    for (int i = 0; i < 8; ++i)
        text += fmt::format(
            "facet normal 0 0 1\nouter loop\nvertex {0}.5 0 0\nvertex {1}.5 0 0\n"
            "vertex {0}.5 1 0\nendloop\nendfacet\n",
            5183520 + i, 5183521 + i);
    const World world = world_of(folder.write("a.stl", text + "endsolid\n"),
                                 ", \"transform\": " + translate({-5183520.4, 0, 0}));
    EXPECT_NEAR(world.mesh().positions[0].x, 0.1, 1e-6);
    EXPECT_NEAR(world.mesh().positions[1].x, 1.1, 1e-6);
}

// A polygon of 1 km, whose corners have texture coordinates and normals.
TEST(FarMesh, MayBeOneLargePolygon) {
    const TemporaryFolder folder;
    const std::string file = folder.write(
        "a.obj",
        "v 528980.85 5183527.1 0\nv 529980.85 5183527.1 0\nv 529980.85 5184527.1 0\n"
        "v 528980.85 5184527.1 0\nvt 0 0\nvn 0 0 1\nf 1/1/1 2/1/1 3/1/1 4/1/1\n");
    const World world =
        world_of(file, ", \"transform\": " + translate({-528980.85, -5183527.1, 0}));
    const std::vector<glm::vec3> exact{{0, 0, 0}, {1000, 0, 0}, {1000, 1000, 0}, {0, 1000, 0}};
    for (size_t i = 0; i < 4; ++i)
        EXPECT_LT(glm::distance(world.mesh().positions.at(i), exact[i]), 1e-3f) << i;
}

TEST(FarMesh, ThatStaysThereIsWarnedOf) {
    const TemporaryFolder folder;
    const World world = world_of(folder.write("a.obj", obj(kPlaces[0])), "");
    ASSERT_EQ(world.warnings().size(), 1u);
    EXPECT_NE(world.warnings()[0].find("a.obj: lies 5.21e+06 from the world's origin"),
              std::string::npos)
        << world.warnings()[0];
    expect_placed(world, glm::dmat4(1.0), kPlaces[0], 0.3);
}

// Half the sheet's size is 1.
TEST(FarMesh, IsWarnedOfByItsSize) {
    const TemporaryFolder folder;
    const std::string file = folder.write("a.obj", obj({0, 0, -30}));
    const auto warnings = [&](const char* transform) {
        return world_of(file, std::string(", \"transform\": ") + transform).warnings().size();
    };
    EXPECT_EQ(warnings(R"({"translate": [0, 0, 25]})"), 0u);
    EXPECT_EQ(warnings(R"({"translate": [0, 0, 20]})"), 1u);
    EXPECT_EQ(warnings(R"([{"translate": [0, 0, 25]}, {"scale": 1000}])"), 0u);
    EXPECT_EQ(warnings(R"([{"scale": 0.1}, {"translate": [0, 0, 2]}])"), 1u);
}

}  // namespace
}  // namespace render
