// image_output_test.cpp - pictures written and read back.
#include "files/image_output.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "files/image_input.hpp"
#include "temporary_folder.hpp"

namespace {

render::Frame four_pixels() {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    return {2,
            2,
            {0.0f, 0.5f, 1.0f, 1.0f, 0.002f, 0.2158605f, 7.0f, 1.0f, -1.0f, nan, 0.25f, 0.0f,
             1.0f, 1.0f, 1.0f, 1.0f}};
}

TEST(ImageOutput, KeepsLinearFloatsInExr) {
    render::TemporaryFolder folder;
    const std::string path = folder.path("a.exr");
    render::Frame frame = four_pixels();
    frame.pixels[9] = 0.125f;
    folder.write("a.exr", render::encode_image(frame, path));
    const render::Image image = render::load_image(path);
    EXPECT_EQ(image.format, RSH_TEXEL_FLOAT32);
    EXPECT_EQ(image.floats, frame.pixels);
}

TEST(ImageOutput, EncodesSrgbInPngAndClamps) {
    render::TemporaryFolder folder;
    const std::string path = folder.path("a.png");
    folder.write("a.png", render::encode_image(four_pixels(), path));
    const render::Image image = render::load_image(path);
    ASSERT_EQ(image.format, RSH_TEXEL_SRGB8);
    // Linear 0.5 is 187.5 of 255 in sRGB, 0.2158605 is 128, 0.002 is in the linear toe.
    const std::vector<uint8_t> expected{0, 188, 255, 255, 7,   128, 255, 255,
                                        0, 0,   137, 255, 255, 255, 255, 255};
    EXPECT_EQ(image.bytes, expected);
}

TEST(ImageOutput, OfEveryEndingCanBeReadBack) {
    render::TemporaryFolder folder;
    render::Frame frame{64, 48,
                        std::vector<float>(size_t{4} * 64 * 48, 0.2158605f)};  // 128 of 255
    for (const char* ending : {".png", ".exr", ".jpg", ".jpeg", ".tif", ".tiff", ".bmp", ".tga",
                               ".hdr", ".ppm", ".webp", ".PNG"}) {
        const std::string name = std::string("a") + ending;
        const render::Image image =
            render::load_image(folder.write(name, render::encode_image(frame, name)));
        ASSERT_EQ(image.width, 64u) << name;
        ASSERT_EQ(image.height, 48u) << name;
        if (image.format == RSH_TEXEL_SRGB8)
            EXPECT_NEAR(image.bytes[0], 128, 3) << name;
        else
            EXPECT_NEAR(image.floats[0], 0.2158605f, 1e-3) << name;
    }
}

}  // namespace
