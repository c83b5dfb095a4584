// image_file.hpp - rows of an image, through OpenImageIO, into a WholeFile. Does not know what the
// channels mean.
#pragma once

#include <OpenImageIO/imageio.h>

#include <memory>
#include <string>

#include "picture/file_proxy.hpp"

namespace render {

// In lower case, with its dot.
std::string ending_of(const std::string& path);

// All functions throw std::runtime_error, which begins with `path`.
class ImageFile {
public:
    ImageFile(WholeFile& file, const std::string& path, const OIIO::ImageSpec& spec);

    // UNKNOWN: as the file has them. `pixel_bytes`: from one pixel to the next; negative: no gaps.
    void write(uint32_t first_row, uint32_t rows, OIIO::TypeDesc type, const void* pixels,
               OIIO::stride_t pixel_bytes = OIIO::AutoStride);
    void finish();  // after the last row; then all bytes are in the file

private:
    void require(bool is_done) const;

    std::string path_;
    FileProxy proxy_;  // outlives what writes to it
    std::unique_ptr<OIIO::ImageOutput> image_;
};

}  // namespace render
