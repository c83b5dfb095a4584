// outputs.cpp - checks, each with the option that it is about.
#include "cli/outputs.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "files/whole_file.hpp"
#include "picture/picture_writer.hpp"

namespace render {
namespace {

template <typename Check>
void check(const char* option, const Check& body) try {
    body();
} catch (const std::runtime_error& error) {
    throw std::runtime_error(fmt::format("{} {}", option, error.what()));
}

}  // namespace

void check_outputs(const Options& options) {
    if (options.json) check("--json", [&] { require_place(*options.json); });
    if (!options.out) return;
    check_pictures(options, 1, options.size.value_or(glm::uvec2(1)));
    if (options.json == options.out)
        throw std::runtime_error(fmt::format(
            "--json {}: is the file of --out too; each needs its own", *options.json));
}

void check_pictures(const Options& options, int count, glm::uvec2 size) {
    if (!options.out) return;
    check("--out", [&] {
        for (int i = 0; i < count; ++i) {
            const std::string path = frame_path(*options.out, i, count);
            require_place(path);
            require_format(path, size.x, size.y);
        }
    });
}

}  // namespace render
