// mtl_file_test.cpp - the terms of MTL and what they become.
#include "import/mtl_file.hpp"

#include <gtest/gtest.h>

namespace render {
namespace {

using Warnings = std::vector<std::string>;

Material read_one(const std::string& terms, Warnings* warnings = nullptr) {
    std::map<std::string, Material> materials;
    Warnings ignored;
    read_mtl("newmtl m\n" + terms, "folder/a.mtl", materials, warnings ? *warnings : ignored);
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

TEST(MtlFile, IlluminationModelsChooseMirrors) {
    for (const char* illum : {"illum 3\n", "illum 5\n"})
        EXPECT_EQ(read_one(std::string("Ks .9 .8 .7\n") + illum).reflection,
                  glm::vec3(0.9f, 0.8f, 0.7f));
}

TEST(MtlFile, IlluminationModels0And1HaveNoHighlight) {
    for (const char* illum : {"0", "1", "1.0"})
        EXPECT_EQ(read_one(std::string("Ks 1 1 1\nNs 0\nillum ") + illum).specular,
                  glm::vec3(0.0f))
            << illum;
    EXPECT_EQ(read_one("illum 1\nKs 1 1 1\n").specular, glm::vec3(0.0f)) << "in any order";
    EXPECT_EQ(read_one("Ks 1 1 1\nillum 2\n").specular, glm::vec3(1.0f));
    EXPECT_EQ(read_one("Ks 1 1 1\n").specular, glm::vec3(1.0f));
}

// The number of the illumination model and Tf stand beside opaque materials too.
TEST(MtlFile, WhatIsStatedAsOpaqueStaysOpaque) {
    for (const char* illum :
         {"", "illum 2\n", "illum 4\n", "illum 6\n", "illum 7\n", "illum 9\n"})
        for (const char* tf : {"", "Tf 1 1 1\n", "Tf 0.5 0.5 0.5\n"})
            for (const char* opacity : {"", "d 1\n", "Tr 0\n", "d 1.0\nTr 0\n", "Tr 1\nd 1\n"})
                for (const char* index : {"", "Ni 1.0\n", "Ni 1.5\n"}) {
                    const std::string terms = std::string(tf) + opacity + index + illum;
                    const bool is_glass = *opacity == 0 && index == std::string("Ni 1.5\n") &&
                                          (terms.find("illum 6") != terms.npos ||
                                           terms.find("illum 7") != terms.npos);
                    EXPECT_EQ(read_one(terms).transmission != glm::vec3(0.0f), is_glass)
                        << terms;
                }
}

TEST(MtlFile, RefractiveMaterialsThatSayNothingOfOpacityAreGlass) {
    for (const char* illum : {"illum 6\n", "illum 7\n"}) {
        const Material m = read_one(std::string("Tf .1 .2 .3\nNi 1.33\n") + illum);
        EXPECT_EQ(m.transmission, glm::vec3(0.1f, 0.2f, 0.3f));
        EXPECT_EQ(m.ior, 1.33f);
        EXPECT_EQ(read_one(std::string("Ni 1.5\n") + illum).transmission, glm::vec3(1.0f));
    }
}

TEST(MtlFile, DissolveMeansSeeThrough) {
    EXPECT_EQ(read_one("d 0.25\nNi 1.5\n").transmission, glm::vec3(0.75f));
    EXPECT_EQ(read_one("d 0.25\nNi 1.5\n").ior, 1.0f);
    EXPECT_EQ(read_one("Tr 0.25\n").transmission, glm::vec3(0.25f));
    EXPECT_EQ(read_one("Tr 1\nd 1\n").transmission, glm::vec3(0.0f)) << "d wins";
    EXPECT_EQ(read_one("d 1\nTr 0\nTf 0.5 0.5 0.5\nillum 2\n").transmission, glm::vec3(0.0f));
    EXPECT_EQ(read_one("d 0.5\nTf 0.5 0.5 0.5\nillum 2\n").transmission, glm::vec3(0.5f));
    for (const char* illum : {"illum 4\n", "illum 9\n"}) {
        EXPECT_EQ(read_one(std::string("Ni 1.5\nd 0.25\n") + illum).transmission,
                  glm::vec3(0.75f));
        EXPECT_EQ(read_one(std::string("Ni 1.5\nd 0.25\n") + illum).ior, 1.0f);
    }
    for (const char* illum : {"illum 6\n", "illum 7\n"}) {
        const Material m = read_one(std::string("d 0\nTf .1 .2 .3\nNi 1.33\n") + illum);
        EXPECT_EQ(m.transmission, glm::vec3(0.1f, 0.2f, 0.3f));
        EXPECT_EQ(m.ior, 1.33f);
        EXPECT_EQ(read_one(std::string("d 0.5\nTf 1 0.5 0\n") + illum).transmission,
                  glm::vec3(0.5f, 0.25f, 0.0f));
        EXPECT_EQ(read_one(std::string("Tr 1\nTf 0 0 0\n") + illum).transmission,
                  glm::vec3(1.0f))
            << "a black filter is none";
    }
}

TEST(MtlFile, NumbersThatAreNoneAreIgnoredWithAWarning) {
    const std::pair<const char*, const char*> cases[] = {
        {"illum 33333333333333\n", "line 2: illum: '33333333333333'"},
        {"illum 4294967298\n", "whole number from 0 to 10"},
        {"illum -1\n", "'-1'"},
        {"illum 2.5\n", "'2.5'"},
        {"illum\n", "''"},
        {"illum x\n", "'x'"},
        {"Kd 1e400 0 0\n", "line 2: Kd: '1e400 0 0'"},
        {"Kd nan 0 0\n", "needs finite numbers"},
        {"Ns inf\n", "Ns: 'inf'"},
        {"Ni 1e39\n", "Ni: '1e39'"},
        {"Kd red\n", "'red'"},
        {"d\n", "''"},
        {"Kd\n", "''"}};
    for (const auto& [terms, part] : cases) {
        Warnings warnings;
        const Material m = read_one(terms, &warnings);
        EXPECT_EQ(m.diffuse, glm::vec3(0.8f)) << terms;
        EXPECT_EQ(m.transmission, glm::vec3(0.0f)) << terms;
        EXPECT_EQ(m.shininess, 1.0f) << terms;
        ASSERT_EQ(warnings.size(), 1u) << terms;
        EXPECT_EQ(warnings[0].find("folder/a.mtl, line 2: "), 0u) << warnings[0];
        EXPECT_NE(warnings[0].find(part), std::string::npos) << warnings[0];
    }
}

TEST(MtlFile, OptionsOfTexturesScaleShiftAndClamp) {
    const Material m = read_one("map_Kd -s 4 1 1 -o .5 -.25 0 -clamp on a b.png\n");
    EXPECT_EQ(m.texture, "folder/a b.png");
    EXPECT_EQ(m.texture_scale, glm::vec2(4, 1));
    EXPECT_EQ(m.texture_shift, glm::vec2(0.5f, -0.25f));
    EXPECT_TRUE(m.clamps_texture);
    EXPECT_EQ(read_one("map_Kd -s 4 a.png\n").texture_scale, glm::vec2(4, 1));
    EXPECT_EQ(read_one("map_Kd -S 4 -3 a.png\n").texture_scale, glm::vec2(4, -3));
    EXPECT_EQ(read_one("map_Kd -o 2 a.png\n").texture_shift, glm::vec2(2, 0));
    EXPECT_EQ(read_one("map_Kd -o 2 3 1.png\n").texture, "folder/1.png");
    EXPECT_EQ(read_one("map_Kd a.png\n").texture_scale, glm::vec2(1));
    EXPECT_FALSE(read_one("map_Kd -clamp off a.png\n").clamps_texture);
    EXPECT_EQ(read_one("map_Kd -a.png\n").texture, "folder/-a.png");
}

TEST(MtlFile, OptionsThatAreNotUsedAreParsedAndWarnedOf) {
    for (const char* harmless : {"-blendu on", "-blendv off", "-bm 0.3", "-mm 0 1", "-cc off",
                                 "-texres 512", "-type sphere"}) {
        Warnings warnings;
        EXPECT_EQ(
            read_one(std::string("map_Kd ") + harmless + " -s 2 2 2 a.png", &warnings).texture,
            "folder/a.png")
            << harmless;
        EXPECT_TRUE(warnings.empty()) << warnings[0];
    }
    for (const char* ignored : {"-t 1 1 1", "-t .5", "-mm 0.2 0.5", "-cc on", "-boost 2",
                                "-imfchan r", "-colorspace linear", "-s inf 1 1", "-o 1e99"}) {
        Warnings warnings;
        const Material m =
            read_one(std::string("map_Kd ") + ignored + " -clamp on a.png", &warnings);
        EXPECT_EQ(m.texture, "folder/a.png") << ignored;
        EXPECT_TRUE(m.clamps_texture) << ignored;
        EXPECT_EQ(m.texture_scale, glm::vec2(1)) << ignored;
        ASSERT_EQ(warnings.size(), 1u) << ignored;
        EXPECT_NE(warnings[0].find(std::string("line 2: map_Kd: option ") + ignored),
                  std::string::npos)
            << warnings[0];
    }
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
