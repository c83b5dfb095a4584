// frame_summary.cpp - selections of cases, and means, least values and fits over them.
#include "frame/frame_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <set>
#include <tuple>

#include "frame/fit.hpp"

namespace bench {
namespace {

using nlohmann::json;
using Cases = std::vector<const Case*>;

template <class Wanted>
Cases select(const Cases& cases, const Wanted& wanted) {
    Cases selected;
    std::copy_if(cases.begin(), cases.end(), std::back_inserter(selected),
                 [&](const Case* c) { return wanted(*c); });
    return selected;
}

std::string text(const Case& c, const char* param) {
    return c.params.value(param, std::string());
}

double number(const Case& c, const char* metric) {
    return c.metrics.at(metric).get<double>();
}

int64_t triangles(const Case& c) {
    return c.params.value("triangles", int64_t{0});
}

uint32_t vector_width(const Case& c) {
    return c.params.value("vector_width", 0u);
}

bool is_frame(const Case& c) {
    return c.ok && c.metrics.contains("ms_total");
}

// 128x128, 256x256 and 2048x2048 are there for the exponent only.
bool is_series_only(const Case& c) {
    const int width = c.params.at("width");
    return width != 512 && width != 1024;
}

// Generated rooms have up to 1 % fewer triangles than their names say.
Cases coherent_from(const Cases& cases, double least_triangles) {
    return select(cases, [&](const Case& c) {
        const std::string rays = text(c, "rays");
        return is_frame(c) && !is_series_only(c) &&
               double(triangles(c)) >= 0.98 * least_triangles &&
               (rays == "reflection" || rays == "refraction" || rays == "shadow");
    });
}

Cases of_kind(const Cases& cases, const char* rays) {
    return select(cases, [&](const Case& c) { return is_frame(c) && text(c, "rays") == rays; });
}

// Cases have no ratio to peers that rsh-bench was built without.
Cases with(const char* metric, const Cases& cases) {
    return select(cases, [&](const Case& c) { return c.metrics.contains(metric); });
}

void put_mean(json& out, const char* name, const Cases& all, const char* metric) {
    std::vector<double> values;
    for (const Case* c : with(metric, all)) values.push_back(number(*c, metric));
    if (!values.empty()) out[name] = geometric_mean(values);
}

void put_least(json& out, const std::string& name, const Cases& all, const char* metric) {
    const Cases cases = with(metric, all);
    if (cases.empty()) return;
    const Case* least = *std::min_element(
        cases.begin(), cases.end(),
        [&](const Case* a, const Case* b) { return number(*a, metric) < number(*b, metric); });
    out[name] = number(*least, metric);
    out[name + "_case"] = least->name;
}

void put_ratios(json& out, const Cases& cases) {
    const Cases all = coherent_from(cases, 20000), big = coherent_from(cases, 300000);
    put_mean(out, "ratio_embree", all, "ratio_embree");
    put_mean(out, "ratio_embree_300k", big, "ratio_embree");
    put_least(out, "ratio_embree_least", all, "ratio_embree");
    put_mean(out, "ratio_refit", all, "ratio_embree_refit");
    put_mean(out, "ratio_refit_300k", big, "ratio_embree_refit");
    put_least(out, "ratio_refit_least", all, "ratio_embree_refit");
    const auto is_of_series = [](const Case& c) { return is_frame(c) && is_series_only(c); };
    put_least(out, "ratio_series_least", select(cases, is_of_series), "ratio_embree");
    put_mean(out, "ratio_diffuse", of_kind(cases, "diffuse"), "ratio_embree");
    put_mean(out, "ratio_second", of_kind(cases, "second"), "ratio_embree");
    put_mean(out, "ratio_shuffled", of_kind(cases, "shuffled"), "ratio_embree");
}

Cases floor_reflections(const Cases& cases) {
    return select(of_kind(cases, "reflection"),
                  [](const Case& c) { return text(c, "scene").rfind("room-floor-", 0) == 0; });
}

void put_series(json& out, const Cases& cases) {
    std::vector<Point> by_triangles, by_pixels;
    for (const Case* c : floor_reflections(cases)) {
        const double width = c->params.at("width"), ms = number(*c, "ms_total");
        if (width == 512 && triangles(*c) >= 78000)
            by_triangles.push_back({double(triangles(*c)), 1e6 * ms});
        if (text(*c, "scene") == "room-floor-80k") by_pixels.push_back({width * width, ms});
    }
    if (by_triangles.size() >= 2) out["ns_per_triangle"] = slope(by_triangles);
    if (by_pixels.size() >= 2) out["pixels_exponent"] = exponent(by_pixels);
}

void put_limits(json& out, const Cases& cases) {
    double copies = 0, bytes = 0;
    for (const Case* c : cases) {
        if (c->ok && c->metrics.contains("build_over_copy"))
            copies = std::max(copies, number(*c, "build_over_copy"));
        if (!is_frame(*c)) continue;
        const double rays = double(c->params.at("width")) * double(c->params.at("height"));
        bytes =
            std::max(bytes, number(*c, "bytes_peak") / (64 * (rays + double(triangles(*c)))));
    }
    if (copies > 0) out["build_over_copy"] = copies;
    if (bytes > 0) out["bytes_over_bound"] = bytes;
}

// The case of paper_faithful for the same rays; null: it was not run.
const Case* faithful_to(const Case& c, const std::vector<Case>& cases) {
    const auto is_same = [&](const Case& other) {
        for (const char* key : {"scene", "width", "height", "rays"})
            if (other.params.at(key) != c.params.at(key)) return false;
        return vector_width(other) == vector_width(c);
    };
    for (const Case& other : cases)
        if (is_frame(other) && text(other, "engine") == "paper_faithful" && is_same(other))
            return &other;
    return nullptr;
}

void keep_least(json& out, const char* name, double value) {
    out[name] = std::min(out.value(name, value), value);
}

void put_against_paper(json& out, const Cases& of_column, const std::vector<Case>& cases) {
    for (const Case* c : coherent_from(of_column, 80000)) {
        if (text(*c, "scene").rfind("room-", 0) != 0) continue;
        const Case* paper = faithful_to(*c, cases);
        if (!paper || paper == c || number(*c, "tests_per_ray") <= 0) continue;
        keep_least(out, "fewer_tests",
                   number(*paper, "tests_per_ray") / number(*c, "tests_per_ray"));
        if (triangles(*c) >= 686000 && triangles(*c) <= 714000)
            keep_least(out, "quicker_700k",
                       number(*paper, "ms_total") / number(*c, "ms_total"));
    }
}

bool is_refit(const Case& c) {
    return c.params.value("refit", false);
}

}  // namespace

std::vector<Case> summarize(const std::vector<Case>& cases) {
    std::set<std::tuple<std::string, std::string, bool, uint32_t>> columns;
    Cases all;
    for (const Case& c : cases) {
        columns.insert({text(c, "engine"), text(c, "bound"), is_refit(c), vector_width(c)});
        all.push_back(&c);
    }
    std::vector<Case> summaries;
    for (const auto& column : columns) {
        const Cases of_column = select(all, [&column](const Case& c) {
            return column == std::tuple(text(c, "engine"), text(c, "bound"), is_refit(c),
                                        vector_width(c));
        });
        const auto& [engine, bound, refit, width] = column;
        Case summary = {fmt::format("frame/summary/engine:{}/bound:{}{}{}", engine, bound,
                                    refit ? "/refit" : "",
                                    width > 0 ? fmt::format("/vectors:{}", width) : ""),
                        {{"engine", engine},
                         {"bound", bound},
                         {"refit", refit},
                         {"vector_width", width},
                         {"cases", of_column.size()}},
                        json::object()};
        put_ratios(summary.metrics, of_column);
        put_series(summary.metrics, of_column);
        put_limits(summary.metrics, of_column);
        put_against_paper(summary.metrics, of_column, cases);
        summaries.push_back(summary);
    }
    return summaries;
}

std::string as_text(const Case& summary) {
    std::string lines = summary.name + "\n";
    for (const auto& [name, value] : summary.metrics.items())
        lines += value.is_string()
                     ? fmt::format("    {:<24} {}\n", name, value.get<std::string>())
                     : fmt::format("    {:<24} {:.3f}\n", name, value.get<double>());
    return lines;
}

}  // namespace bench
