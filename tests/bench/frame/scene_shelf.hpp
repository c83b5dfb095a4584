// scene_shelf.hpp - the scenes of the last few rows, so that rows may go from size to size instead
// of from scene to scene.
#pragma once

#include <deque>
#include <memory>
#include <string>

#include "frame/scene_on_device.hpp"

namespace bench {

class SceneShelf {
public:
    explicit SceneShelf(const Device& device) : device_(device) {}

    // Throws what reading it throws, again and again.
    SceneOnDevice& get(const SceneSpec& spec);

private:
    struct Kept {
        explicit Kept(const Device& device, const SceneSpec& spec)
            : name(spec.name), scene(spec), on_device(device, scene) {}
        std::string name;
        FrameScene scene;
        SceneOnDevice on_device;
    };

    const Device& device_;
    std::deque<std::unique_ptr<Kept>> kept_;  // the newest first
};

}  // namespace bench
