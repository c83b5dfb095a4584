// references_test.cpp - names of files as exporters write them.
#include "files/references.hpp"

#include <gtest/gtest.h>

#include "files/asset.hpp"
#include "import/mesh_file.hpp"
#include "temporary_folder.hpp"

namespace render {
namespace {

using Names = std::vector<std::string>;

class References : public testing::Test {
protected:
    // What the line names, without the folder.
    Names names(const std::string& line, const std::string& from = "a.obj") const {
        Names names;
        for (const std::string& path : find_references(folder_.path(from), line, ".mtl")) {
            const std::string start = folder_.path("");
            names.push_back(
                path.compare(0, start.size(), start) == 0 ? path.substr(start.size()) : path);
        }
        return names;
    }

    TemporaryFolder folder_;
};

TEST_F(References, SeveralNamesMayStandInALine) {
    for (const char* file : {"a.mtl", "b.mtl", "my mats.mtl", "no ending", "a b.mtl"})
        folder_.write(file, "x");
    EXPECT_EQ(names("a.mtl"), (Names{"a.mtl"}));
    EXPECT_EQ(names(" a.mtl\tb.mtl "), (Names{"a.mtl", "b.mtl"}));
    EXPECT_EQ(names("my mats.mtl"), (Names{"my mats.mtl"}));
    EXPECT_EQ(names("a.mtl my mats.mtl b.mtl"), (Names{"a.mtl", "my mats.mtl", "b.mtl"}));
    EXPECT_EQ(names("no ending a.mtl"), (Names{"no ending", "a.mtl"}));
    EXPECT_EQ(names("a b.mtl"), (Names{"a b.mtl"})) << "the longest name that is there";
    EXPECT_EQ(names("a.mtl gone.mtl not there.mtl b.mtl"),
              (Names{"a.mtl", "gone.mtl", "not there.mtl", "b.mtl"}));
    EXPECT_EQ(names(""), (Names{}));
}

TEST_F(References, NamesMayStandInQuotes) {
    for (const char* file : {"a.mtl", "my mats.mtl"}) folder_.write(file, "x");
    EXPECT_EQ(names("\"my mats.mtl\""), (Names{"my mats.mtl"}));
    EXPECT_EQ(names("'my mats.mtl'"), (Names{"my mats.mtl"}));
    EXPECT_EQ(names("\"my mats.mtl\" a.mtl"), (Names{"my mats.mtl", "a.mtl"}));
    EXPECT_EQ(names("\"a.mtl\" \"my mats.mtl\""), (Names{"a.mtl", "my mats.mtl"}));
    EXPECT_EQ(names("\"a.mtl\"\"my mats.mtl\""), (Names{"a.mtl", "my mats.mtl"}));
    EXPECT_EQ(names("\"a.mtl"), (Names{"\"a.mtl"})) << "an open quote is a part of the name";
    EXPECT_EQ(names("\"\""), (Names{""}));
}

TEST_F(References, FoldersOfOtherMachinesAreLeftOut) {
    for (const char* file : {"mats/all.mtl", "here.mtl", "textures/t.mtl", "odd\\name.mtl"})
        folder_.write(file, "x");
    EXPECT_EQ(names("mats\\all.mtl"), (Names{"mats/all.mtl"}));
    EXPECT_EQ(names(".\\mats\\\\all.mtl"), (Names{"mats/all.mtl"}));
    EXPECT_EQ(names("C:\\Users\\me\\mats\\all.mtl"), (Names{"mats/all.mtl"}));
    EXPECT_EQ(names("\"D:/a b/here.mtl\""), (Names{"here.mtl"}));
    EXPECT_EQ(names("\\\\server\\share\\here.mtl"), (Names{"here.mtl"}));
    EXPECT_EQ(names("/home/me/here.mtl"), (Names{"here.mtl"}));
    EXPECT_EQ(names("..\\..\\t.mtl"), (Names{"textures/t.mtl"}));
    EXPECT_EQ(names("textures/t.mtl", "mats/a.obj"), (Names{"textures/t.mtl"}));
    EXPECT_EQ(names("odd\\name.mtl"), (Names{"odd\\name.mtl"})) << "a name that is there stays";
    EXPECT_EQ(names(folder_.path("here.mtl")), (Names{"here.mtl"}));
    EXPECT_EQ(names("C:\\gone.mtl"), (Names{"gone.mtl"}));
}

TEST_F(References, LettersMayDifferInCase) {
    for (const char* file : {"Mats/All.MTL", "x.mtl", "X.mtl"}) folder_.write(file, "x");
    folder_.write_xz("Wood.mtl.xz", "x");
    EXPECT_EQ(names("mats/all.mtl"), (Names{"Mats/All.MTL"}));
    EXPECT_EQ(names("MATS\\ALL.mtl x.mtl X.mtl"), (Names{"Mats/All.MTL", "x.mtl", "X.mtl"}));
    EXPECT_EQ(names("wood.mtl"), (Names{"Wood.mtl"}));
    EXPECT_EQ(read_asset(folder_.path("Wood.mtl")).bytes, "x");
}

TEST_F(References, ArchivesAreSearchedLikeFolders) {
    folder_.write_tar_xz("a.tar.xz", {{"b/x.obj", ""}, {"b/Maps/My Tex.png", "1"}});
    for (const char* name : {"maps\\my tex.png", "\"Maps/My Tex.png\"", "C:\\u\\my tex.PNG"})
        EXPECT_EQ(names(name, "a.tar.xz:b/x.obj"), (Names{"a.tar.xz:b/Maps/My Tex.png"}));
    EXPECT_EQ(names("gone.mtl", "a.tar.xz:b/x.obj"), (Names{"a.tar.xz:b/gone.mtl"}));
}

TEST_F(References, HostileLinesEnd) {
    folder_.write("a.mtl", "x");
    std::string words, slashes;
    for (int i = 0; i < 100000; ++i) words += "x ", slashes += "../";
    EXPECT_LE(names(words).size(), 64u);
    EXPECT_EQ(names(slashes).size(), 1u);
    EXPECT_EQ(names(std::string("a.mtl\0b", 7)).size(), 1u);
    EXPECT_EQ(names(".").size(), 1u) << "a folder is no file";
}

TEST_F(References, NamesThatNoFileCanHaveAreAWarning) {
    const std::string names[] = {std::string(300, 'x'),
                                 std::string(70000, 'x'),
                                 std::string(5000, '/'),
                                 "..",
                                 "/",
                                 "\"",
                                 "a:b:c"};
    for (const std::string& name : names) {
        const Model model = load_mesh(folder_.write(
            "a.obj", "mtllib " + name + "\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
        ASSERT_EQ(model.warnings.size(), 1u) << name.substr(0, 20);
        EXPECT_NE(model.warnings[0].find("a.obj: mtllib: "), std::string::npos);
    }
}

// Through the keywords of OBJ, MTL and PLY.
TEST_F(References, HoldForEveryKeyword) {
    folder_.write("mats/My Mats.mtl", "newmtl red\nKd 1 0 0\nmap_Kd \"..\\Tex\\a b.png\"\n");
    folder_.write("green.mtl",
                  "newmtl green\nKd 0 1 0\nmap_Kd -clamp off C:\\x\\tex\\A B.PNG\n");
    folder_.write("Tex/a b.png", "");
    const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\n";
    for (const char* line : {"mats\\My Mats.mtl green.mtl", "green.mtl \"MATS/my mats.mtl\"",
                             "green.mtl\nmtllib green.mtl\nmtllib mats/my mats.mtl"}) {
        const Model model =
            load_mesh(folder_.write("a.obj", std::string("mtllib ") + line + "\n" + triangle +
                                                 "usemtl green\nf 1 2 3\n"));
        EXPECT_TRUE(model.warnings.empty()) << model.warnings[0];
        ASSERT_EQ(model.materials.size(), 2u);
        for (const Material& material : model.materials)
            EXPECT_EQ(material.texture, folder_.path("Tex/a b.png")) << material.name;
        EXPECT_EQ(model.materials[1].diffuse, glm::vec3(0, 1, 0));
    }
    const Model model = load_mesh(folder_.write(
        "a.ply",
        "ply\nformat ascii 1.0\ncomment TextureFile tex\\A B.png\nelement vertex 1\n"
        "property float x\nproperty float y\nproperty float z\nend_header\n0 0 0\n"));
    EXPECT_EQ(model.materials[0].texture, folder_.path("Tex/a b.png"));
}

}  // namespace
}  // namespace render
