// aff_textures_test.cpp - textures of AFF files: which material has which, and where on it.
#include "import/bart/aff_text.hpp"
#include "scene/scene_file.hpp"
#include "scene/world.hpp"

namespace render {
namespace {

// Two pixels: red left of blue.
const std::string kPicture("P6\n2 1\n255\n\xff\0\0\0\0\xff", 17);
constexpr const char* kTriangle = " 0 0 0 0 0  1 0 0 1 0  0 1 0 .25 1.5\n";

TEST(AffTextures, AreFoundBesideTheFileThatNamesThem) {
    const TemporaryFolder folder;
    const std::string picture = folder.write("sub/a.ppm", kPicture);
    folder.write("sub/part.aff", std::string("tt a.ppm") + kTriangle);
    const Model model =
        load_aff(folder.write("a.aff", "fm 1 1 1 .5 .5 .5 0 0 0 1 0 1\ni 0 sub/part.aff\n"))
            ->at(0.0);
    EXPECT_TRUE(model.warnings.empty());
    ASSERT_EQ(model.materials.size(), 2u);
    EXPECT_EQ(model.materials[0].texture, "");
    EXPECT_EQ(model.materials[1].name, "aff0 a.ppm");
    EXPECT_EQ(model.materials[1].texture, picture);
    EXPECT_EQ(model.materials[1].diffuse, glm::vec3(0.5f));
    EXPECT_EQ(model.mesh.material_ids, (std::vector<uint32_t>{1}));
}

TEST(AffTextures, HaveTheirOriginAtTheTop) {
    const Mesh mesh = load_text(std::string("tt a.ppm") + kTriangle)->at(0.0).mesh;
    EXPECT_EQ(mesh.texcoords, (std::vector<glm::vec2>{{0, 1}, {1, 1}, {0.25f, -0.5f}}));
}

TEST(AffTextures, OfPatchesComeBesideNormals) {
    const Mesh mesh =
        load_text("ttp a.ppm 0 0 0 0 0 1 .5 0  1 0 0 0 1 0 1 .25  0 1 0 1 0 0 .75 1\n")
            ->at(0.0)
            .mesh;
    EXPECT_EQ(mesh.normals, (std::vector<glm::vec3>{{0, 0, 1}, {0, 1, 0}, {1, 0, 0}}));
    EXPECT_EQ(mesh.texcoords, (std::vector<glm::vec2>{{0.5f, 1}, {1, 0.75f}, {0.75f, 0}}));
}

TEST(AffTextures, OfMeshesHaveIndicesOfTheirOwn) {
    const Mesh mesh = load_text(
                          "m vertices 4 0 0 0 1 0 0 1 1 0 0 1 0 normals 1 0 0 1\n"
                          "texturecoords 3 a.ppm 0 0  .5 .25  1 1\n"
                          "triangles 2  0 1 2 0 0 0 0 1 2   0 2 3 0 0 0 2 2 0\n")
                          ->at(0.0)
                          .mesh;
    const std::vector<glm::vec2> expected = {{0, 1}, {0.5f, 0.75f}, {1, 0},
                                             {1, 0}, {1, 0},        {0, 1}};
    for (size_t i = 0; i < 6; ++i)
        EXPECT_EQ(mesh.texcoords[mesh.triangles[i / 3][static_cast<int>(i % 3)]], expected[i])
            << "corner " << i;
    EXPECT_EQ(mesh.positions.size(), 5u) << "the corners that differ in nothing are one vertex";
}

TEST(AffTextures, ShareTheMaterialOfOneFill) {
    const std::string a = std::string("tt a.ppm") + kTriangle,
                      b = std::string("tt b.ppm") + kTriangle,
                      plain = "p 3 0 0 0 1 0 0 0 1 0\n", fill = "f 1 1 1 .5 0 1 0 1\n";
    const Model model = load_text(a + fill + a + b + plain + a + fill + b + plain)->at(0.0);
    std::vector<std::string> names;
    for (const uint32_t id : model.mesh.material_ids)
        names.push_back(model.materials.at(id).name);
    EXPECT_EQ(names, (std::vector<std::string>{"aff0 a.ppm", "aff1 a.ppm", "aff1 b.ppm", "aff1",
                                               "aff1 a.ppm", "aff2 b.ppm", "aff2"}));
    EXPECT_EQ(model.materials.size(), 7u);
}

TEST(AffTextures, ThatAreMissingLeaveThePlainColour) {
    const std::string triangle = std::string("tt a.ppm") + kTriangle;
    const auto animation = load_text("fm 1 1 1 .5 .25 0 0 0 0 1 0 1\n\n" + triangle + triangle);
    expect_one_warning(*animation, {"a.aff, line 3", "texture a.ppm", "plain colour"});
    const Model model = animation->at(0.0);
    EXPECT_EQ(model.materials[1].texture, "");
    EXPECT_EQ(model.materials[1].diffuse, glm::vec3(0.5f, 0.25f, 0.0f));
    EXPECT_EQ(model.mesh.texcoords.size(), 6u) << "a scene file may name another picture";
}

TEST(AffTextures, NeedNoCoordinatesWithoutAny) {
    EXPECT_TRUE(load_text("p 3 0 0 0 1 0 0 0 1 0\n")->at(0.0).mesh.texcoords.empty());
}

TEST(AffTextures, ArePicturesOfTheScene) {
    const TemporaryFolder folder;
    folder.write("a.ppm", kPicture);
    folder.write("broken.ppm", "P6\n2 1\n255\n");
    const std::string file = folder.write(
        "a.aff", std::string("tt a.ppm") + kTriangle + "tt broken.ppm" + kTriangle);
    const World world(read_scenes({file}));
    ASSERT_EQ(world.textures().textures().size(), 1u);
    EXPECT_EQ(world.textures().textures()[0].width, 2u);
    EXPECT_EQ(world.textures().texels()[0] & 0xffffffu, 0x0000ffu) << "red comes first";
    ASSERT_EQ(world.warnings().size(), 1u);
    expect_parts(world.warnings()[0], {"aff0 broken.ppm", "texture"});
}

TEST(AffTextures, MayBeReplacedByASceneFile) {
    const TemporaryFolder folder;
    folder.write("mine.ppm", kPicture);
    folder.write("a.aff", std::string("tt a.ppm") + kTriangle + "p 3 0 0 0 1 0 0 0 1 0\n");
    const std::string file = folder.write(
        "scene.json",
        R"({"meshes": [{"file": "a.aff", "materials": {"aff0 a.ppm": {"texture": "mine.ppm"}}}]})");
    const World world(read_scenes({file}));
    ASSERT_EQ(world.textures().textures().size(), 1u);
    EXPECT_EQ(world.materials()[0].texture, RSH_NO_TEXTURE);
    EXPECT_EQ(world.materials()[1].texture, 0u);
}

TEST(AffTextures, NeedIndicesOfCoordinatesThatAreThere) {
    expect_parts(error_of("m vertices 3 0 0 0 1 0 0 0 1 0 texturecoords 1 a.ppm 0 0\n"
                          "triangles 1 0 1 2\n0 1 0"),
                 {"a.aff, line 3", "index of a texture coordinate", "there are 1"});
}

}  // namespace
}  // namespace render
