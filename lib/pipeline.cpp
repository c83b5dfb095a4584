// pipeline.cpp - the data flow of a frame; read this first.
//
// The paper's five steps: (1) rasterize what the camera sees and spawn secondary rays, (2)
// build the hierarchy over them, (3) push the triangles down it, (4) intersect and shade, (5)
// repeat from (2) for the rays that the hits spawn. With the engine `tiles`, step (3) takes
// the rays through the scene's BVH16 instead, which `bound` makes or refits. Each line calls a
// stage, and each stage has a room in lib/ and kernels/; api/rsh.cpp exposes the stages one by
// one. Knows no buffer sizes: that is frame/memory.cpp.
#include "pipeline.hpp"

#include <limits>
#include <optional>
#include <vector>

#include "approximate/approximate.hpp"
#include "batches/find_hits.hpp"
#include "bvh/scene_bounds.hpp"
#include "camera/rasterize.hpp"
#include "device/cl/wrong_buffers.hpp"
#include "device/error.hpp"
#include "frame/memory.hpp"
#include "rays/node_shape.hpp"
#include "reduce/strategy.hpp"
#include "shade/clear_colour.hpp"
#include "shade/cut.hpp"
#include "shade/shade.hpp"
#include "shade/wave.hpp"
#include "traverse/audit.hpp"
#include "traverse/engine.hpp"

namespace rsh {
namespace {

class Frame {
public:
    Frame(Recorder& recorder, const rsh_frame_desc& desc)
        : recorder_(recorder), desc_(desc), memory_(recorder, desc) {
        if (memory_.is_in_batches())
            feed_.emplace(recorder, memory_.batch_needs(), memory_.batch(),
                          [this] { report_progress(); });
    }

    void render() {
        // For the counts, which are behind them; one that fails would hold them up for ever.
        if (memory_.reads_counts() || feed_) recorder_.wait_for_callers();
        if (memory_.traces_rays()) recorder_.own_wrong_buffers(memory_.wrong_buffers());
        if (desc_.audit_rays) clear_report(recorder_, desc_.audit);
        if (memory_.traces_rays() && !feed_) bound(recorder_, memory_.bound());
        for (cl_uint row = 0; memory_.take_strip(row); row += memory_.rows()) render_strip();
    }

private:
    void render_strip() {
        rasterize(recorder_, memory_.rasterize());
        if (feed_) trace_screen();
        audit_hits(memory_.audit_screen());
        if (memory_.is_approximate())
            approximate();
        else
            render_pixels(memory_.screen());
    }

    // The scene comes in batches: what was rasterized are rays without hits.
    void trace_screen() {
        build(recorder_, memory_.build_screen());
        find_closest(memory_.traverse_screen(), 0);
    }

    // The pixels of a grid, then those between them, from grid to finer grid.
    void approximate() {
        render_some(memory_.grid_pixels(), memory_.grid());
        for (cl_uint step = RSH_WIDEST_STEP; step > 1; step /= 2) {
            blend_pixels(recorder_, memory_.blend(step));
            reduce(recorder_, memory_.pack_listed(step));
            const cl_uint count = recorder_.read_now(memory_.rest_count(), 1).front();
            if (count) render_some(memory_.rest_pixels(count), memory_.rest(count));
        }
    }

    void render_some(const PixelPass& pixels, const Wave& wave) {
        take_pixels(recorder_, pixels);
        render_pixels(wave);
        put_pixels(recorder_, pixels);
    }

    // What the camera's rays see in the end, all of a strip's or some.
    void render_pixels(const Wave& wave) {
        begin_image(wave);
        shade_wave(wave);
        if (memory_.has_bounces()) spawn_waves(wave, whole_wave(wave.width, wave.height));
    }

    // All waves that come of a part of a wave, then their colours, back to that part. If one does not
    // fit, those that come of the first half of the wave before it, then of the second half.
    void spawn_waves(const Wave& from, const wave_part& part) {
        for (cl_uint bounce = from.bounce; bounce < desc_.bounces; ++bounce) {
            const WavePass pass = pass_of(bounce, from, part);
            count_branches(recorder_, pass);
            spawn_branches(recorder_, pass);
            trace_wave(packed(from, part, bounce + 1));
        }
        const std::vector<cl_uint> spawned = read_counts();
        cl_uint last = from.bounce;
        while (last < desc_.bounces && fits(spawned[last])) ++last;
        if (last < desc_.bounces && spawned[last] > 0) {
            if (last == from.bounce)
                spawn_halves(from, part);
            else
                spawn_halves(packed(from, part, last), whole_wave(spawned[last - 1], 1));
        }
        while (last-- > from.bounce)
            gather_branches(recorder_, pass_of(last, from, part), memory_.colour(last + 1),
                            memory_.colour(last));
    }

    void spawn_halves(const Wave& wave, const wave_part& part) {
        const cl_uint half = part.count / 2;
        spawn_waves(wave, {part.width, part.height, part.first, half});
        spawn_waves(wave, {part.width, part.height, part.first + half, part.count - half});
    }

    // From that bounce to the next one, of the waves that come of a part of `from`.
    WavePass pass_of(cl_uint bounce, const Wave& from, const wave_part& part) const {
        if (bounce == from.bounce) return memory_.next(from, part, false);
        const Wave wave = packed(from, part, bounce);
        return memory_.next(wave, whole_wave(wave.width, wave.height), true);
    }

    // One of the waves that come of a part of `from`. Each ray sends on one of each kind at most.
    Wave packed(const Wave& from, const wave_part& part, cl_uint bounce) const {
        const bool has_both = branch_kinds(*desc_.scene) == (1 << RSH_BRANCHES) - 1;
        const cl_uint doublings = has_both ? bounce - from.bounce : 0;
        return memory_.packed(bounce, cl_ulong{part.count} << doublings);
    }

    bool fits(cl_uint spawned) const { return spawned > 0 && spawned <= memory_.most_rays(); }

    void trace_wave(const Wave& wave) {
        if (!feed_) report_progress();
        count_rays(wave);
        build(recorder_, memory_.build(wave));
        find_closest(memory_.traverse(wave), wave.bounce);
        audit_hits(memory_.audit(wave));
        shade_wave(wave);
    }

    void find_closest(const rsh_traverse_desc& pass, cl_uint bounce) {
        if (!feed_) return traverse(recorder_, pass);
        const SeenTriangles seen = memory_.seen(bounce);
        find_hits(recorder_, *feed_, memory_.batch(), pass, &seen);
    }

    void find_hidden(const rsh_traverse_desc& pass) {
        if (!feed_) return traverse(recorder_, pass);
        find_hits(recorder_, *feed_, memory_.batch(), pass, nullptr);
    }

    void shade_wave(const Wave& wave) {
        if (memory_.casts_shadows())
            shade_lights(wave);
        else if (wave.bounce == 0)
            shade(recorder_, memory_.shade(wave));
        else
            shade_first(recorder_, memory_.shade(wave));
        if (desc_.scene->cut != RSH_CUT_BLACK) add_cut_branches(wave);
    }

    // Without a weight to fall below, only the last wave has branches that are not traced.
    void add_cut_branches(const Wave& wave) {
        const bool is_last = wave.bounce == desc_.bounces;
        if (branch_kinds(*desc_.scene) == 0 || (!is_last && desc_.min_weight == 0)) return;
        add_cut(recorder_, memory_.shade(wave),
                is_last ? std::numeric_limits<float>::infinity() : desc_.min_weight);
    }

    // Light by light; the first one with all that no shadow falls on.
    void shade_lights(const Wave& wave) {
        bool is_base = true;
        for (cl_uint light = 0; light < desc_.scene->light_count; ++light) {
            if (!(desc_.scene->shadow_lights >> light & 1)) continue;
            const LightPass pass = memory_.light(wave, light, is_base);
            is_base = false;
            cast_rays(wave, pass);
            build(recorder_, memory_.build_shadow(wave, light));
            find_hidden(memory_.traverse_shadow(wave, light));
            audit_hits(memory_.audit_shadow(wave, light));
            add_light(recorder_, pass);
        }
    }

    void audit_hits(const rsh_audit_desc& wave) {
        if (desc_.audit_rays) audit(recorder_, wave);
    }

    // Light by light, lest their sum outgrow 32 bits; only statistics read the count.
    void cast_rays(const Wave& wave, const LightPass& pass) {
        if (is_counting_) clear_active_count();
        shade_lit(recorder_, pass);
        count_later([bounce = wave.bounce](rsh_statistics& sums, const cl_uint* count) {
            sums.shadow_rays[bounce] += *count;
        });
    }

    void begin_image(const Wave& wave) {
        clear_active_count();
        clear_colour(recorder_, *desc_.scene, memory_.hits(0), wave.rays(), memory_.colour(0),
                     memory_.active_count());
        count_later(
            [](rsh_statistics& sums, const cl_uint* count) { sums.active_rays[0] += *count; });
    }

    void clear_active_count() {
        recorder_.fill(RSH_STAGE_OTHER, memory_.active_count(), 0, sizeof(cl_uint));
    }

    // Where a frame waits for what it enqueued: for how many rays each wave sent on.
    // Bounds that were none end the frame.
    std::vector<cl_uint> read_counts() {
        const size_t bounces = desc_.bounces;
        recorder_.copy_word(recorder_.wrong_buffers(), memory_.spawned_counts(), bounces);
        std::vector<cl_uint> spawned =
            recorder_.read_now(memory_.spawned_counts(), bounces + 1);
        require_right_buffers(spawned.back());
        spawned.pop_back();
        return spawned;
    }

    void count_rays(const Wave& wave) {
        if (!is_counting_) return;
        recorder_.count_later(memory_.list_count(wave), 1,
                              [wave](rsh_statistics& sums, const cl_uint* count) {
                                  sums.active_rays[wave.bounce] += *count;
                              });
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
    std::optional<BatchFeed> feed_;  // of a scene that comes in batches
    const bool is_counting_ = recorder_.context().statistics.enabled();
    cl_uint waves_ = 0;
};

}  // namespace

void frame(Recorder& recorder, const rsh_frame_desc& desc) {
    Frame(recorder, desc).render();
}

}  // namespace rsh
