// parity_suite.cpp - mesh by mesh: points, their solid angles, and the counts of every engine.
#include "parity/parity_suite.hpp"

#include <fmt/format.h>

#include <regex>

#include "parity/inside.hpp"
#include "parity/parity_meshes.hpp"
#include "parity/parity_rays.hpp"
#include "progress.hpp"
#include "stability/traced_scene.hpp"

namespace bench {
namespace {

using namespace parity;

struct Amount {
    uint32_t random, chosen;  // points
};
constexpr Amount kQuick = {6000, 4000};
constexpr Amount kUsual = {1000000, 100000};

std::string case_name(const ClosedMesh& mesh, Points points, const Column& column) {
    return fmt::format("parity/mesh:{}/points:{}/engine:{}/bound:{}", mesh.name,
                       name_of(points), column.engine_name, column.bound_name);
}

Case case_of(const ClosedMesh& mesh, uint32_t triangles, Points points, const Column& column,
             const Inside& found) {
    Case made = {case_name(mesh, points, column),
                 {{"mesh", mesh.name},
                  {"triangles", triangles},
                  {"points", name_of(points)},
                  {"engine", column.engine_name},
                  {"bound", column.bound_name}},
                 {{"points", found.points},
                  {"inside", found.inside},
                  {"near", found.near},
                  {"wrong", found.wrong}},
                 found.wrong == 0};
    if (!found.why.empty()) made.metrics["why"] = found.why;
    return made;
}

std::string as_text(const Case& c) {
    const auto count = [&](const char* key) { return c.metrics[key].get<uint64_t>(); };
    return fmt::format("{}: {} points, {} inside, {} near, {} wrong{}\n", c.name,
                       count("points"), count("inside"), count("near"), count("wrong"),
                       c.ok ? "" : "; " + c.metrics["why"].get<std::string>());
}

// Those of a mesh and its points that the filter lets pass.
std::vector<Column> wanted(const Device& device, const ClosedMesh& mesh, Points points,
                           const std::string& filter) {
    const std::regex expression(filter.empty() ? "." : filter);
    std::vector<Column> columns;
    for (const Column& column : stability::engines(device))
        if (std::regex_search(case_name(mesh, points, column), expression))
            columns.push_back(column);
    return columns;
}

void run_mesh(const Run& run, const ClosedMesh& kind, Points points, uint32_t count,
              const std::vector<Column>& columns) {
    test::Random random(points == Points::kRandom ? 83 : 84);
    stability::Scene scene = {kind.make(), {}};
    scene.rays = rays_from(random, scene.mesh, points, count);
    const Judge judge(scene.mesh, scene.rays);
    const stability::TracedScene on_device(run.device, scene);
    for (const Column& column : columns) {
        const Case c = case_of(kind, scene.mesh.triangle_count(), points, column,
                               judge.compare(on_device.counts(column, true)));
        fmt::print("{}", as_text(c));
        run.results.add(c);
    }
}

void leave_out(const Run& run, const ClosedMesh& mesh, Points points, const std::string& why) {
    run.results.leave_out(fmt::format("parity/mesh:{}/points:{}", mesh.name, name_of(points)),
                          why);
}

}  // namespace

void ParitySuite::add_options(CLI::App& app) {
    app.add_option("--filter", filter_, "Only cases whose name has a match of this expression");
    app.add_option("--random", random_, "Random points of each mesh")
        ->check(CLI::Range(1, 1 << 24));
    app.add_option("--chosen", chosen_,
                   "Points on axes through vertices and edges, and on edges' lines")
        ->check(CLI::Range(1, 1 << 24));
}

void ParitySuite::run(const Run& run) {
    const Amount usual = run.quick ? kQuick : kUsual;
    const std::vector<ClosedMesh> meshes = closed_meshes();
    ProgressBar progress(2 * meshes.size());
    for (const ClosedMesh& mesh : meshes)
        for (const Points points : {Points::kRandom, Points::kChosen}) {
            const std::vector<Column> columns = wanted(run.device, mesh, points, filter_);
            if (columns.empty()) continue;
            progress.begin(mesh.name);
            const uint32_t usually = points == Points::kRandom ? usual.random : usual.chosen;
            const uint32_t asked = points == Points::kRandom ? random_ : chosen_;
            const std::string why =
                run.limit.has_passed() ? run.limit.when_passed() : mesh.why_not;
            if (!why.empty())
                leave_out(run, mesh, points, why);
            else
                run_mesh(run, mesh, points, asked > 0 ? asked : usually, columns);
        }
}

}  // namespace bench
