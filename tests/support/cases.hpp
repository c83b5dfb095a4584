// cases.hpp - every mesh with every kind of rays that matters, by name: what the traversal, the
// hierarchy and the oracle are tested on.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "support/mesh.hpp"
#include "support/rays.hpp"

namespace test {

struct Case {
    Mesh mesh;
    Rays rays;
};

struct NamedCase {
    std::string name;  // a CamelCase word, GoogleTest shows it
    std::function<Case(Random&)> make;
    // Ordinary geometry seen from near: few rays pass within rounding of an edge, so the oracle
    // must be sure of nearly all of them.
    bool ordinary = false;
};

inline void PrintTo(const NamedCase& named, std::ostream* out) {
    *out << named.name;
}

const std::vector<NamedCase>& all_cases();
const NamedCase& case_of_name(const std::string& name);  // throws

// For INSTANTIATE_TEST_SUITE_P.
inline std::string case_name(const ::testing::TestParamInfo<NamedCase>& info) {
    return info.param.name;
}

}  // namespace test
