// options.hpp - the command line of rsh-render. Opens no file.
#pragma once

#include <rsh/rsh.h>

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "files/image_input.hpp"

namespace render {

// What is not given stays empty: the scene's settings or a default take its place.
struct Options {
    std::vector<std::string> scenes;
    std::optional<std::string> out;
    std::optional<std::string> layers;
    std::optional<std::string> json;
    std::string device;
    std::optional<int> frames;
    std::optional<double> time;
    std::optional<glm::uvec2> size;
    std::optional<uint32_t> bounces;
    std::optional<float> min_weight;
    double tolerance = 0;  // see rsh_frame_desc; as it was written, for reports
    uint32_t engine = RSH_ENGINE_DEFAULT;
    uint32_t bound = RSH_SHAPE_DEFAULT;
    uint32_t strategy = RSH_STRATEGY_DEFAULT;
    uint64_t budget = 0;
    uint64_t max_texture_pixels = kMaxTexturePixels;
    rsh_features without = 0;
    uint32_t audited_rays = 0;  // of each wave of every frame
    int checked_frames = 0;
    uint32_t check_ray_step = 1;
    bool prints_statistics = false;
    bool lists_devices = false;
    bool inspects = false;
};

// Options, or the exit code of a command line that wants none (help) or is wrong; the text for
// the user is printed.
struct ParsedOptions {
    std::optional<Options> options;
    int exit_code = 0;
};
ParsedOptions parse_options(int argc, const char* const* argv);

// "640x480"; throws std::runtime_error.
glm::uvec2 parse_size(const std::string& text);

// Where frame `index` of `count` goes: a %d or %04d in `pattern` becomes the index, else, when
// there are several, the index in four digits goes in front of the ending.
std::string frame_path(const std::string& pattern, int index, int count);

}  // namespace render
