#include "oracle/crossings/judge_crossings.hpp"

#include <algorithm>
#include <cmath>

namespace oracle {
namespace {

uint64_t count_certain(const Crossings& expected) {
    return uint64_t(std::count_if(expected.begin(), expected.end(),
                                  [](const Crossing& c) { return c.is_certain; }));
}

// End where it is not.
Crossings::const_iterator find(const Crossings& expected, uint32_t triangle) {
    const auto at = std::lower_bound(
        expected.begin(), expected.end(), triangle,
        [](const Crossing& c, uint32_t number) { return c.triangle < number; });
    return at != expected.end() && at->triangle == triangle ? at : expected.end();
}

bool is_before(const rsh_hit& a, const rsh_hit& b) {
    return a.t < b.t || (a.t == b.t && a.primitive < b.primitive);
}

std::string between(double low, double high) {
    return "must be " + std::to_string(low) + " to " + std::to_string(high);
}

// Empty: nothing is wrong.
std::string what_is_wrong(const Crossing& c, const rsh_hit& hit) {
    if (!(hit.t >= c.t_low && hit.t <= c.t_high))
        return "t is " + std::to_string(hit.t) + ", " + between(c.t_low, c.t_high);
    if (!(std::fabs(hit.u - c.u) <= c.uv_error && std::fabs(hit.v - c.v) <= c.uv_error))
        return "u, v are " + std::to_string(hit.u) + ", " + std::to_string(hit.v) +
               ", must be " + std::to_string(c.u) + ", " + std::to_string(c.v);
    return "";
}

Verdict fault_at(uint32_t triangle, Fault fault, const std::string& why) {
    return {fault, "triangle " + std::to_string(triangle) + ": " + why};
}

}  // namespace

uint64_t count_undecided(const Crossings& expected) {
    return expected.size() - count_certain(expected);
}

Verdict judge_count(const Crossings& expected, uint64_t count) {
    const uint64_t certain = count_certain(expected);
    const std::string counted =
        "counts " + std::to_string(count) + ", must be " + std::to_string(certain) + " to ";
    if (count < certain) return {Fault::kMissed, counted + std::to_string(expected.size())};
    if (count > expected.size())
        return {Fault::kSpurious, counted + std::to_string(expected.size())};
    return {};
}

Verdict judge_all(const Crossings& expected, const rsh_hit* hits, size_t count) {
    std::vector<bool> is_found(expected.size());
    for (size_t i = 0; i < count; ++i) {
        const auto at = find(expected, hits[i].primitive);
        const uint32_t triangle = hits[i].primitive;
        if (at == expected.end())
            return fault_at(triangle, Fault::kSpurious, "cannot be crossed");
        const std::string why = what_is_wrong(*at, hits[i]);
        if (!why.empty()) return fault_at(triangle, Fault::kSpurious, why);
        const size_t place = size_t(at - expected.begin());
        if (is_found[place]) return fault_at(triangle, Fault::kSpurious, "is there twice");
        is_found[place] = true;
        if (i > 0 && !is_before(hits[i - 1], hits[i]))
            return fault_at(triangle, Fault::kWrongTriangle, "is out of order");
    }
    for (size_t k = 0; k < expected.size(); ++k)
        if (expected[k].is_certain && !is_found[k])
            return fault_at(expected[k].triangle, Fault::kMissed, "is missed");
    return {};
}

Verdict judge_parity(uint64_t count, bool is_inside) {
    if (count % 2 == uint64_t{is_inside}) return {};
    return {is_inside ? Fault::kMissed : Fault::kSpurious,
            "crosses a closed mesh " + std::to_string(count) + " times from " +
                (is_inside ? "inside" : "outside")};
}

}  // namespace oracle
