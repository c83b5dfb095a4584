// scenes.hpp - the scene of a row, at the moments of its animation. Knows no device.
#pragma once

#include <memory>
#include <stdexcept>

#include "frame/still_scene.hpp"
#include "paper/rows.hpp"

namespace bench::paper {

class MovingScene {
public:
    virtual ~MovingScene() = default;
    // fraction: 0 at the start of the animation, 1 at its end.
    virtual StillScene at(double fraction) = 0;
};

// Throws std::runtime_error when files are missing.
std::unique_ptr<MovingScene> open_scene(const SceneKind& kind);

// Of Source::kFile.
std::unique_ptr<MovingScene> open_scene_file(const SceneKind& kind);

}  // namespace bench::paper
