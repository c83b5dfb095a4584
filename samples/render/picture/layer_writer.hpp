// layer_writer.hpp - what the pixels of a picture see, as named channels of an EXR file. Finds none of
// it.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "files/whole_file.hpp"

namespace render {

class ImageFile;

constexpr uint32_t kLayerRows = 64;  // of a strip, but for the last one
constexpr uint32_t kNothing = 0xffffffffu;

// As the file has it; these are the values where a pixel sees nothing.
struct LayerPixel {
    float depth = std::numeric_limits<float>::infinity();  // from the eye [world]
    glm::vec3 normal{0.0f};                                // unit
    glm::vec3 position{0.0f};                              // [world]
    uint32_t primitive = kNothing;
    uint32_t material = kNothing;
    uint32_t tests = 0;  // boxes and triangles that its ray was tested against
};

struct LayerStrip {
    uint32_t first_row = 0;
    uint32_t rows = 0;
    std::vector<LayerPixel> pixels;  // row by row
};

// Throws std::runtime_error unless `path` ends in .exr.
void require_layer_format(const std::string& path);

// The channels Z, N.X, N.Y, N.Z, P.X, P.Y, P.Z (floats), primitive, material
// and tests (32-bit integers). All
// functions throw std::runtime_error, which begins with `path`.
class LayerWriter {
public:
    LayerWriter(WholeFile& file, const std::string& path, glm::uvec2 size);
    ~LayerWriter();
    LayerWriter(const LayerWriter&) = delete;
    LayerWriter& operator=(const LayerWriter&) = delete;

    void write(const LayerStrip& strip);  // from the top to the bottom
    void finish();                        // after the last one; then all bytes are in the file

private:
    std::unique_ptr<ImageFile> image_;
};

}  // namespace render
