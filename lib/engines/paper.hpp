// paper.hpp - the traversal of Roger, Assarsson and Holzschuch 2007: breadth first, one level
// per pass, every triangle against the root, four children per pair, a reduction after each
// level.
#pragma once

#include "engines/engine.hpp"

namespace rsh {

class Paper final : public Engine {
public:
    cl_uint id() const noexcept override { return RSH_ENGINE_PAPER; }
    const char* name() const noexcept override { return "paper"; }
    bool needs_nodes() const noexcept override { return true; }
    Layout scratch(const Context& context, const rsh_traverse_desc& desc,
                   Spheres spheres) const override;
    void traverse(Recorder& recorder, const rsh_traverse_desc& desc) const override;
};

}  // namespace rsh
