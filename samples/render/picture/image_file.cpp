// image_file.cpp - OpenImageIO's calls, and what they or the file complain about.
#include "picture/image_file.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <stdexcept>

#include "files/text_scan.hpp"

namespace render {

std::string ending_of(const std::string& path) {
    return lower_case(std::filesystem::path(path).extension().string());
}

ImageFile::ImageFile(WholeFile& file, const std::string& path, const OIIO::ImageSpec& spec)
    : path_(path), proxy_(file), image_(OIIO::ImageOutput::create("image" + ending_of(path))) {
    if (!image_) throw std::runtime_error(fmt::format("{}: {}", path, OIIO::geterror()));
    image_->set_ioproxy(&proxy_);
    require(image_->open("image" + ending_of(path), spec));
}

void ImageFile::require(bool is_done) const {
    proxy_.require_written();
    if (!is_done) throw std::runtime_error(fmt::format("{}: {}", path_, image_->geterror()));
}

void ImageFile::write(uint32_t first_row, uint32_t rows, OIIO::TypeDesc type,
                      const void* pixels, OIIO::stride_t pixel_bytes) {
    require(image_->write_scanlines(static_cast<int>(first_row),
                                    static_cast<int>(first_row + rows), 0, type, pixels,
                                    pixel_bytes));
}

void ImageFile::finish() {
    require(image_->close());
    image_.reset();
    proxy_.finish();
}

}  // namespace render
