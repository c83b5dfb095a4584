// aff_animation_test.cpp - AFF files of a few lines at chosen times.
#include <cmath>

#include "import/bart/aff_text.hpp"

namespace render {
namespace {

void expect_near(glm::vec3 actual, glm::vec3 expected, const char* what) {
    EXPECT_LT(glm::distance(actual, expected), 1e-5f)
        << what << ": " << actual.x << " " << actual.y << " " << actual.z << ", expected "
        << expected.x << " " << expected.y << " " << expected.z;
}

// Curves that stand still at one value from time 0 to 1.
std::string still(const std::string& kind, const std::string& value) {
    std::string text = kind + " 4\n";
    for (const char* time : {"-1 ", "0 ", "1 ", "2 "}) text += time + value + " 0 0 0\n";
    return text;
}

// The museum's first triangle at its keys 2 (tetrahedron), 3 (sphere) and 4 (sheets).
constexpr const char* kMuseumTriangle =
    "tpa 3\n"
    "2  .5 3 .5 0 0 1  -.5 3 -.5 0 0 1  -.5 2 .5 0 0 1\n"
    "3  .461880 2.961880 .461880 .57735 .57735 .57735  -.461880 2.961880 -.461880 -.57735 "
    ".57735 "
    "-.57735  -.461880 2.038120 .461880 -.57735 -.57735 .57735\n"
    "4  0 1.5 0 0 2 0  -.25 2.5 -.5 0 2 0  .75 2.7 -.25 0 2 0\n";

TEST(AffAnimation, MuseumTriangleIsLinearBetweenItsKeysAndClampedOutside) {
    const auto animation = load_text(kMuseumTriangle);
    expect_near(animation->at(-1.0).mesh.positions[0], {0.5f, 3.0f, 0.5f}, "before key 2");
    expect_near(animation->at(2.0).mesh.positions[2], {-0.5f, 2.0f, 0.5f}, "key 2");
    const Mesh sphere = animation->at(3.0).mesh;
    for (int i = 0; i < 3; ++i) {
        const glm::vec3 out = sphere.positions[i] - glm::vec3(0.0f, 2.5f, 0.0f);
        EXPECT_NEAR(glm::length(out), 0.8f, 1e-5f) << "corner " << i;
        expect_near(sphere.normals[i], glm::normalize(out), "normal of the sphere");
    }
    expect_near(animation->at(3.5).mesh.positions[1],
                glm::vec3(-0.461880f - 0.25f, 2.961880f + 2.5f, -0.461880f - 0.5f) / 2.0f,
                "3.5");
    expect_near(animation->at(9.0).mesh.positions[1], {-0.25f, 2.5f, -0.5f}, "after key 4");
    expect_near(animation->at(9.0).mesh.normals[1], {0.0f, 1.0f, 0.0f}, "normals are unit");
}

TEST(AffAnimation, AFreeTriangleJumpsWhereTwoOfItsKeysHaveOneTime) {
    const auto animation = load_text(
        "tpa 3\n"
        "0  0 0 0 0 0 1  1 0 0 0 0 1  0 1 0 0 0 1\n"
        "1  2 0 0 0 0 1  3 0 0 0 0 1  2 1 0 0 0 1\n"
        "1  8 0 0 0 0 1  9 0 0 0 0 1  8 1 0 0 0 1\n");
    expect_near(animation->at(0.5).mesh.positions[0], {1.0f, 0.0f, 0.0f}, "on the way");
    expect_near(animation->at(1.0).mesh.positions[0], {8.0f, 0.0f, 0.0f}, "after the jump");
    expect_near(animation->at(5.0).mesh.positions[0], {8.0f, 0.0f, 0.0f}, "behind the end");
}

TEST(AffAnimation, StaticTransformsScaleThenRotateThenTranslate) {
    const auto animation = load_text(
        "xs 2 1 1  0 0 1 90  10 0 0 {\n xs 1 1 1 0 0 1 0 0 0 5 { p 3 1 0 0  0 1 0  0 0 0 }\n}\n"
        "p 3 1 0 0 0 1 0 0 0 0\n");
    const Mesh mesh = animation->at(0.0).mesh;
    expect_near(mesh.positions[0], {10.0f, 2.0f, 5.0f}, "corner 0");
    expect_near(mesh.positions[1], {9.0f, 0.0f, 5.0f}, "corner 1");
    expect_near(mesh.positions[3], {1.0f, 0.0f, 0.0f}, "after the brace");
}

TEST(AffAnimation, NormalsFollowUnevenScales) {
    const auto animation =
        load_text("xs 1 2 1  0 0 1 0  0 0 0 { pp 3 1 0 0 1 1 0  0 1 0 1 1 0  0 0 1 1 1 0 }\n");
    expect_near(animation->at(0.0).mesh.normals[0], glm::normalize(glm::vec3(2, 1, 0)),
                "normal");
}

TEST(AffAnimation, KeysMayComeAfterTheirUse) {
    const auto animation = load_text(
        "x car { p 3 1 0 0 0 1 0 0 0 0 }\nx gone { p 3 1 0 0 0 1 0 0 0 0 }\n"
        "k car { transl 4 -1 -1 0 0 0 0 0  0 0 0 0 0 0 0  1 1 0 0 0 0 0  2 2 0 0 0 0 0\n" +
        still("rot", "0 0 1 90") + still("scale", "3 3 3") + "}\na 0 1 11\n");
    EXPECT_EQ(animation->frames(), 11);
    EXPECT_EQ(animation->end(), 1.0);
    expect_near(animation->at(0.25).mesh.positions[0], {0.25f, 3.0f, 0.0f}, "moved");
    expect_near(animation->at(0.25).mesh.positions[3], {1.0f, 0.0f, 0.0f}, "without keys");
}

TEST(AffAnimation, WhatIsInvisibleCollapsesAndTheTopologyStays) {
    const auto animation = load_text(
        "x blink { p 4 0 0 0 1 0 0 1 1 0 0 1 0 tpa 1 0 0 0 0 0 0 1"
        " 1 0 0 0 0 1 0 1 0 0 0 1 }\n"
        "k blink { visibility 2 1 0 2 1 }\na 0 3 4\n");
    const Mesh seen = animation->at(0.5).mesh, hidden = animation->at(1.5).mesh;
    EXPECT_EQ(seen.triangles, hidden.triangles);
    EXPECT_EQ(animation->at(2.0).mesh.positions, seen.positions);
    for (const glm::vec3 p : hidden.positions) EXPECT_EQ(p, hidden.positions[0]);
    EXPECT_NE(seen.positions[0], seen.positions[1]);
    EXPECT_NE(seen.positions[4], seen.positions[5]);
}

TEST(AffAnimation, CameraLooksAlongMinusZOfItsRotation) {
    const std::string view =
        "v from 0 1 2 at 0 1 0 up 0 1 0 angle 40 hither .5 resolution 8 6\n";
    const Camera fixed = *load_text(view)->at(0.0).camera;
    EXPECT_EQ(fixed.vertical_degrees, 40.0f);
    EXPECT_EQ(fixed.near, 0.5f);
    expect_near(fixed.eye, {0, 1, 2}, "eye");
    const auto moving = load_text(view + "k camera {" + still("transl", "5 6 7") +
                                  still("rot", "0 1 0 90") + "}\n");
    const Camera camera = *moving->at(0.5).camera;
    expect_near(camera.eye, {5, 6, 7}, "eye");
    expect_near(camera.at - camera.eye, {-1, 0, 0}, "direction");
    expect_near(camera.up, {0, 1, 0}, "up");
    EXPECT_EQ(camera.vertical_degrees, 40.0f);
}

TEST(AffAnimation, LightsMoveWithTheirKeysAndTheirTransform) {
    const auto animation = load_text(
        "l 1 2 3\nl 1 2 3 .5 .25 1\nxs 1 1 1 0 0 1 0 0 0 10 { la lamp 1 0 0 1 1 0 }\n"
        "k lamp {" +
        still("transl", "0 5 0") + "}\n");
    const auto lights = animation->at(0.5).lights;
    ASSERT_EQ(lights.size(), 3u);
    EXPECT_EQ(lights[0].colour, glm::vec3(1.0f));
    EXPECT_EQ(lights[1].colour, glm::vec3(0.5f, 0.25f, 1.0f));
    expect_near(lights[2].position, {1, 5, 10}, "animated light");
}

TEST(AffAnimation, SpecularMirrorsAndTransmittanceRefracts) {
    const Model model = load_text(
                            "am 2 2 2\nf 1 .5 0 .5 .25 30 0 0\np 3 0 0 0 1 0 0 0 1 0\n"
                            "fm .1 .2 .3 .4 .5 .6 .7 .8 .9 20 .85 1.55\n"
                            "p 3 0 0 0 1 0 0 0 1 0\n")
                            ->at(0.0);
    ASSERT_EQ(model.materials.size(), 2u);
    EXPECT_EQ(model.mesh.material_ids, (std::vector<uint32_t>{0, 1}));
    EXPECT_EQ(model.materials[0].diffuse, glm::vec3(0.5f, 0.25f, 0.0f));
    EXPECT_EQ(model.materials[0].reflection, glm::vec3(0.25f));
    EXPECT_EQ(model.materials[0].transmission, glm::vec3(0.0f));
    EXPECT_EQ(model.materials[0].ior, 1.0f);
    expect_near(model.materials[1].ambient, {0.2f, 0.4f, 0.6f}, "ambient, times am");
    EXPECT_EQ(model.materials[1].reflection, glm::vec3(0.7f, 0.8f, 0.9f));
    EXPECT_EQ(model.materials[1].transmission, glm::vec3(0.85f));
    EXPECT_EQ(model.materials[1].ior, 1.55f);
}

TEST(AffAnimation, MeshesHaveTheirOwnIndicesOfNormalsAndTextures) {
    const Model model =
        load_text(
            "m vertices 3 0 0 0 1 0 0 0 1 0 normals 2 0 0 1 0 1 0\n"
            "texturecoords 1 t.ppm .5 .5 triangles 2 0 1 2 0 0 1 0 0 0  2 1 0 0 0 0 0 0 0\n"
            "tt u.ppm 0 0 0 0 0  1 0 0 1 0  0 1 0 0 1\n")
            ->at(0.0);
    ASSERT_EQ(model.mesh.triangles.size(), 3u);
    EXPECT_EQ(model.mesh.normals[model.mesh.triangles[0].z], glm::vec3(0, 1, 0));
    EXPECT_EQ(model.mesh.normals[model.mesh.triangles[1].x], glm::vec3(0, 0, 1));
    EXPECT_EQ(model.mesh.triangles[0].x, model.mesh.triangles[1].z);
    EXPECT_EQ(model.warnings.size(), 2u) << "one for each texture";
}

// Corners lie on the shape, normals point the way the triangles face: outwards.
TEST(AffAnimation, ConesAndSpheresFaceOutwards) {
    const Mesh mesh = load_text("c 1 0 0 2  1 4 0 1\ns 10 0 0 3\n")->at(0.0).mesh;
    EXPECT_EQ(mesh.triangles.size(), 24u * 2 + 24u * 12 * 2);
    for (size_t i = 0; i < mesh.triangles.size(); ++i) {
        const glm::uvec3 t = mesh.triangles[i];
        const glm::vec3 a = mesh.positions[t.x], b = mesh.positions[t.y],
                        c = mesh.positions[t.z];
        const glm::vec3 face = glm::cross(b - a, c - a);
        if (glm::length(face) < 1e-5f) continue;  // at the poles
        EXPECT_GT(glm::dot(face, mesh.normals[t.x]), 0.0f) << "triangle " << i;
        const bool is_cone = i < 48;
        const float radius = is_cone ? glm::length(glm::vec2(a.x - 1.0f, a.z))
                                     : glm::distance(a, glm::vec3(10, 0, 0));
        EXPECT_NEAR(radius, is_cone ? 2.0f - a.y / 4.0f : 3.0f, 1e-5f) << "triangle " << i;
    }
}

TEST(AffAnimation, IncludesDependOnTheLevelOfDetail) {
    const TemporaryFolder folder;
    folder.write("sub/part.aff", "i 0 leaf.aff p 3 0 0 0 1 0 0 0 1 0 % no line end");
    folder.write("sub/leaf.aff", "p 3 0 0 0 1 0 0 0 1 0");
    const std::string text = "i 1 none.aff\ni 0 sub/part.aff d 1 i 1 sub/leaf.aff # end\n";
    EXPECT_EQ(load_aff(folder.write("a.aff", text))->at(0.0).mesh.triangles.size(), 3u);
    const std::string loop = folder.write("loop.aff", "i 0 loop.aff\n");
    EXPECT_THROW(load_aff(loop), LoadError);
}

// 2^30 files, if it were followed.
TEST(AffAnimation, IncludesThatMultiplyAreAnError) {
    const TemporaryFolder folder;
    for (int i = 0; i < 30; ++i) {
        const std::string next = "i 0 " + std::to_string(i + 1) + ".aff\n";
        folder.write(std::to_string(i) + ".aff", next + next);
    }
    folder.write("30.aff", "");
    try {
        load_aff(folder.path("0.aff"));
        FAIL() << "loads";
    } catch (const LoadError& error) {
        EXPECT_NE(std::string(error.what()).find("more than 10000 files"), std::string::npos)
            << error.what();
    }
}

TEST(AffAnimation, MayBeginWithTheMarkOfUtf8) {
    EXPECT_EQ(load_text("\xef\xbb\xbfp 3 0 0 0 1 0 0 0 1 0\n")->at(0.0).mesh.triangles.size(),
              1u);
}

TEST(AffAnimation, NumbersFitTheirType) {
    const std::string mesh = "m vertices 3 0 0 0 1 0 0 0 1 0 triangles 1 0 1 ";
    for (const char* index : {"1.5", "-1", "3", "1e99", "nan"})
        EXPECT_NE(error_of(mesh + index).find("index of a vertex"), std::string::npos) << index;
    for (const char* count : {"-1", "1e99", "nan", "2.5", "4000000000"})
        EXPECT_NE(error_of("p " + std::string(count) + " 0 0 0").find("number of corners"),
                  std::string::npos)
            << count;
    for (const char* angle : {"0", "-40", "180", "1e99", "nan"})
        EXPECT_NE(error_of("v angle " + std::string(angle)).find("angle is"), std::string::npos)
            << angle;
}

TEST(AffAnimation, ErrorsNameTheLine) {
    EXPECT_NE(error_of("b 1 1 1\nq 3\n").find("line 2: unknown command 'q'"),
              std::string::npos);
    EXPECT_NE(error_of("p 3 0 0 0 1.5 0 0 0 1.25").find("ends where it needs"),
              std::string::npos);
    EXPECT_NE(error_of("p 99999999 0 0 0").find("number of corners"), std::string::npos);
    EXPECT_NE(error_of("k a { transl 2 0 0 0 0 0 0 0 1 0 0 0 0 0 0 }").find("at least 4 keys"),
              std::string::npos);
    EXPECT_NE(error_of("x a { p 3 0 0 0 1 0 0 0 1 0").find("not closed"), std::string::npos);
    EXPECT_NE(error_of("}").find("none is open"), std::string::npos);
    EXPECT_NE(error_of("m vertices 3 0 0 0 1 0 0 0 1 0 triangles 1 0 1 3").find("there are 3"),
              std::string::npos);
}

}  // namespace
}  // namespace render
