// memory.hpp - the memory of a frame, which it works off in strips (strips.hpp): per bounce a wave of
// rays, and what all waves share. The first wave is the strip, or some of its pixels; each later one
// holds what the one before it sent on, packed, or a part of that if there is no room for more.
// Declares buffers; pipeline.cpp says what happens in them.
#pragma once

#include <algorithm>
#include <vector>

#include "approximate/approximate.hpp"
#include "batches/seen_triangles.hpp"
#include "device/cl/scratch.hpp"
#include "frame/passes.hpp"
#include "frame/strips.hpp"
#include "rays/node_shape.hpp"
#include "shade/shade.hpp"
#include "shade/wave.hpp"

namespace rsh {

// The strategy of all its traversals; see reduce/strategy.hpp.
cl_uint chosen_strategy(const Context& context, const rsh_frame_desc& desc);
Layout frame_scratch(const Context& context, const rsh_frame_desc& desc);
// With strips and batches of that size.
Layout strip_scratch(const Context& context, const rsh_frame_desc& desc, const StripSize& size);

// Rays of a bounce: a screen, or a list of height 1.
struct Wave {
    cl_uint bounce, width, height;

    cl_uint rays() const { return width * height; }
};

class FrameMemory {
public:
    FrameMemory(Recorder& recorder, const rsh_frame_desc& desc);

    // The strip that begins in that row; false: there is none.
    bool take_strip(cl_uint first_row);
    cl_uint rows() const { return size_.rows; }
    Wave screen() const { return {0, desc_.width, desc_.height}; }
    // Of an approximate frame: first waves of some pixels.
    Wave grid() const { return {0, grid_.columns, grid_.rows}; }
    Wave rest(cl_uint count) const { return {0, count, 1}; }
    // Rays that a wave after the first one may hold.
    cl_uint most_rays() const { return desc_.width * size_.rows; }
    // Such a wave, which has up to `most` rays. How many, only list_count says.
    Wave packed(cl_uint bounce, cl_ulong most) const {
        return {bounce, static_cast<cl_uint>(std::min<cl_ulong>(most, most_rays())), 1};
    }
    bool traces_rays() const;
    bool casts_shadows() const;
    bool has_bounces() const;
    bool is_approximate() const;
    bool is_in_batches() const { return desc_.batches != nullptr; }
    // Whether the host waits for counts of the device.
    bool reads_counts() const { return has_bounces() || is_approximate(); }

    // Descriptors of the stages over this frame's memory.
    rsh_rasterize_desc rasterize() const;
    rsh_bound_desc bound() const;
    rsh_build_desc build(const Wave& wave) const;
    rsh_traverse_desc traverse(const Wave& wave) const;
    rsh_audit_desc audit(const Wave& wave) const;
    rsh_audit_desc audit_screen() const;
    // Of a scene in batches, in which the camera's rays are traced like others.
    rsh_build_desc build_screen() const;
    rsh_traverse_desc traverse_screen() const;
    rsh_shade_desc shade(const Wave& wave) const;
    // From a part of a wave to the next one. is_counted: of that part only as many rays as the
    // wave has.
    WavePass next(const Wave& wave, const wave_part& part, bool is_counted) const;
    // One light at the hits of a wave, and the rays to it.
    LightPass light(const Wave& wave, cl_uint light, bool is_base) const;
    rsh_build_desc build_shadow(const Wave& wave, cl_uint light) const;
    rsh_traverse_desc traverse_shadow(const Wave& wave, cl_uint light) const;
    rsh_audit_desc audit_shadow(const Wave& wave, cl_uint light) const;

    // Of a scene in batches: the batch, and the triangles that a wave hits.
    BatchNeeds batch_needs() const { return rsh::batch_needs(desc_); }
    BatchMemory batch() const { return batch_memory(scratch_, size_.triangles); }
    SeenTriangles seen(cl_uint bounce) const {
        return seen_triangles(scratch_, bounce, most_rays());
    }

    // Of an approximate frame: the pixels of its first grid; between those of a grid, the ones that
    // are not like them.
    PixelPass grid_pixels() const;
    BlendPass blend(cl_uint step) const;
    rsh_reduce_desc pack_listed(cl_uint step) const;
    PixelPass rest_pixels(cl_uint count) const;
    cl_mem rest_count() const { return scratch_["rest count"]; }

    cl_mem hits(cl_uint bounce) const { return at("hits", bounce); }
    cl_mem colour(cl_uint bounce) const {
        return bounce || is_approximate() ? at("colour", bounce) : colour_.get();
    }
    cl_mem occlusion() const { return scratch_.find("occlusion"); }
    cl_mem wrong_buffers() const { return scratch_["wrong buffers"]; }
    cl_mem active_count() const { return scratch_["active count"]; }
    // One word; NULL: of the first wave.
    cl_mem list_count(const Wave& wave) const;
    // A word per bounce, as in WavePass, and one more.
    cl_mem spawned_counts() const { return scratch_["spawned counts"]; }
    cl_mem skip() const { return scratch_.find("skip"); }

private:
    // The same pass over the shadow rays of a light.
    template <class Pass>
    Pass of_shadow(Pass pass, cl_uint light) const;
    rsh_spawn_desc spawn_shadow(const Wave& wave, cl_uint light) const;
    PixelPass pixels() const;
    cl_mem at(const char* name, cl_uint bounce) const;
    cl_mem weights(const Wave& wave) const;
    // What the hits of that bounce name triangles of.
    const rsh_scene* scene(cl_uint bounce) const;
    // Rays that left triangles which those of that bounce hit.
    rsh_traverse_desc leaving(rsh_traverse_desc pass, cl_uint bounce) const;
    cl_mem bounds() const;

    const rsh_frame_desc whole_;
    const StripSize size_;  // of all strips but the last
    rsh_frame_desc desc_;   // of the strip
    pixel_grid grid_;       // the first one of the strip
    Scratch scratch_;
    std::vector<rsh_scene> seen_scenes_;  // per bounce, of a scene in batches
    Buffer colour_;                       // of the strip
};

}  // namespace rsh
