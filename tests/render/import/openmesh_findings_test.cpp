// openmesh_findings_test.cpp - what the readers of OpenMesh 9 get wrong, each on the smallest file
// that shows it: the reason why they are not used.
#include <gtest/gtest.h>

#include <cmath>

#include "import/mesh_file.hpp"
#include "temporary_folder.hpp"

namespace render {
namespace {

constexpr const char* kSquare = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

std::string ply_square(const std::string& face_properties, const std::string& faces) {
    return std::string(
               "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\n"
               "property float y\nproperty float z\nelement face 2\n") +
           face_properties + "end_header\n" + kSquare + faces;
}

TEST(OpenMeshFindings, PlyKeepsAllFacesBehindAnotherFaceProperty) {
    const TemporaryFolder folder;
    const Model model = load_mesh(folder.write(
        "a.ply", ply_square("property uchar flags\nproperty list uchar int vertex_indices\n",
                            "7 3 0 1 2\n7 3 0 2 3\n")));
    ASSERT_EQ(model.mesh.triangles.size(), 2u);
    EXPECT_EQ(model.mesh.triangles[1], glm::uvec3(0, 2, 3));
}

TEST(OpenMeshFindings, PlyKeepsAllFacesBeforeACustomList) {
    const TemporaryFolder folder;
    const Model model =
        load_mesh(folder.write("a.ply", ply_square("property list uchar int vertex_indices\n"
                                                   "property list uchar float quality\n",
                                                   "3 0 1 2 2 0.5 0.5\n3 0 2 3 0\n")));
    ASSERT_EQ(model.mesh.triangles.size(), 2u);
    EXPECT_EQ(model.mesh.triangles[1], glm::uvec3(0, 2, 3));
}

TEST(OpenMeshFindings, PlyReadsTextureCoordinatesPerFace) {
    const TemporaryFolder folder;
    const Model model = load_mesh(folder.write(
        "a.ply",
        ply_square(
            "property list uchar int vertex_indices\nproperty list uchar float texcoord\n",
            "3 0 1 2 6 0 0 1 0 1 1\n3 0 2 3 6 .5 .5 1 1 0 1\n")));
    const Mesh& mesh = model.mesh;
    ASSERT_EQ(mesh.triangles.size(), 2u);
    ASSERT_EQ(mesh.texcoords.size(), mesh.positions.size());
    EXPECT_EQ(mesh.texcoords[mesh.triangles[0].x], glm::vec2(0.0f, 0.0f));
    EXPECT_EQ(mesh.texcoords[mesh.triangles[1].x], glm::vec2(0.5f, 0.5f));
    EXPECT_EQ(mesh.positions[mesh.triangles[1].x], mesh.positions[mesh.triangles[0].x]);
}

// Three quads around one edge: the second triangle of the third quad is non-manifold.
TEST(OpenMeshFindings, NonManifoldQuadsYieldEachTriangleOnce) {
    const TemporaryFolder folder;
    const Model model = load_mesh(folder.write(
        "a.obj",
        "v 0 0 0\nv 0 0 1\nv 1 0 0\nv 1 0 1\nv 0 1 0\nv 0 1 1\nv -1 0 0\nv -1 0 1\n"
        "f 1 2 4 3\nf 1 2 6 5\nf 1 2 8 7\n"));
    EXPECT_EQ(model.mesh.triangles.size(), 6u);
    EXPECT_EQ(model.mesh.positions.size(), 8u);
}

// Two triangles that share a vertex only: a half-edge mesh doubles it.
TEST(OpenMeshFindings, NonManifoldVerticesKeepTheirNumbers) {
    const TemporaryFolder folder;
    const Model model = load_mesh(folder.write(
        "a.off",
        "OFF\n5 3 0\n0 0 0\n1 0 0\n1 1 0\n-1 0 0\n-1 -1 0\n3 0 1 2\n3 0 3 4\n3 0 1 2\n"));
    EXPECT_EQ(model.mesh.positions.size(), 5u);
    ASSERT_EQ(model.mesh.triangles.size(), 3u);
    EXPECT_EQ(model.mesh.triangles[1], glm::uvec3(0, 3, 4));
}

TEST(OpenMeshFindings, HeadersThatPromiseTooMuchAreRefused) {
    const TemporaryFolder folder;
    const std::string off = folder.write("a.off", "OFF\n3 4000000000 0\n0 0 0\n1 0 0\n0 1 0\n");
    EXPECT_NE(error_of_mesh(off).find("4000000000 faces"), std::string::npos);
    const std::string ply =
        folder.write("a.ply",
                     "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\n"
                     "property float x\nproperty float y\nproperty float z\nend_header\n");
    EXPECT_NE(error_of_mesh(ply).find("4000000000 of element vertex"), std::string::npos);
    const std::string stl = folder.write(
        "a.stl", std::string(80, ' ') + bytes_of<uint32_t>({2}) + std::string(50, 'a'));
    EXPECT_NE(error_of_mesh(stl).find("promises 2 triangles"), std::string::npos);
}

TEST(OpenMeshFindings, FilesThatEndEarlyNamePromisedAndActualCounts) {
    const TemporaryFolder folder;
    const std::string off =
        folder.write("a.off", "OFF\n3 2 0\n0.125 0.125 0.125\n1 0 0\n0 1 0\n3 0 1 2\n");
    const std::string message = error_of_mesh(off);
    EXPECT_NE(message.find("ends after 1 of 2 faces"), std::string::npos) << message;
    EXPECT_NE(message.find(off), std::string::npos) << message;
}

TEST(OpenMeshFindings, OffMayHoldCommentsBlanksAndColoursAnywhere) {
    const TemporaryFolder folder;
    for (const char* text :
         {"# before\nOFF # keyword\n# counts\n3 1 0\n\n0 0 0 # first\n1 0 0\n#\n0 1 0\n3 0 1 "
          "2\n",
          "OFF 3 1 0\n0 0\n0 1 0 0\n\t0   1 0\n\n3\n0 1\n2\n",
          "3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 0.5 0.5 0.5\n",
          "COFF\n3 1 0\n0 0 0 255 0 0\n1 0 0\n0 1 0 1 2 3 4\n3 0 1 2\n",
          "NOFF\r\n3 1 0\r\n0 0 0 0 0 1\r\n1 0 0 0 0 1\r\n0 1 0 0 0 1\r\n3 0 1 2\r\n"}) {
        const Model model = load_mesh(folder.write("a.off", text));
        ASSERT_EQ(model.mesh.triangles.size(), 1u) << text;
        EXPECT_EQ(model.mesh.positions[2], glm::vec3(0.0f, 1.0f, 0.0f)) << text;
    }
}

TEST(OpenMeshFindings, Utf16IsRefusedByName) {
    const TemporaryFolder folder;
    const std::string with_mark = folder.write("a.obj", std::string("\xfe\xff\0v\0 ", 6));
    EXPECT_NE(error_of_mesh(with_mark).find("UTF-16"), std::string::npos);
    const std::string without = folder.write("b.off", std::string("O\0F\0F\0", 6));
    EXPECT_NE(error_of_mesh(without).find("UTF-16"), std::string::npos);
}

TEST(OpenMeshFindings, NonFiniteCoordinatesStayAndShiftNoIndex) {
    const TemporaryFolder folder;
    const std::string vertices[] = {"nan 0 0", "0 inf 1e39", "1e-40 0 0", "7 8 9"};
    const std::string obj =
        folder.write("a.obj", "v " + vertices[0] + "\nv " + vertices[1] + "\nv " + vertices[2] +
                                  "\nv " + vertices[3] + "\nf 1 2 3\nf 2 3 4\n");
    std::string rows;
    for (const std::string& vertex : vertices) rows += vertex + "\n";
    const std::string off = folder.write("a.off", "OFF\n4 2 0\n" + rows + "3 0 1 2\n3 1 2 3\n");
    const std::string ply = folder.write(
        "a.ply",
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
        "property float z\nelement face 2\nproperty list uchar int vertex_index\n"
        "end_header\n" +
            rows + "3 0 1 2\n3 1 2 3\n");
    for (const std::string& path : {obj, off, ply}) {
        const Mesh mesh = load_mesh(path).mesh;
        ASSERT_EQ(mesh.positions.size(), 4u) << path;
        EXPECT_TRUE(std::isnan(mesh.positions[0].x)) << path;
        EXPECT_TRUE(std::isinf(mesh.positions[1].y) && std::isinf(mesh.positions[1].z)) << path;
        EXPECT_FLOAT_EQ(mesh.positions[2].x, 1e-40f) << path;
        EXPECT_EQ(mesh.positions[3], glm::vec3(7, 8, 9)) << path;
        EXPECT_EQ(mesh.triangles.at(1), glm::uvec3(1, 2, 3)) << path;
    }
}

TEST(OpenMeshFindings, FacesOutOfRangeAreLeftOutWithAWarning) {
    const TemporaryFolder folder;
    const std::string obj = folder.write(
        "a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\nf 1 2 3\nf 0 1 2\nf 1 2 -9\n");
    const std::string off = folder.write(
        "a.off",
        "OFF\n3 4 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n3 0 1 2\n3 0 1 -1\n3 99999999999 0 1\n");
    for (const std::string& path : {obj, off}) {
        const Model model = load_mesh(path);
        ASSERT_EQ(model.mesh.triangles.size(), 1u) << path;
        EXPECT_EQ(model.mesh.triangles[0], glm::uvec3(0, 1, 2)) << path;
        ASSERT_FALSE(model.warnings.empty()) << path;
        EXPECT_NE(model.warnings[0].find("3 faces with an index out of range"),
                  std::string::npos)
            << model.warnings[0];
    }
}

}  // namespace
}  // namespace render
