// budgets_suite.cpp - measures bound by bound, with exact and with rough quotients.
#include "budgets/budgets_suite.hpp"

#include <fmt/format.h>

#include <map>
#include <regex>

#include "budgets/bound.hpp"
#include "budgets/budgets_text.hpp"
#include "budgets/measured_program.hpp"
#include "budgets/search.hpp"
#include "progress.hpp"

namespace bench {
namespace {

using namespace budgets;
using nlohmann::json;

constexpr uint64_t kUsual = 100'000'000, kQuick = 1'500'000;

struct Measurement {
    const Bound* bound;
    bool is_rough;

    double derived() const { return is_rough ? bound->rough : bound->derived; }
    std::string name() const {
        return fmt::format("budgets/bound:{}/division:{}", bound->name, division());
    }
    const char* division() const { return is_rough ? "rough" : "correct"; }
};

std::vector<Measurement> select(const std::string& filter) {
    const std::regex wanted(filter.empty() ? "." : filter);
    std::vector<Measurement> selected;
    for (const Bound& bound : all_bounds())
        for (const bool is_rough : {false, true}) {
            const Measurement one = {&bound, is_rough};
            if (one.derived() > 0 && std::regex_search(one.name(), wanted))
                selected.push_back(one);
        }
    return selected;
}

json params_of(const Measurement& one) {
    return {{"bound", one.bound->name},
            {"where", one.bound->where},
            {"unit", one.bound->unit},
            {"division", one.division()}};
}

class Programs {
public:
    explicit Programs(const Device& device) : device_(device) {}

    cl::Kernel kernel(const Measurement& one) {
        const auto key = std::make_pair(std::string(one.bound->file), one.is_rough);
        auto found = programs_.find(key);
        if (found == programs_.end())
            found =
                programs_.emplace(key, measured_program(device_, one.bound->file, one.is_rough))
                    .first;
        return cl::Kernel(found->second, fmt::format("search_{}", one.bound->name).c_str());
    }

private:
    const Device& device_;
    std::map<std::pair<std::string, bool>, cl::Program> programs_;
};

Case measure(const Device& device, Programs& programs, const Measurement& one,
             uint64_t evaluations) {
    Case result = {one.name(), params_of(one), json::object(), false};
    try {
        cl::Kernel kernel = programs.kernel(one);
        const Worst worst = search(device, kernel, one.bound->inputs, evaluations);
        json input = json::array();
        for (const float value : worst.input) input.push_back(fmt::format("{:a}", value));
        result.metrics = {{"evaluations", worst.evaluations},     {"derived_u", one.derived()},
                          {"granted_u", one.bound->granted},      {"measured_u", worst.error},
                          {"ratio", worst.error / one.derived()}, {"worst_input", input}};
        result.ok = worst.error <= one.derived();
    } catch (const std::exception& error) {
        result.metrics["error"] = describe_error(error);
    }
    return result;
}

bool has_doubles(const Device& device) {
    return device.device().getInfo<CL_DEVICE_EXTENSIONS>().find("cl_khr_fp64") !=
           std::string::npos;
}

}  // namespace

void BudgetsSuite::add_options(CLI::App& app) {
    app.add_option("--filter", filter_, "Only cases whose name has a match of this expression");
    app.add_option("--evaluations", evaluations_, "Of each bound; default 1e8, quick 1.5e6")
        ->check(CLI::PositiveNumber);
    app.add_flag("--list", lists_, "Print the names of the cases instead of running them");
}

void BudgetsSuite::run(const Run& run) {
    const uint64_t evaluations = evaluations_ ? evaluations_ : run.quick ? kQuick : kUsual;
    const std::vector<Measurement> selected = select(filter_);
    ProgressBar progress(lists_ ? 0 : selected.size());
    Programs programs(run.device);
    for (const Measurement& one : selected) {
        if (lists_) {
            fmt::print("{}\n", one.name());
        } else if (run.limit.has_passed()) {
            run.results.leave_out(one.name(), run.limit.when_passed());
        } else if (!has_doubles(run.device)) {
            run.results.leave_out(one.name(), "the device has no double precision");
        } else {
            progress.begin(one.name());
            const Case result = measure(run.device, programs, one, evaluations);
            fmt::print("{}", as_text(result));
            run.results.add(result);
        }
    }
    fmt::print("{}", table_of_budgets(run.results.cases()));
}

}  // namespace bench
