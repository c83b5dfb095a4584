// ply_file_test.cpp - PLY in its three encodings.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "import/mesh_file.hpp"
#include "temporary_folder.hpp"

namespace render {
namespace {

std::string header(const std::string& format, const std::string& list) {
    return "ply\nformat " + format +
           " 1.0\ncomment x\nelement vertex 3\nproperty float x\n"
           "property float y\nproperty float z\nelement face 1\nproperty list " +
           list + " vertex_indices\nend_header\n";
}

std::string swapped(std::string words) {
    for (size_t i = 0; i + 3 < words.size(); i += 4)
        std::reverse(words.begin() + static_cast<std::ptrdiff_t>(i),
                     words.begin() + static_cast<std::ptrdiff_t>(i) + 4);
    return words;
}

TEST(PlyFile, ReadsAllEncodingsAlike) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const std::string vertices = bytes_of<float>({0, nan, 0, 1.5f, 0, 0, 0, 1, 0});
    const std::string face = bytes_of<uint32_t>({3, 0, 1, 2});
    const std::string files[] = {
        header("ascii", "uchar int") + "0 nan 0\n1.5 0 0\n0 1 0\n3 0 1 2",
        header("binary_little_endian", "int int") + vertices + face,
        header("binary_big_endian", "int int") + swapped(vertices + face),
        header("binary_little_endian", "uint uint") + vertices + face};
    const TemporaryFolder folder;
    for (const std::string& file : files) {
        const Mesh mesh = load_mesh(folder.write("a.ply", file)).mesh;
        ASSERT_EQ(mesh.triangles.size(), 1u) << file;
        EXPECT_EQ(mesh.triangles[0], glm::uvec3(0, 1, 2)) << file;
        EXPECT_TRUE(std::isnan(mesh.positions[0].y)) << file;
        EXPECT_EQ(mesh.positions[1], glm::vec3(1.5f, 0, 0)) << file;
    }
}

TEST(PlyFile, EveryTruncationIsAnError) {
    const std::string binary = header("binary_little_endian", "int int") +
                               bytes_of<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}) +
                               bytes_of<uint32_t>({3, 0, 1, 2});
    const std::string text = header("ascii", "uchar int") + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2";
    const TemporaryFolder folder;
    for (const std::string& whole : {binary, text})
        for (size_t size = 0; size < whole.size(); ++size)
            EXPECT_FALSE(error_of_mesh(folder.write("a.ply", whole.substr(0, size))).empty())
                << "first " << size << " of " << whole.size() << " bytes";
}

TEST(PlyFile, NormalsAndTextureCoordinatesBelongToVertices) {
    const TemporaryFolder folder;
    const Mesh mesh =
        load_mesh(
            folder.write("a.ply",
                         "ply\nformat ascii 1.0\nelement vertex 3\nproperty float nx\n"
                         "property float ny\nproperty float nz\nproperty float x\n"
                         "property float y\nproperty float z\nproperty float s\n"
                         "property float t\nelement face 1\n"
                         "property list uchar int vertex_index\nend_header\n"
                         "0 0 1 0 0 0 0 0\n0 1 0 1 0 0 .5 0\n1 0 0 0 1 0 0 .5\n3 0 1 2\n"))
            .mesh;
    ASSERT_EQ(mesh.normals.size(), 3u);
    ASSERT_EQ(mesh.texcoords.size(), 3u);
    EXPECT_EQ(mesh.normals[1], glm::vec3(0, 1, 0));
    EXPECT_EQ(mesh.texcoords[2], glm::vec2(0, 0.5f));
    EXPECT_EQ(mesh.positions[2], glm::vec3(0, 1, 0));
}

void expect_error(const std::string& text, const std::string& part) {
    const TemporaryFolder folder;
    const std::string file = folder.write("a.ply", text);
    const std::string message = error_of_mesh(file);
    EXPECT_EQ(message.compare(0, file.size(), file), 0) << message;
    EXPECT_NE(message.find(part), std::string::npos) << message;
}

std::string quad_header(const std::string& format, const std::string& element) {
    return "ply\nformat " + format +
           " 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n" +
           element + "end_header\n";
}

std::vector<glm::uvec3> triangles_of(const std::string& text) {
    const TemporaryFolder folder;
    return load_mesh(folder.write("a.ply", text)).mesh.triangles;
}

const std::string kQuad = "-1 -1 0 1 -1 0 -1 1 0 1 1 0\n";
const std::string kStrips = "element tristrips 1\nproperty list int int vertex_indices\n";

TEST(PlyFile, TriangleStripsEndAtMinusOne) {
    using Triangles = std::vector<glm::uvec3>;
    const std::string ascii = quad_header("ascii", kStrips) + kQuad;
    EXPECT_EQ(triangles_of(ascii + "8 0 1 3 -1 1 2 3 -1"), (Triangles{{0, 1, 3}, {1, 2, 3}}));
    EXPECT_EQ(triangles_of(ascii + "4 0 1 2 3"), (Triangles{{0, 1, 2}, {2, 1, 3}}));
    EXPECT_EQ(triangles_of(ascii + "7 -1 0 1 -1 1 3 2"), (Triangles{{1, 3, 2}}))
        << "strips too short for a triangle";
    EXPECT_EQ(triangles_of(ascii + "6 0 1 2 2 1 3"), (Triangles{{0, 1, 2}, {1, 2, 3}}))
        << "triangles without area only turn the strip";
    const std::string vertices = bytes_of<float>({-1, -1, 0, 1, -1, 0, -1, 1, 0, 1, 1, 0});
    const std::string strip = bytes_of<int32_t>({5, 0, 1, 2, 3, -1});
    for (const bool swaps : {false, true})
        EXPECT_EQ(triangles_of(quad_header(swaps ? "binary_big_endian" : "binary_little_endian",
                                           kStrips) +
                               (swaps ? swapped(vertices + strip) : vertices + strip)),
                  (Triangles{{0, 1, 2}, {2, 1, 3}}));
    const std::string face = "element face 1\nproperty list uchar int vertex_indices\n";
    EXPECT_EQ(triangles_of(quad_header("ascii", face + kStrips) + kQuad + "3 3 2 1 3 0 1 2"),
              (Triangles{{3, 2, 1}, {0, 1, 2}}))
        << "faces and strips";
}

TEST(PlyFile, ElementsMayStandInAnyOrder) {
    const std::string text =
        "ply\nformat ascii 1.0\nelement face 1\nproperty list uchar int vertex_index\n"
        "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
        "end_header\n3 0 1 2\n0 0 0\n1 0 0\n0 1 0\n";
    EXPECT_EQ(triangles_of(text), (std::vector<glm::uvec3>{{0, 1, 2}}));
}

// The first byte of the values may look like the second half of a line end.
TEST(PlyFile, HeadersMayEndTheirLinesWithCr) {
    std::string text = quad_header("binary_little_endian",
                                   "element face 1\nproperty list uchar int vertex_indices\n");
    std::replace(text.begin(), text.end(), '\n', '\r');
    const std::string face = std::string(1, '\4') + bytes_of<uint32_t>({0, 1, 2, 3});
    for (const uint32_t first : {0u, 0x3f80000au, 0x3f800d0au}) {
        const TemporaryFolder folder;
        const std::string vertices = bytes_of<uint32_t>({first}) + std::string(44, '\0');
        Mesh mesh;
        ASSERT_NO_THROW(mesh = load_mesh(folder.write("a.ply", text + vertices + face)).mesh)
            << std::hex << first;
        EXPECT_EQ(mesh.triangles.size(), 2u);
        EXPECT_EQ(bytes_of<float>({mesh.positions[0].x}), bytes_of<uint32_t>({first}));
    }
}

TEST(PlyFile, CountsAreCheckedAgainstTheBytesThatAreThere) {
    const std::string vertices = bytes_of<float>({0, 0, 0, 1, 0, 0, 0, 1, 0});
    const std::string lists[][3] = {
        {"int int", bytes_of<int32_t>({-1, 0, 1, 2}),
         "face 0: list vertex_indices promises -1"},
        {"int int", bytes_of<int32_t>({2000000000, 0, 1, 2}), "promises 2000000000 values"},
        {"uint char", bytes_of<uint32_t>({0xffffffffu, 0}), "promises 4294967295 values"},
        {"int int", bytes_of<int32_t>({4, 0, 1, 2}), "whole number up to 3"},
        {"float int", bytes_of<float>({2.5f, 0, 0, 0}), "promises 2.5"},
        {"float int", bytes_of<uint32_t>({0x7fc00000u, 0, 1, 2}), "promises nan"},
        {"float int", bytes_of<float>({1e30f, 0, 0, 0}), "e+30"}};
    for (const auto& [types, values, part] : lists)
        expect_error(header("binary_little_endian", types) + vertices + values, part);
    expect_error(header("ascii", "uchar int") + "0 0 0 1 0 0 0 1 0 -3 0 1 2", "promises -3");
    expect_error(header("ascii", "uchar int") + "0 0 0 1 0 0 0 1 0 9 0 1 2",
                 "promises 9 values");
    for (const char* count : {"-4", "1e9", "99999999999999999999", "", "x"})
        expect_error(std::string("ply\nformat ascii 1.0\nelement vertex ") + count +
                         "\nproperty float x\nend_header\n",
                     "has the count '" + std::string(count) + "'");
}

// Nothing to read for each of them: any number of them takes no time.
TEST(PlyFile, ElementsWithoutPropertiesTakeNoTime) {
    const std::string text = quad_header("ascii",
                                         "element nothing 9000000000000000000\nelement face 1\n"
                                         "property list uchar int vertex_indices\n");
    EXPECT_EQ(triangles_of(text + kQuad + "3 0 1 2").size(), 1u);
    expect_error(quad_header("ascii", "element face 9000000000000000000\n") + kQuad,
                 "element face has no list property vertex_indices");
    expect_error("ply\nformat ascii 1.0\nelement vertex 9000000000000000000\nend_header\n",
                 "no property x");
}

TEST(PlyFile, IndicesMustBeWholeAndInRange) {
    const std::string face = "element face 4\nproperty list uchar float vertex_indices\n";
    const TemporaryFolder folder;
    const Model model =
        load_mesh(folder.write("a.ply", quad_header("ascii", face) + kQuad +
                                            "3 0 1 2.5\n3 0 1 -1\n3 0 1 1e99\n3 0 1 3\n"));
    EXPECT_EQ(model.mesh.triangles, (std::vector<glm::uvec3>{{0, 1, 3}}));
    ASSERT_EQ(model.warnings.size(), 1u);
    EXPECT_NE(model.warnings[0].find("3 faces with an index out of range"), std::string::npos);
}

TEST(PlyFile, MessagesNameTheRow) {
    const std::string face = "element face 1\nproperty list uchar int vertex_indices\n";
    expect_error(quad_header("ascii", face) + "0 0 0 0 0 0 0 x 0 0 0 0 3 0 1 2",
                 "vertex 2: needs a number, but has 'x'");
    expect_error("solid\n", "starts with 'solid'");
    expect_error(quad_header("ascii", face + "element vertex 1\nproperty float x\n"
                                             "property float y\nproperty float z\n") +
                     kQuad + "3 0 1 2 0 0 0",
                 "two elements vertex");
}

}  // namespace
}  // namespace render
