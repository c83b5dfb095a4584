// metrics_test.cpp - errors of pictures that are known, and FLIP as its authors' program computes it.
#include <gtest/gtest.h>

#include "accuracy/edges.hpp"
#include "accuracy/flip.hpp"
#include "accuracy/picture_errors.hpp"

namespace {

using namespace bench::accuracy;
using test::Double3;

Image plain(uint32_t width, uint32_t height, Double3 colour) {
    return {width, height, std::vector<Double3>(size_t(width) * height, colour)};
}

// 32x24 with a gradient, a disc and stripes; flip_figures.py makes the same.
Image pattern(double shift) {
    Image image = {32, 24, {}};
    for (int y = 0; y < 24; ++y)
        for (int x = 0; x < 32; ++x) {
            Double3 p(x / 31.0, y / 23.0, 0.25);
            if (std::pow(x - 10 - shift, 2) + std::pow(y - 12.0, 2) < 36) p = {0.9, 0.2, 0.1};
            if (x > 22 && (x + y) % 3 == 0) p = {0.1 + 0.2 * shift, 0.6, 0.8};
            image.pixels.push_back(p);
        }
    return image;
}

std::vector<double> flip_of(const Image& a, const Image& b,
                            double pixels_per_degree = kPixelsPerDegree) {
    return flip(flip_side(a, pixels_per_degree), flip_side(b, pixels_per_degree));
}

PictureErrors compared(const Image& a, const Image& b, const std::vector<bool>& is_edge) {
    return compare(Shown(a), Shown(b), is_edge);
}

double mean(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values) sum += value;
    return sum / double(values.size());
}

TEST(Image, IsAveragedOverSquares) {
    Image image = {4, 2, {}};
    for (int i = 0; i < 8; ++i) image.pixels.push_back({double(i), 0, 1});
    const Image half = averaged(image, 2);
    ASSERT_EQ(half.pixels.size(), 2u);
    EXPECT_EQ(half.pixels[0].x, (0 + 1 + 4 + 5) / 4.0);
    EXPECT_EQ(half.pixels[1].x, (2 + 3 + 6 + 7) / 4.0);
    EXPECT_EQ(half.pixels[1].z, 1);
}

TEST(Image, IsInterpolatedBetweenCentres) {
    const Image two = {2, 1, {{0, 0, 0}, {1, 1, 1}}};
    const Image four = interpolated(two, 4, 2);
    const double expected[4] = {0, 0.25, 0.75, 1};
    for (int i = 0; i < 8; ++i) EXPECT_EQ(four.pixels[size_t(i)].x, expected[i % 4]) << i;
}

TEST(Image, IsClippedAndEncodedForAScreen) {
    const Image shown = to_srgb({3, 1, {{-1, 0, 0.001}, {0.5, 1, 3}, {0.2, 0.2, 0.2}}});
    EXPECT_EQ(shown.pixels[0].x, 0);
    EXPECT_NEAR(shown.pixels[0].z, 0.01292, 1e-12);
    EXPECT_NEAR(shown.pixels[1].x, 0.735357, 1e-6);
    EXPECT_DOUBLE_EQ(shown.pixels[1].z, 1);
    EXPECT_EQ(in_255(shown.pixels[2].x), 124);
}

TEST(PictureErrors, AreNoneOfThePictureItself) {
    const Image image = pattern(0);
    const PictureErrors e = compared(image, image, std::vector<bool>(32 * 24));
    EXPECT_EQ(e.rmse + e.rmse_inside + e.wrong_pixels + e.flip + e.flip_above, 0);
}

// A quarter of the pixels is off by 0.1 in one of three channels; all of these are at edges.
TEST(PictureErrors, CountInsideWhatIsAtNoEdge) {
    const Image reference = plain(8, 8, {0, 0, 0});
    Image shown = reference;
    std::vector<bool> is_edge(64);
    for (size_t i = 0; i < 16; ++i) {
        shown.pixels[i].y = 0.01002282557;  // 0.1 in sRGB
        is_edge[i] = true;
    }
    const PictureErrors e = compared(reference, shown, is_edge);
    EXPECT_NEAR(e.rmse, std::sqrt(0.01 / 3 / 4), 1e-9);
    EXPECT_EQ(e.wrong_pixels, 0.25);
    EXPECT_EQ(e.rmse_inside, 0);
    EXPECT_EQ(e.wrong_inside, 0);
}

TEST(PictureErrors, ForgiveTwoStepsOf255) {
    const Image a = plain(2, 1, {1, 1, 1});
    Image b = a;
    b.pixels[0].x = 0.98230;  // 253
    b.pixels[1].x = 0.97345;  // 252
    EXPECT_EQ(compared(a, b, {false, false}).wrong_pixels, 0.5);
}

TEST(Edges, AreWhereTheMaterialOrTheDepthChanges) {
    std::vector<Seen> seen(5 * 3);
    for (int i = 0; i < 15; ++i) {
        seen[size_t(i)] = {7, {0.3 * (i % 5), 0.3 * (i / 5), 0}, {0, 0, 1}, 10};
        if (i % 5 == 4) seen[size_t(i)].material = 8;
    }
    std::vector<bool> is_edge = find_edges(seen, 5);
    for (int i = 0; i < 15; ++i) EXPECT_EQ(is_edge[size_t(i)], i % 5 >= 3) << i;
    for (int i = 0; i < 15; ++i) {
        seen[size_t(i)].material = 7;
        if (i / 5 == 0) seen[size_t(i)].point.z = 0.21;  // more than 2 % of 10
    }
    is_edge = find_edges(seen, 5);
    for (int i = 0; i < 15; ++i) EXPECT_EQ(is_edge[size_t(i)], i / 5 <= 1) << i;
}

// Of black and white the largest, and of equal pictures nothing.
TEST(Flip, ReachesFromNoneToAlmostAll) {
    EXPECT_EQ(mean(flip_of(pattern(1), pattern(1))), 0);
    EXPECT_NEAR(mean(flip_of(plain(8, 8, {0, 0, 0}), plain(8, 8, {1, 1, 1}))), 0.967388, 1e-5);
}

// What flip_figures.py printed, by flip-evaluator 1.7.
TEST(Flip, IsThatOfItsAuthorsProgram) {
    const std::vector<double> map = flip_of(pattern(0), pattern(1));
    EXPECT_NEAR(mean(map), 0.089489, 1e-5);
    const struct {
        size_t x, y;
        double flip;
    } some[] = {{5, 12, 0.507002}, {16, 12, 0.437972}, {17, 7, 0.108967},
                {25, 3, 0.083627}, {31, 23, 0.110505}, {0, 0, 0.000344}};
    for (const auto& pixel : some)
        EXPECT_NEAR(map[pixel.y * 32 + pixel.x], pixel.flip, 1e-5)
            << pixel.x << ", " << pixel.y;
    EXPECT_NEAR(mean(flip_of(pattern(0), pattern(1), 30)), 0.077142, 1e-5);
}

}  // namespace
