// outputs.cpp - checks, each with the option that it is about.
#include "cli/outputs.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "files/image_output.hpp"
#include "files/whole_file.hpp"

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
    check_pictures(options, 1);
    if (options.json == options.out)
        throw std::runtime_error(fmt::format(
            "--json {}: is the file of --out too; each needs its own", *options.json));
}

void check_pictures(const Options& options, int count) {
    if (!options.out) return;
    check("--out", [&] {
        for (int i = 0; i < count; ++i) {
            const std::string path = frame_path(*options.out, i, count);
            require_place(path);
            require_image_ending(path);
        }
    });
}

}  // namespace render
