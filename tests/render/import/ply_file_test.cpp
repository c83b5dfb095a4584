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

}  // namespace
}  // namespace render
