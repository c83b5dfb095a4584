// triangle_order_test.cpp - triangles that stand still come before those that move.
#include <gtest/gtest.h>

#include "scene/scene_file.hpp"
#include "scene/world.hpp"
#include "temporary_folder.hpp"

namespace render {
namespace {

constexpr const char* kTriangle = "p 3  0 0 0  1 0 0  0 1 0\n";

// A fill per triangle; they move where `moves` says so. Vertices that stand still between others that
// move count as moving where they are few: each triangle has a ball with many behind it.
std::string aff(const std::string& moves) {
    std::string text =
        "a 0 2 3\nk t { scale 5  -1 1 1 1 0 0 0  0 1 1 1 0 0 0  1 2 1 1 0 0 0  2 -1 1 1 0 0 0  "
        "3 1 1 1 0 0 0 }\n";
    for (size_t i = 0; i < moves.size(); ++i) {
        text += "f " + std::to_string(i) + " 0 0 1 0 0 0 0\n";
        const std::string things = std::string(kTriangle) + "s 0 0 0 1\n";
        text += moves[i] == 'm' ? "x t {\n" + things + "}\n" : things;
    }
    return text;
}

class TriangleOrder : public testing::Test {
protected:
    World world(const std::vector<std::string>& files) const {
        std::string meshes;
        for (size_t i = 0; i < files.size(); ++i) {
            const std::string path = folder_.write(std::to_string(i) + ".aff", aff(files[i]));
            meshes += (i ? ", " : "") + (R"({"file": ")" + path + "\"}");
        }
        return World(parse_scene("{\"meshes\": [" + meshes + "]}", "scene.json"));
    }

    TemporaryFolder folder_;
};

constexpr size_t kThing = 1 + 24 * 12 * 2;  // a triangle and a ball

// The fill of each thing, in the order of triangles.
std::vector<int> fills(const World& world) {
    std::vector<int> found;
    for (size_t i = 0; i < world.mesh().triangles.size(); i += kThing)
        found.push_back(
            static_cast<int>(world.materials()[world.mesh().material_ids[i]].diffuse.s[0]));
    return found;
}

std::vector<size_t> numbers(const World& world) {
    std::vector<size_t> found;
    for (size_t i = 0; i < world.mesh().triangles.size(); i += kThing) {
        EXPECT_EQ(world.triangle_number(i) % kThing, 0u);
        EXPECT_EQ(world.triangle_number(i + kThing - 1), world.triangle_number(i) + kThing - 1);
        found.push_back(world.triangle_number(i) / kThing);
    }
    return found;
}

TEST_F(TriangleOrder, PutsWhatStandsStillFirst) {
    const World world = this->world({"mssms", "sm"});
    EXPECT_EQ(world.still_triangles(), 4 * kThing);
    EXPECT_EQ(numbers(world), (std::vector<size_t>{1, 2, 4, 5, 0, 3, 6}));
    EXPECT_EQ(fills(world), (std::vector<int>{1, 2, 4, 0, 0, 3, 1}));
}

TEST_F(TriangleOrder, StaysWhereAllOrNothingMoves) {
    for (const char* moves : {"ss", "mm", "sm"}) {
        const World world = this->world({moves});
        EXPECT_EQ(numbers(world), (std::vector<size_t>{0, 1})) << moves;
        EXPECT_EQ(world.still_triangles(), kThing * (2 - (moves[0] == 'm') - (moves[1] == 'm')))
            << moves;
    }
}

// At 2 s all that moves is mirrored. The corners of every thing's triangle are where they belong.
TEST_F(TriangleOrder, StaysWhenTrianglesTurn) {
    World world = this->world({"mssm", "ms"});
    for (const double time : {0.5, 2.0, 0.0, 2.0}) {
        world.move_to(time);
        EXPECT_EQ(world.has_turned_triangles(), time != 0.5) << time;
        for (size_t i = 0; i < world.mesh().triangles.size(); i += kThing) {
            const bool is_turned = time == 2.0 && i >= world.still_triangles();
            const glm::uvec3 t = world.mesh().triangles[i];
            const glm::vec3 second = world.mesh().positions[is_turned ? t.z : t.y];
            EXPECT_EQ(second.y, 0.0f) << "triangle " << i << " at " << time;
            EXPECT_EQ(second.x < 0.0f, is_turned) << "triangle " << i << " at " << time;
        }
    }
}

}  // namespace
}  // namespace render
