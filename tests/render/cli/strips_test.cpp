// strips_test.cpp - pictures that rsh-render makes in strips: their bytes, their sums, their memory.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "program.hpp"
#include "temporary_folder.hpp"

namespace render {
namespace {

constexpr int kRows = 205;  // three strips and a bit

class RenderStrips : public testing::Test {
protected:
    RenderStrips() {
        scene_ = folder_.write("scene.json",
                               R"({"meshes": [{"generator": "room", "triangles": 1500}]})") +
                 " --size 61x" + std::to_string(kRows) + " --bounces 2 ";
    }
    std::string path(const std::string& name) const { return folder_.path(name); }

    std::string picture(const std::string& options, const std::string& name) {
        const Ended ended =
            run(scene_ + options + " --out " + path(name) + " --json " + path("a.json"));
        EXPECT_EQ(ended.status, 0) << options << ": " << ended.printed;
        return content(path(name));
    }
    nlohmann::json frame() const {
        return nlohmann::json::parse(content(path("a.json"))).at("frames").at(0);
    }

    // The least --budget with these options, as the error of one byte names it.
    std::string least(const std::string& options) {
        const Ended ended = run(scene_ + options + " --budget 1 --stats");
        EXPECT_EQ(ended.status, 1);
        const std::string before = "at least ";
        const size_t at = ended.printed.find(before);
        if (at == std::string::npos) ADD_FAILURE() << "names no least: " << ended.printed;
        return std::to_string(std::stoull("0" + ended.printed.substr(at + before.size())));
    }

    TemporaryFolder folder_;
    std::string scene_;
};

TEST_F(RenderStrips, HaveTheBytesOfThePicture) {
    for (const std::string engine : {"tiles", "paper", "paper_faithful"}) {
        const std::string options = "--engine " + engine;
        const std::string whole = picture(options, "whole.png");
        const uint64_t in_one = frame().at("traversals");
        const std::string budget = " --budget " + least(options);
        EXPECT_TRUE(picture(options + budget, "strips.png") == whole) << engine;
        EXPECT_GT(frame().at("traversals"), 2 * in_one) << engine << ": was not cut";
    }
}

TEST_F(RenderStrips, HaveTheFloatsOfThePicture) {
    const auto pixels = [&](const std::string& options) {
        // Without the head, which has the time.
        return picture(options, "a.exr").substr(1024);
    };
    EXPECT_TRUE(pixels("--budget " + least("")) == pixels(""));
}

// As tests/support/layers/counts.cpp counts; the scene and its bounds come on top.
TEST_F(RenderStrips, KeepToTheBudget) {
    const auto peak_bytes = [&](const std::string& options) {
        const Ended ended = run(
            path("scene.json") + " --size 512x512 --bounces 2 --out " + path("a.png") + options,
            "env OPENCL_LAYERS='" RSH_COUNTS_LAYER "' RSH_COUNTS='" + path("counts.json") +
                "'");
        EXPECT_EQ(ended.status, 0) << ended.printed;
        return nlohmann::json::parse(content(path("counts.json"))).at("bytes_peak").get<int>();
    };
    constexpr int kMiB = 1 << 20;
    EXPECT_LT(peak_bytes(" --budget 40M"), 41 * kMiB);
    EXPECT_GT(peak_bytes(""), 60 * kMiB);
}

TEST_F(RenderStrips, AddUpTheirRays) {
    picture("", "a.png");
    const nlohmann::json whole = frame();
    picture("--budget " + least(""), "a.png");
    for (const char* sum : {"active_rays", "shadow_rays"})
        EXPECT_EQ(frame().at(sum), whole.at(sum)) << sum;
}

TEST_F(RenderStrips, AreCheckedAsThePictureIs) {
    const std::string whole = run(scene_ + "--check 1").printed;
    EXPECT_NE(whole.find("hits differ"), std::string::npos) << whole;
    EXPECT_EQ(run(scene_ + "--check 1 --budget " + least("")).printed, whole);
}

TEST_F(RenderStrips, NeedTheLeastBudgetThatIsNamed) {
    const uint64_t bytes = std::stoull(least(""));
    EXPECT_EQ(run(scene_ + "--stats --budget " + std::to_string(bytes)).status, 0);
    EXPECT_EQ(run(scene_ + "--stats --budget " + std::to_string(bytes - 1)).status, 1);
}

}  // namespace
}  // namespace render
