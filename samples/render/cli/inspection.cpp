// inspection.cpp - one row for each mesh, placed as the scene says.
#include "cli/inspection.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "cli/outputs.hpp"
#include "cli/report.hpp"
#include "cli/write_output.hpp"
#include "model/inspect.hpp"
#include "scene/part.hpp"
#include "scene/scene_file.hpp"

namespace render {
namespace {

struct Row {
    std::string name;
    Inspection found;
};

Row inspect_entry(const MeshEntry& entry) {
    Part part(entry);
    const Model& model = part.at(0.0);
    for (const std::string& warning : model.warnings)
        fmt::print(stderr, "warning: {}\n", warning);
    const std::string file = entry.file.empty() ? "room" : entry.file;
    return {entry.where == file ? file : fmt::format("{} ({})", entry.where, file),
            inspect(model.mesh.positions, model.mesh.triangles)};
}

nlohmann::json row_json(const Row& row) {
    const Inspection& i = row.found;
    return {{"mesh", row.name},
            {"vertices", i.vertices},
            {"triangles", i.triangles},
            {"components", i.components},
            {"boundary_edges", i.boundary_edges},
            {"non_manifold_edges", i.non_manifold_edges},
            {"flipped_edges", i.flipped_edges},
            {"degenerate_triangles", i.degenerate_triangles},
            {"closed", i.is_closed},
            {"outwards", i.is_wound_outwards},
            {"volume", i.volume}};
}

void print_row(const Row& row) {
    const Inspection& i = row.found;
    fmt::print("{:>10} {:>10} {:>10} {:>9} {:>12} {:>8} {:>10} {:>6} {:>8} {:>12.5g}  {}\n",
               i.vertices, i.triangles, i.components, i.boundary_edges, i.non_manifold_edges,
               i.flipped_edges, i.degenerate_triangles, i.is_closed ? "yes" : "no",
               i.is_wound_outwards ? "yes" : "no", i.volume, row.name);
}

}  // namespace

void print_inspections(const Options& options) {
    check_outputs(options);
    std::vector<Row> rows;
    for (const MeshEntry& entry : read_scenes(options.scenes).meshes)
        rows.push_back(inspect_entry(entry));
    fmt::print("{:>10} {:>10} {:>10} {:>9} {:>12} {:>8} {:>10} {:>6} {:>8} {:>12}  {}\n",
               "vertices", "triangles", "components", "boundary", "non-manifold", "flipped",
               "degenerate", "closed", "outwards", "volume", "mesh");
    for (const Row& row : rows) print_row(row);
    if (!options.json) return;
    nlohmann::json meshes = nlohmann::json::array();
    for (const Row& row : rows) meshes.push_back(row_json(row));
    write_output(*options.json, json_text({{"meshes", meshes}}));
}

}  // namespace render
