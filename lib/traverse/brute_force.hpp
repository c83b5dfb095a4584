// brute_force.hpp - every ray against every triangle (traverse/brute_force.cl): what the others
// must equal.
#pragma once

#include "traverse/engine.hpp"

namespace rsh {

class BruteForce final : public Engine {
public:
    cl_uint id() const noexcept override { return RSH_ENGINE_BRUTE_FORCE; }
    const char* name() const noexcept override { return "brute_force"; }
    cl_uint node_shape() const noexcept override { return RSH_SHAPE_DEFAULT; }
    Layout scratch(const Context& context, const rsh_traverse_desc& desc,
                   BoundsFrom from) const override;
    void traverse(Recorder& recorder, const rsh_traverse_desc& desc) const override;
};

}  // namespace rsh
