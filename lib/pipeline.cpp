// pipeline.cpp - the data flow of a frame; read this first.
//
// The paper's five steps: (1) rasterize what the camera sees and spawn secondary rays, (2)
// build the hierarchy over them, (3) push the triangles down it, (4) intersect and shade, (5)
// repeat from (2) for the rays that the hits spawn. With the engine `tiles`, step (3) takes
// the rays through the scene's BVH16 instead, which `bound` makes or refits. Each line calls a
// stage, and each stage has a room in lib/ and kernels/; api/rsh.cpp exposes the stages one by
// one. Knows no buffer sizes: that is frame/memory.cpp.
#include "pipeline.hpp"

#include "bvh/scene_bounds.hpp"
#include "camera/rasterize.hpp"
#include "device/cl/wrong_buffers.hpp"
#include "device/error.hpp"
#include "frame/memory.hpp"
#include "rays/node_shape.hpp"
#include "shade/clear_colour.hpp"
#include "shade/shade.hpp"
#include "shade/spawn.hpp"
#include "traverse/audit.hpp"
#include "traverse/engine.hpp"

namespace rsh {
namespace {

class Frame {
public:
    Frame(Recorder& recorder, const rsh_frame_desc& desc)
        : recorder_(recorder), desc_(desc), memory_(recorder, desc) {}

    void render() {
        // For a wave, which is behind them; one that fails would hold it up for ever.
        if (memory_.has_bounces()) recorder_.wait_for_callers();
        if (memory_.traces_rays()) recorder_.own_wrong_buffers(memory_.wrong_buffers());
        if (desc_.audit_rays) clear_report(recorder_, desc_.audit);
        rasterize(recorder_, memory_.rasterize());
        audit_hits(memory_.audit(0));
        if (memory_.traces_rays()) bound(recorder_, memory_.bound());
        begin_image();
        shade_wave(0);
        spawn_waves(0);
    }

private:
    // The ray tree, depth first: all reflections of a wave and what they see, then its
    // refractions.
    void spawn_waves(cl_uint bounce) {
        if (bounce == desc_.bounces) return;
        if (has(RSH_FEATURE_REFLECTION)) trace_wave(bounce, RSH_SPAWN_REFLECTION);
        if (has(RSH_FEATURE_REFRACTION)) trace_wave(bounce, RSH_SPAWN_REFRACTION);
    }

    void trace_wave(cl_uint bounce, cl_uint kind) {
        clear_active_count();
        spawn(recorder_, memory_.spawn(bounce, kind));
        if (!count_wave(bounce + 1)) return;
        report_progress();
        build(recorder_, memory_.build(bounce + 1));
        traverse(recorder_, memory_.traverse(bounce + 1));
        audit_hits(memory_.audit(bounce + 1));
        shade_wave(bounce + 1);
        spawn_waves(bounce + 1);
    }

    void shade_wave(cl_uint bounce) {
        if (memory_.casts_shadows()) cast_shadows(bounce);
        shade(recorder_, memory_.shade(bounce));
    }

    void cast_shadows(cl_uint bounce) {
        recorder_.fill(RSH_STAGE_OTHER, memory_.occlusion(), 0, size_t{memory_.pixels()} * 4);
        for (cl_uint light = 0; light < desc_.scene->light_count; ++light) {
            if (!(desc_.scene->shadow_lights >> light & 1)) continue;
            spawn_shadow(bounce, light);
            build(recorder_, memory_.build_shadow(light));
            traverse(recorder_, memory_.traverse_shadow(light));
            audit_hits(memory_.audit_shadow(light));
        }
    }

    void audit_hits(const rsh_audit_desc& wave) {
        if (desc_.audit_rays) audit(recorder_, wave);
    }

    // Light by light, lest their sum outgrow 32 bits; only statistics read the count.
    void spawn_shadow(cl_uint bounce, cl_uint light) {
        if (is_counting_) clear_active_count();
        spawn(recorder_, memory_.spawn_shadow(bounce, light));
        count_later([bounce](rsh_statistics& sums, const cl_uint* count) {
            sums.shadow_rays[bounce] += *count;
        });
    }

    void begin_image() {
        clear_active_count();
        clear_colour(recorder_, *desc_.scene, memory_.hits(0), memory_.pixels(), desc_.colour,
                     memory_.active_count());
        count_later(
            [](rsh_statistics& sums, const cl_uint* count) { sums.active_rays[0] += *count; });
    }

    bool has(rsh_features feature) const { return (desc_.scene->features & feature) != 0; }

    void clear_active_count() {
        recorder_.fill(RSH_STAGE_OTHER, memory_.active_count(), 0, sizeof(cl_uint));
    }

    // The one place where a frame waits for what it enqueued: an empty wave ends its branch of the
    // tree, and bounds that were none end the frame.
    bool count_wave(cl_uint bounce) {
        recorder_.copy_word(recorder_.wrong_buffers(), memory_.active_count(), 1);
        const auto [count, wrong_buffers] = recorder_.read_now(memory_.active_count());
        require_right_buffers(wrong_buffers);
        recorder_.context().statistics.add([bounce, count = count](rsh_statistics& sums) {
            sums.active_rays[bounce] += count;
        });
        return count > 0;
    }

    template <class Use>
    void count_later(Use use) {
        if (is_counting_) recorder_.count_later(memory_.active_count(), 1, use);
    }

    void report_progress() {
        if (desc_.progress && desc_.progress(waves_++, 0, desc_.progress_user))
            throw Error(RSH_CANCELLED, "progress: asked to stop");
    }

    Recorder& recorder_;
    const rsh_frame_desc& desc_;
    FrameMemory memory_;
    const bool is_counting_ = recorder_.context().statistics.enabled();
    cl_uint waves_ = 0;
};

}  // namespace

void frame(Recorder& recorder, const rsh_frame_desc& desc) {
    Frame(recorder, desc).render();
}

}  // namespace rsh
