// wrong_buffers_test.cpp - bounds and nodes that were made for something else, or never: no hits,
// nothing outside of buffers, and it is told.
#include <gtest/gtest.h>

#include "support/compare.hpp"
#include "support/rays.hpp"
#include "support/render.hpp"
#include "support/trace.hpp"

namespace {

using test::device;

constexpr uint32_t kWidth = 512, kHeight = 128;

std::vector<cl_uint> engines_over_nodes() {
    std::vector<cl_uint> engines;
    for (cl_uint engine = 1; rsh_engine_name(engine); ++engine)
        if (rsh_engine_shape(engine) != RSH_SHAPE_DEFAULT) engines.push_back(engine);
    return engines;
}

rsh_status device_status() {
    return rsh_device_status(device().rsh, device().queue());
}

template <class Desc>
Desc empty() {
    Desc desc = {};
    desc.struct_size = sizeof desc;
    return desc;
}

// A traversal whose bounds and nodes are made apart; both begin as noise.
class WrongBuffers : public ::testing::TestWithParam<cl_uint> {
protected:
    WrongBuffers() {
        device_status();
        bound_.geometry = traverse_.geometry = mesh_.geometry();
        bound_.shape = build_.shape = traverse_.shape = rsh_engine_shape(GetParam());
        bound_.bounds = traverse_.bounds = bounds_.get();
        build_.rays = traverse_.rays = rays_.get();
        build_.nodes = traverse_.nodes = nodes_.get();
        traverse_.width = kWidth;
        traverse_.height = kHeight;
        traverse_.engine = GetParam();
        traverse_.hits = hits_.get();
    }
    ~WrongBuffers() override { device_status(); }

    void bound() const {
        RSH_CHECK(rsh_bound(device().rsh, device().queue(), &bound_, 0, nullptr, nullptr));
    }

    void build(cl_uint width, cl_uint height) {
        build_.width = width;
        build_.height = height;
        RSH_CHECK(rsh_build(device().rsh, device().queue(), &build_, 0, nullptr, nullptr));
    }

    size_t count_hits() const {
        RSH_CHECK(
            rsh_traverse(device().rsh, device().queue(), &traverse_, 0, nullptr, nullptr));
        size_t found = 0;
        for (const rsh_hit& hit : hits_.read()) found += hit.primitive != RSH_NO_HIT;
        EXPECT_TRUE(hits_.guards_intact());
        EXPECT_TRUE(bounds_.guards_intact());
        EXPECT_TRUE(nodes_.guards_intact());
        return found;
    }

    void expect_no_hits_and_told(const std::string& word) const {
        EXPECT_EQ(count_hits(), 0u);
        EXPECT_EQ(device_status(), RSH_INVALID_VALUE);
        EXPECT_NE(std::string(rsh_last_error()).find(word + ": were not made"),
                  std::string::npos)
            << rsh_last_error();
        EXPECT_EQ(device_status(), RSH_SUCCESS) << "is told once";
    }

    test::Random random_{77};
    test::DeviceMesh mesh_{test::random_soup(random_, 500, 0.4f)};
    test::Buffer<rsh_ray> rays_{test::pinhole_rays(kWidth, kHeight).rays};
    test::Buffer<rsh_hit> hits_{size_t{kWidth} * kHeight};
    test::Buffer<uint8_t> bounds_{std::vector<uint8_t>(1u << 20, 0xa5)};
    test::Buffer<uint8_t> nodes_{std::vector<uint8_t>(8u << 20, 0x5a)};
    rsh_bound_desc bound_ = empty<rsh_bound_desc>();
    rsh_build_desc build_ = empty<rsh_build_desc>();
    rsh_traverse_desc traverse_ = empty<rsh_traverse_desc>();
};

TEST_P(WrongBuffers, AreNotTheRightOnes) {
    bound();
    build(kWidth, kHeight);
    EXPECT_GT(count_hits(), 100u);
    EXPECT_EQ(device_status(), RSH_SUCCESS) << rsh_last_error();
}

TEST_P(WrongBuffers, AreNodesOfAnotherGrid) {
    bound();
    build(256, 256);
    expect_no_hits_and_told("nodes");
}

TEST_P(WrongBuffers, AreNodesOfAList) {
    bound();
    build(kWidth * kHeight, 1);
    expect_no_hits_and_told("nodes");
}

TEST_P(WrongBuffers, AreNodesOfAShorterList) {
    bound();
    build(kWidth * kHeight - 1, 1);
    traverse_.width = kWidth * kHeight;
    traverse_.height = 1;
    expect_no_hits_and_told("nodes");
}

TEST_P(WrongBuffers, AreNodesNeverBuilt) {
    bound();
    expect_no_hits_and_told("nodes");
}

TEST_P(WrongBuffers, AreBoundsNeverMade) {
    build(kWidth, kHeight);
    expect_no_hits_and_told("bounds");
}

TEST_P(WrongBuffers, AreBoundsOfFewerTriangles) {
    bound_.geometry.triangle_count -= 1;
    bound();
    build(kWidth, kHeight);
    expect_no_hits_and_told("bounds");
}

TEST_P(WrongBuffers, AreThoseOfAnotherShape) {
    const bool is_box = traverse_.shape == RSH_SHAPE_BOX;
    bound_.shape = build_.shape = is_box ? RSH_SHAPE_CONE : RSH_SHAPE_BOX;
    bound();
    build(kWidth, kHeight);
    expect_no_hits_and_told("bounds and nodes");
}

TEST_P(WrongBuffers, LeaveOcclusionAsItWas) {
    bound();
    build(256, 256);
    const std::vector<uint32_t> before(size_t{kWidth} * kHeight, 0x10u);
    const test::Buffer<uint32_t> occlusion(before);
    traverse_.query = RSH_QUERY_ANY;
    traverse_.occlusion = occlusion.get();
    RSH_CHECK(rsh_traverse(device().rsh, device().queue(), &traverse_, 0, nullptr, nullptr));
    EXPECT_EQ(occlusion.read(), before);
    EXPECT_EQ(device_status(), RSH_INVALID_VALUE);
}

TEST_P(WrongBuffers, AreInTheStatistics) {
    bound();
    RSH_CHECK(rsh_count_statistics(device().rsh, CL_TRUE));
    count_hits();
    rsh_statistics sums = empty<rsh_statistics>();
    RSH_CHECK(rsh_get_statistics(device().rsh, &sums));
    RSH_CHECK(rsh_count_statistics(device().rsh, CL_FALSE));
    EXPECT_EQ(sums.wrong_buffers, cl_ulong{RSH_WRONG_NODES});
}

INSTANTIATE_TEST_SUITE_P(All, WrongBuffers, ::testing::ValuesIn(engines_over_nodes()),
                         [](const auto& engine) {
                             return std::string(rsh_engine_name(engine.param));
                         });

// A frame that refits what was never made gets bounds, and says so where it waits.
TEST(WrongBuffersOfFrames, AreAnError) {
    test::Scene host = test::plain();
    host.materials[0].reflection = {{0.5f, 0.5f, 0.5f, 0}};
    const test::DeviceScene scene(host);
    const test::Buffer<uint8_t> bounds(std::vector<uint8_t>(1u << 20, 0xa5));
    test::FrameOptions options;
    options.width = options.height = 16;
    options.bounces = 1;
    options.engine = RSH_ENGINE_TILES;
    options.bounds = bounds.get();
    options.update = RSH_BOUND_REFIT;
    EXPECT_THROW(test::frame(scene, options), std::exception);
    EXPECT_NE(std::string(rsh_last_error()).find("bounds: were not made"), std::string::npos)
        << rsh_last_error();
    device().queue.finish();
    EXPECT_NO_THROW(test::frame(scene, options)) << "they are made by now";
    EXPECT_TRUE(bounds.guards_intact());
}

}  // namespace
