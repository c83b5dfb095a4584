// outputs.cpp - checks, each with the option that it is about.
#include "cli/outputs.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "files/whole_file.hpp"
#include "picture/layer_writer.hpp"
#include "picture/picture_writer.hpp"

namespace render {
namespace {

template <typename Check>
void check(const char* option, const Check& body) try {
    body();
} catch (const std::runtime_error& error) {
    throw std::runtime_error(fmt::format("{} {}", option, error.what()));
}

// Each needs a file of its own.
void check_apart(const char* option, const std::optional<std::string>& path, const char* other,
                 const std::optional<std::string>& path_of_other) {
    if (path && path == path_of_other)
        throw std::runtime_error(fmt::format("{} {}: is the file of {} too; each needs its own",
                                             option, *path, other));
}

template <typename Check>
void check_frames(const char* option, const std::optional<std::string>& pattern, int count,
                  const Check& require_format) {
    if (!pattern) return;
    check(option, [&] {
        for (int i = 0; i < count; ++i) {
            const std::string path = frame_path(*pattern, i, count);
            require_place(path);
            require_format(path);
        }
    });
}

}  // namespace

void check_outputs(const Options& options) {
    if (options.json) check("--json", [&] { require_place(*options.json); });
    check_pictures(options, 1, options.size.value_or(glm::uvec2(1)));
    check_apart("--json", options.json, "--out", options.out);
    check_apart("--json", options.json, "--layers", options.layers);
    check_apart("--layers", options.layers, "--out", options.out);
}

void check_pictures(const Options& options, int count, glm::uvec2 size) {
    check_frames("--out", options.out, count,
                 [&](const std::string& path) { require_format(path, size.x, size.y); });
    check_frames("--layers", options.layers, count, require_layer_format);
}

}  // namespace render
