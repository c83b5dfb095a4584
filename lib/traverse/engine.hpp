// engine.hpp - one way to find what rays hit. All engines give the same bits; list.cpp knows
// which ones there are.
#pragma once

#include <vector>

#include "device/cl/recorder.hpp"
#include "device/cl/scratch.hpp"

namespace rsh {

// Whether the triangles' bounds are the caller's or the traversal's own.
enum class SceneBounds { given, made };

inline SceneBounds scene_bounds_of(const rsh_traverse_desc& desc) {
    return desc.bounds ? SceneBounds::given : SceneBounds::made;
}

class Engine {
public:
    virtual ~Engine() = default;
    virtual cl_uint id() const noexcept = 0;        // RSH_ENGINE_...
    virtual const char* name() const noexcept = 0;  // command lines, logs, benchmarks
    // The bounds that it takes, the preferred one first; none: it needs neither bounds nor
    // nodes.
    virtual std::vector<cl_uint> bounds() const = 0;
    cl_uint preferred_bound() const {
        const std::vector<cl_uint> taken = bounds();
        return taken.empty() ? cl_uint{RSH_BOUND_DEFAULT} : taken.front();
    }
    // Reads none of the descriptor's buffers, not even whether they are there.
    virtual Layout scratch(const Context& context, const rsh_traverse_desc& desc,
                           SceneBounds bounds) const = 0;
    virtual void traverse(Recorder& recorder, const rsh_traverse_desc& desc) const = 0;
};

const std::vector<const Engine*>& engines();
const Engine& find_engine(cl_uint id);  // throws; RSH_ENGINE_DEFAULT: the quickest

// A bound that the engine does not take is refused.
void check_bound(const Engine& engine, cl_uint bound);

// Room for the scene's bounds, and their making, where the caller gives none.
void reserve_bounds(Layout& scratch, const Context& context, const rsh_traverse_desc& desc,
                    SceneBounds bounds);
cl_mem make_bounds(Recorder& recorder, const rsh_traverse_desc& desc, const Scratch& scratch);

// Tells the caller which batch comes; throws when he asks to stop.
void report_progress(const rsh_traverse_desc& desc, cl_uint batch, cl_uint batch_count);

}  // namespace rsh
