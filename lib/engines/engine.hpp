// engine.hpp - one way to find what rays hit. All engines give the same bits; list.cpp knows
// which ones there are.
#pragma once

#include <vector>

#include "cl/recorder.hpp"

namespace rsh {

// Whether the triangles' spheres are the caller's or the traversal's own.
enum class Spheres { given, made };

inline Spheres spheres_of(const rsh_traverse_desc& desc) {
    return desc.spheres ? Spheres::given : Spheres::made;
}

class Engine {
public:
    virtual ~Engine() = default;
    virtual cl_uint id() const noexcept = 0;        // RSH_ENGINE_...
    virtual const char* name() const noexcept = 0;  // command lines, logs, benchmarks
    virtual bool needs_nodes() const noexcept = 0;  // rsh_traverse_desc::nodes
    // Reads none of the descriptor's buffers, not even whether they are there.
    virtual Layout scratch(const Context& context, const rsh_traverse_desc& desc,
                           Spheres spheres) const = 0;
    virtual void traverse(Recorder& recorder, const rsh_traverse_desc& desc) const = 0;
};

const std::vector<const Engine*>& engines();
const Engine& find_engine(cl_uint id);  // throws; RSH_ENGINE_DEFAULT: the quickest

}  // namespace rsh
