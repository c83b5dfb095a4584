// picture_writer_test.cpp - pictures written, at once and in strips, and read back.
#include "picture/picture_writer.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <cmath>
#include <csignal>
#include <filesystem>
#include <future>
#include <iterator>
#include <limits>
#include <random>
#include <regex>

#include "files/image_input.hpp"
#include "program.hpp"
#include "temporary_folder.hpp"

namespace {

using render::Strip;

constexpr const char* kEndings[] = {".png", ".exr", ".jpg", ".jpeg", ".tif",  ".tiff",
                                    ".bmp", ".tga", ".hdr", ".ppm",  ".webp", ".PNG"};

// In strips of so many rows.
void write(const Strip& picture, const std::string& path, uint32_t rows,
           const std::string& description = {}) {
    render::WholeFile file(path);
    render::PictureWriter writer(file, path, picture.width, picture.rows, description);
    const size_t row = size_t{4} * picture.width;
    for (uint32_t first = 0; first < picture.rows; first += rows) {
        const uint32_t last = std::min(first + rows, picture.rows);
        const auto pixels = picture.pixels.begin();
        writer.write({picture.width,
                      first,
                      last - first,
                      {pixels + static_cast<std::ptrdiff_t>(row * first),
                       pixels + static_cast<std::ptrdiff_t>(row * last)}});
    }
    writer.finish();
    file.commit();
}

// Some formats hold the time of their making.
std::string without_times(const std::string& bytes) {
    static const std::regex kTime("[0-9]{4}:[0-9]{2}:[0-9]{2} [0-9]{2}:[0-9]{2}:[0-9]{2}");
    return std::regex_replace(bytes, kTime, "a time");
}

Strip four_pixels() {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    return {2,
            0,
            2,
            {0.0f, 0.5f, 1.0f, 1.0f, 0.002f, 0.2158605f, 7.0f, 1.0f, -1.0f, nan, 0.25f, 0.0f,
             1.0f, 1.0f, 1.0f, 1.0f}};
}

Strip noise(uint32_t width, uint32_t height) {
    Strip picture{width, 0, height, std::vector<float>(size_t{4} * width * height)};
    std::mt19937 random(1);
    std::uniform_real_distribution<float> value(0.0f, 1.0f);
    for (float& channel : picture.pixels) channel = value(random);
    return picture;
}

TEST(PictureWriter, KeepsLinearFloatsInExr) {
    render::TemporaryFolder folder;
    const std::string path = folder.path("a.exr");
    Strip picture = four_pixels();
    picture.pixels[9] = 0.125f;
    write(picture, path, 2);
    const render::Image image = render::load_image(path);
    EXPECT_EQ(image.format, RSH_TEXEL_FLOAT32);
    EXPECT_EQ(image.floats, picture.pixels);
}

TEST(PictureWriter, EncodesSrgbInPngAndClamps) {
    render::TemporaryFolder folder;
    const std::string path = folder.path("a.png");
    write(four_pixels(), path, 2);
    const render::Image image = render::load_image(path);
    ASSERT_EQ(image.format, RSH_TEXEL_SRGB8);
    // Linear 0.5 is 187.5 of 255 in sRGB, 0.2158605 is 128, 0.002 is in the linear toe.
    const std::vector<uint8_t> expected{0, 188, 255, 255, 7,   128, 255, 255,
                                        0, 0,   137, 255, 255, 255, 255, 255};
    EXPECT_EQ(image.bytes, expected);
}

TEST(PictureWriter, OfEveryEndingCanBeReadBack) {
    render::TemporaryFolder folder;
    const Strip picture{64, 0, 48,
                        std::vector<float>(size_t{4} * 64 * 48, 0.2158605f)};  // 128 of 255
    for (const std::string ending : kEndings) {
        const std::string path = folder.path("a" + ending);
        write(picture, path, 48);
        const render::Image image = render::load_image(path);
        ASSERT_EQ(image.width, 64u) << ending;
        ASSERT_EQ(image.height, 48u) << ending;
        if (image.format == RSH_TEXEL_SRGB8)
            EXPECT_NEAR(image.bytes[0], 128, 3) << ending;
        else
            EXPECT_NEAR(image.floats[0], 0.2158605f, 1e-3) << ending;
    }
}

TEST(PictureWriter, DescribesWhatItIsToldTo) {
    render::TemporaryFolder folder;
    for (const std::string ending : {".png", ".exr", ".jpg", ".tif"}) {
        const std::string path = folder.path("a" + ending);
        write(four_pixels(), path, 2, "what it is");
        EXPECT_EQ(render::description_of(path), "what it is") << ending;
    }
}

TEST(PictureWriter, LeavesAPictureWithoutDescriptionAlone) {
    render::TemporaryFolder folder;
    for (const std::string ending : kEndings) {
        const std::string path = folder.path("a" + ending);
        write(four_pixels(), path, 2);
        EXPECT_EQ(render::description_of(path), "") << ending;
    }
}

TEST(PictureWriter, OfEveryEndingIsReadableWithADescription) {
    render::TemporaryFolder folder;
    for (const std::string ending : kEndings) {
        const std::string path = folder.path("a" + ending);
        write(four_pixels(), path, 2, "what it is");
        EXPECT_EQ(render::load_image(path).width, 2u) << ending;
    }
}

TEST(PictureWriter, OfEveryEndingHasTheSameBytesInStrips) {
    render::TemporaryFolder folder;
    const Strip picture = noise(67, 197);
    for (const std::string ending : kEndings) {
        const std::string whole = folder.path("whole" + ending);
        write(picture, whole, picture.rows);
        for (const uint32_t rows : {64u, 128u}) {
            const std::string strips = folder.path("strips" + ending);
            write(picture, strips, rows);
            EXPECT_TRUE(without_times(render::content(strips)) ==
                        without_times(render::content(whole)))
                << ending << " in strips of " << rows << " rows";
        }
    }
}

// BMP and EXR go back in their files, which a stream cannot.
TEST(PictureWriter, GivesStreamsTheSameBytes) {
    render::TemporaryFolder folder;
    const Strip picture = noise(67, 197);
    for (const std::string ending : {".png", ".exr", ".bmp", ".tif"}) {
        const std::string whole = folder.path("whole" + ending),
                          pipe = folder.path("pipe" + ending);
        write(picture, whole, picture.rows);
        ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
        auto read = std::async(std::launch::async, [&] { return render::content(pipe); });
        write(picture, pipe, 64);
        EXPECT_TRUE(without_times(read.get()) == without_times(render::content(whole)))
            << ending;
    }
}

// Files of this process end after so many bytes, as on a full disk.
class FullDisk {
public:
    explicit FullDisk(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
        getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit limit{bytes, before_.rlim_max};
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~FullDisk() {
        setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
    }

private:
    rlimit before_{};
    void (*handler_)(int);
};

TEST(PictureWriter, KeepsTheOldFileWhereTheDiskHasNoRoom) {
    render::TemporaryFolder folder;
    const Strip picture = noise(67, 197);
    for (const std::string ending : kEndings) {
        const std::string path = folder.write("a" + ending, "old");
        std::string said = "nothing";
        try {
            const FullDisk disk(3000);
            write(picture, path, 64);
        } catch (const std::runtime_error& error) {
            said = error.what();
        }
        EXPECT_EQ(said.rfind(path + ": cannot be written: File too large", 0), 0u) << said;
        EXPECT_EQ(render::content(path), "old");
    }
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path("")), {}),
              std::distance(std::begin(kEndings), std::end(kEndings)))
        << "something is left";
}

// Of the largest side that the program takes, WebP lacks one pixel.
TEST(PictureWriter, RefusesAPictureThatItsFormatCannotHold) {
    render::TemporaryFolder folder;
    const std::string path = folder.path("a.webp");
    try {
        write(noise(16384, 1), path, 1);
        FAIL() << "was written";
    } catch (const std::runtime_error& error) {
        EXPECT_EQ(error.what(),
                  path + ": is 16384 x 1 pixels, a .webp has at most 16383 a side");
    }
}

}  // namespace
