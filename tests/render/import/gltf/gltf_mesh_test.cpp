// gltf_mesh_test.cpp - triangles and vertices of still glTF files, and how files hold their bytes.
#include <gtest/gtest.h>

#include <cmath>

#include "import/gltf/gltf_animation.hpp"
#include "import/gltf/gltf_builder.hpp"
#include "temporary_folder.hpp"

namespace render {
namespace {

using Triangles = std::vector<glm::uvec3>;
using Points = std::vector<glm::vec3>;

Model load_text(const std::string& text) {
    const TemporaryFolder folder;
    const auto animation = load_gltf(folder.write("a.gltf", text));
    EXPECT_FALSE(animation->moves());
    return animation->at(0.0);
}

Model load(const GltfBuilder& file) {
    return load_text(file.text());
}

// Five vertices in a zigzag.
const std::vector<float> kZigzag = {0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0, 2, 0, 0};

nlohmann::json zigzag(GltfBuilder& file) {
    return {{"attributes", {{"POSITION", file.floats("VEC3", kZigzag)}}}};
}

void expect_warning(const Model& model, const std::string& part) {
    for (const std::string& warning : model.warnings)
        if (warning.find(part) != std::string::npos) return;
    ADD_FAILURE() << "no warning says \"" << part << "\"";
}

TEST(GltfMesh, TrianglesAreListsStripsAndFansWithIndicesOrNot) {
    struct Case {
        int mode;
        std::vector<uint8_t> indices;
        Triangles expected;
    };
    const Case cases[] = {
        {4, {0, 2, 1, 2, 3, 1}, {{0, 2, 1}, {2, 3, 1}}},
        {5, {}, {{0, 1, 2}, {1, 3, 2}, {2, 3, 4}}},
        {5, {4, 3, 2}, {{4, 3, 2}}},
        {6, {}, {{1, 2, 0}, {2, 3, 0}, {3, 4, 0}}},
        {6, {2, 0, 1, 3}, {{0, 1, 2}, {1, 3, 2}}},
    };
    for (const Case& c : cases) {
        GltfBuilder file;
        nlohmann::json primitive = zigzag(file);
        primitive["mode"] = c.mode;
        if (!c.indices.empty()) primitive["indices"] = file.bytes("SCALAR", c.indices);
        file.add_mesh(primitive);
        EXPECT_EQ(load(file).mesh.triangles, c.expected)
            << "mode " << c.mode << ", " << c.indices.size() << " indices";
    }
}

TEST(GltfMesh, PrimitivesAndNodesKeepTheirMaterialsAndPlaces) {
    GltfBuilder file;
    file.json["materials"] = {{{"name", "red"}}, {{"name", "blue"}}};
    nlohmann::json blue = zigzag(file), plain = zigzag(file);
    blue["mode"] = plain["mode"] = 5;
    blue["material"] = 1;
    file.json["meshes"] = {{{"primitives", {blue, plain}}}};
    file.json["nodes"] = {{{"mesh", 0}, {"translation", {0, 0, 5}}},
                          {{"mesh", 0}, {"translation", {0, 7, 0}}}};
    const Model model = load(file);
    ASSERT_EQ(model.materials.size(), 3u);
    EXPECT_EQ(model.materials[2].name, "default");
    EXPECT_EQ(model.mesh.material_ids,
              (std::vector<uint32_t>{1, 1, 1, 2, 2, 2, 1, 1, 1, 2, 2, 2}));
    ASSERT_EQ(model.mesh.positions.size(), 20u);
    EXPECT_EQ(model.mesh.positions[7], glm::vec3(1, 0, 5));
    EXPECT_EQ(model.mesh.positions[19], glm::vec3(2, 7, 0));
    EXPECT_EQ(model.mesh.triangles[11], glm::uvec3(17, 18, 19));
}

// A quarter turn about z, then twice as wide, then one to the right: x = 1 - 2 y, y = x.
TEST(GltfMesh, NodesTurnScaleAndMoveWithThoseAboveThem) {
    GltfBuilder file;
    nlohmann::json primitive = zigzag(file);
    primitive["mode"] = 5;
    file.add_mesh(primitive);
    const double half = 0.70710678118654752;
    file.json["nodes"][0]["rotation"] = {0, 0, half, half};
    file.json["nodes"].push_back(
        {{"children", {0}}, {"matrix", {2, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 1}}});
    const Points positions = load(file).mesh.positions;
    const Points expected = {{1, 0, 0}, {-1, 0, 0}, {1, 1, 0}, {-1, 1, 0}, {1, 2, 0}};
    for (size_t i = 0; i < expected.size(); ++i)
        EXPECT_LT(glm::distance(positions[i], expected[i]), 1e-6f) << "vertex " << i;
}

TEST(GltfMesh, AMirrorKeepsTheOutsideOutside) {
    GltfBuilder file;
    file.add_mesh({{"attributes",
                    {{"POSITION", file.floats("VEC3", {0, 0, 0, 1, 0, 0, 0, 1, 0})},
                     {"NORMAL", file.floats("VEC3", {0, 0, 1, 0, 0, 1, 0, 0, 1})}}}});
    file.json["nodes"][0]["scale"] = {-1, 1, 1};
    const Mesh mesh = load(file).mesh;
    EXPECT_EQ(mesh.triangles, (Triangles{{0, 2, 1}}));
    EXPECT_EQ(mesh.normals, (Points(3, {0, 0, 1})));
    EXPECT_EQ(mesh.positions[1], glm::vec3(-1, 0, 0));
}

TEST(GltfMesh, PrimitivesWithoutNormalsAreFlatBesideOthers) {
    GltfBuilder file;
    file.add_triangle();
    file.add_mesh({{"attributes",
                    {{"POSITION", file.floats("VEC3", {0, 0, 0, 1, 0, 0, 0, 1, 0})},
                     {"NORMAL", file.floats("VEC3", {0, 0, 2, 0, 3, 0, 1, 0, 0})}}}});
    const Mesh mesh = load(file).mesh;
    EXPECT_EQ(mesh.normals,
              (Points{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 1}, {0, 1, 0}, {1, 0, 0}}));
    EXPECT_TRUE(mesh.texcoords.empty());
}

// The renderer's v goes up, glTF's down; bytes stand for 255ths.
TEST(GltfMesh, TextureCoordinatesAreThoseOfTheMaterialsTexture) {
    GltfBuilder file;
    file.json["images"] = {{{"uri", "gone.png"}}};
    file.json["textures"] = {{{"source", 0}}};
    file.json["materials"] = {
        {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}, {"texCoord", 1}}}}}}};
    const int texcoords = file.bytes("VEC2", {0, 0, 255, 51, 102, 255});
    file.json["accessors"][static_cast<size_t>(texcoords)]["normalized"] = true;
    const int others = file.floats("VEC2", {9, 9, 9, 9, 9, 9});
    file.add_mesh({{"attributes",
                    {{"POSITION", file.floats("VEC3", {0, 0, 0, 1, 0, 0, 0, 1, 0})},
                     {"TEXCOORD_0", others},
                     {"TEXCOORD_1", texcoords}}},
                   {"material", 0}});
    const std::vector<glm::vec2> found = load(file).mesh.texcoords;
    const std::vector<glm::vec2> expected = {{0, 1}, {1, 0.8f}, {0.4f, 0}};
    ASSERT_EQ(found.size(), expected.size());
    for (size_t i = 0; i < expected.size(); ++i)
        EXPECT_LT(glm::distance(found[i], expected[i]), 1e-6f) << "vertex " << i;
}

TEST(GltfMesh, SparseAccessorsReplaceElements) {
    GltfBuilder file;
    const int zeros = file.sparse("VEC3", 4, {1, 3}, {1, 2, 3, 4, 5, 6});
    const int changed = file.floats("VEC3", {9, 9, 9, 8, 8, 8, 7, 7, 7});
    file.json["accessors"][static_cast<size_t>(changed)]["sparse"] =
        file.json["accessors"][static_cast<size_t>(zeros)]["sparse"];
    file.json["accessors"][static_cast<size_t>(changed)]["sparse"]["count"] = 1;
    file.add_mesh({{"attributes", {{"POSITION", zeros}}}, {"mode", 5}});
    file.add_mesh({{"attributes", {{"POSITION", changed}}}});
    EXPECT_EQ(
        load(file).mesh.positions,
        (Points{{0, 0, 0}, {1, 2, 3}, {0, 0, 0}, {4, 5, 6}, {9, 9, 9}, {1, 2, 3}, {7, 7, 7}}));
}

TEST(GltfMesh, ViewsMayBeInterleaved) {
    GltfBuilder file;
    const int whole =
        file.floats("VEC3", {0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 1, 0, 0, 1, 0, 1, 0, 0});
    auto& accessors = file.json["accessors"];
    accessors[static_cast<size_t>(whole)]["count"] = 3;
    file.json["bufferViews"][0]["byteStride"] = 24;
    accessors.push_back(accessors[0]);
    accessors[1]["byteOffset"] = 12;
    file.add_mesh({{"attributes", {{"POSITION", 0}, {"NORMAL", 1}}}});
    const Mesh mesh = load(file).mesh;
    EXPECT_EQ(mesh.positions, (Points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    EXPECT_EQ(mesh.normals, (Points{{0, 0, 1}, {0, 1, 0}, {1, 0, 0}}));
}

TEST(GltfMesh, OnlyTheFilesSceneIsShown) {
    GltfBuilder file;
    for (int i = 0; i < 3; ++i) file.add_triangle();
    for (size_t i = 0; i < 3; ++i) file.json["nodes"][i]["translation"] = {i, 0, 0};
    file.json["nodes"][1]["children"] = {2};
    EXPECT_EQ(load(file).mesh.triangles.size(), 3u) << "without scenes, all nodes";
    file.json["scenes"] = {{{"nodes", {0}}}, {{"nodes", {1}}}};
    EXPECT_EQ(load(file).mesh.positions[0].x, 0.0f) << "without a choice, the first";
    file.json["scene"] = 1;
    const Mesh mesh = load(file).mesh;
    ASSERT_EQ(mesh.triangles.size(), 2u);
    EXPECT_EQ(mesh.positions[0].x, 1.0f);
    EXPECT_EQ(mesh.positions[3].x, 3.0f);
}

TEST(GltfMesh, BytesLieInTheTextBesideItInAChunkOrInAnArchive) {
    GltfBuilder file;
    file.add_triangle();
    const Points expected = load(file).mesh.positions;
    const TemporaryFolder folder;
    EXPECT_EQ(load_gltf(folder.write("a.glb", file.binary()))->at(0).mesh.positions, expected);

    const std::string bytes(reinterpret_cast<const char*>(expected.data()), 36);
    nlohmann::json beside = file.json;
    beside["buffers"] = {{{"byteLength", 36}, {"uri", "some%20bytes.bin"}}};
    folder.write("some bytes.bin", bytes);
    const std::string path = folder.write("b.gltf", beside.dump());
    EXPECT_EQ(load_gltf(path)->at(0).mesh.positions, expected);
    const std::string archive = folder.write_tar_xz(
        "c.tar.xz", {{"m/b.gltf", beside.dump()}, {"m/some bytes.bin", bytes}});
    EXPECT_EQ(load_gltf(archive + ":m/b.gltf")->at(0).mesh.positions, expected);
}

TEST(GltfMesh, WhatIsNotThereIsAWarning) {
    GltfBuilder file;
    file.json["nodes"].push_back(nlohmann::json::object());
    expect_warning(load(file), "holds no triangle");
    file.add_mesh(
        {{"attributes", {{"POSITION", file.floats("VEC3", {0, 0, 0, NAN, 0, 0, 0, 1, 0})}}}});
    expect_warning(load(file), "1 vertices have a coordinate that is no number");
}

TEST(GltfMesh, WhatIsLeftOutIsAWarning) {
    GltfBuilder file;
    file.json["extensionsUsed"] = {"KHR_lights_punctual", "EXT_none"};
    file.add_triangle();
    file.json["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"] = 0;
    nlohmann::json lines = zigzag(file);
    lines["mode"] = 3;
    file.add_mesh(lines);
    file.add_mesh({{"attributes", {{"NORMAL", 0}}}});
    const Model model = load(file);
    EXPECT_EQ(model.mesh.triangles.size(), 1u);
    expect_warning(model, "EXT_none");
    expect_warning(model, "1 primitives have a COLOR_0");
    expect_warning(model, "1 primitives of points or lines");
    expect_warning(model, "1 primitives without POSITION");
    EXPECT_EQ(model.warnings.size(), 4u);
}

}  // namespace
}  // namespace render
