// no_scene_files.cpp - without rsh-render's reader there are generated rooms alone.
#include "paper/scenes/scenes.hpp"

namespace bench::paper {

std::unique_ptr<MovingScene> open_scene_file(const SceneKind& kind) {
    throw std::runtime_error(kind.name + ": rsh-bench was built without RSH_BUILD_SAMPLES");
}

}  // namespace bench::paper
