#include "reduce/patterns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <stdexcept>

#include "reduce/parts.hpp"
#include "reduce/streams/bitmap.hpp"
#include "reduce/streams/stream_files.hpp"

namespace bench {
namespace {

namespace fs = std::filesystem;

using Flags = std::vector<cl_uchar>;

Flags random_flags(const StreamSpec& spec) {
    Flags flags(spec.count);
    for_parts(spec.count, [&](const Part& part) {
        std::mt19937 random(spec.count + cl_uint(spec.keep_percent) + cl_uint(part.index));
        for (cl_uint i = part.begin; i < part.end; ++i)
            flags[i] = int(random() % 100) < spec.keep_percent;
    });
    return flags;
}

// Lengths are geometric, of means that give the density: 256 elements for one of each.
Flags run_flags(const StreamSpec& spec, std::mt19937& random) {
    const double share = std::clamp(spec.keep_percent / 100.0, 0.004, 0.996);
    std::geometric_distribution<cl_uint> kept(1 / (256 * share)),
        dropped(1 / (256 * (1 - share)));
    Flags flags;
    flags.reserve(spec.count);
    for (bool keeps = false; flags.size() < spec.count; keeps = !keeps) {
        const size_t length = 1 + (keeps ? kept : dropped)(random);
        flags.insert(flags.end(), std::min<size_t>(length, spec.count - flags.size()), keeps);
    }
    return flags;
}

Flags alternating_flags(const StreamSpec& spec) {
    Flags flags(spec.count);
    for (cl_ulong i = 0; i < spec.count; ++i)
        flags[i] =
            (i + 1) * cl_ulong(spec.keep_percent) / 100 > i * cl_ulong(spec.keep_percent) / 100;
    return flags;
}

Flags sorted_flags(const StreamSpec& spec) {
    Flags flags(spec.count);
    std::fill_n(flags.begin(), size_t(cl_ulong{spec.count} * cl_ulong(spec.keep_percent) / 100),
                cl_uchar{1});
    return flags;
}

fs::path mask_folder() {
    const char* scenes = std::getenv("RSH_SCENES");
    return scenes ? fs::path(scenes) / "masks" : fs::path();
}

Flags mask_flags(const StreamSpec& spec) {
    const Flags mask = read_bitmap(mask_folder() / (spec.pattern.substr(5) + ".pbm"));
    Flags flags(spec.count ? spec.count : mask.size());
    for (size_t i = 0; i < flags.size(); ++i) flags[i] = mask[i % mask.size()];
    return flags;
}

}  // namespace

std::vector<cl_uchar> make_flags(const StreamSpec& spec) {
    std::mt19937 random(spec.count + cl_uint(spec.keep_percent));
    if (spec.pattern == "random") return random_flags(spec);
    if (spec.pattern == "runs") return run_flags(spec, random);
    if (spec.pattern == "alternating") return alternating_flags(spec);
    if (spec.pattern == "sorted") return sorted_flags(spec);
    if (spec.pattern.rfind("mask:", 0) == 0) return mask_flags(spec);
    if (!spec.path.empty()) return read_stream_file(spec.path);
    throw std::runtime_error(fmt::format(
        "pattern: is \"{}\", must be random, runs, alternating, sorted, mask:NAME or pairs:...",
        spec.pattern));
}

std::vector<std::string> mask_names() {
    std::vector<std::string> names;
    std::error_code none;
    for (const fs::directory_entry& entry : fs::directory_iterator(mask_folder(), none))
        if (entry.path().extension() == ".pbm") names.push_back(entry.path().stem().string());
    std::sort(names.begin(), names.end());
    return names;
}

}  // namespace bench
