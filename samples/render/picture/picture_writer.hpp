// picture_writer.hpp - a picture as an image file, strip by strip, through OpenImageIO. Neither
// opens nor commits the file.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "files/whole_file.hpp"

namespace render {

class ImageFile;

// Rows of a picture: linear light, four floats per pixel, from top to bottom.
struct Strip {
    uint32_t width = 0;
    uint32_t first_row = 0;  // of the picture
    uint32_t rows = 0;
    std::vector<float> pixels;
};

// Throws std::runtime_error unless the ending of `path` is of a format that can be written and
// holds so many pixels.
void require_format(const std::string& path, uint32_t width, uint32_t height);

// The ending of `path` decides: .exr keeps linear floats r, g, b, a, .hdr r, g, b; .png and the
// others get 8 bits of sRGB r, g, b. The file's bytes do not depend on the strips. It takes memory
// for 64 rows, but for WebP, whose encoder wants the picture, and for a file that is a stream, which
// gets its bytes at the end. `description`, unless empty, becomes the image's "ImageDescription" in
// .png, .exr, .jpg and .tif; other formats may not keep it. All functions throw std::runtime_error,
// which begins with `path`.
class PictureWriter {
public:
    PictureWriter(WholeFile& file, const std::string& path, uint32_t width, uint32_t height,
                  const std::string& description = {});
    ~PictureWriter();
    PictureWriter(const PictureWriter&) = delete;
    PictureWriter& operator=(const PictureWriter&) = delete;

    // The strips from the top to the bottom, each of a multiple of 64 rows but for the last.
    void write(const Strip& strip);
    void finish();  // after the last one; then all bytes are in the file

private:
    void write_rows(uint32_t first_row, uint32_t rows, uint32_t width, const float* pixels);

    std::unique_ptr<ImageFile> image_;
    bool is_linear_;
};

}  // namespace render
