// gltf_material_test.cpp - materials, textures, lights and cameras of glTF files.
#include <gtest/gtest.h>

#include "files/png_bytes.hpp"
#include "import/gltf/gltf_animation.hpp"
#include "import/gltf/gltf_builder.hpp"
#include "scene/scene_file.hpp"
#include "scene/world.hpp"
#include "temporary_folder.hpp"

namespace render {
namespace {

using Json = nlohmann::json;

Model load(const GltfBuilder& file) {
    const TemporaryFolder folder;
    return load_gltf(folder.write("a.gltf", file.text()))->at(0.0);
}

Material material(const Json& json) {
    GltfBuilder file;
    file.add_triangle(json);
    return load(file).materials.at(0);
}

void expect_near(glm::vec3 actual, glm::vec3 expected, const char* what) {
    EXPECT_LT(glm::distance(actual, expected), 1e-5f * (1.0f + glm::length(expected)))
        << what << ": " << actual.x << " " << actual.y << " " << actual.z << ", expected "
        << expected.x << " " << expected.y << " " << expected.z;
}

void expect_warning(const std::vector<std::string>& warnings, const std::string& part) {
    for (const std::string& warning : warnings)
        if (warning.find(part) != std::string::npos) return;
    ADD_FAILURE() << "no warning says \"" << part << "\"";
}

Json pbr(double metallic, double roughness) {
    return {{"pbrMetallicRoughness",
             {{"baseColorFactor", {0.8, 0.4, 0.2, 1}},
              {"metallicFactor", metallic},
              {"roughnessFactor", roughness}}}};
}

constexpr glm::vec3 kColour(0.8f, 0.4f, 0.2f), kBlack(0.0f);

TEST(GltfMaterial, DielectricsScatterTheirColourAndGlint) {
    // 2 / 0.5^4 - 2 = 30, and 0.04 (30 + 8) / 8 = 0.19.
    const Material m = material(pbr(0.0, 0.5));
    expect_near(m.diffuse, kColour, "diffuse");
    expect_near(m.reflection, kBlack, "reflection");
    expect_near(m.transmission, kBlack, "transmission");
    expect_near(m.specular, glm::vec3(0.19f), "specular");
    EXPECT_FLOAT_EQ(m.shininess, 30.0f);
}

TEST(GltfMaterial, MetalsMirrorTheirColourTheLessTheRougherTheyAre) {
    const Material polished = material(pbr(1.0, 0.0));
    expect_near(polished.reflection, kColour, "reflection");
    expect_near(polished.diffuse, kBlack, "diffuse");
    expect_near(polished.specular, kColour / 0.8f, "specular, up to 1");
    EXPECT_FLOAT_EQ(polished.shininess, 1e4f);
    const Material brushed = material(pbr(1.0, 0.5));
    expect_near(brushed.reflection, 0.25f * kColour, "reflection");
    expect_near(brushed.diffuse, 0.75f * kColour, "diffuse");
    const Material rough = material(pbr(1.0, 1.0));
    expect_near(rough.reflection, kBlack, "reflection");
    expect_near(rough.diffuse, kColour, "diffuse");
    expect_near(rough.specular, kBlack, "specular");
    const Material half = material(pbr(0.5, 0.0));
    expect_near(half.reflection, 0.5f * kColour, "reflection");
}

TEST(GltfMaterial, GlassTransmitsItsColourWithItsIndex) {
    Json json = pbr(0.0, 0.0);
    json["extensions"]["KHR_materials_transmission"]["transmissionFactor"] = 0.75;
    expect_near(material(json).transmission, 0.75f * kColour, "transmission");
    expect_near(material(json).diffuse, 0.25f * kColour, "diffuse");
    EXPECT_FLOAT_EQ(material(json).ior, 1.5f);
    json["extensions"]["KHR_materials_ior"]["ior"] = 1.33;
    EXPECT_FLOAT_EQ(material(json).ior, 1.33f);
    json["pbrMetallicRoughness"]["metallicFactor"] = 1.0;
    expect_near(material(json).transmission, kBlack, "a metal's transmission");
    EXPECT_FLOAT_EQ(material(json).ior, 1.0f);
}

TEST(GltfMaterial, AlphaThatBlendsIsSeenThrough) {
    Json json = pbr(0.0, 1.0);
    json["pbrMetallicRoughness"]["baseColorFactor"][3] = 0.4;
    expect_near(material(json).transmission, kBlack, "opaque");
    json["alphaMode"] = "BLEND";
    expect_near(material(json).transmission, 0.6f * kColour, "transmission");
    EXPECT_FLOAT_EQ(material(json).ior, 1.0f);
}

TEST(GltfMaterial, DefaultsAreThoseOfTheFormat) {
    const Material m = material(Json::object());
    EXPECT_EQ(m.name, "0");
    expect_near(m.diffuse, glm::vec3(1.0f), "diffuse");
    expect_near(m.reflection, kBlack, "reflection");
    expect_near(m.emission, kBlack, "emission");
}

TEST(GltfMaterial, EmissionIsTheFactorUnlessATextureHasIt) {
    Json json{{"emissiveFactor", {0.1, 0.2, 0.3}}};
    expect_near(material(json).emission, {0.1f, 0.2f, 0.3f}, "emission");
    GltfBuilder file;
    json["emissiveTexture"]["index"] = json["normalTexture"]["index"] = 0;
    file.json["images"] = {{{"uri", "gone.png"}}};
    file.json["textures"] = {{{"source", 0}}};
    file.add_triangle(json);
    const Model model = load(file);
    expect_near(model.materials[0].emission, kBlack, "emission");
    expect_warning(model.warnings, "1 of 1 materials have an emissiveTexture");
    expect_warning(model.warnings, "1 of 1 materials have a normalTexture");
    EXPECT_EQ(model.warnings.size(), 2u);
}

// The same image three times: in a view, in the text, and beside the file.
TEST(GltfMaterial, ImagesLieInTheFileOrBesideIt) {
    const std::string png = png_file({2, 3}, std::string("\x80\x40\x20", 3));
    const TemporaryFolder folder;
    folder.write("Textures/a b.png", png);
    GltfBuilder file;
    file.json["images"] = {{{"bufferView", file.view(png)}, {"mimeType", "image/png"}},
                           {{"uri", "textures/a%20b.png"}}};
    file.json["samplers"] = {{{"wrapS", 33071}, {"wrapT", 33071}}, {{"wrapS", 33648}}};
    file.json["textures"] = {{{"source", 0}},
                             {{"source", 1}, {"sampler", 0}},
                             {{"source", 0}, {"sampler", 1}},
                             Json::object()};
    for (int i = 0; i < 4; ++i)
        file.add_triangle({{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", i}}}}}});
    const std::string path = folder.write("a.glb", file.binary());
    const World world(read_scenes({path}));
    const auto& textures = world.textures().textures();
    ASSERT_EQ(textures.size(), 2u) << "an image of the file twice is one texture";
    for (const rsh_texture& texture : textures) {
        EXPECT_EQ(texture.width, 2u);
        EXPECT_EQ(texture.height, 3u);
        EXPECT_EQ(world.textures().texels()[texture.first_word], 0xff204080u);
    }
    EXPECT_EQ(textures[0].wrap, RSH_WRAP_REPEAT);
    EXPECT_EQ(textures[1].wrap, RSH_WRAP_CLAMP);
    EXPECT_EQ(world.materials()[2].texture, 0u);
    EXPECT_EQ(world.materials()[3].texture, RSH_NO_TEXTURE);
    expect_warning(world.warnings(), "samplers[1]: wrapS 33648");
    expect_warning(world.warnings(), "textures[3] has no source");
    EXPECT_EQ(world.warnings().size(), 2u);
}

TEST(GltfMaterial, ScenesReplaceTexturesThatTheFileHolds) {
    const std::string png = png_file({2, 3}, "\x80\x40\x20"), other = png_file({1, 1}, "abc");
    const TemporaryFolder folder;
    folder.write("other.png", other);
    GltfBuilder file;
    file.json["images"] = {{{"bufferView", file.view(png)}, {"mimeType", "image/png"}}};
    file.json["textures"] = {{{"source", 0}}};
    file.add_triangle({{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
    folder.write("a.glb", file.binary());
    const std::string scene =
        R"({"meshes": [{"file": "a.glb", "material": {"texture": "other.png"}}]})";
    const World world(parse_scene(scene, folder.path("scene.json")));
    ASSERT_EQ(world.textures().textures().size(), 1u);
    EXPECT_EQ(world.textures().textures()[0].width, 1u);
}

TEST(GltfMaterial, ABrokenImageIsAWarningThatNamesIt) {
    GltfBuilder file;
    file.json["images"] = {{{"bufferView", file.view("no image")}, {"mimeType", "image/png"}}};
    file.json["textures"] = {{{"source", 0}}};
    file.add_triangle({{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
    const TemporaryFolder folder;
    const World world(read_scenes({folder.write("a.glb", file.binary())}));
    expect_warning(world.warnings(), "a.glb: images[0].png");
}

// pi candela: what the renderer calls 1.
TEST(GltfLights, ShineFromTheirNodesAlongZ) {
    GltfBuilder file;
    file.add_triangle();
    constexpr double kPi = 3.14159265358979323846;
    file.json["extensions"]["KHR_lights_punctual"]["lights"] = {
        {{"type", "point"}, {"intensity", 2 * kPi}, {"color", {1, 0.5, 0}}},
        {{"type", "directional"}, {"intensity", kPi}},
        {{"type", "spot"},
         {"intensity", kPi},
         {"range", 9},
         {"spot", {{"innerConeAngle", kPi / 12}, {"outerConeAngle", kPi / 6}}}}};
    for (int i = 0; i < 3; ++i) {
        Json node{{"translation", {i, 2, 3}}, {"scale", {1, 1, 5}}};
        node["rotation"] = {0, 0.70710678118654752, 0, 0.70710678118654752};  // -z to -x
        node["extensions"]["KHR_lights_punctual"]["light"] = i;
        file.json["nodes"].push_back(node);
    }
    const Model model = load(file);
    ASSERT_EQ(model.lights.size(), 3u);
    const Light &point = model.lights[0], &sun = model.lights[1], &spot = model.lights[2];
    EXPECT_EQ(point.kind, RSH_LIGHT_POINT);
    expect_near(point.colour, {2, 1, 0}, "colour");
    expect_near(point.position, {0, 2, 3}, "position");
    EXPECT_EQ(point.attenuation, glm::vec3(0, 0, 1));
    EXPECT_EQ(sun.kind, RSH_LIGHT_DIRECTIONAL);
    expect_near(sun.direction, {-1, 0, 0}, "direction");
    EXPECT_EQ(sun.attenuation, kBlack);
    EXPECT_EQ(spot.kind, RSH_LIGHT_SPOT);
    expect_near(spot.direction, {-1, 0, 0}, "direction");
    EXPECT_NEAR(spot.inner_degrees, 15.0f, 1e-4f);
    EXPECT_NEAR(spot.outer_degrees, 30.0f, 1e-4f);
    expect_warning(model.warnings, "lights[2].range 9 is ignored");
}

TEST(GltfCamera, IsTheFirstPerspectiveOne) {
    GltfBuilder file;
    file.add_triangle();
    EXPECT_FALSE(load(file).camera);
    file.json["cameras"] = {
        {{"type", "orthographic"},
         {"orthographic", {{"xmag", 1}, {"ymag", 1}, {"zfar", 9}, {"znear", 0}}}},
        {{"type", "perspective"}, {"perspective", {{"yfov", 0.5}, {"znear", 0.25}}}}};
    file.json["nodes"].push_back({{"camera", 0}});
    file.json["nodes"].push_back(
        {{"camera", 1},
         {"translation", {1, 2, 3}},
         {"rotation", {0.70710678118654752, 0, 0, 0.70710678118654752}}});
    const Model model = load(file);
    expect_warning(model.warnings, "cameras[0]: is orthographic");
    ASSERT_TRUE(model.camera);
    expect_near(model.camera->eye, {1, 2, 3}, "eye");
    expect_near(model.camera->at, {1, 3, 3}, "at");
    expect_near(model.camera->up, {0, 0, 1}, "up");
    EXPECT_NEAR(model.camera->vertical_degrees, 28.6478898f, 1e-4f);
    EXPECT_FLOAT_EQ(model.camera->near, 0.25f);
}

}  // namespace
}  // namespace render
