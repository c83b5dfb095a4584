#include "accuracy/image.hpp"

#include <algorithm>
#include <fstream>
#include <stdexcept>

namespace bench::accuracy {
namespace {

using test::Double3;

double encode(double linear) {
    const double x = std::clamp(linear, 0.0, 1.0);
    return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
}

}  // namespace

const Double3& Image::at(int64_t x, int64_t y) const {
    x = std::clamp<int64_t>(x, 0, int64_t(width) - 1);
    y = std::clamp<int64_t>(y, 0, int64_t(height) - 1);
    return pixels[size_t(y) * width + size_t(x)];
}

Image averaged(const Image& image, uint32_t side) {
    Image made = {image.width / side, image.height / side, {}};
    for (uint32_t y = 0; y < made.height; ++y)
        for (uint32_t x = 0; x < made.width; ++x) {
            Double3 sum;
            for (uint32_t i = 0; i < side * side; ++i)
                sum = sum + image.at(x * side + i % side, y * side + i / side);
            made.pixels.push_back((1.0 / (double(side) * side)) * sum);
        }
    return made;
}

Image interpolated(const Image& image, uint32_t width, uint32_t height) {
    Image made = {width, height, {}};
    for (uint32_t j = 0; j < height; ++j)
        for (uint32_t i = 0; i < width; ++i) {
            const double x = (i + 0.5) / width * image.width - 0.5;
            const double y = (j + 0.5) / height * image.height - 0.5;
            const int64_t left = int64_t(std::floor(x)), top = int64_t(std::floor(y));
            const double fx = x - double(left), fy = y - double(top);
            made.pixels.push_back(
                (1 - fy) * ((1 - fx) * image.at(left, top) + fx * image.at(left + 1, top)) +
                fy * ((1 - fx) * image.at(left, top + 1) + fx * image.at(left + 1, top + 1)));
        }
    return made;
}

Image to_srgb(const Image& linear) {
    Image made = linear;
    for (Double3& p : made.pixels) p = {encode(p.x), encode(p.y), encode(p.z)};
    return made;
}

int in_255(double srgb) {
    return int(std::lround(255 * srgb));
}

void write_picture(const std::string& path, const Image& linear) {
    std::ofstream file(path, std::ios::binary);
    file << "P6\n" << linear.width << ' ' << linear.height << "\n255\n";
    for (const Double3& p : to_srgb(linear).pixels)
        for (const double channel : {p.x, p.y, p.z}) file.put(char(in_255(channel)));
    file.close();
    if (!file) throw std::runtime_error(path + ": cannot be written");
}

}  // namespace bench::accuracy
