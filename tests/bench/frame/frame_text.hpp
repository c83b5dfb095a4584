// frame_text.hpp - the lines of a case for a terminal.
#pragma once

#include "results.hpp"

namespace bench {

void print_frame(const Case& c);
void print_build(const Case& c);

}  // namespace bench
