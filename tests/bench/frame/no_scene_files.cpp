// no_scene_files.cpp - in place of files/, where rsh-bench is built without the samples.
#include <stdexcept>

#include "frame/still_scene.hpp"

namespace bench {

const bool kReadsSceneFiles = false;

StillScene read_still_scene(const SceneSpec& spec) {
    throw std::runtime_error(spec.name + ": rsh-bench was built without RSH_BUILD_SAMPLES");
}

}  // namespace bench
