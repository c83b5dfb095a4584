// stability_suite.cpp - chooses families and variants, and runs them family by family.
#include "stability/stability_suite.hpp"

#include <fmt/format.h>

#include <regex>
#include <stdexcept>

#include "progress.hpp"
#include "stability/run_family.hpp"
#include "stability/stability_text.hpp"
#include "stability/sum.hpp"

namespace bench {
namespace {

using namespace stability;

struct Selected {
    Family family;
    uint64_t salt;
    std::vector<Variant> variants;
};

std::vector<Variant> all_variants(const Device& device) {
    std::vector<Variant> variants;
    for (const Column& column : engines(device))
        for (const bool is_list : {false, true})
            for (const cl_uint query :
                 {RSH_QUERY_CLOSEST, RSH_QUERY_ANY, RSH_QUERY_COUNT, RSH_QUERY_ALL})
                variants.push_back({column, is_list, query});
    return variants;
}

// Of its name alone, so that a family's scenes do not depend on what other families there are.
uint64_t salt_of(const Family& family) {
    uint32_t hash = 2166136261u;
    for (const char* c = family.name; *c; ++c)
        hash = (hash ^ static_cast<unsigned char>(*c)) * 16777619u;
    return hash;
}

std::vector<Selected> select(const Device& device, const std::string& filter) {
    const std::regex wanted(filter.empty() ? "." : filter);
    const std::vector<Variant> variants = all_variants(device);
    std::vector<Selected> selected;
    for (const Family& family : all_families()) {
        Selected one = {family, salt_of(family), {}};
        for (const Variant& variant : variants)
            if (std::regex_search(case_name(family, variant), wanted))
                one.variants.push_back(variant);
        if (!one.variants.empty()) selected.push_back(one);
    }
    return selected;
}

FamilyResult run_selected(const Device& device, const Limit& limit, const Selected& one,
                          const Amount& amount, ProgressBar& progress) {
    const auto begin = [&](uint32_t round) {
        progress.begin(fmt::format("{} {} of {}", one.family.name, round + 1, amount.rounds));
    };
    try {
        return run_family(device, one.family, one.salt, one.variants, amount, limit, begin);
    } catch (const std::exception& error) {
        FamilyResult failed;
        failed.rounds = amount.rounds;
        for (const Variant& variant : one.variants)
            failed.cases.push_back({case_name(one.family, variant),
                                    params_of(one.family, variant),
                                    {{"error", describe_error(error)}},
                                    false});
        return failed;
    }
}

void leave_out_rounds(const Run& run, const Selected& one, uint32_t from, uint32_t to) {
    if (from < to)
        run.results.leave_out(
            fmt::format("stability/family:{}, rounds {} to {}", one.family.name, from + 1, to),
            run.limit.when_passed());
}

void list(const std::vector<Selected>& selected) {
    for (const Selected& one : selected)
        for (const Variant& variant : one.variants)
            fmt::print("{}\n", case_name(one.family, variant));
}

void run_all(const Run& run, const Device& device, const std::vector<Selected>& selected,
             const Amount& amount) {
    Totals totals;
    ProgressBar progress(selected.size() * amount.rounds);
    for (const Selected& one : selected) {
        FamilyResult result;
        if (!run.limit.has_passed())
            result = run_selected(device, run.limit, one, amount, progress);
        leave_out_rounds(run, one, result.rounds, amount.rounds);
        for (const Case& c : result.cases) {
            fmt::print("{}", as_text(c));
            run.results.add(c);
        }
        totals.add(result.totals);
    }
    if (run.results.cases().empty()) return;
    const Case sum = sum_of(run.results.cases(), totals);
    run.results.add(sum);
    fmt::print("{}{}", table_by_family(run.results.cases()), as_text_of_sum(sum));
}

}  // namespace

void StabilitySuite::add_options(CLI::App& app) {
    app.add_option("--filter", filter_, "Only cases whose name has a match of this expression");
    app.add_option("--vector-width", vector_width_,
                   "Of the kernels; the hashes must be the same")
        ->check(CLI::IsMember({1, 4, 8, 16}));
    app.add_flag("--full", is_full_, "1e8 rays and 1e10 pairs, in up to two hours");
    app.add_flag("--hundredth", is_hundredth_, "A hundredth of --full");
    app.add_flag("--list", lists_, "Print the names of the cases instead of running them");
}

void StabilitySuite::run(const Run& run) {
    if (run.quick + is_full_ + is_hundredth_ > 1)
        throw std::invalid_argument("--quick, --full, --hundredth: not together");
    const Amount& amount = run.quick       ? kQuick
                           : is_full_      ? kFull
                           : is_hundredth_ ? kHundredth
                                           : kUsual;
    const Device device(run.device, vector_width_);
    const std::vector<Selected> selected = select(device, filter_);
    if (lists_)
        list(selected);
    else
        run_all(run, device, selected, amount);
}

}  // namespace bench
