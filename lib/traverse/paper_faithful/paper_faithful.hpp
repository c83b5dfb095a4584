// paper_faithful.hpp - the traversal of Roger, Assarsson and Holzschuch 2007: breadth first,
// one level per pass, every triangle against the root, four children per pair, a reduction
// after each level.
#pragma once

#include "traverse/engine.hpp"

namespace rsh {

class PaperFaithful final : public Engine {
public:
    cl_uint id() const noexcept override { return RSH_ENGINE_PAPER_FAITHFUL; }
    const char* name() const noexcept override { return "paper_faithful"; }
    cl_uint node_shape() const noexcept override { return RSH_SHAPE_CONE; }
    cl_uint longest_stream(const rsh_traverse_desc& desc) const override;
    Layout scratch(const Context& context, const rsh_traverse_desc& desc,
                   BoundsFrom from) const override;
    void traverse(Recorder& recorder, const rsh_traverse_desc& desc) const override;
};

}  // namespace rsh
