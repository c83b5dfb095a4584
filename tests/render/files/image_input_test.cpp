// image_input_test.cpp - what the numbers in a picture mean: colour space, depth, alpha.
#include "files/image_input.hpp"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "files/png_bytes.hpp"
#include "temporary_folder.hpp"

namespace render {
namespace {

using Colour = std::array<float, 3>;

// 200, 100, 50 of 255 by sRGB's curve.
constexpr Colour kLinear{0.57758f, 0.12744f, 0.03190f};
constexpr Colour kStored{0.78431f, 0.39216f, 0.19608f};

double linear_byte(int byte) {
    const double x = byte / 255.0;
    return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
}

Colour first_pixel(const Image& image) {
    if (image.format == RSH_TEXEL_FLOAT32)
        return {image.floats.at(0), image.floats.at(1), image.floats.at(2)};
    Colour colour;
    for (int c = 0; c < 3; ++c) colour[c] = static_cast<float>(linear_byte(image.bytes.at(c)));
    return colour;
}

void expect_colour(const std::string& path, const Colour& right, double tolerance = 5e-5) {
    const Colour found = first_pixel(load_image(path));
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(found[c], right[c], tolerance) << path << ", channel " << c;
}

std::string words(std::initializer_list<int> bytes) {  // each byte as 16 bits of the same share
    std::string text;
    for (const int byte : bytes) text += std::string(2, static_cast<char>(byte));
    return text;
}

std::string gamma(uint32_t times_100000) {
    return png_chunk("gAMA", big_endian(times_100000));
}

const std::string kRgb = "\xc8\x64\x32";  // 200, 100, 50

TEST(ImageInput, IntegersOfAnyDepthAreSrgb) {
    const TemporaryFolder folder;
    expect_colour(folder.write("8.png", png_file({2, 2, 8, 2}, kRgb)), kLinear);
    expect_colour(folder.write("16.png", png_file({2, 2, 16, 2}, words({200, 100, 50}))),
                  kLinear);
    expect_colour(folder.write("grey16.png", png_file({3, 1, 16, 0}, words({200}))),
                  {kLinear[0], kLinear[0], kLinear[0]});
    expect_colour(folder.write("16.ppm", "P6\n1 1\n65535\n" + words({200, 100, 50})), kLinear);
}

TEST(ImageInput, AFileMaySayThatItsIntegersAreNotSrgb) {
    const TemporaryFolder folder;
    expect_colour(folder.write("g1.png", png_file({}, kRgb, gamma(100000))), kStored);
    expect_colour(folder.write("g1_16.png",
                               png_file({2, 2, 16, 2}, words({200, 100, 50}), gamma(100000))),
                  kStored);
    const auto power = [](float g) {
        return Colour{std::pow(kStored[0], g), std::pow(kStored[1], g),
                      std::pow(kStored[2], g)};
    };
    expect_colour(folder.write("g1.8.png", png_file({}, kRgb, gamma(55556))), power(1.8f));
    expect_colour(folder.write("g2.6.png", png_file({}, kRgb, gamma(38462))), power(2.6f));
    // What stands beside sRGB's own chunk, or for it, is sRGB.
    expect_colour(folder.write("g2.2.png", png_file({}, kRgb, gamma(45455))), kLinear);
    expect_colour(
        folder.write("both.png", png_file({}, kRgb, gamma(100000) + png_chunk("sRGB", {'\0'}))),
        kLinear);
}

TEST(ImageInput, AlphaDoesNotTouchTheColour) {
    const TemporaryFolder folder;
    for (const int alpha : {0, 1, 128, 255}) {
        const std::string a(1, static_cast<char>(alpha));
        const std::string name = std::to_string(alpha);
        expect_colour(folder.write(name + ".png", png_file({2, 2, 8, 6}, kRgb + a)), kLinear);
        expect_colour(folder.write(name + "_16.png",
                                   png_file({2, 2, 16, 6}, words({200, 100, 50, alpha}))),
                      kLinear);
        expect_colour(folder.write(name + "_grey.png", png_file({2, 2, 8, 4}, "\xc8" + a)),
                      {kLinear[0], kLinear[0], kLinear[0]});
        expect_colour(folder.write(name + "_palette.png",
                                   png_file({2, 2, 8, 3}, {'\0'},
                                            png_chunk("PLTE", kRgb) + png_chunk("tRNS", a))),
                      kLinear);
    }
    // Uncompressed TGA, 1 x 1, 32 bits with 8 of alpha: b, g, r, a.
    const std::string head("\0\0\2\0\0\0\0\0\0\0\0\0\1\0\1\0\x20\x28", 18);
    expect_colour(folder.write("half.tga", head + "\x32\x64\xc8\x80"), kLinear);
}

// Writes one pixel with half of alpha by OpenImageIO.
std::string write_by_oiio(const std::string& path, OIIO::TypeDesc type,
                          const Colour& colour = kStored) {
    OIIO::ImageSpec spec(1, 1, 4, type);
    spec.attribute("oiio:UnassociatedAlpha", 1);
    const float pixel[4] = {colour[0], colour[1], colour[2], 0.5f};
    const auto output = OIIO::ImageOutput::create(path);
    EXPECT_TRUE(output && output->open(path, spec) &&
                output->write_image(OIIO::TypeDesc::FLOAT, pixel) && output->close())
        << path;
    return path;
}

TEST(ImageInput, OtherFormatsMeanTheSame) {
    const TemporaryFolder folder;
    const auto path = [&](const char* name) { return folder.path(name); };
    expect_colour(write_by_oiio(path("8.tif"), OIIO::TypeDesc::UINT8), kLinear);
    expect_colour(write_by_oiio(path("16.tif"), OIIO::TypeDesc::UINT16), kLinear);
    expect_colour(write_by_oiio(path("8.bmp"), OIIO::TypeDesc::UINT8), kLinear);
    expect_colour(write_by_oiio(path("16.sgi"), OIIO::TypeDesc::UINT16), kLinear);
    expect_colour(write_by_oiio(path("float.tif"), OIIO::TypeDesc::FLOAT), kStored);
    expect_colour(write_by_oiio(path("float.exr"), OIIO::TypeDesc::FLOAT), kStored);
    expect_colour(write_by_oiio(path("half.exr"), OIIO::TypeDesc::HALF), kStored, 5e-4);
}

TEST(ImageInput, CompressedFilesMeanTheSame) {
    const TemporaryFolder folder;
    const std::string half = png_file({2, 2, 8, 6}, kRgb + "\x80");
    const std::string deep = png_file({2, 2, 16, 2}, words({200, 100, 50}));
    folder.write_xz("half.png.xz", half);
    expect_colour(folder.path("half.png"), kLinear);
    expect_colour(folder.path("half.png.xz"), kLinear);
    const std::string archive = folder.write_tar_xz("a.tar.xz", {{"16.png", deep}});
    expect_colour(archive + ":16.png", kLinear);
    const std::string tga("\0\0\2\0\0\0\0\0\0\0\0\0\1\0\1\0\x20\x28\x32\x64\xc8\x80", 22);
    folder.write_xz("half.tga.xz", tga);
    expect_colour(folder.path("half.tga"), kLinear);
}

// Its writer in OpenImageIO takes colours that are multiplied by alpha, at a gamma of 2.2; what is
// stored loses some bits.
TEST(ImageInput, AlphaDoesNotTouchTheColourOfWebp) {
    if (!OIIO::ImageOutput::create("x.webp")) GTEST_SKIP() << "OpenImageIO without WebP";
    const TemporaryFolder folder;
    Colour colour = kStored;
    for (float& channel : colour) channel *= std::pow(0.5f, 1 / 2.2f);
    expect_colour(write_by_oiio(folder.path("8.webp"), OIIO::TypeDesc::UINT8, colour), kLinear,
                  0.03);
}

std::string error_of(const std::string& path, size_t max_pixels) {
    try {
        load_image(path, max_pixels);
    } catch (const std::exception& error) {
        return error.what();
    }
    return "";
}

TEST(ImageInput, RefusesMorePixelsThanAllowedByTheHeadAlone) {
    const TemporaryFolder folder;
    const auto head_of = [](uint32_t side) {
        return png_chunk(
            "IHDR", big_endian(side) + big_endian(side) + std::string("\x08\x02\0\0\0", 5));
    };
    const std::string start = "\x89PNG\r\n\x1a\n";
    const std::string lie =
        start + head_of(33000) + png_chunk("IDAT", "") + png_chunk("IEND", "");
    const std::string png = folder.write("lie.png", lie);
    const std::string hdr =
        folder.write("lie.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 33000 +X 33000\n");
    const std::string pnm = folder.write("lie.pgm", "P5\n33000 33000\n255\n");
    for (const std::string& path : {png, hdr, pnm})
        for (const char* part :
             {path.c_str(), "33000 x 33000", "134217728", "--max-texture-pixels"})
            EXPECT_NE(error_of(path, kMaxTexturePixels).find(part), std::string::npos)
                << '"' << part << "\" is not in: " << error_of(path, kMaxTexturePixels);
}

TEST(ImageInput, ReadsAsManyPixelsAsAllowed) {
    const TemporaryFolder folder;
    const std::string path = folder.write("6.png", png_file({3, 2, 8, 2}, kRgb));
    EXPECT_EQ(error_of(path, 6), "");
    EXPECT_NE(error_of(path, 5).find("found 3 x 2 pixels, allowed: 5 in all"),
              std::string::npos);
}

TEST(ImageInput, NamesAFileThatIsNoImage) {
    const TemporaryFolder folder;
    const std::string path = folder.path("nothing.png");
    try {
        load_image(path);
        FAIL() << "no exception";
    } catch (const std::exception& error) {
        EXPECT_NE(std::string(error.what()).find("nothing.png"), std::string::npos);
    }
}

}  // namespace
}  // namespace render
