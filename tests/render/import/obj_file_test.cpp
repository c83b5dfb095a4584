// obj_file_test.cpp - the traps of Wavefront OBJ.
#include <gtest/gtest.h>

#include <cmath>

#include "import/mesh_file.hpp"
#include "temporary_folder.hpp"

namespace render {
namespace {

Model load_text(const std::string& text) {
    const TemporaryFolder folder;
    return load_mesh(folder.write("a.obj", text));
}

TEST(ObjFile, AcceptsTabsCarriageReturnsAndLeadingBlanks) {
    const Model model =
        load_text("\r\n v\t0 0 0\r\n\tv  1\t0 0 \r\nv +0.5 1. .5e0\r\n  f\t1 2  3 \r\n");
    ASSERT_EQ(model.mesh.triangles.size(), 1u);
    EXPECT_EQ(model.mesh.positions[2], glm::vec3(0.5f, 1.0f, 0.5f));
}

TEST(ObjFile, NegativeIndicesCountFromTheLineTheyStandIn) {
    const Model model = load_text(
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 5 0 0\nv 6 0 0\nv 5 1 0\nf -3 -2 -1\n");
    ASSERT_EQ(model.mesh.triangles.size(), 2u);
    EXPECT_EQ(model.mesh.triangles[0], glm::uvec3(0, 1, 2));
    EXPECT_EQ(model.mesh.triangles[1], glm::uvec3(3, 4, 5));
}

TEST(ObjFile, JoinsContinuedLinesAndNeedsNoLastLineEnd) {
    const Model model = load_text("v 0 0 0\nv 1 0 \\\n0\nv 0 1 0\nf 1 \\\r\n 2 \\\n 3");
    ASSERT_EQ(model.mesh.triangles.size(), 1u);
    EXPECT_EQ(model.mesh.positions[1], glm::vec3(1, 0, 0));
}

TEST(ObjFile, SplitsQuadsAndConcavePolygons) {
    EXPECT_EQ(
        load_text("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n").mesh.triangles.size(), 2u);
    // An arrow head: the fan from its first corner would leave it.
    const Mesh mesh = load_text("v 0 2 0\nv -1 0 0\nv 0 1 0\nv 1 0 0\nf 2 3 4 1\n").mesh;
    ASSERT_EQ(mesh.triangles.size(), 2u);
    double area = 0.0;
    for (const glm::uvec3 t : mesh.triangles)
        area += 0.5 * glm::length(glm::cross(mesh.positions[t.y] - mesh.positions[t.x],
                                             mesh.positions[t.z] - mesh.positions[t.x]));
    EXPECT_NEAR(area, 1.0, 1e-6);
}

TEST(ObjFile, CornersWithDifferentAttributesAreDifferentVertices) {
    const Mesh mesh = load_text(
                          "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0.25 0.75\n"
                          "vn 0 0 1\nvn 1 0 0\n"
                          "f 1/1/1 2/2/1 3/3/1\nf 1/2/1 3/3/1 4/1/2\n")
                          .mesh;
    // Corner 3/3/1 is shared, vertex 1 is not.
    ASSERT_EQ(mesh.positions.size(), 5u);
    const glm::uvec3 a = mesh.triangles[0], b = mesh.triangles[1];
    EXPECT_EQ(a.z, b.y);
    EXPECT_NE(a.x, b.x);
    EXPECT_EQ(mesh.positions[a.x], mesh.positions[b.x]);
    EXPECT_EQ(mesh.texcoords[a.x], glm::vec2(0, 0));
    EXPECT_EQ(mesh.texcoords[b.x], glm::vec2(1, 0));
    EXPECT_EQ(mesh.texcoords[a.z], glm::vec2(0.25f, 0.75f));
    EXPECT_EQ(mesh.normals[b.z], glm::vec3(1, 0, 0));
}

TEST(ObjFile, CornersWithoutNormalAreFlat) {
    const Mesh mesh =
        load_text("v 0 0 0\nv 1 0 0\nv 1 1 0\nvn 0 0 1\nf 1//1 2//1 3//1\nf 3 2 1\n").mesh;
    ASSERT_EQ(mesh.normals.size(), 6u);
    EXPECT_EQ(mesh.normals[mesh.triangles[0].x], glm::vec3(0, 0, 1));
    EXPECT_EQ(mesh.normals[mesh.triangles[1].x], glm::vec3(0, 0, 0));
}

TEST(ObjFile, RepeatedCornersKeepTheTriangleCount) {
    const Mesh mesh =
        load_text("v 0 0 0\nv 1 0 0\nv 1 nan 0\nv 0 1 0\nf 1 1 2\nf 1 2 1 4\nf 3 3 1\n").mesh;
    EXPECT_EQ(mesh.triangles.size(), 4u);
    ASSERT_EQ(mesh.positions.size(), 4u);
    EXPECT_TRUE(std::isnan(mesh.positions[2].y));
    EXPECT_EQ(mesh.triangles[3], glm::uvec3(2, 2, 0));
}

TEST(ObjFile, MaterialsFollowTheirFaces) {
    const TemporaryFolder folder;
    folder.write("my materials.mtl",
                 "newmtl red paint\nKd 1 0 0\nnewmtl glass\nillum 7\nNi 1.5\n");
    const Model model = load_mesh(folder.write(
        "a.obj",
        "mtllib my materials.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\n"
        "usemtl glass\nf 1 2 3 4\nusemtl red paint\nf 1 2 3\nusemtl glass\nf 1 3 4\n"
        "usemtl gone\nf 1 2 4\n"));
    std::vector<std::string> names;
    for (const uint32_t id : model.mesh.material_ids) names.push_back(model.materials[id].name);
    EXPECT_EQ(names, (std::vector<std::string>{"default", "glass", "glass", "red paint",
                                               "glass", "gone"}));
    EXPECT_EQ(model.materials[model.mesh.material_ids[3]].diffuse, glm::vec3(1, 0, 0));
    ASSERT_EQ(model.warnings.size(), 1u);
    EXPECT_NE(model.warnings[0].find("'gone'"), std::string::npos);
}

// Vertices that two materials share become two where their texture coordinates differ.
TEST(ObjFile, TexturesAreScaledAndShiftedByTheirMaterials) {
    const TemporaryFolder folder;
    folder.write("a.mtl",
                 "newmtl scaled\nmap_Kd -s 4 2 1 -o 0.5 a.png\nnewmtl plain\nmap_Kd a.png\n");
    const Model model = load_mesh(folder.write(
        "a.obj",
        "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\n"
        "vt 0 1\nusemtl scaled\nf 1/1 2/2 3/3\nusemtl plain\nf 1/1 3/3 4/4\nf 1 2 3\n"));
    const Mesh& mesh = model.mesh;
    ASSERT_EQ(mesh.triangles.size(), 3u);
    const auto uv = [&](size_t triangle, int corner) {
        return mesh.texcoords[mesh.triangles[triangle][corner]];
    };
    EXPECT_EQ(uv(0, 0), glm::vec2(0.5f, 0));
    EXPECT_EQ(uv(0, 1), glm::vec2(4.5f, 0));
    EXPECT_EQ(uv(0, 2), glm::vec2(4.5f, 2));
    EXPECT_EQ(uv(1, 0), glm::vec2(0, 0));
    EXPECT_EQ(uv(1, 1), glm::vec2(1, 1));
    EXPECT_EQ(mesh.positions[mesh.triangles[0].x], mesh.positions[mesh.triangles[1].x]);
}

TEST(ObjFile, WhatIsNoNumberIsAnErrorWithItsLine) {
    const TemporaryFolder folder;
    EXPECT_NE(error_of_mesh(folder.write("a.obj", "v 0 0 0\nv 1 x 0\n")).find("line 2"),
              std::string::npos);
    EXPECT_NE(error_of_mesh(folder.write("b.obj", "v 0 0 0\nf 1 //1 1\n")).find("//1"),
              std::string::npos);
    EXPECT_NE(error_of_mesh(folder.write("c.obj", "# empty\n")).find("no vertex"),
              std::string::npos);
    EXPECT_NE(error_of_mesh(folder.write("d.obj", "v 1 2\n")).find("coordinate 2 is ''"),
              std::string::npos);
    EXPECT_NE(error_of_mesh(folder.write("e.obj", "v 1 2 \\\n3mm\n")).find("line 2"),
              std::string::npos);
    EXPECT_NE(error_of_mesh(folder.write("f.obj", "v 1 1 1\nf 1 1 1 1x\n")).find("'1x'"),
              std::string::npos);
}

TEST(ObjFile, CommentsMayStandBehindAnything) {
    const Mesh mesh =
        load_text("v 0 0 0 # 7\nv 1 0 0 #\nv 0 1 0\nf 1 2 3 # 1 2\nf 1 2 3 #1\n").mesh;
    ASSERT_EQ(mesh.triangles.size(), 2u);
    EXPECT_EQ(mesh.triangles[1], glm::uvec3(0, 1, 2));
}

TEST(ObjFile, FacesMayStandInFrontOfWhatTheyReferTo) {
    const Mesh mesh =
        load_text("fo 1//1 2//1 3//1\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\n").mesh;
    ASSERT_EQ(mesh.triangles.size(), 1u);
    EXPECT_EQ(mesh.normals.at(2), glm::vec3(0, 0, 1));
}

TEST(ObjFile, IndicesBeyondAnIntAreOutOfRange) {
    const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\n";
    for (const char* corner :
         {"4294967297", "2147483648", "-4294967295", "18446744073709551617",
          "99999999999999999999999999", "1e10", "4", "0"}) {
        const Model model = load_text(vertices + "f 1 2 " + corner + "\nf 1 2 3\n");
        EXPECT_EQ(model.mesh.triangles, (std::vector<glm::uvec3>{{0, 1, 2}})) << corner;
        ASSERT_EQ(model.warnings.size(), 1u) << corner;
        EXPECT_NE(model.warnings[0].find("1 faces with an index out of range"),
                  std::string::npos)
            << model.warnings[0];
    }
    const Model model = load_text(vertices + "f 1//4294967297 2//1 3//0000000001\n");
    EXPECT_EQ(model.mesh.normals, (std::vector<glm::vec3>{{0, 0, 0}, {0, 0, 1}, {0, 0, 1}}));
    ASSERT_EQ(model.warnings.size(), 1u);
    EXPECT_NE(model.warnings[0].find("1 corners refer to a normal"), std::string::npos);
}

TEST(ObjFile, CoordinatesThatAreNoFloatsAreWarnedOf) {
    for (const char* number : {"1e400", "-1e400", "1e39", "nan", "-inf", "1e99999999999"}) {
        const Model model = load_text("v 0 0 0\nv 1 0 0\nv 0 1 " + std::string(number) +
                                      "\nv 0 1 0\nf 1 2 3\nf 1 2 4\n");
        EXPECT_EQ(model.mesh.triangles.size(), 2u) << number;
        EXPECT_EQ(model.mesh.positions[3], glm::vec3(0, 1, 0)) << number;
        ASSERT_EQ(model.warnings.size(), 1u) << number;
        EXPECT_NE(model.warnings[0].find("1 vertices have a coordinate that is no number"),
                  std::string::npos)
            << model.warnings[0];
    }
}

TEST(ObjFile, KeywordsMayBeCapitals) {
    const TemporaryFolder folder;
    folder.write("a.mtl", "newmtl red\nKd 1 0 0\n");
    const Model model = load_mesh(folder.write(
        "a.obj",
        "MTLLIB a.mtl\nV 0 0 0\nV 1 0 0\nV 0 1 0\nVT 0 1\nUseMtl red\nF 1/1 2/1 3/1\n"));
    ASSERT_EQ(model.mesh.triangles.size(), 1u);
    EXPECT_EQ(model.mesh.texcoords.at(0), glm::vec2(0, 1));
    EXPECT_EQ(model.materials.at(0).diffuse, glm::vec3(1, 0, 0));
    EXPECT_TRUE(model.warnings.empty());
}

TEST(ObjFile, WhatIsIgnoredIsWarnedOfOnce) {
    const Model model = load_text(
        "\x1bv 5 5 5\ng a\ns off\nv 0 0 0\nv 1 0 0\nv 0 1 0\n"
        "surf 0 1 0 1 1\nsurf 0 1\nf 1 2 3\n");
    ASSERT_EQ(model.warnings.size(), 2u);
    EXPECT_NE(model.warnings[0].find("line 1: '\x1bv' is ignored"), std::string::npos);
    EXPECT_NE(model.warnings[1].find("line 7: 'surf' is ignored"), std::string::npos);
    std::string many;
    for (int i = 0; i < 1000; ++i) many += "word" + std::to_string(i) + "\n";
    EXPECT_LE(load_text(many + "v 0 0 0\n").warnings.size(), 12u);
}

TEST(ObjFile, AnErrorTellsTheWarningsBeforeIt) {
    const TemporaryFolder folder;
    for (const auto& [name, text] :
         {std::pair("a.obj", "xv 1 1 1\nv 1 1\n"),
          {"a.ply",
           "ply\nformat ascii 1.0\nelement x 1\nproperty int a\nelement vertex 1\n"
           "property float x\nproperty float y\nproperty float z\nend_header\n1 0 0 x\n"},
          {"a.off", "COFF 1 0 0\n0 0\n"}}) {
        const std::string message = error_of_mesh(folder.write(name, text));
        EXPECT_NE(message.find("\nwarning: "), std::string::npos) << message;
    }
}

}  // namespace
}  // namespace render
