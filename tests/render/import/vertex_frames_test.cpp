// vertex_frames_test.cpp - raw vertex animations.
#include <gtest/gtest.h>

#include "files/text_scan.hpp"
#include "import/vertex_frames.hpp"
#include "temporary_folder.hpp"

namespace render {
namespace {

constexpr const char* kDescription =
    "{\"frames\": 3, \"vertices\": 3, \"triangles\": 1, \"time_start\": 1, \"time_end\": 2}";

// One triangle; its second corner moves along y, then along z.
std::string positions() {
    return bytes_of<float>({0, 0, 0, 1, 0, 0, 0, 1, 0,  //
                            0, 0, 0, 1, 1, 0, 0, 1, 0,  //
                            0, 0, 0, 1, 1, 1, 0, 1, 0});
}

class VertexFramesFiles : public testing::Test {
protected:
    std::unique_ptr<Animation> load(const std::string& obj, const std::string& frames,
                                    const std::string& json) const {
        const std::string mesh = folder_.write("a.obj", obj);
        folder_.write("b.json", json);
        return load_vertex_frames(mesh, folder_.write("b.f32", frames));
    }

    TemporaryFolder folder_;
    const std::string obj_ = "v 9 9 9\nv 9 9 9\nv 9 9 9\n";
};

TEST_F(VertexFramesFiles, AreLinearBetweenFramesAndClamped) {
    const auto animation = load(obj_ + "f 1 2 3\n", positions(), kDescription);
    EXPECT_EQ(animation->frames(), 3);
    EXPECT_EQ(animation->start(), 1.0);
    EXPECT_EQ(animation->end(), 2.0);
    EXPECT_EQ(animation->at(0.0).mesh.positions[1], glm::vec3(1, 0, 0));
    EXPECT_EQ(animation->at(1.25).mesh.positions[1], glm::vec3(1, 0.5f, 0));
    EXPECT_EQ(animation->at(1.5).mesh.positions[1], glm::vec3(1, 1, 0));
    EXPECT_EQ(animation->at(1.75).mesh.positions[1], glm::vec3(1, 1, 0.5f));
    EXPECT_EQ(animation->at(3.0).mesh.positions[1], glm::vec3(1, 1, 1));
    EXPECT_TRUE(animation->at(1.0).mesh.normals.empty());
}

// Texture coordinates split the vertices; positions still follow the numbers of the file.
TEST_F(VertexFramesFiles, ComputeNormalsIfTheMeshHasThem) {
    const auto animation =
        load(obj_ + "vn 1 0 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 3/3/1 1/1/1 2/2/1\n", positions(),
             kDescription);
    const Mesh first = animation->at(1.0).mesh, last = animation->at(2.0).mesh;
    ASSERT_EQ(first.normals.size(), 3u);
    EXPECT_EQ(first.normals[0], glm::vec3(0, 0, 1));
    EXPECT_EQ(last.positions[first.triangles[0].z], glm::vec3(1, 1, 1));
    EXPECT_LT(glm::distance(last.normals[0], glm::normalize(glm::vec3(-1, 0, 1))), 1e-6f);
}

TEST_F(VertexFramesFiles, PromisesAreChecked) {
    const std::string face = obj_ + "f 1 2 3\n";
    EXPECT_THROW(load(obj_ + "v 0 0 0\nf 1 2 3\n", positions(), kDescription), LoadError);
    EXPECT_THROW(load(face + "f 1 2 3\n", positions(), kDescription), LoadError);
    EXPECT_THROW(load(face, positions() + "x", kDescription), LoadError);
    EXPECT_THROW(load(face, positions().substr(4), kDescription), LoadError);
    EXPECT_THROW(load(face, positions(), "{\"frames\": 3}"), LoadError);
    EXPECT_THROW(load(face, positions(), "[]"), LoadError);
    EXPECT_THROW(load(face, positions(), "no JSON"), LoadError);
}

}  // namespace
}  // namespace render
