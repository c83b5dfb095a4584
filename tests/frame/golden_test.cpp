// golden_test.cpp - whole pictures against committed ones: the only tests that would notice
// when everything agrees with everything and the picture is wrong all the same. Somebody looked
// at them.
//
// RSH_UPDATE_GOLDEN=1 writes the golden pictures anew instead of comparing; look at each of
// them before it is committed. On failure the picture and the difference are written beside the
// program.
#include <gtest/gtest.h>

#include <cstdlib>

#include "frame/picture.hpp"
#include "support/render.hpp"
#include "support/source_tree.hpp"

namespace {

constexpr uint32_t kSide = 128;

// Another device may round otherwise, and a pixel at an edge then changes completely; nearly
// all must agree within two of 255 steps.
constexpr int kStep = 2;
constexpr size_t kWrongPixels = kSide * kSide / 200;
constexpr double kRmse = 2.0;

struct Golden {
    const char* name;
    test::Scene (*make)();
    uint32_t bounces;
};

test::Scene gallery_without_textures() {
    test::Scene scene = test::gallery();
    scene.materials[0].texture = RSH_NO_TEXTURE;
    scene.environment_texture = 0;
    scene.environment = {0.2f, 0.3f, 0.5f};
    return scene;
}

test::Scene gallery_by_one_spot() {
    test::Scene scene = test::gallery();
    scene.lights = {test::spot_light({1, 5, 4}, {-0.2f, -1, -0.7f}, {1.2f, 1.2f, 1.1f})};
    return scene;
}

void PrintTo(const Golden& golden, std::ostream* out) {
    *out << golden.name;
}

size_t wrong_pixels(const test::Picture& a, const test::Picture& b) {
    size_t wrong = 0;
    for (size_t i = 0; i < a.rgb.size(); i += 3) {
        int worst = 0;
        for (size_t c = 0; c < 3; ++c)
            worst = std::max(worst, std::abs(int(a.rgb[i + c]) - int(b.rgb[i + c])));
        wrong += worst > kStep;
    }
    return wrong;
}

double rmse(const test::Picture& a, const test::Picture& b) {
    double sum = 0;
    for (size_t i = 0; i < a.rgb.size(); ++i)
        sum += std::pow(double(a.rgb[i]) - double(b.rgb[i]), 2);
    return std::sqrt(sum / double(a.rgb.size()));
}

class Image : public ::testing::TestWithParam<Golden> {};

TEST_P(Image, LooksLikeTheGoldenOne) {
    if (test::small()) GTEST_SKIP() << "RSH_TEST_SMALL is set: too many pixels for an emulator";
    test::FrameOptions options;
    options.width = options.height = kSide;
    options.bounces = GetParam().bounces;
    const auto colour = test::frame(test::DeviceScene(GetParam().make()), options);
    const test::Picture actual = test::to_picture(colour, kSide, kSide);
    const std::string name = GetParam().name;
    const std::string path =
        (test::source_tree() / "tests/frame/golden" / (name + ".png")).string();
    if (std::getenv("RSH_UPDATE_GOLDEN")) {
        test::write_png(path, actual);
        std::printf("wrote %s: look at it\n", path.c_str());
        return;
    }
    const test::Picture expected = test::read_png(path);
    ASSERT_EQ(expected.width * 10000 + expected.height, kSide * 10000 + kSide) << path;
    const size_t wrong = wrong_pixels(actual, expected);
    const double error = rmse(actual, expected);
    EXPECT_LE(wrong, kWrongPixels) << "pixels differ by more than " << kStep << " of 255";
    EXPECT_LE(error, kRmse) << "root mean square error in steps of 1/255";
    if (!HasFailure()) return;
    test::write_png(name + "-actual.png", actual);
    test::write_png(name + "-difference.png", test::difference(actual, expected));
    std::printf("golden %s, see %s-actual.png and %s-difference.png in the working directory\n",
                path.c_str(), name.c_str(), name.c_str());
}

INSTANTIATE_TEST_SUITE_P(All, Image,
                         ::testing::Values(Golden{"plain", test::plain, 0},
                                           Golden{"gallery", test::gallery, 4},
                                           Golden{"untextured", gallery_without_textures, 1},
                                           Golden{"spot", gallery_by_one_spot, 2}),
                         [](const auto& golden) { return std::string(golden.param.name); });

}  // namespace
