#include "paper/rows.hpp"

#include <fmt/format.h>

namespace bench::paper {
namespace {

constexpr int64_t kGrowth[] = {50000, 100000, 200000, 400000, 700000};
constexpr cl_uint kSides[] = {128, 256, 512, 1024, 2048, 4096};

SceneKind generated(Source source, const char* name, int64_t triangles, cl_uint layers = 1) {
    return {source, name, triangles, layers, "", false, {}, {}};
}

SceneKind file(const char* name, bool moves) {
    const std::string path = std::string(RSH_SCENE_FILES "/") + name + ".json";
    return {Source::kFile, name, 0, 1, path, moves, {}, {}};
}

// The talk tells the time of the largest scene of a series alone.
void add_growth(std::vector<Row>& rows, Row row, double paper_ms) {
    for (const int64_t triangles : kGrowth) {
        row.scene.triangles = triangles;
        row.is_quick = triangles == kGrowth[std::size(kGrowth) - 1];
        if (row.is_quick) row.paper_ms = paper_ms;
        rows.push_back(row);
    }
}

void add_still(std::vector<Row>& rows) {
    Row one = {"one_reflector", generated(Source::kSphere, "room, a mirror ball", 20000)};
    one.paper_ms = 79;
    one.is_quick = true;
    one.least_spawn_share = 0.15;
    rows.push_back(one);

    Row covering = {"covering_1",
                    generated(Source::kCovering, "room, mirror floor from above", 30000)};
    covering.paper_ms = 136;
    covering.is_quick = true;
    covering.least_spawn_share = 0.6;
    rows.push_back(covering);
    covering.name = "covering_2";
    covering.bounces = 2;
    covering.paper_ms = 391;
    rows.push_back(covering);

    Row several = {"several",
                   generated(Source::kSeveral, "room, floor, ball, glass, vases", 83000)};
    several.paper_ms = 302;
    several.is_quick = true;
    several.least_reflectors = 5;
    rows.push_back(several);
}

void add_series(std::vector<Row>& rows) {
    Row patio = {"patio", generated(Source::kSphere, "room, a mirror ball", 0)};
    patio.least_spawn_share = 0.15;
    add_growth(rows, patio, 300);
    add_growth(
        rows,
        {"less_coherent", generated(Source::kSeveral, "room, floor, ball, glass, vases", 0)},
        1000);
    add_growth(rows, {"statue", generated(Source::kStatue, "room, a mirror statue", 0)}, 4000);

    Row resolution = {"resolution",
                      generated(Source::kCovering, "room, mirror floor from above", 30000)};
    for (const cl_uint side : kSides) {
        resolution.size = {side, side};
        rows.push_back(resolution);
    }
}

void add_files(std::vector<Row>& rows) {
    Row museum = {"museum3", file("museum3", true)};
    museum.scene.name = "BART's museum3, its soups drawn anew";
    museum.has_shadows = true;
    museum.paper_ms = 289;
    museum.is_quick = true;
    rows.push_back(museum);
    museum.name = "museum8";
    museum.scene = file("museum8", true);
    museum.scene.name = "BART's museum8, its soups drawn anew";
    museum.paper_ms = 3330;
    rows.push_back(museum);

    Row large = {"large", file("large", false)};
    large.scene.name = "large, its range scans mirrors";
    large.scene.mirrors = {"dragon_up.ply", "dragon_side.ply"};
    large.scene.eye_and_target = {{3.75f, 0.27f, 1.3f}, {3.33f, 0.07f, 0.82f}};
    large.least_spawn_share = 0.15;
    large.paper_ms = 18500;
    large.is_quick = true;
    rows.push_back(large);
}

// What the talk claims without a figure: that hidden triangles cost as much as others, and which way to
// reduce a stream is the quickest.
void add_claims(std::vector<Row>& rows) {
    for (const cl_uint layers : {1u, 2u, 4u, 8u, 16u})
        rows.push_back({"occlusion", generated(Source::kLayers, "sheets behind each other",
                                               100000, layers)});
    for (const char* strategy : {"block", "block_search", "chunk", "scan_scatter", "horn",
                                 "blelloch", "atomic", "lookback", "count_emit"}) {
        Row reduction = {"reduction",
                         generated(Source::kCovering, "room, mirror floor from above", 30000)};
        reduction.strategy = strategy;
        rows.push_back(reduction);
    }
}

}  // namespace

std::vector<Row> rows() {
    std::vector<Row> all;
    add_still(all);
    add_series(all);
    add_claims(all);
    add_files(all);
    return all;
}

std::string case_name(const Row& row, const std::string& engine) {
    std::string series;
    if (row.scene.triangles > 0) series += fmt::format("/triangles:{}", row.scene.triangles);
    if (row.scene.source == Source::kLayers)
        series += fmt::format("/layers:{}", row.scene.layers);
    if (!row.strategy.empty()) series += "/strategy:" + row.strategy;
    return fmt::format("paper/row:{}{}/size:{}x{}/engine:{}", row.name, series, row.size.width,
                       row.size.height, engine);
}

}  // namespace bench::paper
