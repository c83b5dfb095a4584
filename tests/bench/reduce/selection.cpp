#include "reduce/selection.hpp"

#include <algorithm>
#include <stdexcept>

#include "reduce/pair_stream.hpp"
#include "reduce/patterns.hpp"
#include "reduce/streams/stream_files.hpp"

namespace bench {
namespace {

constexpr cl_uint kMillions = 1u << 22;

const std::vector<int>& all_keeps() {
    static const std::vector<int> keeps = {0, 1, 5, 10, 25, 50, 75, 90, 99, 100};
    return keeps;
}

std::vector<std::string> own_patterns() {
    return {"runs", "alternating", "sorted"};
}

std::vector<std::string> pair_patterns(bool quick) {
    if (!has_scenes()) return {};
    if (quick) return {"pairs:chinese_dragon_20k:2"};
    std::vector<std::string> names;
    for (const char* scene : {"chinese_dragon_20k", "kitchen", "bunny_69k"})
        for (const char* level : {":4", ":2", ":0"})
            names.push_back(std::string("pairs:") + scene + level);
    return names;
}

std::vector<std::string> strategies() {
    std::vector<std::string> names;
    for (cl_uint id = 1; rsh_strategy_name(id); ++id) names.emplace_back(rsh_strategy_name(id));
    return names;
}

std::vector<StreamSpec> quick_streams() {
    std::vector<StreamSpec> streams;
    for (const int keep : {0, 10, 50, 90, 100})
        streams.push_back({"random", kMillions, 4, keep});
    for (const int keep : {10, 50, 90}) streams.push_back({"random", kMillions, 8, keep});
    for (const cl_uint count : {1u << 10, 1u << 16})
        streams.push_back({"random", count, 4, 50});
    for (const cl_uint bytes : {12u, 16u}) streams.push_back({"random", 1u << 20, bytes, 50});
    for (const std::string& pattern : own_patterns())
        streams.push_back({pattern, 1u << 20, 4, 50});
    if (!mask_names().empty())
        streams.push_back({"mask:" + mask_names().front(), 1u << 20, 4, 50});
    for (const std::string& pattern : pair_patterns(true))
        streams.push_back({pattern, 0, 8, 50});
    return streams;
}

// Every axis by itself: density at each element size, length, pattern.
std::vector<StreamSpec> all_streams() {
    std::vector<StreamSpec> streams;
    for (const cl_uint bytes : {4u, 8u, 12u, 16u})
        for (const int keep : all_keeps())
            streams.push_back({"random", kMillions, bytes, keep});
    for (const cl_uint bytes : {4u, 8u})
        for (cl_uint bits = 10; bits <= (bytes == 4 ? 26u : 24u); bits += 2)
            if (bits != 22) streams.push_back({"random", 1u << bits, bytes, 50});
    for (const cl_uint bytes : {4u, 8u})
        for (const std::string& pattern : own_patterns())
            for (const int keep : {10, 50, 90})
                streams.push_back({pattern, kMillions, bytes, keep});
    for (const std::string& mask : mask_names())
        streams.push_back({"mask:" + mask, kMillions, 4, 50});
    for (const std::string& pattern : pair_patterns(false))
        streams.push_back({pattern, 0, 8, 50});
    return streams;
}

bool has_density(const std::string& pattern) {
    return pattern.rfind("mask:", 0) != 0 && pattern.rfind("pairs:", 0) != 0;
}

template <class T>
std::vector<T> either(const std::vector<T>& asked, std::vector<T> otherwise) {
    return asked.empty() ? otherwise : asked;
}

std::vector<cl_uint> sorted(std::vector<cl_uint> counts) {
    std::sort(counts.begin(), counts.end());
    return counts;
}

// All combinations of what was asked for, the short ones first.
std::vector<StreamSpec> asked_streams(const ReduceOptions& o) {
    std::vector<StreamSpec> streams;
    for (const cl_uint count : sorted(either(o.counts, {kMillions})))
        for (const std::string& pattern : either(o.patterns, {"random"}))
            for (const cl_uint bytes : either(o.bytes, {4}))
                for (const int keep : either(o.keeps, {50})) {
                    const bool is_pairs = pattern.rfind("pairs:", 0) == 0;
                    streams.push_back({pattern, is_pairs ? 0 : count, bytes, keep});
                    if (!has_density(pattern)) break;
                }
    return streams;
}

// Elements of pairs have 8 bytes, all others those that were asked for. What cannot be read is told
// before anything is timed.
std::vector<StreamSpec> streams_of_files(const ReduceOptions& o) {
    std::vector<StreamSpec> streams;
    for (const std::filesystem::path& path : find_stream_files(o.streams)) {
        const auto count = cl_uint(read_stream_file(path).size());
        for (const cl_uint bytes :
             has_pairs(path) ? std::vector<cl_uint>{8} : either(o.bytes, {4}))
            streams.push_back(
                {"file:" + path.filename().string(), count, bytes, 50, path.string()});
    }
    return streams;
}

std::vector<StreamSpec> select_streams(const ReduceOptions& o, bool quick) {
    if (!o.streams.empty()) return streams_of_files(o);
    if (!o.counts.empty() || !o.bytes.empty() || !o.keeps.empty() || !o.patterns.empty())
        return asked_streams(o);
    return quick ? quick_streams() : all_streams();
}

Keep keep_named(const std::string& name) {
    for (const Keep keep : {Keep::kNotNull, Keep::kFlags, Keep::kBits})
        if (name == name_of(keep)) return keep;
    throw std::runtime_error("keep-by: is \"" + name + "\", must be not_null, flags or bits");
}

// "own" stands for all the library's strategies.
std::vector<std::string> expanded(const std::vector<std::string>& names) {
    std::vector<std::string> all;
    for (const std::string& name : names) {
        const std::vector<std::string> these =
            name == "own" ? strategies() : std::vector<std::string>{name};
        all.insert(all.end(), these.begin(), these.end());
    }
    return all;
}

// Peers decide by the element itself.
std::vector<std::string> select_contenders(const ReduceOptions& o,
                                           const std::vector<std::string>& plugins, Keep keep) {
    std::vector<std::string> names = strategies();
    if (keep == Keep::kNotNull) {
        const std::vector<std::string> peers = peer_names();
        names.insert(names.end(), peers.begin(), peers.end());
        names.emplace_back("peer:pyopencl");
    }
    std::vector<std::string> all = expanded(either(o.contenders, names));
    for (const std::string& plugin : plugins)
        if (std::find(all.begin(), all.end(), plugin) == all.end()) all.push_back(plugin);
    return all;
}

}  // namespace

std::vector<Heat> select_heats(const ReduceOptions& options,
                               const std::vector<std::string>& plugins, bool quick) {
    std::vector<Heat> heats;
    for (const StreamSpec& stream : select_streams(options, quick))
        for (const std::string& by : either(options.keep_by, {"not_null"})) {
            const Keep keep = keep_named(by);
            heats.push_back({stream, keep, select_contenders(options, plugins, keep)});
        }
    return heats;
}

}  // namespace bench
