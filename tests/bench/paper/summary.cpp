#include "paper/summary.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "frame/fit.hpp"
#include "paper/rows.hpp"

namespace bench::paper {
namespace {

using nlohmann::json;

// The right cases of one engine.
class OfEngine {
public:
    OfEngine(const std::vector<Case>& cases, const std::string& engine) {
        for (const Case& c : cases)
            if (c.ok && c.params.value("engine", "") == engine && c.metrics.contains("ms"))
                cases_.push_back(&c);
    }

    bool is_empty() const { return cases_.empty(); }

    // ms over a parameter of the cases of a row.
    std::vector<Point> series(const std::string& row, const char* parameter) const {
        std::vector<Point> points;
        for (const Case* c : cases_)
            if (c->params.value("row", "") == row && c->params.contains(parameter))
                points.push_back(
                    {c->params[parameter].get<double>(), c->metrics["ms"].get<double>()});
        std::sort(points.begin(), points.end(),
                  [](const Point& a, const Point& b) { return a.x < b.x; });
        return points;
    }

    // Of a metric, or of what is made of it, over the rows that the paper gives a time for.
    template <class Value>
    std::vector<double> of_the_paper(const Value& value) const {
        std::vector<double> found;
        for (const Case* c : cases_)
            if (c->metrics.contains("paper_ms") && c->params["row"] != kBuildRow)
                found.push_back(value(c->metrics));
        return found;
    }

private:
    std::vector<const Case*> cases_;
};

void put_growth(const OfEngine& engine, const std::string& row, json& metrics) {
    const std::vector<Point> points = engine.series(row, "triangles");
    if (points.size() < 2) return;
    metrics[row + "_ns_per_triangle"] = 1e6 * slope(points);
    metrics[row + "_exponent"] = exponent(points);
}

void put_pixels(const OfEngine& engine, json& metrics) {
    std::vector<Point> points = engine.series("resolution", "width");
    for (Point& point : points) point.x *= point.x;
    if (points.size() > 1) metrics["pixels_exponent"] = exponent(points);
}

void put_others(const OfEngine& engine, json& metrics) {
    const std::vector<Point> layers = engine.series("occlusion", "layers");
    if (layers.size() > 1) metrics["occlusion_ratio"] = layers.back().y / layers.front().y;
    const std::vector<Point> batches = engine.series("batches", "batches");
    if (batches.size() > 1) metrics["ms_per_batch"] = slope(batches);
    const std::vector<double> shares = engine.of_the_paper([](const json& m) {
        return m.value("ms_build", 0.0) / std::max(m["ms"].get<double>(), 1e-9);
    });
    if (shares.empty()) return;
    metrics["build_share"] = *std::max_element(shares.begin(), shares.end());
    const std::vector<double> speedups =
        engine.of_the_paper([](const json& m) { return m["speedup"].get<double>(); });
    metrics["least_speedup"] = *std::min_element(speedups.begin(), speedups.end());
}

}  // namespace

std::vector<Case> summarize(const std::vector<Case>& cases) {
    std::vector<Case> summaries;
    for (const std::string name : kEngines) {
        const OfEngine engine(cases, name);
        if (engine.is_empty()) continue;
        Case summary = {"paper/summary/engine:" + name,
                        {{"row", "summary"}, {"engine", name}},
                        json::object(),
                        true};
        for (const char* row : {"patio", "less_coherent", "statue"})
            put_growth(engine, row, summary.metrics);
        put_pixels(engine, summary.metrics);
        put_others(engine, summary.metrics);
        summaries.push_back(summary);
    }
    return summaries;
}

std::string as_text_of_summary(const Case& summary) {
    std::string text = summary.name + '\n';
    for (const auto& [name, value] : summary.metrics.items())
        text += fmt::format("    {} {:.4g}\n", name, value.get<double>());
    return text;
}

}  // namespace bench::paper
