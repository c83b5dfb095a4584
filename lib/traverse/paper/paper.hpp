// paper.hpp - the traversal of Roger, Assarsson and Holzschuch 2007, tuned: breadth first,
// every triangle against the root, and no early end, but 16 children per node tested at a time,
// a range of triangles per node instead of a stream of pairs, and survivors counted before they
// are written. What paper_faithful.hpp does as written, for comparison.
#pragma once

#include "traverse/engine.hpp"

namespace rsh {

class Paper final : public Engine {
public:
    cl_uint id() const noexcept override { return RSH_ENGINE_PAPER; }
    const char* name() const noexcept override { return "paper"; }
    cl_uint node_shape() const noexcept override { return RSH_SHAPE_BOX; }
    Layout scratch(const Context& context, const rsh_traverse_desc& desc,
                   BoundsFrom from) const override;
    void traverse(Recorder& recorder, const rsh_traverse_desc& desc) const override;
};

}  // namespace rsh
