// mtl_file_test.cpp - the terms of MTL and what they become.
#include "import/mtl_file.hpp"

#include <gtest/gtest.h>

namespace render {
namespace {

Material read_one(const std::string& terms) {
    std::map<std::string, Material> materials;
    std::vector<std::string> warnings;
    read_mtl("newmtl m\n" + terms, "folder/a.mtl", materials, warnings);
    EXPECT_EQ(materials.size(), 1u);
    return materials["m"];
}

TEST(MtlFile, ReadsColoursAndShininess) {
    const Material m =
        read_one("\tKa 0.1 0.2 0.3 # red\r\n Kd 0.5\nKs .25 .5 .75\nKe 10 9 8\nNs 39.5\n");
    EXPECT_EQ(m.ambient, glm::vec3(0.1f, 0.2f, 0.3f));
    EXPECT_EQ(m.diffuse, glm::vec3(0.5f));
    EXPECT_EQ(m.specular, glm::vec3(0.25f, 0.5f, 0.75f));
    EXPECT_EQ(m.emission, glm::vec3(10, 9, 8));
    EXPECT_EQ(m.shininess, 39.5f);
    EXPECT_EQ(m.reflection, glm::vec3(0.0f)) << "illum 2 has highlights, no mirror";
}

TEST(MtlFile, IlluminationModelsChooseMirrorAndGlass) {
    for (const char* illum : {"illum 3\n", "illum 5\n"})
        EXPECT_EQ(read_one(std::string("Ks .9 .8 .7\n") + illum).reflection,
                  glm::vec3(0.9f, 0.8f, 0.7f));
    for (const char* illum : {"illum 6\n", "illum 7\n"}) {
        const Material m = read_one(std::string("Tf .1 .2 .3\nNi 1.33\nd 1\n") + illum);
        EXPECT_EQ(m.transmission, glm::vec3(0.1f, 0.2f, 0.3f));
        EXPECT_EQ(m.ior, 1.33f);
    }
    EXPECT_EQ(read_one("illum 4\nNi 1.5\n").transmission, glm::vec3(1.0f));
    EXPECT_EQ(read_one("illum 4\nNi 1.5\n").ior, 1.0f);
    EXPECT_EQ(read_one("illum 9\nd 0.25\n").transmission, glm::vec3(0.75f));
}

TEST(MtlFile, DissolveMeansSeeThrough) {
    EXPECT_EQ(read_one("d 0.25\nNi 1.5\n").transmission, glm::vec3(0.75f));
    EXPECT_EQ(read_one("Tr 0.25\n").transmission, glm::vec3(0.25f));
    EXPECT_EQ(read_one("Tr 1\nd 1\n").transmission, glm::vec3(0.0f)) << "d wins";
    EXPECT_EQ(read_one("d 1\nTr 0\nTf 0.5 0.5 0.5\nillum 2\n").transmission, glm::vec3(0.0f));
}

TEST(MtlFile, TexturesStandBesideTheFile) {
    EXPECT_EQ(read_one("map_Kd a b.png\n").texture, "folder/a b.png");
    EXPECT_EQ(read_one("map_Kd -s 2 2 1 -clamp on -mm 0 1 maps\\x.png\n").texture,
              "folder/maps/x.png");
    EXPECT_EQ(read_one("map_Kd /abs/x.png\n").texture, "/abs/x.png");
}

TEST(MtlFile, KeywordsMayBeSpelledInAnyCaseAndBadNumbersAreSkipped) {
    const Material m = read_one("KD 1 0 0\nkS .5 .5 .5\nNS x\nd -halo 0.1\nMAP_KD a.png\n");
    EXPECT_EQ(m.diffuse, glm::vec3(1, 0, 0));
    EXPECT_EQ(m.specular, glm::vec3(0.5f));
    EXPECT_EQ(m.shininess, 1.0f);
    EXPECT_EQ(m.transmission, glm::vec3(0.0f));
    EXPECT_EQ(m.texture, "folder/a.png");
    EXPECT_EQ(read_one("").diffuse, glm::vec3(0.8f));
    EXPECT_EQ(read_one("map_Kd -s 2 2 a.png\n").texture, "folder/a.png");
    EXPECT_EQ(read_one("map_Kd -cc on a.png\n").diffuse, glm::vec3(0.8f));
}

TEST(MtlFile, TheFirstDefinitionOfANameStays) {
    std::map<std::string, Material> materials;
    std::vector<std::string> warnings;
    read_mtl("Kd 9 9 9\nnewmtl m\nKd 1 0 0\nnewmtl m\nKd 0 1 0\n", "a.mtl", materials,
             warnings);
    EXPECT_EQ(materials["m"].diffuse, glm::vec3(1, 0, 0));
    EXPECT_EQ(warnings.size(), 1u);
}

}  // namespace
}  // namespace render
