#include <gtest/gtest.h>

#include <set>

#include "paper/scenes/layers.hpp"
#include "paper/scenes/reflectors.hpp"
#include "paper/scenes/statue.hpp"

namespace bench::paper {
namespace {

TEST(PaperLayers, HaveAsManyTrianglesWhateverTheirNumber) {
    for (const uint32_t layers : {1u, 4u, 16u})
        EXPECT_NEAR(double(make_layers(100000, layers).mesh.triangles.size()), 100000, 1000)
            << layers;
}

// A wave of the first sheet must not reach the second one.
TEST(PaperLayers, DoNotMeet) {
    const StillScene scene = make_layers(20000, 4);
    std::set<long> places;
    for (const glm::vec3& p : scene.mesh.positions)
        if (p.z > 0) places.insert(std::lround((p.z - 3.0f) / 0.05f));
    EXPECT_EQ(places, (std::set<long>{0, 1, 2, 3}));
}

TEST(PaperStatue, HasTheTrianglesThatAreAskedFor) {
    render::Model model;
    add_statue(model, 50000);
    EXPECT_NEAR(double(model.mesh.triangles.size()), 50000, 1000);
    ASSERT_EQ(model.materials.size(), 1u);
    EXPECT_GT(model.materials[0].reflection.x, 0);
    ASSERT_EQ(model.mesh.normals.size(), model.mesh.positions.size());
    for (const glm::vec3& normal : model.mesh.normals)
        EXPECT_NEAR(glm::length(normal), 1.0f, 1e-3f);
}

// Outside is away from the axis, as the library takes it.
TEST(PaperStatue, ShowsItsOutside) {
    render::Model model;
    add_statue(model, 20000);
    size_t outwards = 0;
    const render::Mesh& mesh = model.mesh;
    for (const glm::uvec3& t : mesh.triangles) {
        const glm::vec3 a = mesh.positions[t.x];
        const glm::vec3 normal = glm::cross(mesh.positions[t.y] - a, mesh.positions[t.z] - a);
        outwards += glm::dot(normal, glm::vec3(a.x, 0, a.z)) > 0;
    }
    EXPECT_GT(outwards, mesh.triangles.size() * 9 / 10);
}

StillScene three_things() {
    StillScene scene;
    // Two triangles that share an edge, with corners of their own; one apart; one that does not reflect.
    scene.mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                            {5, 0, 0}, {6, 0, 0}, {5, 1, 0}, {9, 0, 0}, {9, 1, 0}, {9, 0, 1}};
    scene.mesh.triangles = {{0, 1, 2}, {3, 4, 5}, {6, 7, 8}, {9, 10, 11}};
    scene.mesh.material_ids = {0, 0, 0, 1};
    scene.materials.resize(2);
    scene.materials[0] = scene.materials[1] = rsh_material{};
    scene.materials[0].reflection.s[1] = 0.5f;
    return scene;
}

rsh_hit hit(cl_uint primitive) {
    return {1, 0, 0, primitive};
}

TEST(PaperReflectors, AreThingsThatHangTogetherAndAreSeen) {
    const StillScene scene = three_things();
    EXPECT_EQ(count_reflectors(scene, {hit(0), hit(1), hit(RSH_NO_HIT)}), 1u);
    EXPECT_EQ(count_reflectors(scene, {hit(0), hit(2), hit(3)}), 2u);
    EXPECT_EQ(count_reflectors(scene, {hit(3)}), 0u);
}

}  // namespace
}  // namespace bench::paper
