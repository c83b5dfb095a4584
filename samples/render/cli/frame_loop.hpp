// frame_loop.hpp - the program between command line and files: reads the scene, renders its
// frames, writes, checks and reports them.
#pragma once

#include "cli/options.hpp"

namespace render {

// Exit code: 0, or 1 when a check found a difference. Throws for anything that cannot be done.
int run(const Options& options);

}  // namespace render
