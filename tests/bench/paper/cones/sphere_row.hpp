// sphere_row.hpp - the row `sphere_for_triangle`: how often the sphere of a triangle is tested and kept where
// the triangle itself would not be. On the host; a case per scene.
#pragma once

#include "suite.hpp"

namespace bench::paper {

std::vector<std::string> sphere_case_names();
void measure_spheres(const Run& run, const std::vector<std::string>& names);

}  // namespace bench::paper
