#include "queries/queries_suite.hpp"

#include <fmt/format.h>

#include <regex>

#include "frame/frame_rows.hpp"
#include "progress.hpp"
#include "queries/layers.hpp"
#include "queries/measure.hpp"

namespace bench {
namespace {

using namespace queries;

constexpr Amount kQuick = {8000, 64, 5};
constexpr Amount kUsual = {80000, 512, 15};

}  // namespace

void QueriesSuite::add_options(CLI::App& app) {
    app.add_option("--filter", filter_, "Only cases whose name has a match of this expression");
}

void QueriesSuite::run(const Run& run) {
    const Amount amount = run.quick ? kQuick : kUsual;
    const std::regex wanted(filter_.empty() ? "." : filter_);
    std::vector<Column> columns;
    for (const Column& column : frame_columns(run.device))
        if (!column.is_refit) columns.push_back(column);
    ProgressBar progress(2 * columns.size());
    for (const std::string rays : {"coherent", "incoherent"})
        for (const Column& column : columns) {
            const std::string name = case_name(rays, column);
            progress.begin(name);
            if (!std::regex_search(name, wanted)) continue;
            if (run.limit.has_passed()) {
                run.results.leave_out(name, run.limit.when_passed());
                continue;
            }
            const Case c = measure(run.device, rays,
                                   layers(amount.triangles, amount.side, rays == "coherent"),
                                   column, amount);
            fmt::print("{}", as_text(c));
            run.results.add(c);
        }
}

}  // namespace bench
