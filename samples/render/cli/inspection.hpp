// inspection.hpp - rsh-render --inspect: what each mesh of the scenes is as a surface. Needs no
// OpenCL device.
#pragma once

#include "cli/options.hpp"

namespace render {

// Prints a table, and writes the same to options.json if that is named. Throws for a scene that
// cannot be read.
void print_inspections(const Options& options);

}  // namespace render
