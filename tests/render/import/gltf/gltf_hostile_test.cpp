// gltf_hostile_test.cpp - a small glTF file with members of its JSON, or its bytes, changed by chance: it loads
// and can be evaluated, or ends in an error that names it. RSH_HOSTILE_FILES=N tries N of each kind (300).
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <functional>
#include <random>

#include "import/gltf/gltf_animation.hpp"
#include "import/gltf/gltf_builder.hpp"
#include "import/model_bounds.hpp"
#include "temporary_folder.hpp"

namespace render {
namespace {

using Json = nlohmann::json;

// A bit of everything.
GltfBuilder seed() {
    GltfBuilder file;
    const int positions = file.floats("VEC3", {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0});
    const int joints = file.bytes("VEC4", {0, 1, 0, 1, 1, 0, 1, 0, 0, 0, 1, 1, 1, 1, 0, 0});
    const int weights = file.floats("VEC4", std::vector<float>(16, 0.25f));
    file.add_mesh(
        {{"attributes",
          {{"POSITION", positions},
           {"NORMAL", positions},
           {"TEXCOORD_0", file.floats("VEC2", std::vector<float>(8))},
           {"JOINTS_0", joints},
           {"WEIGHTS_0", weights}}},
         {"indices", file.shorts("SCALAR", {0, 1, 2, 1, 3, 2})},
         {"material", 0},
         {"targets", {{{"POSITION", file.sparse("VEC3", 4, {1, 3}, {1, 2, 3, 4, 5, 6})}}}}});
    file.json["materials"] = {
        {{"pbrMetallicRoughness",
          {{"baseColorTexture", {{"index", 0}}}, {"roughnessFactor", 0.5}}}}};
    file.json["textures"] = {{{"source", 0}, {"sampler", 0}}};
    file.json["samplers"] = {{{"wrapS", 33071}}};
    file.json["images"] = {{{"bufferView", file.view("an image")}, {"mimeType", "image/png"}}};
    file.json["nodes"][0]["skin"] = 0;
    file.json["nodes"].push_back({{"children", {2}}, {"mesh", 0}, {"scale", {1, 2, 3}}});
    file.json["nodes"].push_back({{"camera", 0}});
    file.json["nodes"][2]["extensions"]["KHR_lights_punctual"]["light"] = 0;
    file.json["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "point"}}};
    file.json["cameras"] = {
        {{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 0.1}}}}};
    file.json["skins"] = {
        {{"joints", {1, 2}},
         {"inverseBindMatrices", file.floats("MAT4", std::vector<float>(32))}}};
    file.json["scenes"] = {{{"nodes", {0, 1}}}};
    file.json["scene"] = 0;
    file.animate(1, "rotation", "LINEAR", {0, 1},
                 file.floats("VEC4", {0, 0, 0, 1, 1, 0, 0, 0}));
    file.animate(0, "weights", "CUBICSPLINE", {0, 1},
                 file.floats("SCALAR", {0, 1, 2, 3, 4, 5}));
    return file;
}

class Mutator {
public:
    explicit Mutator(uint32_t seed) : random_(seed) {}

    void change(Json& json) {
        Json flat = json.flatten();
        auto member = flat.begin();
        std::advance(member, below(flat.size()));
        const Json::json_pointer at(member.key());
        switch (below(4)) {
            case 0:
                json[at] = odd_value();
                break;
            case 1:
                json[at] =
                    std::next(flat.begin(), static_cast<long>(below(flat.size()))).value();
                break;
            case 2:
                json[at.parent_pointer().empty() ? at : at.parent_pointer()] = odd_value();
                break;
            default:
                erase(json[at.parent_pointer()], at.back());
        }
    }

    void change(std::string& bytes) {
        const size_t at = below(bytes.size());
        switch (below(3)) {
            case 0:
                bytes.resize(at);
                break;
            case 1:
                bytes[at] = static_cast<char>(below(256));
                break;
            default:
                bytes.insert(at, bytes.substr(below(bytes.size()), below(40)));
        }
    }

    size_t below(size_t end) { return end == 0 ? 0 : random_() % end; }

private:
    Json odd_value() {
        const Json values[] = {-1,
                               0,
                               1,
                               2,
                               3,
                               4,
                               5,
                               6,
                               7,
                               16,
                               1.5,
                               1e300,
                               2147483647,
                               2147483648u,
                               4294967296,
                               -2147483649,
                               true,
                               nullptr,
                               "",
                               "SCALAR",
                               "VEC4",
                               Json::array(),
                               Json::object(),
                               Json::array({0, 1}),
                               5121,
                               5125,
                               5126};
        return values[below(std::size(values))];
    }

    static void erase(Json& parent, const std::string& key) {
        if (parent.is_array())
            parent.erase(static_cast<size_t>(std::stoul(key)));
        else
            parent.erase(key);
    }

    std::mt19937 random_;
};

void try_files(const char* name, const std::function<std::string(Mutator&)>& make) {
    const char* wanted = std::getenv("RSH_HOSTILE_FILES");
    const uint32_t rounds = wanted ? static_cast<uint32_t>(std::atoi(wanted)) : 300;
    const TemporaryFolder folder;
    uint32_t loaded = 0;
    for (uint32_t round = 0; round < rounds; ++round) {
        Mutator mutator(round);
        const std::string file = folder.write(name, make(mutator));
        const std::string what = file + ", round " + std::to_string(round);
        const auto start = std::chrono::steady_clock::now();
        try {
            const auto animation = load_gltf(file);
            for (const double time : {-1.0, 0.5, 1.0})
                expect_in_bounds(animation->at(time), what);
            ++loaded;
        } catch (const std::exception& error) {
            EXPECT_NE(std::string(error.what()).find(file), std::string::npos)
                << what << ": " << error.what();
        }
        const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
        EXPECT_LT(taken.count(), 2.0) << what;
        if (testing::Test::HasFatalFailure()) return;
    }
    EXPECT_GT(loaded, 0u) << "none was good enough to be evaluated";
    EXPECT_LT(loaded, rounds) << "none was bad";
}

TEST(GltfHostile, MembersOfTheJson) {
    try_files("a.gltf", [](Mutator& mutator) {
        GltfBuilder file = seed();
        for (size_t i = 1 + mutator.below(3); i > 0; --i) mutator.change(file.json);
        return file.text();
    });
}

TEST(GltfHostile, BytesOfTheBinaryForm) {
    try_files("a.glb", [](Mutator& mutator) {
        std::string bytes = seed().binary();
        mutator.change(bytes);
        return bytes;
    });
}

}  // namespace
}  // namespace render
