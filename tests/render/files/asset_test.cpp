// asset_test.cpp - where a path leads: files, compressed files, members of archives.
#include "files/asset.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

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

std::string read_bytes(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
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
    EXPECT_EQ(find_asset(folder.path("t.obj")), folder.path("t.tar.xz") + ":t.obj");
    EXPECT_EQ(find_asset(folder.path("t.ply")), std::nullopt);
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

// Streams of xz with 16 MiB each, of some KiB.
std::string repeated_zeros(const TemporaryFolder& folder, int times) {
    const std::string stream =
        read_bytes(folder.write_xz("zeros.xz", std::string(size_t{16} << 20, '\0')));
    std::string streams;
    for (int i = 0; i < times; ++i) streams += stream;
    return streams;
}

// The 512 bytes before a member of a tar file.
std::string tar_head(const std::string& name, size_t size) {
    std::string head(512, '\0');
    const auto put = [&](size_t at, const std::string& text) {
        head.replace(at, text.size(), text);
    };
    const auto octal = [](size_t number, size_t digits) {
        std::string text;
        for (; text.size() < digits; number /= 8)
            text.insert(text.begin(), static_cast<char>('0' + number % 8));
        return text;
    };
    put(0, name);
    put(100, octal(0644, 7));
    put(124, octal(size, 11));
    put(136, octal(0, 11));
    put(148, "        0");
    put(257, std::string("ustar\00000", 8));
    size_t sum = 0;
    for (const char c : head) sum += static_cast<unsigned char>(c);
    put(148, octal(sum, 6) + std::string("\0 ", 2));
    return head;
}

TEST(Asset, RefusesWhatUnpacksAThousandfold) {
    const TemporaryFolder folder;
    const std::string bomb = folder.write("bomb.obj.xz", repeated_zeros(folder, 20));
    EXPECT_NE(error_of(bomb).find("bomb.obj.xz: unpacks to more than"), std::string::npos);
    EXPECT_EQ(read_asset(folder.path("zeros")).bytes.size(), size_t{16} << 20);
}

// The member behind it could only be reached by unpacking it.
TEST(Asset, RefusesAnArchiveWithAMemberThatUnpacksAThousandfold) {
    const TemporaryFolder folder;
    std::string streams =
        read_bytes(folder.write_xz("head.xz", tar_head("a", size_t{320} << 20)));
    streams += repeated_zeros(folder, 20);
    const std::string bomb = folder.write("bomb.tar.xz", streams);
    for (const char* member : {":a", ":b"})
        EXPECT_NE(error_of(bomb + member).find("unpacks to more than"), std::string::npos);
}

TEST(Asset, RefusesFilesWithoutEnd) {
    const TemporaryFolder folder;
    const std::string path = folder.write("sparse.obj", "v 0 0 0\n");
    std::filesystem::resize_file(path, uintmax_t{5} << 30);
    EXPECT_NE(error_of(path).find("sparse.obj: has 5368709120 bytes"), std::string::npos);
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
