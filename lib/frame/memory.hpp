// memory.hpp - the memory of a frame: one wave of rays per bounce, and what all waves share. A
// wave is a screen of rays, all reflections or all refractions of the wave before it, inactive
// where there is none. Declares buffers; pipeline.cpp says what happens in them.
#pragma once

#include "device/cl/scratch.hpp"
#include "rays/node_shape.hpp"

namespace rsh {

// The strategy of all its traversals; see reduce/strategy.hpp.
cl_uint chosen_strategy(const Context& context, const rsh_frame_desc& desc);
Layout frame_scratch(const Context& context, const rsh_frame_desc& desc);

class FrameMemory {
public:
    FrameMemory(Recorder& recorder, const rsh_frame_desc& desc);

    cl_uint pixels() const { return desc_.width * desc_.height; }
    bool traces_rays() const;
    bool casts_shadows() const;
    bool has_bounces() const;

    // Descriptors of the public calls over this frame's memory, for the wave of a bounce.
    rsh_rasterize_desc rasterize() const;
    rsh_bound_desc bound() const;
    rsh_build_desc build(cl_uint bounce) const;
    rsh_traverse_desc traverse(cl_uint bounce) const;
    rsh_audit_desc audit(cl_uint bounce) const;
    rsh_spawn_desc spawn(cl_uint bounce, cl_uint kind) const;
    rsh_shade_desc shade(cl_uint bounce) const;
    // The shadow rays of one light at the hits of a bounce.
    rsh_spawn_desc spawn_shadow(cl_uint bounce, cl_uint light) const;
    rsh_build_desc build_shadow(cl_uint light) const;
    rsh_traverse_desc traverse_shadow(cl_uint light) const;
    rsh_audit_desc audit_shadow(cl_uint light) const;

    cl_mem hits(cl_uint bounce) const { return at("hits", bounce); }
    cl_mem occlusion() const { return scratch_.find("occlusion"); }
    cl_mem wrong_buffers() const { return scratch_["wrong buffers"]; }
    cl_mem active_count() const { return scratch_["active count"]; }
    cl_mem skip() const { return scratch_.find("skip"); }

private:
    // The same pass over the shadow rays of a light.
    template <class Pass>
    Pass of_shadow(Pass pass, cl_uint light) const;
    cl_mem at(const char* name, cl_uint bounce) const;
    // Without the rays that are spawned.
    rsh_spawn_desc spawn_at(cl_uint bounce, cl_uint kind) const;
    cl_mem bounds() const;

    rsh_frame_desc desc_;
    Scratch scratch_;
};

}  // namespace rsh
