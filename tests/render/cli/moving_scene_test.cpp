// moving_scene_test.cpp - what rsh-render uploads for the second frame and later ones, and what it says of
// times at which nothing moves.
#include <gtest/gtest.h>
#include <rsh/rsh_types.h>

#include "import/gltf/gltf_builder.hpp"
#include "program.hpp"
#include "temporary_folder.hpp"

namespace render {
namespace {

class RenderMovingScene : public testing::Test {
protected:
    // A room, a triangle of a glTF file that moves, and as many that do not as make a gap.
    RenderMovingScene() {
        GltfBuilder file;
        for (int i = 0; i < 201; ++i) file.add_triangle();
        for (size_t i = 0; i < 201; ++i)
            file.json["nodes"][i]["translation"] = {0.01 * i, 1, 1};
        file.animate(100, "translation", "LINEAR", {0, 1},
                     file.floats("VEC3", {0, 1, 2, 1, 1, 2}));
        folder_.write("a.glb", file.binary());
    }
    std::string scene(const std::string& members) const {
        return folder_.write(
                   "scene.json",
                   R"({"meshes": [{"generator": "room", "triangles": 1500, "mirror": "none",
                                             "glass": false}, {"file": "a.glb"}])" +
                       members + "}") +
               " --size 32x32 --bounces 1 ";
    }
    std::string path(const std::string& name) const { return folder_.path(name); }

    std::vector<size_t> uploads(const std::string& members) const {
        const Ended ended = run(scene(members) + " --frames 4 --json " + path("a.json"));
        EXPECT_EQ(ended.status, 0) << ended.printed;
        std::vector<size_t> bytes;
        const auto report = nlohmann::json::parse(content(path("a.json")));
        for (const auto& frame : report.at("frames")) bytes.push_back(frame.at("upload_bytes"));
        return bytes;
    }

    TemporaryFolder folder_;
};

// Three corners without normals.
constexpr size_t kTriangleBytes = 3 * 12;
constexpr size_t kLightBytes = sizeof(rsh_light);

TEST_F(RenderMovingScene, UploadsWhatMoved) {
    // The light over the camera's shoulder, which stays there.
    EXPECT_EQ(uploads(""), (std::vector<size_t>(4, kTriangleBytes)));
}

TEST_F(RenderMovingScene, UploadsLightsThatChange) {
    const std::string light = R"(, "lights": [{"kind": "point", "position": [0, 3, 0]},
        {"kind": "point", "position": [0, 2, 0], "keys": [{"time": 0}, {"time": 0.5, "colour": 2}]}])";
    // Frames at 0, 1/3, 2/3 and 1 s. Two frames at the start go before those that count.
    EXPECT_EQ(uploads(light),
              (std::vector<size_t>{kTriangleBytes, kTriangleBytes + 2 * kLightBytes,
                                   kTriangleBytes + 2 * kLightBytes, kTriangleBytes}));
}

// Of the frames that count, the bounds of the still scene were made before.
TEST_F(RenderMovingScene, KeepsTheBoundsOfWhatStandsStill) {
    const auto bounds_ms = [&](const std::string& scene) {
        const Ended ended = run(scene + " --frames 3 --json " + path("a.json"));
        EXPECT_EQ(ended.status, 0) << ended.printed;
        const auto report = nlohmann::json::parse(content(path("a.json")));
        std::vector<double> ms;
        for (const auto& frame : report.at("frames"))
            ms.push_back(frame.at("stages_ms").at("bound"));
        return ms;
    };
    const std::string still = folder_.write(
        "still.json", R"({"meshes": [{"generator": "room", "triangles": 1500}]})");
    EXPECT_EQ(bounds_ms(still + " --size 32x32"), (std::vector<double>{0, 0, 0}));
    for (const double ms : bounds_ms(scene(""))) EXPECT_GT(ms, 0.0);
}

TEST_F(RenderMovingScene, SaysThatATimeIsOutsideOfTheClip) {
    const auto printed = [&](const std::string& members, const std::string& time) {
        const Ended ended = run(scene(members) + " --out " + path("a.png") + " --time " + time);
        EXPECT_EQ(ended.status, 0) << ended.printed;
        return ended.printed;
    };
    EXPECT_EQ(printed("", "0.5"), "");
    const std::string outside = printed("", "2.5");
    EXPECT_NE(outside.find("warning: --time: "), std::string::npos) << outside;
    EXPECT_NE(
        outside.find("meshes[1]: moves from 0 s to 1 s; at 2.5 s it stands as at its end"),
        std::string::npos)
        << outside;
    const std::string clamped = content(path("a.png"));
    printed("", "1");
    EXPECT_TRUE(content(path("a.png")) == clamped) << "is not the picture of the end";
    EXPECT_EQ(printed(R"(, "settings": {"time": [0, 9]})", "2.5"), "") << "is meant";
}

}  // namespace
}  // namespace render
