// strips_test.cpp - a frame in strips, and a window of a picture, have the picture's bits.
#include <gtest/gtest.h>

#include <algorithm>

#include "support/compare.hpp"
#include "support/render.hpp"
#include "support/ways.hpp"

namespace {

using test::FrameOptions;

TEST(Strips, GiveTheSameBytes) {
    const test::OwnContext context;
    const test::DeviceScene scene(test::gallery());
    FrameOptions options;
    options.width = test::small() ? 5 : 61;
    options.height = 205;  // three strips and a bit
    options.bounces = 2;
    options.context = context.get();
    RSH_CHECK(rsh_count_statistics(context.get(), CL_TRUE));
    const auto traversals = [&] {
        rsh_statistics s = {};
        s.struct_size = sizeof s;
        RSH_CHECK(rsh_get_statistics(context.get(), &s));
        RSH_CHECK(rsh_count_statistics(context.get(), CL_TRUE));
        return s.traversals;
    };
    for (const test::TraceOptions& way : test::all_ways()) {
        SCOPED_TRACE(name_of(way));
        options.engine = way.engine;
        options.budget = 0;
        const auto whole = test::frame(scene, options);
        const cl_ulong in_one = traversals(), least = test::least_budget(scene, options);
        for (const bool own_scratch : {false, true})
            for (const size_t budget : {least, least + least / 2, 2 * least, 3 * least}) {
                options.own_scratch = own_scratch;
                options.budget = budget;
                EXPECT_TRUE(test::same_bits(test::frame(scene, options), whole, "pixels"))
                    << "budget " << budget;
                const cl_ulong in_strips = traversals();
                if (budget == least) {
                    EXPECT_GT(in_strips, 2 * in_one) << "it was not cut into strips";
                }
            }
    }
}

// What is named as the least suffices, also where it has room for streams of which another strategy
// would be chosen than of those of a smaller budget.
TEST(Strips, TakeTheLeastBudgetThatIsNamed) {
    const test::DeviceScene scene(test::gallery());
    FrameOptions options;
    options.height = 192;
    options.bounces = 2;
    for (const test::TraceOptions& way : test::all_ways())
        for (const uint32_t width : {5u, 61u, 512u, 640u, 1024u, 2048u, 8192u}) {
            SCOPED_TRACE(name_of(way) + ", width " + std::to_string(width));
            options.engine = way.engine;
            options.width = width;
            EXPECT_GT(test::least_budget(scene, options), 0u);
        }
}

TEST(Strips, GiveTheSameBytesWhereTheLastOneIsARow) {
    const test::DeviceScene scene(test::gallery());
    FrameOptions options;
    options.width = test::small() ? 5 : 61;
    options.height = 129;
    for (const test::TraceOptions& way : test::all_ways()) {
        SCOPED_TRACE(name_of(way));
        options.engine = way.engine;
        options.budget = 0;
        options.own_scratch = false;
        const auto whole = test::frame(scene, options);
        options.budget = test::least_budget(scene, options);
        options.own_scratch = true;
        EXPECT_TRUE(test::same_bits(test::frame(scene, options), whole, "pixels"));
    }
}

TEST(Window, HasTheBitsOfThePicture) {
    const test::DeviceScene scene(test::gallery());
    FrameOptions whole;
    whole.width = test::small() ? 16 : 83;
    whole.height = test::small() ? 12 : 71;
    whole.bounces = 2;
    const auto picture = test::frame(scene, whole);
    const rsh_camera camera = test::gallery_camera(whole.width, whole.height);
    const uint32_t w = whole.width, h = whole.height;
    const uint32_t windows[][4] = {{0, 0, w, h},
                                   {0, 0, 1, 1},
                                   {w - 1, h - 1, 1, 1},
                                   {3, 5, w - 7, h - 6},
                                   {0, h / 2, w, 2}};
    for (const auto& [x, y, width, height] : windows) {
        SCOPED_TRACE(std::to_string(width) + " x " + std::to_string(height) + " at " +
                     std::to_string(x) + ", " + std::to_string(y));
        FrameOptions part = whole;
        part.width = width;
        part.height = height;
        part.camera = &camera;
        part.window = {x, y, w, h};
        std::vector<cl_float4> expected;
        for (uint32_t row = y; row < y + height; ++row)
            expected.insert(expected.end(), picture.begin() + row * w + x,
                            picture.begin() + row * w + x + width);
        EXPECT_TRUE(test::same_bits(test::frame(scene, part), expected, "pixels"));
    }
}

}  // namespace
