// prepare.cpp - the C boundary of rsh_prepare: goes through each call without enqueueing anything,
// which tells the programs that it needs. So they are named nowhere but where they are launched.
#include "api/check.hpp"
#include "api/settle.hpp"
#include "bvh/scene_bounds.hpp"
#include "camera/rasterize.hpp"
#include "device/cl/recorder.hpp"
#include "pipeline.hpp"
#include "rays/node_shape.hpp"
#include "reduce/strategy.hpp"
#include "shade/find_surfaces.hpp"
#include "shade/shade.hpp"
#include "shade/spawn.hpp"
#include "shade/spawn_wave.hpp"
#include "shadow/shadow.hpp"
#include "trace/trace.hpp"
#include "traverse/audit.hpp"
#include "traverse/engine.hpp"

namespace rsh {
namespace {

// What a call would look into or call.
template <class Desc>
void leave_out_what_acts(Desc&) {}
void leave_out_what_acts(rsh_traverse_desc& desc) {
    desc.progress = nullptr;
}
void leave_out_what_acts(rsh_trace_desc& desc) {
    desc.progress = nullptr;
}
void leave_out_what_acts(rsh_frame_desc& desc) {
    desc.progress = nullptr;
    desc.colour = nullptr;
}

class Calls {
public:
    Calls(Context& context, NeededPrograms& needed)
        : context_(context), recorder_(context, needed) {}

    template <class Desc, class Pass>
    void add(const Desc* desc, const char* name, const char* size_field, Pass pass) {
        if (!desc) return;
        const Received<Desc> received(desc, name, size_field);
        Desc settled = settled_shape(context_, *received);
        leave_out_what_acts(settled);
        pass(recorder_, settled);
    }

private:
    Context& context_;
    Recorder recorder_;
};

NeededPrograms needed_by(Context& context, const rsh_prepare_desc& desc) {
    NeededPrograms needed;
    Calls calls(context, needed);
#define RSH_ADD(call) calls.add(desc.call, #call, #call ".struct_size", rsh::call)
    RSH_ADD(rasterize);
    RSH_ADD(bound);
    RSH_ADD(build);
    RSH_ADD(traverse);
    RSH_ADD(trace);
    RSH_ADD(audit);
    RSH_ADD(spawn);
    RSH_ADD(spawn_wave);
    RSH_ADD(gather_wave);
    RSH_ADD(shadow);
    RSH_ADD(find_surfaces);
    RSH_ADD(shade);
    RSH_ADD(frame);
    RSH_ADD(reduce);
#undef RSH_ADD
    return needed;
}

// With general programs, all that calls cannot do without comes before the variants.
NeededPrograms in_order(const NeededPrograms& needed, Variants& variants, bool general) {
    NeededPrograms all;
    for (const KernelName& name : needed.kernels()) {
        if (!general) break;
        if (name.is_variant) variants.allow_general(name);
        all.add(name.is_variant ? general_of(name) : name);
    }
    for (const KernelName& name : needed.kernels()) all.add(variants.in_advance(name));
    return all;
}

}  // namespace
}  // namespace rsh

extern "C" {

rsh_status rsh_prepare(rsh_context context, const rsh_prepare_desc* desc) {
    return rsh::guarded([&] {
        rsh::Context& checked = rsh::checked_context(context);
        const rsh::Received<rsh_prepare_desc> received(desc);
        rsh::require(received->background <= 1, "background", received->background, "0 or 1");
        rsh::require(received->general <= 1, "general", received->general, "0 or 1");
        rsh::Preparation preparation = {
            rsh::in_order(rsh::needed_by(checked, *received), checked.variants,
                          received->general != CL_FALSE),
            received->progress, received->progress_user};
        if (received->background)
            checked.preparer.start(std::move(preparation));
        else
            checked.preparer.prepare(preparation);
    });
}

rsh_status rsh_wait_prepared(rsh_context context) {
    return rsh::guarded([&] { rsh::checked_context(context).preparer.wait(); });
}

}  // extern "C"
