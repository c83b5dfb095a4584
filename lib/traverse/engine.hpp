// engine.hpp - one way to find what rays hit. All engines give the same bits; list.cpp knows
// which ones there are.
#pragma once

#include "device/choices.hpp"
#include "device/cl/recorder.hpp"
#include "device/cl/scratch.hpp"

namespace rsh {

// Who makes the scene's bounds.
enum class BoundsFrom { caller, traversal };

inline BoundsFrom bounds_from(const rsh_traverse_desc& desc) {
    return desc.bounds ? BoundsFrom::caller : BoundsFrom::traversal;
}

class Engine {
public:
    virtual ~Engine() = default;
    virtual cl_uint id() const noexcept = 0;        // RSH_ENGINE_...
    virtual const char* name() const noexcept = 0;  // command lines, logs, benchmarks
    // RSH_SHAPE_... of the nodes that it takes; RSH_SHAPE_DEFAULT: it needs neither bounds nor
    // nodes.
    virtual cl_uint node_shape() const noexcept = 0;
    // Whether its kernels are made for what the device reports; only then it may be the default.
    virtual bool suits(const DeviceCaps&) const noexcept { return true; }
    // Whether it takes rsh_traverse_desc::tests_per_ray.
    virtual bool counts_tests_per_ray() const noexcept { return false; }
    // Hits of a ray that it packs in order, see kernels/traverse/tiles/pack_hits.h; 0: it makes a record of
    // each hit.
    virtual cl_uint packed_hits() const noexcept { return 0; }
    // Whether it can go on from hits of other batches of the scene; else they are merged.
    virtual bool continues_hits() const noexcept { return false; }
    // Elements of the longest stream that it reduces; 0: it takes no strategy.
    virtual cl_uint longest_stream(const rsh_traverse_desc&) const { return 0; }
    // Reads none of the descriptor's buffers, not even whether they are there.
    virtual Layout scratch(const Context& context, const rsh_traverse_desc& desc,
                           BoundsFrom bounds) const = 0;
    virtual void traverse(Recorder& recorder, const rsh_traverse_desc& desc) const = 0;
};

Choices<Engine> engines();
const Engine& find_engine(cl_uint id);  // throws
// What RSH_ENGINE_DEFAULT stands for: the first one that suits the device.
const Engine& default_engine(const DeviceCaps& caps) noexcept;

// Finds what the rays hit.
void traverse(Recorder& recorder, const rsh_traverse_desc& desc);
// Bytes of the hits, or of a word per ray.
cl_ulong answer_bytes(const rsh_traverse_desc& desc);
// What it needs; without `bounds`, these included where the descriptor has none.
Layout traverse_scratch(const Context& context, const rsh_traverse_desc& desc);
Layout traverse_scratch(const Context& context, const rsh_traverse_desc& desc,
                        BoundsFrom bounds);

// The strategy that a call is to use; see reduce/strategy.hpp.
cl_uint chosen_strategy(const Context& context, const rsh_traverse_desc& desc);

// A shape that the engine does not take is refused.
void check_node_shape(const Engine& engine, cl_uint shape);

// Room for the scene's bounds, and their making, where the caller gives none.
void reserve_bounds(Layout& scratch, const Context& context, const rsh_traverse_desc& desc,
                    BoundsFrom from);
cl_mem make_bounds(Recorder& recorder, const rsh_traverse_desc& desc, const Scratch& scratch);

// Tells the caller which batch comes; throws when he asks to stop.
void report_progress(const rsh_traverse_desc& desc, cl_uint batch, cl_uint batch_count);

}  // namespace rsh
