#include "stability/stability_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "table/text_table.hpp"

namespace bench::stability {
namespace {

using nlohmann::json;

struct Count {
    const char* key;
    const char* head;  // of its column
    bool is_fault;
};
constexpr Count kCounts[] = {{"decisions", "decided", false},
                             {"undecided", "open", true},
                             {"missed", "missed", true},
                             {"spurious", "spurious", true},
                             {"wrong_triangle", "triangle", true},
                             {"differ", "differ", true},
                             {"nan_out", "nan", true},
                             {"self_hits", "self", true}};

uint64_t count_of(const json& metrics, const char* key) {
    return metrics.value(key, uint64_t{0});
}

// Of all its cases the worst; they share rays and decisions, which thus are counted once.
struct Worst {
    std::map<std::string, uint64_t> counts;
    double t_error = 0;
    size_t wrong = 0;

    void add(const Case& c) {
        for (const Count& one : kCounts)
            counts[one.key] = std::max(counts[one.key], count_of(c.metrics, one.key));
        t_error = std::max(t_error, c.metrics.value("t_error_of_budget", 0.0));
        wrong += !c.ok;
    }
    void add_row(const std::string& name, TextTable& table) const {
        TextTable::Row row = {name, std::to_string(wrong)};
        for (const Count& one : kCounts) row.push_back(std::to_string(counts.at(one.key)));
        row.push_back(fmt::format("{:.2f}", t_error));
        table.add(row);
    }
};

}  // namespace

std::string as_text(const Case& c) {
    const json& m = c.metrics;
    if (m.contains("error"))
        return fmt::format("{}\n    {}\n", c.name, m["error"].get<std::string>());
    std::string text = fmt::format("{}: {} rays, {} decisions", c.name, count_of(m, "rays"),
                                   count_of(m, "decisions"));
    if (c.params["query"] == "closest")
        text +=
            fmt::format(", t error {:.2f} of its budget", m["t_error_of_budget"].get<double>());
    if (c.ok) return text + '\n';
    for (const Count& one : kCounts)
        if (one.is_fault && count_of(m, one.key) > 0)
            text += fmt::format("; {} {}", count_of(m, one.key), one.key);
    return text + (m.contains("why") ? "; first: " + m["why"].get<std::string>() : "") + '\n';
}

std::string table_by_family(const std::vector<Case>& cases) {
    std::vector<std::pair<std::string, Worst>> families;
    for (const Case& c : cases) {
        const auto name = c.params["family"].get<std::string>();
        if (families.empty() || families.back().first != name) families.push_back({name, {}});
        families.back().second.add(c);
    }
    TextTable::Row heads = {"family", "wrong"};
    for (const Count& one : kCounts) heads.push_back(one.head);
    heads.push_back("t err");
    TextTable table(heads, 1);
    for (const auto& [name, worst] : families) worst.add_row(name, table);
    return "\nper family, the worst of its cases; 't err': of the budget derived for it:\n" +
           table.text();
}

std::string as_text_of_sum(const Case& sum) {
    const auto count = [&](const char* key) { return double(count_of(sum.metrics, key)); };
    return fmt::format(
        "all: {:.4g} rays, {:.4g} pairs by the engines, {:.4g} decisions by the oracles, "
        "{:.4g} of them open\n",
        count("rays"), count("pairs"), count("decisions"), count("undecided"));
}

}  // namespace bench::stability
