#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "table/members.hpp"
#include "table/sections.hpp"
#include "table/text_table.hpp"
#include "timing.hpp"

namespace bench {
namespace {

using nlohmann::json;

std::string count_text(const json& params) {
    const auto n = uint64_t(number_of(params, "n"));
    int power = 0;
    while (power < 32 && uint64_t{1} << power < n) ++power;
    return uint64_t{1} << power == n ? fmt::format("2^{}", power) : fmt::format("{}", n);
}

std::string stream_text(const json& params) {
    std::string text = fmt::format("{} x {} B, {} %", count_text(params), cell(params, "bytes"),
                                   cell(params, "keep"));
    const std::string pattern = text_of(params, "pattern", ""),
                      by = text_of(params, "keep_by", "");
    if (!pattern.empty() && pattern != "random") text += ", " + pattern;
    if (!by.empty() && by != "not_null") text += ", by " + by;
    return text;
}

// The copy of a process that ran a stream: each has its own.
struct Copy {
    std::vector<double> ms;
    double bytes = 0;  // read and written

    std::string text() const {
        return ms.empty() ? "-" : fmt::format("{:.1f}", bytes / spread(ms).median * 1e-6);
    }
};

// Streams, contenders and copies in the order in which they are met.
class Streams {
public:
    void add(const json& c, const std::string& copier) {
        const json &params = c["params"], &metrics = c["metrics"];
        const std::string stream = stream_text(params), name = text_of(params, "strategy");
        note(streams_, stream);
        note(contenders_, name);
        note(copiers_, copier);
        cells_[{stream, name}] =
            c["ok"].get<bool>() ? cell(metrics, "ratio_to_copy", 2) : "WRONG";
        const double ms = number_of(metrics, "copy_ms");
        if (ms <= 0) return;
        Copy& copy = copies_[{stream, copier}];
        copy.ms.push_back(ms);
        copy.bytes = 2 * number_of(params, "n") * number_of(params, "bytes");
    }

    bool is_empty() const { return streams_.empty(); }

    std::string text() const {
        TextTable::Row heads = {"stream, kept"};
        const bool is_one = copiers_.size() == 1;
        for (const std::string& copier : copiers_)
            heads.push_back(is_one ? "copy GB/s" : copier + " GB/s");
        for (const std::string& name : contenders_) heads.push_back(name);
        TextTable table(heads, 1);
        for (const std::string& stream : streams_) table.add(row(stream));
        return table.text();
    }

private:
    using Key = std::pair<std::string, std::string>;

    static void note(std::vector<std::string>& names, const std::string& name) {
        if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }

    TextTable::Row row(const std::string& stream) const {
        TextTable::Row cells = {stream};
        for (const std::string& copier : copiers_) {
            const auto found = copies_.find({stream, copier});
            cells.push_back(found == copies_.end() ? "-" : found->second.text());
        }
        for (const std::string& name : contenders_) {
            const auto found = cells_.find({stream, name});
            cells.push_back(found == cells_.end() ? "-" : found->second);
        }
        return cells;
    }

    std::vector<std::string> streams_, contenders_, copiers_;
    std::map<Key, std::string> cells_;
    std::map<Key, Copy> copies_;
};

std::string copier_of(const ResultFile& file) {
    const auto device = file.json.find("device");
    return device == file.json.end() ? "copy" : "copy by " + text_of(*device, "platform");
}

}  // namespace

std::string reduce_section(const std::vector<ResultFile>& files) {
    Streams streams;
    for (const ResultFile& file : files)
        if (file.suite() == "reduce")
            for (const json& c : file.cases()) streams.add(c, copier_of(file));
    if (streams.is_empty()) return "";
    return "REDUCE: a copy in GB/s, read and written; then the copy's time over each "
           "contender's,\n"
           "above 1: quicker than the copy\n" +
           streams.text();
}

}  // namespace bench
