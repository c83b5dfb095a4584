// moving_frames_test.cpp - many frames of whatever can move: each is the picture of its time, and after the
// first one nothing is made or compiled, nor does the process grow.
#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>

#include "import/gltf/gltf_builder.hpp"
#include "program.hpp"
#include "temporary_folder.hpp"

namespace render {
namespace {

// A mesh of a scene file that moves from 0 s to 1 s.
struct Format {
    const char* name;
    std::string (*mesh)(const TemporaryFolder& folder);
};

std::ostream& operator<<(std::ostream& out, const Format& format) {
    return out << format.name;
}

// Something that stands still beside it, and all other things that may move.
std::string aff(const TemporaryFolder& folder) {
    folder.write(
        "a.aff",
        "v from 0 1 3 at 0 1 0 up 0 1 0 angle 50 hither .1 resolution 8 8\n"
        "a 0 1 9\nla lamp 0 0 0\ns 1 1 -1 .5\nx t { s 0 0 0 .5 }\n"
        "tpa 2 0 -1 0 0 0 0 1 0 0 0 0 0 1 0 1 0 0 0 1"
        "      1 -1 1 0 0 0 1 0 1 0 1 0 0 0 2 0 0 0 1\n"
        "k t { transl 4 -1 0 1 0 0 0 0  0 0 1 0 0 0 0  1 0 2 0 0 0 0  2 0 2 0 0 0 0\n"
        "rot 4 -1 0 1 0 0 0 0 0  0 0 1 0 0 0 0 0  1 0 1 0 90 0 0 0  2 0 1 0 90 0 0 0 }\n"
        "k lamp { transl 4 -1 0 3 1 0 0 0  0 0 3 1 0 0 0  1 1 3 1 0 0 0  2 1 3 1 0 0 0 }\n"
        "k camera { transl 4 -1 0 1 3 0 0 0  0 0 1 3 0 0 0  1 .5 1 3 0 0 0  2 0 1 3 0 0 0 }\n");
    return R"({"file": "a.aff"})";
}

std::string gltf(const TemporaryFolder& folder) {
    GltfBuilder file;
    file.add_triangle();
    file.add_triangle();
    file.animate(1, "translation", "LINEAR", {0, 1}, file.floats("VEC3", {0, 1, 0, 0, 2, 0}));
    folder.write("a.glb", file.binary());
    return R"({"file": "a.glb"})";
}

std::string vertex_frames(const TemporaryFolder& folder) {
    folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    folder.write("a.f32", bytes_of<float>({0, 0, 0, 1, 0, 0, 0, 1, 0,  //
                                           0, 1, 0, 1, 1, 0, 0, 2, 0}));
    folder.write(
        "a.json",
        R"({"frames": 2, "vertices": 3, "triangles": 1, "time_start": 0, "time_end": 1})");
    return R"({"file": "a.obj", "vertex_frames": "a.f32", "smooth": true})";
}

std::string keys(const TemporaryFolder& folder) {
    folder.write("a.off", "OFF 3 1 0\n0 0 0 1 0 0 0 1 0\n3 0 1 2\n");
    return R"({"file": "a.off", "keys": [{"time": 0}, {"time": 1, "translate": [0, 1, 0]}]})";
}

class MovingFrames : public testing::TestWithParam<Format> {
protected:
    // The program on the moving mesh in a room, at 16x16 pixels.
    void render(const std::string& options, const std::string& environment = "") const {
        const std::string scene = folder_.write(
            "scene.json",
            R"({"meshes": [{"generator": "room", "triangles": 1500, "mirror": "floor"}, )" +
                GetParam().mesh(folder_) + "]}");
        const Ended ended = run(scene + " --size 16x16 --bounces 1 " + options, environment);
        EXPECT_EQ(ended.status, 0) << ended.printed;
    }

    nlohmann::json json(const std::string& name) const {
        return nlohmann::json::parse(content(folder_.path(name)));
    }

    TemporaryFolder folder_;
};

TEST_P(MovingFrames, AreThePicturesOfTheirTimes) {
    render("--frames 5 --out " + folder_.path("frame%d.png"));
    for (const int i : {0, 3, 4}) {
        const std::string alone = folder_.path("alone.png");
        render("--time " + std::to_string(0.25 * i) + " --out " + alone);
        EXPECT_TRUE(content(folder_.path("frame" + std::to_string(i) + ".png")) ==
                    content(alone))
            << "frame " << i;
    }
    EXPECT_FALSE(content(folder_.path("frame0.png")) == content(folder_.path("frame4.png")));
}

// As tests/support/layers/counts.cpp counts, once a first run has filled the cache of programs.
TEST_P(MovingFrames, MakeAndCompileNothingAfterTheFirst) {
    const auto counts = [&](const std::string& frames) {
        render("--frames " + frames + " --out " + folder_.path("%d.png"),
               "env OPENCL_LAYERS='" RSH_COUNTS_LAYER "' RSH_COUNTS='" +
                   folder_.path("counts.json") + "'");
        return json("counts.json");
    };
    counts("1");
    const auto one = counts("1"), seven = counts("7");
    for (const char* word : {"buffers", "bytes_peak", "compiles", "binary_builds", "kernels"})
        EXPECT_EQ(one.at(word), seven.at(word)) << word;
    EXPECT_GT(seven.at("launches"), one.at("launches"));
}

TEST_P(MovingFrames, KeepTheMemoryOfTheProcess) {
    render("--frames 300 --json " + folder_.path("report.json") + " --out " +
           folder_.path("%d.png"));
    const auto report = json("report.json");
    std::vector<size_t> bytes;
    for (const auto& frame : report.at("frames")) bytes.push_back(frame.at("resident_bytes"));
    ASSERT_EQ(bytes.size(), 300u);
    if (bytes[0] == 0) GTEST_SKIP() << "the system does not say how large a process is";
    const size_t most = *std::max_element(bytes.begin(), bytes.end());
    EXPECT_LE(most, bytes[0] + 10'000'000);
}

INSTANTIATE_TEST_SUITE_P(All, MovingFrames,
                         testing::Values(Format{"aff", aff}, Format{"gltf", gltf},
                                         Format{"vertex_frames", vertex_frames},
                                         Format{"keys", keys}),
                         [](const auto& format) { return std::string(format.param.name); });

}  // namespace
}  // namespace render
