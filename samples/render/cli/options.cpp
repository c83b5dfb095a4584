// options.cpp - CLI11's description of the command line.
#include "cli/options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cfloat>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <regex>
#include <stdexcept>

namespace render {
namespace {

// Engines and strategies are named by the library; one that it does not know is an error here.
using FromName = rsh_status (*)(const char*, cl_uint*);
CLI::callback_t named(FromName from_name, uint32_t& value) {
    return [from_name, &value](const CLI::results_t& words) {
        cl_uint found = 0;
        if (from_name(words.at(0).c_str(), &found) != RSH_SUCCESS)
            throw CLI::ValidationError(words.at(0), rsh_last_error());
        value = found;
        return true;
    };
}

CLI::callback_t size_option(std::optional<glm::uvec2>& size) {
    return [&size](const CLI::results_t& words) {
        try {
            size = parse_size(words.at(0));
        } catch (const std::runtime_error& error) {
            throw CLI::ValidationError("--size", error.what());
        }
        return true;
    };
}

// "nan" is a number for the parser and lies in every range.
CLI::Validator a_number() {
    const auto check = [](const std::string& word) {
        return std::isnan(std::strtod(word.c_str(), nullptr)) ? "found nan, allowed: a number"
                                                              : std::string();
    };
    return CLI::Validator(check, "");
}

// "64M"; without the second check "-1" would be the largest number there is.
void add_size(CLI::App& app, const char* name, uint64_t& value, const char* text) {
    const auto not_negative = [](std::string& word) {
        return word.find('-') == std::string::npos ? ""
                                                   : "found " + word + ", allowed: 0 or more";
    };
    app.add_option(name, value, text)
        ->transform(CLI::AsSizeValue(false))
        ->transform(CLI::Validator(not_negative, ""));
}

void add_picture_options(CLI::App& app, Options& o) {
    app.add_option("--out", o.out, "Picture: .png (sRGB) or .exr (linear); may hold %04d");
    app.add_option("--layers", o.layers,
                   "What pixels see, as channels of an .exr: depth, normal, position, ...");
    auto* frames = app.add_option("--frames", o.frames, "Frames over the scene's time span");
    frames->check(CLI::Range(1, 1000000));
    app.add_option("--time", o.time, "Render the one frame at this time [s]")
        ->check(CLI::Range(-DBL_MAX, DBL_MAX))
        ->check(a_number())
        ->excludes(frames);
    app.add_option("--size", size_option(o.size), "Pixels, e.g. 640x480");
    app.add_option("--bounces", o.bounces, "Longest chain of secondary rays")
        ->check(CLI::Range(0, RSH_MAX_LEVELS));
    app.add_option("--min-weight", o.min_weight, "Leave out rays that weigh no more")
        ->check(CLI::Range(0.0, 1.0))
        ->check(a_number());
    app.add_option("--tolerance", o.tolerance,
                   "Approximate: trace only pixels that differ so much from their neighbours")
        ->check(CLI::Range(0.0, 1.0))
        ->check(a_number());
    const auto leave_out = [&o](rsh_features feature) {
        return [&o, feature](int64_t) { o.without |= feature; };
    };
    app.add_flag("--no-shadow", leave_out(RSH_FEATURE_SHADOW), "Cast no shadow rays");
    app.add_flag("--no-reflection", leave_out(RSH_FEATURE_REFLECTION), "Reflect no rays");
    app.add_flag("--no-refraction", leave_out(RSH_FEATURE_REFRACTION), "Refract no rays");
}

void add_tracing_options(CLI::App& app, Options& o) {
    app.add_option("--engine", named(rsh_engine_from_name, o.engine),
                   "Way to traverse; auto: what suits the device");
    app.add_option("--bound", named(rsh_shape_from_name, o.bound), "Shape of the nodes");
    app.add_option("--strategy", named(rsh_strategy_from_name, o.strategy), "Way to reduce");
    add_size(app, "--budget", o.budget,
             "Bytes of device memory for rays and what is made of them, e.g. 1G");
    app.add_option("--device", o.device, "Part of a device's or platform's name");
    add_size(app, "--max-texture-pixels", o.max_texture_pixels,
             "Refuse textures of more pixels, e.g. 128M");
    app.add_flag("--list-devices", o.lists_devices, "List the OpenCL devices and exit");
}

void add_report_options(CLI::App& app, Options& o) {
    app.add_flag("--stats", o.prints_statistics, "Print rays, pairs and time per stage");
    app.add_option("--json", o.json, "Write the statistics of every frame to this file");
    app.add_flag("--inspect", o.inspects,
                 "Print what each mesh is as a surface (--json: write it), and render nothing");
    auto* audit =
        app.add_option("--audit", o.audited_rays,
                       "Trace N random rays of each wave of every frame by brute "
                       "force as well and count hits that are missed, spurious, wrong")
            ->check(CLI::Range(1u, UINT32_MAX));
    app.add_option("--check", o.checked_frames,
                   "Trace the first N frames by brute force as well and count hits that differ")
        ->check(CLI::Range(1, 1000000))
        ->excludes(audit);
    app.add_option("--check-rays", o.check_ray_step,
                   "Check only one of every K rays of each wave")
        ->check(CLI::Range(1u, UINT32_MAX));
}

void require_purpose(const Options& o) {
    if (o.out || o.layers || o.json || o.prints_statistics || o.audited_rays > 0 ||
        o.checked_frames > 0 || o.inspects)
        return;
    throw CLI::ValidationError("nothing is asked for",
                               "add --out FILE for a picture, --layers FILE for what pixels "
                               "see, --stats or --json FILE for "
                               "times, --audit N or --check N "
                               "to compare with brute force, or --inspect");
}

}  // namespace

glm::uvec2 parse_size(const std::string& text) {
    static const std::regex kSize("([0-9]{1,5})x([0-9]{1,5})");
    std::smatch match;
    glm::uvec2 size(0);
    if (std::regex_match(text, match, kSize))
        size = {std::stoul(match[1]), std::stoul(match[2])};
    if (size.x < 1 || size.y < 1 || size.x > 16384 || size.y > 16384)
        throw std::runtime_error(
            fmt::format("found \"{}\", allowed: WIDTHxHEIGHT, each 1 to 16384", text));
    return size;
}

std::string frame_path(const std::string& pattern, int index, int count) {
    static const std::regex kNumber("%(0?([0-9]))?d");
    std::smatch match;
    if (std::regex_search(pattern, match, kNumber)) {
        const int digits = match[2].matched ? std::stoi(match[2]) : 1;
        return fmt::format("{}{:0{}}{}", match.prefix().str(), index, digits,
                           match.suffix().str());
    }
    if (count == 1) return pattern;
    const std::filesystem::path path(pattern);
    std::filesystem::path numbered = path.parent_path() / path.stem();
    return fmt::format("{}{:04}{}", numbered.string(), index, path.extension().string());
}

ParsedOptions parse_options(int argc, const char* const* argv) {
    Options options;
    CLI::App app("rsh-render: renders scenes with a hierarchy over the rays", "rsh-render");
    app.add_option("SCENE", options.scenes,
                   "Scene files (.json) or meshes, merged into one scene");
    add_picture_options(app, options);
    add_tracing_options(app, options);
    add_report_options(app, options);
    try {
        app.parse(argc, argv);
        if (options.lists_devices) return {options, 0};
        if (options.scenes.empty()) throw CLI::RequiredError("SCENE");
        require_purpose(options);
    } catch (const CLI::ParseError& error) {
        return {std::nullopt, app.exit(error)};
    }
    return {options, 0};
}

}  // namespace render
