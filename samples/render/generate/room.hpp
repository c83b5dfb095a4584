// room.hpp - the project's own test scene: a closed room with a mirror sphere, a mirror floor,
// a glass ball and furniture, of any wanted number of triangles. Same options, same model,
// anywhere.
#pragma once

#include <cstdint>

#include "model/model.hpp"

namespace render {

constexpr int64_t kMinRoomTriangles = 1500;
constexpr int64_t kMaxRoomTriangles = 50000000;

struct RoomOptions {
    int64_t triangles = 20000;  // met within 1 %
    bool mirror_sphere = true;
    bool mirror_floor = false;
    bool glass = true;
    uint32_t seed = 1;  // of the furniture's details
};

// Floor at y = 0, x from -5 to 5, z from -4 to 4, 3.6 high; about the origin a disc of
// radius 1.2 is free for a mesh of the user's. Has two lights and a camera.
Model make_room(const RoomOptions& options);

}  // namespace render
