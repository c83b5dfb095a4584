// moment.hpp - one moment of a row's scene, in buffers, ready for frames with the row's kinds of rays.
#pragma once

#include "accuracy/scene_on_device.hpp"
#include "paper/frame.hpp"
#include "paper/rows.hpp"
#include "paper/scenes/scenes.hpp"

namespace bench::paper {

class Moment {
public:
    Moment(const Device& device, StillScene scene, const Row& row);

    const StillScene& still() const { return still_; }
    const accuracy::SceneOnDevice& on_device() const { return on_device_; }
    void place_in(Frame& frame) const { frame.place(scene_, on_device_.camera()); }

    // Milliseconds to send what moves to the device once more: positions and normals.
    double upload() const;

private:
    void send(cl_mem buffer, const std::vector<glm::vec3>& items) const;

    const Device& device_;
    StillScene still_;
    accuracy::Staged staged_;
    accuracy::SceneOnDevice on_device_;
    rsh_scene scene_;
};

}  // namespace bench::paper
