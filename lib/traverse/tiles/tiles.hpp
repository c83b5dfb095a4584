// tiles.hpp - each work-item finishes a tile of 256 rays on its own
// (traverse/tiles/traverse_tiles.cl): boxes of the scene front to back, and nothing behind the
// tile's farthest hit.
#pragma once

#include "traverse/engine.hpp"

namespace rsh {

class Tiles final : public Engine {
public:
    cl_uint id() const noexcept override { return RSH_ENGINE_TILES; }
    const char* name() const noexcept override { return "tiles"; }
    cl_uint node_shape() const noexcept override { return RSH_SHAPE_BOX; }
    Layout scratch(const Context& context, const rsh_traverse_desc& desc,
                   BoundsFrom from) const override;
    void traverse(Recorder& recorder, const rsh_traverse_desc& desc) const override;
};

}  // namespace rsh
