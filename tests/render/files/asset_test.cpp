// asset_test.cpp - where a path leads: files, compressed files, members of archives.
#include "files/asset.hpp"

#include <gtest/gtest.h>

#include "files/text_scan.hpp"
#include "import/mesh_file.hpp"
#include "temporary_folder.hpp"

namespace render {
namespace {

constexpr const char* kTriangle =
    "mtllib t.mtl\nusemtl m\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
constexpr const char* kMaterial = "newmtl m\nKd 1 0 0\nmap_Kd maps/t.png\n";

std::string error_of(const std::string& path) {
    try {
        read_asset(path);
    } catch (const LoadError& error) {
        return error.what();
    }
    ADD_FAILURE() << path << " can be read, but must not";
    return {};
}

TEST(Asset, FindsCompressedFilesWithAndWithoutTheirEnding) {
    const TemporaryFolder folder;
    folder.write_xz("x.txt.xz", "packed");
    EXPECT_EQ(read_asset(folder.path("x.txt.xz")).bytes, "packed");
    EXPECT_EQ(read_asset(folder.path("x.txt")).bytes, "packed");
    folder.write("x.txt", "plain");
    EXPECT_EQ(read_asset(folder.path("x.txt")).bytes, "plain");
}

TEST(Asset, MembersBringTheirNeighbours) {
    const TemporaryFolder folder;
    const std::string archive =
        folder.write_tar_xz("a.tar.xz", {{"./sub/t.obj", kTriangle}, {"sub/t.mtl", kMaterial}});
    const Model model = load_mesh(archive + ":sub/t.obj");
    ASSERT_EQ(model.mesh.triangles.size(), 1u);
    EXPECT_TRUE(model.warnings.empty());
    EXPECT_EQ(model.materials[0].diffuse, glm::vec3(1, 0, 0));
    EXPECT_EQ(model.materials[0].texture, archive + ":sub/maps/t.png");
}

TEST(Asset, AFileThatIsAbsentIsFoundInTheArchiveOfItsName) {
    const TemporaryFolder folder;
    folder.write_tar_xz("t.tar.xz", {{"t.obj", kTriangle}, {"t.mtl", kMaterial}});
    const Model model = load_mesh(folder.path("t.obj"));
    EXPECT_EQ(model.mesh.triangles.size(), 1u);
    EXPECT_EQ(model.materials[0].diffuse, glm::vec3(1, 0, 0));
    EXPECT_NE(error_of(folder.path("t.ply")).find("does not exist"), std::string::npos);
}

TEST(Asset, WhatCannotBeReadIsAnError) {
    const TemporaryFolder folder;
    const std::string archive = folder.write_tar_xz("a.tar.xz", {{"b", "c"}});
    EXPECT_NE(error_of(archive).find("name the member"), std::string::npos);
    EXPECT_NE(error_of(archive + ":x").find("no member x"), std::string::npos);
    EXPECT_NE(error_of(folder.path("")).find("directory"), std::string::npos);
    EXPECT_NE(error_of(folder.path("none.obj")).find("does not exist"), std::string::npos);
    EXPECT_NE(error_of(folder.write("bad.xz",
                                    "\xfd"
                                    "7zXZ but no more"))
                  .find("unpacked"),
              std::string::npos);
}

TEST(Asset, EveryTruncationOfACompressedFileIsAnError) {
    const TemporaryFolder folder;
    const std::string whole =
        read_asset(folder.write_xz("x", std::string(1000, 'a') + "b")).bytes;
    for (size_t size = 0; size < whole.size(); ++size)
        EXPECT_NE(error_of(folder.write("cut.xz", whole.substr(0, size))).find("cut.xz"),
                  std::string::npos)
            << "first " << size << " of " << whole.size() << " bytes";
}

TEST(Asset, SiblingsStayInTheirArchive) {
    const TemporaryFolder folder;
    const std::string archive = folder.write_tar_xz("a.tar.xz", {{"b", "c"}});
    EXPECT_EQ(sibling_path(archive + ":x/y.obj", "../z.mtl"), archive + ":z.mtl");
    EXPECT_EQ(sibling_path("x/y.ply.xz", "z.png"), "x/z.png");
    EXPECT_EQ(sibling_path("y.obj", "z.mtl"), "z.mtl");
    EXPECT_EQ(inner_extension("a.tar.xz:x.OBJ"), "obj");
    EXPECT_EQ(inner_extension("x.ply.xz"), "ply");
    EXPECT_EQ(inner_extension("noextension"), "");
}

}  // namespace
}  // namespace render
