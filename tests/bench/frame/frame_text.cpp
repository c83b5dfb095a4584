#include "frame/frame_text.hpp"

#include <fmt/format.h>

#include "frame/frame_peer.hpp"

namespace bench {
namespace {

void print_wrong(const Case& c) {
    const nlohmann::json& m = c.metrics;
    fmt::print("{}\n    not timed: ", c.name);
    if (m.contains("error"))
        fmt::print("{}\n", m["error"].get<std::string>());
    else
        fmt::print("{} mismatches{}\n", m.value("mismatches", size_t{0}),
                   m.contains("columns_disagree")
                       ? ", and the columns of this row have different hits"
                       : "");
}

}  // namespace

void print_build(const Case& c) {
    if (!c.ok) return print_wrong(c);
    const nlohmann::json& m = c.metrics;
    fmt::print("{}\n    build {:.2f} ms, copy {:.2f} ms: {:.2f} times; {} mismatches\n", c.name,
               m["ms_build"].get<double>(), m["ms_copy"].get<double>(),
               m["build_over_copy"].get<double>(), m["mismatches"].get<size_t>());
}

void print_frame(const Case& c) {
    if (!c.ok) return print_wrong(c);
    const nlohmann::json& m = c.metrics;
    fmt::print(
        "{}\n    {:.2f} ms (bound {:.2f}, build {:.2f}, traverse {:.2f}){}; "
        "{:.0f} tests/ray, {} mismatches\n",
        c.name, m["ms_total"].get<double>(), m["ms_bound"].get<double>(),
        m["ms_build"].get<double>(), m["ms_traverse"].get<double>(), frame_peer_text(m),
        m["tests_per_ray"].get<double>(), m["mismatches"].get<size_t>());
}

}  // namespace bench
