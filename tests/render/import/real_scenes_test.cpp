// real_scenes_test.cpp - real meshes and animations, read from the folder that RSH_SCENES
// names: triangle counts, and that broken files load or give an error.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iostream>

#include "files/asset.hpp"
#include "files/text_scan.hpp"
#include "import/bart/aff_animation.hpp"
#include "import/gltf/gltf_animation.hpp"
#include "import/mesh_file.hpp"
#include "import/vertex_frames.hpp"

namespace render {
namespace {

namespace fs = std::filesystem;

class RealScenes : public testing::Test {
protected:
    void SetUp() override {
        const char* folder = std::getenv("RSH_SCENES");
        if (!folder || !fs::is_directory(folder))
            GTEST_SKIP() << "RSH_SCENES names no folder, so no real scene is read";
        folder_ = folder;
    }

    std::string path(const std::string& name) const { return (folder_ / name).string(); }

    fs::path folder_;
};

struct Count {
    const char* file;
    size_t triangles;
    size_t vertices;  // of the file
};

TEST_F(RealScenes, MeshesHaveAllTheirTrianglesAndNoVertexTwice) {
    constexpr Count kCounts[] = {{"conference/conference.obj", 331179, 194399},
                                 {"dragon/dragon_vrip.ply", 871414, 437645},
                                 {"dragon/dragon_vrip_res2.ply", 202520, 100250},
                                 {"dragon/dragon_vrip_res3.ply", 47794, 22998},
                                 {"dragon/dragon_vrip_res4.ply", 11102, 5205},
                                 {"bunny/bun_zipper.ply", 69451, 35947},
                                 {"bunny/bun_zipper_res2.ply", 16301, 8171},
                                 {"bunny/bun_zipper_res3.ply", 3851, 1889},
                                 {"bunny/bun_zipper_res4.ply", 948, 453},
                                 {"chinese_dragon_20k/ChineseDragon-10kv.off", 19994, 10000},
                                 {"koala/koala.obj", 99994, 49999},
                                 {"cornell_box/CornellBox-Empty-CO.obj", 12, 24},
                                 {"cornell_box/CornellBox-Empty-RG.obj", 12, 24},
                                 {"cornell_box/CornellBox-Empty-Squashed.obj", 12, 2574},
                                 {"cornell_box/CornellBox-Empty-White.obj", 12, 24},
                                 {"cornell_box/CornellBox-Glossy.obj", 1112, 578},
                                 {"cornell_box/CornellBox-Glossy-Floor.obj", 1112, 578},
                                 {"cornell_box/CornellBox-Mirror.obj", 36, 72},
                                 {"cornell_box/CornellBox-Original.obj", 36, 72},
                                 {"cornell_box/CornellBox-Sphere.obj", 2188, 1116},
                                 {"cornell_box/CornellBox-Water.obj", 7088, 3666},
                                 {"cornell_box/water.obj", 4900, 2550}};
    for (const Count& count : kCounts) {
        const NumberedModel loaded = load_numbered_mesh(path(count.file));
        EXPECT_EQ(loaded.model.mesh.triangles.size(), count.triangles) << count.file;
        EXPECT_EQ(loaded.file_vertices, count.vertices) << count.file;
        EXPECT_EQ(loaded.model.mesh.material_ids.size(), count.triangles) << count.file;
    }
}

TEST_F(RealScenes, MirrorsAndGlassOfTheCornellBox) {
    const Model model = load_mesh(path("cornell_box/CornellBox-Sphere.obj"));
    size_t mirrors = 0, glasses = 0;
    for (const Material& material : model.materials) {
        if (material.reflection.x > 0.9f) ++mirrors;
        if (material.transmission.x > 0.0f && material.ior > 2.0f) ++glasses;
    }
    EXPECT_EQ(mirrors, 1u);
    EXPECT_EQ(glasses, 1u);
}

void expect_bart(const std::string& file, size_t triangles, int frames) {
    const auto animation = load_aff(file);
    EXPECT_EQ(animation->frames(), frames) << file;
    const Model first = animation->at(animation->start());
    EXPECT_EQ(first.mesh.triangles.size(), triangles) << file;
    EXPECT_TRUE(first.camera.has_value()) << file;
    for (int i = 1; i <= 8; ++i) {
        const double time =
            animation->start() + (animation->end() - animation->start()) * i / 8.0;
        const Model model = animation->at(time);
        ASSERT_EQ(model.mesh.triangles, first.mesh.triangles) << file << " at " << time;
        for (const glm::vec3 p : model.mesh.positions)
            ASSERT_LT(glm::length(p), 1000.0f) << file << " at " << time;
    }
}

TEST_F(RealScenes, BartMuseum) {
    expect_bart(path("bart_museum/aff/museum5.aff"), 11692, 300);
}
TEST_F(RealScenes, BartKitchen) {
    expect_bart(path("bart_kitchen/aff/kitchen.aff"), 110561, 800);
}

// Textures that were left out, and two wheels with keys at equal times. Each warning names its line.
TEST_F(RealScenes, BartLoadsWithAWarningForEachSlip) {
    const auto count = [&](const std::string& file) {
        const std::vector<std::string> warnings = load_aff(path(file))->at(0.0).warnings;
        for (const std::string& warning : warnings)
            EXPECT_NE(warning.find(".aff, line "), std::string::npos) << warning;
        return warnings.size();
    };
    EXPECT_EQ(count("bart_kitchen/aff/kitchen.aff"), 8u + 2u);
    EXPECT_EQ(count("bart_museum/aff/museum5.aff"), 5u);
    EXPECT_EQ(count("bart_museum/aff/museum7.aff"), 5u + 1u) << "its triangles are not there";
}

// Distance of a point from the surface of the tetrahedron through (+-.5, +-.5, +-.5) + c, along
// the faces' normals (1, 1, 1) and so on.
float tetrahedron_error(glm::vec3 p) {
    const glm::vec3 q = p - glm::vec3(0.0f, 2.5f, 0.0f);
    const float planes[] = {q.x - q.y - q.z, -q.x + q.y - q.z, -q.x - q.y + q.z,
                            q.x + q.y + q.z};
    float error = 1e9f;
    for (const float plane : planes)
        error = std::min(error, std::min(std::abs(plane - 0.5f), std::abs(plane + 0.5f)));
    return error;
}

TEST_F(RealScenes, MuseumMorphsThroughTetrahedronAndSphere) {
    const auto animation = load_aff(path("bart_museum/aff/museum5.aff"));
    const Mesh rest = animation->at(0.0).mesh, tetrahedron = animation->at(2.0).mesh,
               sphere = animation->at(3.0).mesh;
    size_t moving = 0;
    for (size_t i = 0; i < rest.positions.size(); ++i) {
        if (rest.positions[i] == sphere.positions[i]) continue;
        ++moving;
        EXPECT_LT(tetrahedron_error(tetrahedron.positions[i]), 1e-5f) << "vertex " << i;
        EXPECT_NEAR(glm::distance(sphere.positions[i], glm::vec3(0.0f, 2.5f, 0.0f)), 0.8f,
                    1e-5f)
            << "vertex " << i;
    }
    EXPECT_EQ(moving, 3u * 1024);
}

void expect_frames(const fs::path& folder, const std::string& name, size_t triangles,
                   int frames) {
    const std::string base = (folder / name).string();
    const auto animation = load_vertex_frames(base + "_base.obj", base + "_frames.f32");
    EXPECT_EQ(animation->frames(), frames) << name;
    const Model still = load_mesh(base + "_base.obj");
    const Model first = animation->at(animation->start());
    ASSERT_EQ(first.mesh.triangles.size(), triangles) << name;
    for (size_t i = 0; i < still.mesh.positions.size(); ++i)
        ASSERT_LT(glm::distance(first.mesh.positions[i], still.mesh.positions[i]), 1e-3f)
            << name << ", vertex " << i << ": the first frame is the mesh itself";
    EXPECT_NE(animation->at(animation->end() / 2.0).mesh.positions, first.mesh.positions)
        << name;
}

TEST_F(RealScenes, VertexAnimationsStartAtTheirMesh) {
    expect_frames(folder_ / "fox", "fox_walk", 576, 24);
    expect_frames(folder_ / "fox", "fox_run", 576, 24);
    expect_frames(folder_ / "robot_expressive", "robot_dance", 3234, 30);
}

// Others have evaluated these clips, with rotations on the chord between two keys, not the arc: that is up to
// 1.4e-4 of the size. tests/scenes/gltf_check.py compares all clips, and closely.
void expect_baked(const Animation& clip, const fs::path& folder, const std::string& name) {
    const std::string base = (folder / name).string();
    const auto baked = load_vertex_frames(base + "_base.obj", base + "_frames.f32");
    for (int i = 0; i < baked->frames(); i += 5) {
        const double time = baked->start() + (baked->end() - baked->start()) * i /
                                                 std::max(baked->frames() - 1, 1);
        const Mesh a = clip.at(time).mesh, b = baked->at(time).mesh;
        ASSERT_EQ(a.triangles.size(), b.triangles.size()) << name;
        glm::vec3 low(INFINITY), high(-INFINITY);
        for (const glm::vec3& p : b.positions) low = glm::min(low, p), high = glm::max(high, p);
        for (size_t k = 0; k < a.triangles.size(); ++k)
            for (int corner = 0; corner < 3; ++corner)
                ASSERT_LT(glm::distance(a.positions[a.triangles[k][corner]],
                                        b.positions[b.triangles[k][corner]]),
                          1e-3f * glm::distance(low, high))
                    << name << ", frame " << i << ", triangle " << k;
    }
}

TEST_F(RealScenes, GltfClipsAreTheirBakedFrames) {
    expect_baked(*load_gltf(path("fox/Fox.glb"), "Run"), folder_ / "fox", "fox_run");
    expect_baked(*load_gltf(path("fox/Fox.glb"), "Walk"), folder_ / "fox", "fox_walk");
    expect_baked(*load_gltf(path("robot_expressive/RobotExpressive.glb"), "Dance"),
                 folder_ / "robot_expressive", "robot_dance");
}

// Returns how many vertices may move.
size_t expect_still_outside_of_moving(const Animation& animation) {
    const Mesh rest = animation.at(animation.start()).mesh;
    std::vector<bool> may_move(rest.positions.size());
    for (const VertexRange& range : animation.moving_vertices())
        for (size_t i = 0; i < range.count; ++i) may_move.at(range.first + i) = true;
    for (const double u : {0.2, 0.5, 0.77, 1.0}) {
        const Mesh now =
            animation.at(animation.start() + u * (animation.end() - animation.start())).mesh;
        for (size_t i = 0; i < may_move.size(); ++i)
            if (!may_move[i] &&
                (now.positions[i] != rest.positions[i] || now.normals[i] != rest.normals[i])) {
                ADD_FAILURE() << "vertex " << i << " moves";
                break;
            }
    }
    return static_cast<size_t>(std::count(may_move.begin(), may_move.end(), true));
}

TEST_F(RealScenes, OnlyMovingVerticesMove) {
    const auto kitchen = load_aff(path("bart_kitchen/aff/kitchen.aff"));
    const size_t all = kitchen->at(0.0).mesh.positions.size();
    const size_t moving = expect_still_outside_of_moving(*kitchen);
    std::cout << moving << " of " << all << " vertices of the kitchen move\n";
    EXPECT_LT(moving, all);
    expect_still_outside_of_moving(*load_aff(path("bart_museum/aff/museum5.aff")));
    expect_still_outside_of_moving(*load_gltf(path("fox/Fox.glb")));
}

// Formats that rsh-render does not read are left to their error as well.
TEST_F(RealScenes, BrokenFilesLoadOrGiveAnErrorThatNamesThem) {
    size_t loaded = 0, refused = 0;
    for (const auto& entry : fs::recursive_directory_iterator(folder_ / "broken")) {
        const std::string file = entry.path().string();
        const std::string extension = inner_extension(file);
        if (!entry.is_regular_file() || extension == "mtl" || extension == "txt" ||
            extension == "md")
            continue;
        try {
            const bool is_gltf = extension == "gltf" || extension == "glb";
            const Model model = is_gltf ? load_gltf(file)->at(0.0) : load_mesh(file);
            ++loaded;
            for (const glm::uvec3 t : model.mesh.triangles)
                ASSERT_LT(std::max({t.x, t.y, t.z}), model.mesh.positions.size()) << file;
            EXPECT_FALSE(model.mesh.triangles.empty() && model.warnings.empty()) << file;
        } catch (const std::runtime_error& error) {
            ++refused;
            EXPECT_EQ(std::string(error.what()).compare(0, file.size(), file), 0)
                << error.what();
        }
    }
    std::cout << loaded << " broken files loaded, " << refused << " refused\n";
    EXPECT_GE(loaded, 60u);
    EXPECT_GE(refused, 6u);
}

}  // namespace
}  // namespace render
