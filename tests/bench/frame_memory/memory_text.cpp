#include "frame_memory/memory_text.hpp"

#include <fmt/format.h>

#include "table/members.hpp"

namespace bench::memory {
namespace {

double mebibytes(const nlohmann::json& metrics, const char* key) {
    return number_of(metrics, key) / (1 << 20);
}

}  // namespace

std::string as_text(const Case& c) {
    const nlohmann::json& m = c.metrics;
    std::string text = c.name + ": ";
    for (const char* key : {"error", "refusal"})
        if (m.contains(key)) return text + text_of(m, key) + '\n';
    text += c.ok ? fmt::format("{} ms ({} of that without a budget)", cell(m, "ms", 2),
                               cell(m, "slowdown", 2))
                 : "not timed";
    text += fmt::format(", peak {:.2f} of {:.2f} MiB, {} parts, {} batches",
                        mebibytes(m, "bytes_peak"), mebibytes(m, "bytes_allowed"),
                        cell(m, "parts"), cell(m, "batches"));
    if (number_of(m, "mismatches") > 0)
        text += fmt::format(", {} mismatches", cell(m, "mismatches"));
    return text + '\n';
}

}  // namespace bench::memory
