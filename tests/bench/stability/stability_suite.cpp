// stability_suite.cpp - chooses families and variants, and runs them family by family.
#include "stability/stability_suite.hpp"

#include <fmt/format.h>

#include <regex>
#include <stdexcept>

#include "progress.hpp"
#include "stability/run_family.hpp"
#include "stability/stability_text.hpp"

namespace bench {
namespace {

using namespace stability;

// Quick: every family within a minute on two cores. Full: 1e8 rays and 1e8 decisions in all.
constexpr Amount kQuick = {{32, 300}, 1, 1024};
constexpr Amount kUsual = {{64, 600}, 4, 1024};
constexpr Amount kFull = {{256, 600}, 45, 1024};

struct Selected {
    Family family;
    uint64_t salt;
    std::vector<Variant> variants;
};

std::vector<Variant> all_variants(const Device& device) {
    std::vector<Variant> variants;
    for (const Column& column : engines(device))
        for (const bool is_list : {false, true})
            for (const bool is_any : {false, true})
                variants.push_back({column, is_list, is_any});
    return variants;
}

std::vector<Selected> select(const Device& device, const std::string& filter) {
    const std::regex wanted(filter.empty() ? "." : filter);
    const std::vector<Variant> variants = all_variants(device);
    std::vector<Selected> selected;
    uint64_t salt = 0;
    for (const Family& family : all_families()) {
        Selected one = {family, ++salt, {}};
        for (const Variant& variant : variants)
            if (std::regex_search(case_name(family, variant), wanted))
                one.variants.push_back(variant);
        if (!one.variants.empty()) selected.push_back(one);
    }
    return selected;
}

std::vector<Case> run_selected(const Device& device, const Limit& limit, const Selected& one,
                               const Amount& amount) {
    try {
        return run_family(device, one.family, one.salt, one.variants, amount, limit);
    } catch (const std::exception& error) {
        std::vector<Case> failed;
        for (const Variant& variant : one.variants)
            failed.push_back({case_name(one.family, variant),
                              params_of(one.family, variant),
                              {{"error", describe_error(error)}},
                              false});
        return failed;
    }
}

}  // namespace

void StabilitySuite::add_options(CLI::App& app) {
    app.add_option("--filter", filter_, "Only cases whose name has a match of this expression");
    app.add_option("--vector-width", vector_width_,
                   "Of the kernels; the hashes must be the same")
        ->check(CLI::IsMember({1, 4, 8, 16}));
    app.add_flag("--full", is_full_, "All that a proof needs, in hours");
    app.add_flag("--list", lists_, "Print the names of the cases instead of running them");
}

void StabilitySuite::run(const Run& run) {
    if (run.quick && is_full_) throw std::invalid_argument("--full: not together with --quick");
    const Amount amount = run.quick ? kQuick : is_full_ ? kFull : kUsual;
    const Device device(run.device, vector_width_);
    const std::vector<Selected> selected = select(device, filter_);
    ProgressBar progress(lists_ ? 0 : selected.size());
    for (const Selected& one : selected) {
        if (!lists_) progress.begin(one.family.name);
        const bool is_late = run.limit.has_passed();
        for (const Variant& variant : one.variants) {
            if (lists_) fmt::print("{}\n", case_name(one.family, variant));
            if (!lists_ && is_late)
                run.results.leave_out(case_name(one.family, variant), run.limit.when_passed());
        }
        if (lists_ || is_late) continue;
        for (const Case& result : run_selected(device, run.limit, one, amount)) {
            fmt::print("{}", as_text(result));
            run.results.add(result);
        }
    }
    fmt::print("{}", table_by_family(run.results.cases()));
}

}  // namespace bench
