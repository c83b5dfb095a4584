// device_scene.hpp - a test scene in device buffers.
#pragma once

#include <memory>

#include "support/buffer.hpp"
#include "support/scene.hpp"

namespace test {

class DeviceScene {
public:
    // Features as rsh_find_features finds them, less the bits of `without`.
    explicit DeviceScene(const Scene& scene, rsh_features without = 0);
    rsh_scene desc = {};

private:
    template <class T>
    cl_mem upload(const std::vector<T>& data);
    std::vector<std::unique_ptr<Bytes>> buffers_;
};

}  // namespace test
