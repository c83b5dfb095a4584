// no_scene_files.cpp - in place of files/, where rsh-bench is built without the samples.
#include <stdexcept>

#include "accuracy/scenes.hpp"

namespace bench::accuracy {

Staged read_staged(const std::string& file) {
    throw std::runtime_error(file + ": rsh-bench was built without RSH_BUILD_SAMPLES");
}

}  // namespace bench::accuracy
