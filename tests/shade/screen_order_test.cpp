// screen_order_test.cpp - the places of a wave name each ray of a screen once, square by square, row
// by row, and along Hilbert's curve in each, which goes from pixel to neighbouring pixel. What a wave
// holds, and every picture, is right without that; only packets are slower.
#include <gtest/gtest.h>

#include <cstdlib>

#include "rays/types.h"
#include "shade/types.h"
#include "support/buffer.hpp"
#include "support/random.hpp"
#include "support/source_tree.hpp"

namespace {

const char* const kSource = R"(
#include "shade/screen_order.h"

__kernel void list_places(wave_part wave, __global uint* ray)
{
    const uint at = RSH_WIDTH * (uint)get_global_id(0);
    uint index[RSH_WIDTH];
    rays_at_places(wave, wave.first + at, wave.first + wave.count, index);
    for (uint k = 0; k < RSH_WIDTH; ++k) ray[at + k] = index[k];
}
)";

class Places {
public:
    explicit Places(uint32_t lanes) : lanes_(lanes), program_(test::device().context, kSource) {
        const std::string tree = test::source_tree().string();
        const std::string options = "-cl-std=CL1.2 -I " + tree + "/kernels -I " + tree +
                                    "/include -D RSH_WIDTH=" + std::to_string(lanes);
        try {
            program_.build({test::device().device}, options.c_str());
        } catch (const cl::BuildError& error) {
            for (const auto& log : error.getBuildLog()) ADD_FAILURE() << log.second;
            throw;
        }
        kernel_ = cl::Kernel(program_, "list_places");
    }

    // The rays at the places of a part, and as many places behind them as fill the last vector.
    std::vector<uint32_t> rays_of(const wave_part& part) {
        const uint32_t items = part.count / lanes_ + 1;
        const test::Buffer<uint32_t> rays(size_t{items} * lanes_);
        kernel_.setArg(0, part);
        const cl_mem ray = rays.get();
        kernel_.setArg(1, sizeof ray, &ray);
        test::device().queue.enqueueNDRangeKernel(kernel_, cl::NullRange, items);
        EXPECT_TRUE(rays.guards_intact());
        return rays.read();
    }

private:
    uint32_t lanes_;
    cl::Program program_;
    cl::Kernel kernel_;
};

constexpr uint32_t kSide = RSH_SCREEN_SQUARE, kSquare = kSide * kSide;

wave_part places_of_screen(uint32_t width, uint32_t height) {
    const uint32_t columns = (width + kSide - 1) / kSide, rows = (height + kSide - 1) / kSide;
    return {width, height, 0, columns * rows * kSquare};
}

void expect_each_ray_once(const wave_part& screen, const std::vector<uint32_t>& rays) {
    std::vector<uint32_t> times(size_t{screen.width} * screen.height);
    for (size_t place = 0; place < rays.size(); ++place) {
        if (rays[place] == RSH_NO_RAY) continue;
        ASSERT_LT(rays[place], times.size()) << "place " << place;
        ++times[rays[place]];
    }
    for (size_t ray = 0; ray < times.size(); ++ray) ASSERT_EQ(times[ray], 1u) << "ray " << ray;
}

void expect_curve_in_squares(const wave_part& screen, const std::vector<uint32_t>& rays) {
    const uint32_t columns = (screen.width + kSide - 1) / kSide;
    for (uint32_t place = 0; place < screen.count; ++place) {
        if (rays[place] == RSH_NO_RAY) continue;
        const uint32_t x = rays[place] % screen.width, y = rays[place] / screen.width;
        ASSERT_EQ(y / kSide * columns + x / kSide, place / kSquare)
            << "square of pixel " << x << ", " << y << ", at place " << place;
        if (place % kSquare == 0 || rays[place - 1] == RSH_NO_RAY) continue;
        const uint32_t last_x = rays[place - 1] % screen.width,
                       last_y = rays[place - 1] / screen.width;
        ASSERT_EQ(std::abs(int(x - last_x)) + std::abs(int(y - last_y)), 1)
            << "steps from pixel " << last_x << ", " << last_y << " to " << x << ", " << y
            << ", at place " << place;
    }
}

// Parts begin and end anywhere: what is at a place does not depend on them, and nothing is beyond.
void expect_same_in_parts(Places& places, const wave_part& whole,
                          const std::vector<uint32_t>& rays) {
    test::Random random(whole.width);
    for (int i = 0; i < 5; ++i) {
        wave_part part = whole;
        part.first = random.below(whole.count);
        part.count = 1 + random.below(whole.count - part.first);
        const std::vector<uint32_t> found = places.rays_of(part);
        for (uint32_t place = 0; place < found.size(); ++place)
            ASSERT_EQ(found[place], place < part.count ? rays[part.first + place] : RSH_NO_RAY)
                << "place " << place << " of the part from " << part.first << " on";
    }
}

class ScreenOrder : public ::testing::TestWithParam<uint32_t> {};

TEST_P(ScreenOrder, GoesFromPixelToNeighbourInEachSquare) {
    Places places(GetParam());
    std::vector<wave_part> screens = {places_of_screen(kSide + 3, 2)};
    if (!test::small()) {
        screens.push_back(places_of_screen(kSide, kSide));
        screens.push_back(places_of_screen(3 * kSide, 2 * kSide));
        screens.push_back(places_of_screen(2 * kSide - 1, 3 * kSide + 1));
    }
    for (const wave_part& screen : screens) {
        SCOPED_TRACE(std::to_string(screen.width) + " x " + std::to_string(screen.height));
        const std::vector<uint32_t> rays = places.rays_of(screen);
        expect_each_ray_once(screen, rays);
        expect_curve_in_squares(screen, rays);
        expect_same_in_parts(places, screen, rays);
    }
}

TEST_P(ScreenOrder, IsThatOfTheRaysInAPackedWave) {
    Places places(GetParam());
    const wave_part wave = {1009, 1, 0, 1009};
    const std::vector<uint32_t> rays = places.rays_of(wave);
    for (uint32_t place = 0; place < wave.count; ++place) ASSERT_EQ(rays[place], place);
    expect_same_in_parts(places, wave, rays);
}

INSTANTIATE_TEST_SUITE_P(Lanes, ScreenOrder, ::testing::Values(1, 4, 8, 16),
                         ::testing::PrintToStringParamName());

}  // namespace
