#include "reduce/patterns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <stdexcept>

#include "reduce/parts.hpp"

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

// A bitmap as PBM stores it (P4): rows of bits, the highest first, padded to bytes.
Flags read_mask(const std::string& name) {
    const fs::path path = mask_folder() / (name + ".pbm");
    std::ifstream file(path, std::ios::binary);
    std::string magic;
    size_t width = 0, height = 0;
    if (!(file >> magic >> width >> height) || magic != "P4" || file.get() == EOF)
        throw std::runtime_error(
            fmt::format("found no bitmap in {} (RSH_SCENES)", path.string()));
    const size_t row_bytes = (width + 7) / 8;
    std::vector<char> rows(row_bytes * height);
    if (!file.read(rows.data(), std::streamsize(rows.size())))
        throw std::runtime_error(fmt::format("{} ends early", path.string()));
    Flags flags;
    for (size_t y = 0; y < height; ++y)
        for (size_t x = 0; x < width; ++x)
            flags.push_back(rows[y * row_bytes + x / 8] >> (7 - x % 8) & 1);
    return flags;
}

Flags mask_flags(const StreamSpec& spec) {
    const Flags mask = read_mask(spec.pattern.substr(5));
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
