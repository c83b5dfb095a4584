#include "paper/build_row.hpp"

#include <fmt/format.h>

#include "frame/build_rows.hpp"
#include "paper/paper_text.hpp"
#include "paper/rows.hpp"

namespace bench::paper {
namespace {

Column column_of(const std::string& engine) {
    Column column;
    column.engine_name = engine;
    rsh::check(rsh_engine_from_name(engine.c_str(), &column.engine), "rsh_engine_from_name");
    column.bound = rsh_engine_shape(column.engine);
    column.bound_name = rsh_shape_name(column.bound);
    return column;
}

// The reflections of a mirror floor: the second of the two rows of rsh-bench frame.
BuildRow row_of_reflections() {
    return build_rows().back();
}

Case as_paper_case(const Case& built, const std::string& engine) {
    Case done = {build_case_name(engine), built.params, built.metrics, built.ok};
    done.params.update({{"row", kBuildRow}, {"bounces", 1}, {"batches", 1}});
    done.params["spawn_share"] =
        built.params["active_rays"].get<double>() /
        (built.params["width"].get<double>() * built.params["height"].get<double>());
    if (!built.ok) return done;
    const double ms = built.metrics["ms_build"];
    done.metrics.update(
        {{"ms", ms}, {"paper_ms", kBuildPaperMs}, {"speedup", kBuildPaperMs / ms}});
    return done;
}

}  // namespace

std::string build_case_name(const std::string& engine) {
    return fmt::format("paper/row:{}/size:1024x1024/engine:{}", kBuildRow, engine);
}

void measure_builds(const Run& run, const std::vector<std::string>& engines, size_t pairs) {
    if (engines.empty()) return;
    const BuildRow row = row_of_reflections();
    const FrameScene scene(row.scene);
    SceneOnDevice on_device(run.device, scene);
    for (const std::string& engine : engines) {
        const Case done = as_paper_case(
            measure_build(run.device, on_device, row, column_of(engine), pairs), engine);
        fmt::print("{}", as_text(done));
        run.results.add(done);
    }
}

}  // namespace bench::paper
