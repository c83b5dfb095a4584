// compare.hpp - arrays must be the same, bit for bit; a difference names the first wrong index,
// both values and how many are wrong. Where and how to run it again is main.cpp's to print.
#pragma once

#include <gtest/gtest.h>

#include <cstring>
#include <ostream>
#include <vector>

#include <rsh/rsh.h>

inline std::ostream& operator<<(std::ostream& out, const rsh_hit& hit) {
    return out << "{t " << hit.t << ", u " << hit.u << ", v " << hit.v << ", primitive "
               << hit.primitive << "}";
}

inline std::ostream& operator<<(std::ostream& out, const rsh_ray& ray) {
    out.precision(9);
    const auto* o = ray.origin_tmin.s;
    const auto* d = ray.direction_tmax.s;
    return out << "{origin " << o[0] << " " << o[1] << " " << o[2] << ", direction " << d[0]
               << " " << d[1] << " " << d[2] << ", t " << o[3] << " .. " << d[3] << "}";
}

inline std::ostream& operator<<(std::ostream& out, const cl_float4& v) {
    return out << "(" << v.s[0] << ", " << v.s[1] << ", " << v.s[2] << ", " << v.s[3] << ")";
}

namespace test {

template <class T>
::testing::AssertionResult same_bits(const std::vector<T>& actual,
                                     const std::vector<T>& expected,
                                     const char* what = "elements") {
    if (actual.size() != expected.size())
        return ::testing::AssertionFailure()
               << actual.size() << " " << what << ", expected " << expected.size();
    size_t wrong = 0, first = 0;
    for (size_t i = actual.size(); i-- > 0;) {
        if (std::memcmp(&actual[i], &expected[i], sizeof(T)) == 0) continue;
        ++wrong;
        first = i;
    }
    if (wrong == 0) return ::testing::AssertionSuccess();
    return ::testing::AssertionFailure()
           << wrong << " of " << actual.size() << " " << what << " differ, first [" << first
           << "]: actual " << ::testing::PrintToString(actual[first]) << ", expected "
           << ::testing::PrintToString(expected[first]);
}

}  // namespace test
