// text_marks_test.cpp - bytes that editors put before the first keyword, in every text format.
#include <gtest/gtest.h>

#include "import/mesh_file.hpp"
#include "import/vertex_frames.hpp"
#include "temporary_folder.hpp"

namespace render {
namespace {

const std::string kMark = "\xef\xbb\xbf";
const std::string kPly =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
    "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

struct TextFile {
    const char* name;  // without an ending, the first keyword tells the format
    std::string text;
};

const TextFile kFiles[] = {
    {"a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"},
    {"a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"},
    {"b.off", "3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"},
    {"a.ply", kPly},
    {"a.stl",
     "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
     "vertex 0 1 0\nendloop\nendfacet\nendsolid\n"},
    {"ply", kPly},
    {"off", "OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"}};

void expect_same(const Mesh& mesh, const std::string& what) {
    ASSERT_EQ(mesh.triangles.size(), 1u) << what;
    ASSERT_EQ(mesh.positions.size(), 3u) << what;
    EXPECT_EQ(mesh.triangles[0], glm::uvec3(0, 1, 2)) << what;
    EXPECT_EQ(mesh.positions[0], glm::vec3(0, 0, 0)) << what;
    EXPECT_EQ(mesh.positions[2], glm::vec3(0, 1, 0)) << what;
}

TEST(TextMarks, BeforeTheFirstKeywordChangeNothing) {
    const TemporaryFolder folder;
    for (const TextFile& file : kFiles)
        for (const std::string& before : {std::string(), kMark, kMark + kMark, "\n" + kMark,
                                          kMark + " \r\n\t", std::string("\n\n")})
            expect_same(load_mesh(folder.write(file.name, before + file.text)).mesh,
                        std::string(file.name) + " behind " + testing::PrintToString(before));
}

TEST(TextMarks, BetweenObjFilesThatWereJoinedChangeNothing) {
    const TemporaryFolder folder;
    const Mesh mesh = load_mesh(folder.write("a.obj", kMark + "v 0 0 0\nv 1 0 0\n" + kMark +
                                                          "v 0 1 0\nf 1 2 3\n" + kMark +
                                                          "f 1 \\\n" + kMark + "2 3\n"))
                          .mesh;
    ASSERT_EQ(mesh.triangles.size(), 2u);
    EXPECT_EQ(mesh.triangles[1], glm::uvec3(0, 1, 2));
}

TEST(TextMarks, DoNotHideTheFirstMaterialNorADescription) {
    const TemporaryFolder folder;
    folder.write("a.mtl", kMark + "newmtl red\nKd 1 0 0\n");
    const std::string obj = folder.write(
        "a.obj", kMark + "mtllib a.mtl\nusemtl red\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const Model model = load_mesh(obj);
    ASSERT_EQ(model.materials.size(), 1u);
    EXPECT_EQ(model.materials[0].diffuse, glm::vec3(1, 0, 0));
    EXPECT_TRUE(model.warnings.empty()) << model.warnings[0];

    folder.write("f.json", kMark +
                               "{\"frames\": 1, \"vertices\": 3, \"triangles\": 1, "
                               "\"time_start\": 0, \"time_end\": 1}");
    const std::string frames = folder.write("f.f32", std::string(36, '\0'));
    EXPECT_EQ(load_vertex_frames(obj, frames)->frames(), 1);
}

TEST(TextMarks, OfUtf16AreAnErrorThatSaysSo) {
    const TemporaryFolder folder;
    for (const std::string mark : {"\xff\xfe", "\xfe\xff"})
        for (const char* name : {"a.obj", "a.off", "a.ply"})
            EXPECT_NE(error_of_mesh(folder.write(name, mark + "v 0")).find("UTF-16"),
                      std::string::npos)
                << name;
    folder.write("a.mtl", "\xff\xfen");
    const Model model =
        load_mesh(folder.write("b.obj", "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
    ASSERT_EQ(model.warnings.size(), 1u);
    EXPECT_NE(model.warnings[0].find("UTF-16"), std::string::npos) << model.warnings[0];
}

}  // namespace
}  // namespace render
