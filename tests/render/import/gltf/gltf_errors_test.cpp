// gltf_errors_test.cpp - files that say what cannot be: each is an error that names the member, what it is
// and what it must be.
#include <gtest/gtest.h>

#include <functional>

#include "import/gltf/gltf_animation.hpp"
#include "import/gltf/gltf_builder.hpp"
#include "temporary_folder.hpp"

namespace render {
namespace {

using Json = nlohmann::json;

std::string error_of(const std::string& name, const std::string& bytes) {
    const TemporaryFolder folder;
    try {
        load_gltf(folder.write(name, bytes));
    } catch (const std::exception& error) {
        return error.what();
    }
    ADD_FAILURE() << "loads, but must not:\n" << bytes.substr(0, 2000);
    return {};
}

void expect_parts(const std::string& message, const std::vector<std::string>& parts) {
    for (const std::string& part : parts)
        EXPECT_NE(message.find(part), std::string::npos)
            << '"' << part << "\" is not in: " << message;
}

// Two triangles with everything that may be wrong. Accessors: 0 positions, 1 indices, 2 joints,
// 3 weights, 4 what a target adds, 5 values of the animation, 6 its times.
GltfBuilder whole_file() {
    GltfBuilder file;
    const int positions = file.floats("VEC3", {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0});
    const int indices = file.bytes("SCALAR", {0, 1, 2, 1, 3, 2});
    const int joints = file.bytes("VEC4", std::vector<uint8_t>(16));
    const int weights = file.floats("VEC4", std::vector<float>(16, 0.25f));
    const int added = file.sparse("VEC3", 4, {1}, {1, 2, 3});
    file.add_mesh({{"attributes",
                    {{"POSITION", positions}, {"JOINTS_0", joints}, {"WEIGHTS_0", weights}}},
                   {"indices", indices},
                   {"targets", {{{"POSITION", added}}}},
                   {"material", 0}});
    file.json["skins"] = {{{"joints", {1}}}};
    file.json["nodes"][0]["skin"] = 0;
    file.json["nodes"].push_back(Json::object());
    file.json["nodes"].push_back({{"camera", 0}});
    file.json["cameras"] = {
        {{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 0.1}}}}};
    file.json["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "point"}}};
    file.json["nodes"][2]["extensions"]["KHR_lights_punctual"]["light"] = 0;
    file.json["materials"] = {
        {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
    file.json["textures"] = {{{"source", 0}, {"sampler", 0}}};
    file.json["samplers"] = {Json::object()};
    file.json["images"] = {{{"uri", "gone.png"}}};
    file.json["scenes"] = {{{"nodes", {0, 1, 2}}}};
    file.animate(1, "translation", "LINEAR", {0, 1}, file.floats("VEC3", {0, 0, 0, 1, 1, 1}));
    return file;
}

TEST(GltfErrors, TheWholeFileHasNone) {
    const TemporaryFolder folder;
    const auto animation = load_gltf(folder.write("a.gltf", whole_file().text()));
    EXPECT_EQ(animation->at(0.0).mesh.triangles.size(), 2u);
    EXPECT_TRUE(animation->moves());
}

struct Wrong {
    const char* pointer;             // of the member in the file's JSON
    Json value;                      // which it gets; null: it is taken away
    std::vector<std::string> parts;  // of the message
};

void expect_errors(const std::vector<Wrong>& cases) {
    for (const Wrong& wrong : cases) {
        SCOPED_TRACE(std::string(wrong.pointer) + " = " + wrong.value.dump());
        GltfBuilder file = whole_file();
        const Json::json_pointer at(wrong.pointer);
        if (wrong.value.is_null())
            file.json[at.parent_pointer()].erase(at.back());
        else
            file.json[at] = wrong.value;
        std::vector<std::string> parts = wrong.parts;
        parts.push_back("a.gltf: ");
        expect_parts(error_of("a.gltf", file.text()), parts);
    }
}

TEST(GltfErrors, ViewsAndAccessorsStayWithinTheirBytes) {
    expect_errors({
        {"/bufferViews/0/byteLength", 100000, {"bufferViews[0]", "byte 100000", "buffers[0]"}},
        {"/bufferViews/0/byteOffset", 100000, {"bufferViews[0]", "byte 100048"}},
        {"/bufferViews/0/byteOffset", -4, {"bufferViews[0].byteOffset", "-4", "from 0"}},
        {"/bufferViews/0/byteLength", 0, {"bufferViews[0].byteLength", "from 1"}},
        {"/bufferViews/0/byteStride", 3, {"bufferViews[0].byteStride", "from 4 to 252"}},
        {"/bufferViews/0/byteStride", 13, {"bufferViews[0].byteStride", "multiple of 4"}},
        {"/bufferViews/0/byteStride", 8, {"accessors[0]", "12", "8 bytes", "bufferViews[0]"}},
        {"/bufferViews/0/byteStride", 16, {"accessors[0]", "byte 60", "48 bytes"}},
        {"/bufferViews/0/buffer", 1, {"bufferViews[0].buffer", "found 1", "from 0 to 0"}},
        {"/accessors/0/count", 5, {"accessors[0]", "5 elements reach to byte 60", "48 bytes"}},
        {"/accessors/0/count", 0, {"accessors[0].count", "from 1"}},
        {"/accessors/0/count", 4.0, {"accessors[0].count", "without a point"}},
        {"/accessors/0/byteOffset", 4, {"accessors[0]", "byte 52", "48 bytes"}},
        {"/accessors/0/bufferView", 99, {"accessors[0].bufferView", "99", "from 0 to"}},
        {"/accessors/0/bufferView", "0", {"accessors[0].bufferView", "string"}},
        {"/accessors/0/type", "VEC5", {"accessors[0].type", "VEC5", "VEC4"}},
        {"/accessors/0/componentType", 5124, {"accessors[0].componentType", "5124", "5126"}},
        {"/accessors/4/count", 100000000, {"accessors[4].count", "16777216"}},
        {"/accessors/4/sparse/count", 5, {"accessors[4].sparse.count", "from 1 to 4"}},
        {"/accessors/4/sparse/count", 2, {"accessors[4].sparse", "2 elements"}},
        {"/accessors/4/sparse/indices/componentType", 5126, {"sparse.indices", "5121, 5123"}},
        {"/accessors/4/sparse/values/bufferView", 50, {"sparse.values.bufferView", "50"}},
        {"/accessors/4/sparse/values/byteOffset", 4, {"sparse.values", "byte 16", "12 bytes"}},
    });
}

TEST(GltfErrors, IndicesNameWhatIsThere) {
    expect_errors({
        {"/scene", 1, {"scene:", "found 1", "from 0 to 0"}},
        {"/scenes/0/nodes/0", 3, {"scenes[0].nodes[0]", "found 3", "from 0 to 2"}},
        {"/nodes/0/mesh", 1, {"nodes[0].mesh", "from 0 to 0"}},
        {"/nodes/0/mesh", -1, {"nodes[0].mesh", "-1"}},
        {"/nodes/0/skin", 7, {"nodes[0].skin", "7"}},
        {"/nodes/2/camera", 7, {"nodes[2].camera", "7"}},
        {"/nodes/2/extensions/KHR_lights_punctual/light", 1, {"nodes[2].extensions", "light"}},
        {"/meshes/0/primitives/0/attributes/POSITION",
         9,
         {"attributes.POSITION", "from 0 to 6"}},
        {"/meshes/0/primitives/0/indices", 9, {"primitives[0].indices", "from 0 to 6"}},
        {"/meshes/0/primitives/0/material", 1, {"primitives[0].material", "from 0 to 0"}},
        {"/meshes/0/primitives/0/targets/0/POSITION", 9, {"targets[0].POSITION", "9"}},
        {"/meshes/0/primitives/0/mode", 7, {"primitives[0].mode", "from 0 to 6"}},
        {"/materials/0/pbrMetallicRoughness/baseColorTexture/index",
         1,
         {"baseColorTexture.index"}},
        {"/textures/0/source", 1, {"textures[0].source", "1"}},
        {"/textures/0/sampler", 1, {"textures[0].sampler", "1"}},
        {"/samplers/0/wrapS", 5, {"samplers[0].wrapS", "10497"}},
        {"/images/0/bufferView", 0, {"images[0]", "either"}},
        {"/skins/0/joints/0", 3, {"skins[0].joints[0]", "from 0 to 2"}},
        {"/skins/0/inverseBindMatrices", 70, {"skins[0].inverseBindMatrices", "70"}},
        {"/animations/0/channels/0/sampler", 1, {"channels[0].sampler", "from 0 to 0"}},
        {"/animations/0/channels/0/target/node", 3, {"target.node", "from 0 to 2"}},
        {"/animations/0/channels/0/target/path", "color", {"target.path", "color", "weights"}},
        {"/animations/0/samplers/0/input", 70, {"samplers[0].input", "70"}},
        {"/nodes/1/children", {1}, {"nodes[1]", "circle"}},
        {"/nodes/1/children", {2, 2}, {"nodes[1].children[1]", "child of nodes[1] already"}},
    });
}

TEST(GltfErrors, AccessorsAreOfTheRightKindAndLength) {
    expect_errors({
        {"/meshes/0/primitives/0/attributes/POSITION", 3, {"POSITION", "VEC4", "VEC3"}},
        {"/meshes/0/primitives/0/attributes/NORMAL",
         6,
         {"NORMAL", "2 elements", "4 as POSITION"}},
        {"/meshes/0/primitives/0/indices", 5, {"indices", "VEC3", "must be SCALAR"}},
        {"/meshes/0/primitives/0/indices", 6, {"indices", "5126", "5125"}},
        {"/meshes/0/primitives/0/attributes/JOINTS_0", 3, {"JOINTS_0", "5126", "5123"}},
        {"/meshes/0/primitives/0/attributes/WEIGHTS_0", 2, {"WEIGHTS_0", "5121", "normalized"}},
        {"/meshes/0/primitives/0/attributes/WEIGHTS_0", nullptr, {"WEIGHTS_0", "JOINTS_0"}},
        {"/meshes/0/primitives/0/targets/0/POSITION", 6, {"targets[0].POSITION", "4 as"}},
        {"/accessors/1/count", 5, {"primitives[0]", "5 corners", "multiple of 3"}},
        {"/skins/0/inverseBindMatrices", 0, {"inverseBindMatrices", "VEC3", "MAT4"}},
        {"/meshes/0/weights", {1, 2}, {"meshes[0].weights", "2 numbers", "1 morph"}},
        {"/nodes/0/weights", {1, 2}, {"nodes[0].weights", "2 numbers", "1 morph"}},
        {"/animations/0/samplers/0/input", 5, {"samplers[0].input", "VEC3", "SCALAR"}},
        {"/animations/0/samplers/0/output", 6, {"samplers[0].output", "SCALAR", "VEC3"}},
        {"/animations/0/samplers/0/output", 0, {"output", "4 elements", "each of 2 keys"}},
        {"/animations/0/samplers/0/interpolation", "CUBICSPLINE", {"output", "must have 3"}},
        {"/animations/0/samplers/0/interpolation", "HERMITE", {"interpolation", "LINEAR"}},
        {"/animations/0/channels/0/target/path",
         "weights",
         {"channels[0]", "no morph targets"}},
    });
}

TEST(GltfErrors, NumbersKeepToTheirRanges) {
    expect_errors({
        {"/asset/version", "1.0", {"asset.version", "1.0", "2"}},
        {"/asset/minVersion", "2.9", {"asset.minVersion", "2.9", "2.0"}},
        {"/nodes/1/translation", {1, 2}, {"nodes[1].translation", "3 numbers"}},
        {"/nodes/1/rotation", {0, 0, 0, 0}, {"nodes[1].rotation", "not 0"}},
        {"/nodes/1/matrix", {1, 2}, {"nodes[1].matrix", "16 numbers"}},
        {"/materials/0/pbrMetallicRoughness/metallicFactor", 2, {"metallicFactor", "0 to 1"}},
        {"/materials/0/pbrMetallicRoughness/baseColorFactor", {1, 1, 1}, {"4 numbers"}},
        {"/materials/0/pbrMetallicRoughness/baseColorFactor", {1, 1, 1, 9}, {"from 0 to 1"}},
        {"/materials/0/emissiveFactor", {-1, 0, 0}, {"emissiveFactor", "from 0 to 1"}},
        {"/materials/0/alphaMode", "GLOW", {"alphaMode", "BLEND"}},
        {"/cameras/0/perspective/yfov", 4, {"cameras[0].perspective.yfov", "4"}},
        {"/cameras/0/type", "round", {"cameras[0].type", "perspective"}},
        {"/extensions/KHR_lights_punctual/lights/0/type", "area", {"lights[0].type", "spot"}},
        {"/extensions/KHR_lights_punctual/lights/0/intensity", -1, {"lights[0].intensity"}},
        {"/extensions/KHR_lights_punctual/lights/0/type", "spot", {"lights[0]", "\"spot\""}},
        {"/extensionsRequired",
         {"KHR_draco", "EXT_x", "KHR_materials_ior"},
         {"KHR_draco, EXT_x,"}},
    });
}

TEST(GltfErrors, ElementsOfAccessorsNameWhatIsThere) {
    const auto error = [](const std::function<void(GltfBuilder&)>& change) {
        GltfBuilder file = whole_file();
        change(file);
        return error_of("a.gltf", file.text());
    };
    Json primitive = whole_file().json["meshes"][0]["primitives"][0];
    expect_parts(error([&](GltfBuilder& file) {
                     file.json["meshes"][0]["primitives"][0]["indices"] =
                         file.bytes("SCALAR", {0, 1, 4});
                 }),
                 {"meshes[0].primitives[0].indices", "element 2 is 4", "below 4"});
    expect_parts(error([&](GltfBuilder& file) {
                     file.json["meshes"][0]["primitives"][0]["attributes"]["JOINTS_0"] =
                         file.bytes("VEC4", {0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0});
                 }),
                 {"nodes[0]", "vertex 1", "joint 1", "below 1"});
    expect_parts(error([&](GltfBuilder& file) {
                     file.json["meshes"][0]["primitives"][0]["targets"][0]["POSITION"] =
                         file.sparse("VEC3", 4, {4}, {1, 2, 3});
                 }),
                 {"targets[0].POSITION", "sparse.indices[0] is 4", "below 4"});
    expect_parts(
        error([&](GltfBuilder& file) {
            file.json["animations"][0]["samplers"][0]["input"] = file.floats("SCALAR", {1, 1});
        }),
        {"samplers[0].input", "key 1 is 1", "after 1"});
    expect_parts(error([&](GltfBuilder& file) {
                     file.json["animations"][0]["channels"].push_back(
                         file.json["animations"][0]["channels"][0]);
                 }),
                 {"channels[1].target", "translation already"});
    expect_parts(error([&](GltfBuilder& file) {
                     file.json["nodes"][1]["matrix"] = {1, 0, 0, 0, 0, 1, 0, 0,
                                                        0, 0, 1, 0, 0, 0, 0, 1};
                 }),
                 {"channels[0].target", "nodes[1] has a matrix"});
}

TEST(GltfErrors, ContainersPromiseWhatTheyHold) {
    GltfBuilder file = whole_file();
    const std::string glb = file.binary();
    const auto with = [&](size_t at, uint32_t word) {
        std::string changed = glb;
        changed.replace(at, 4, bytes_of<uint32_t>({word}));
        return error_of("a.glb", changed);
    };
    const size_t json_end =
        20 + nlohmann::json::parse(glb.substr(20, glb.rfind('}') - 19)).dump().size();
    const size_t binary = (json_end + 3) / 4 * 4;
    expect_parts(with(4, 1), {"a.glb: ", "version", "is 1", "must be 2"});
    expect_parts(with(8, 12), {"promises 12 bytes", std::to_string(glb.size())});
    expect_parts(with(12, 0x7ffffffc), {"chunk JSON", "2147483644"});
    expect_parts(with(16, 0), {"type of chunk JSON"});
    ASSERT_EQ(glb.substr(binary + 4, 3), "BIN");
    const auto length = static_cast<uint32_t>(glb.size() - binary - 8);
    expect_parts(with(binary, length + 4), {"chunk BIN", std::to_string(length + 4)});
    expect_parts(with(binary, 8), {"buffers[0].byteLength", "at most 8"});
    for (size_t size = 0; size < glb.size(); size += 1 + size / 16)
        EXPECT_NE(error_of("a.glb", glb.substr(0, size)), "") << size << " bytes";
}

TEST(GltfErrors, FilesAreNoJsonOrAreNotThere) {
    expect_parts(error_of("a.gltf", ""), {"a.gltf", "not JSON"});
    expect_parts(error_of("a.gltf", "[]"), {"a.gltf", "an object"});
    expect_parts(error_of("a.gltf", "{}"), {"a.gltf", "asset"});
    expect_parts(error_of("a.gltf", std::string(1000, '[')), {"a.gltf", "100 deep"});
    GltfBuilder file;
    file.add_triangle();
    file.json["buffers"] = {{{"byteLength", 36}, {"uri", "none.bin"}}};
    expect_parts(error_of("a.gltf", file.json.dump()),
                 {"a.gltf", "none.bin", "does not exist"});
    file.json["buffers"][0].erase("uri");
    expect_parts(error_of("a.gltf", file.json.dump()), {"buffers[0].byteLength", "uri"});
}

}  // namespace
}  // namespace render
