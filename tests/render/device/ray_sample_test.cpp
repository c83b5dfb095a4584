// ray_sample_test.cpp - which rays are active, and which of them a sample takes.
#include "device/ray_sample.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

rsh_ray ray(float direction_x, float tmin, float tmax) {
    return {{{0, 0, 0, tmin}}, {{direction_x, 0, 0, tmax}}};
}

TEST(RaySample, KnowsInactiveRays) {
    EXPECT_TRUE(render::is_active(ray(1, 0, INFINITY)));
    EXPECT_TRUE(render::is_active(ray(1, 2, 2)));
    EXPECT_FALSE(render::is_active(ray(0, 0, 1)));
    EXPECT_FALSE(render::is_active(ray(1, 2, 1)));
    EXPECT_FALSE(render::is_active(ray(1, NAN, 1)));
    EXPECT_FALSE(render::is_active(ray(1, 0, NAN)));
    EXPECT_FALSE(render::is_active(ray(INFINITY, 0, 1)));
}

TEST(RaySample, CountsActiveRaysOnly) {
    const rsh_ray on = ray(1, 0, 1), off = ray(0, 0, 1);
    const std::vector<rsh_ray> wave{off, on, off, on, on, on, off, on};
    EXPECT_EQ(render::sample_rays(wave, 1).index, (std::vector<size_t>{1, 3, 4, 5, 7}));
    EXPECT_EQ(render::sample_rays(wave, 2).index, (std::vector<size_t>{1, 4, 7}));
    EXPECT_EQ(render::sample_rays(wave, 9).index, (std::vector<size_t>{1}));
    EXPECT_TRUE(render::sample_rays({off, off}, 1).rays.empty());
}

}  // namespace
