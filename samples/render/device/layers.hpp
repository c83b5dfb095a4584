// layers.hpp - what each pixel of a picture sees: rsh_rasterize's hits, read back and looked up in the
// mesh. Writes no file.
#pragma once

#include <functional>

#include "device/device.hpp"
#include "picture/layer_writer.hpp"
#include "scene/world.hpp"

namespace render {

// What is to be done with each strip, from the top to the bottom.
using TakeLayers = std::function<void(const LayerStrip&)>;

// `picture` describes a frame of the world as it is now. 64 rows are held at a time.
void render_layers(const rsh::Device& device, const World& world, const rsh_frame_desc& picture,
                   const TakeLayers& take);

}  // namespace render
