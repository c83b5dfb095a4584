// outputs.hpp - the files that rsh-render is to leave, checked before there is anything to write.
// Writes none.
#pragma once

#include "cli/options.hpp"

namespace render {

// Throws std::runtime_error for a picture or a report of these options that could not be written.
void check_outputs(const Options& options);
// The same for all of several pictures of that size, whose number may be part of a folder's name.
void check_pictures(const Options& options, int count, glm::uvec2 size);

}  // namespace render
