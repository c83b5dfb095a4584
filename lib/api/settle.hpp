// settle.hpp - what a descriptor leaves to the library, chosen once per call: engine and shape by
// the device, so that checks and passes see none that is a default; then, of what was checked,
// the strategy, which a self-test may mask while the call is under way.
#pragma once

#include "api/check.hpp"

namespace rsh {

template <class Desc>
void fill_defaults(const Context&, Desc&) {}
void fill_defaults(const Context& context, rsh_bound_desc& desc);
void fill_defaults(const Context& context, rsh_build_desc& desc);
void fill_defaults(const Context& context, rsh_traverse_desc& desc);
void fill_defaults(const Context& context, rsh_trace_desc& desc);
void fill_defaults(const Context& context, rsh_shadow_desc& desc);
void fill_defaults(const Context& context, rsh_frame_desc& desc);

template <class Desc>
void settle_strategy(const Context&, Desc&) {}
void settle_strategy(const Context& context, rsh_reduce_desc& desc);
void settle_strategy(const Context& context, rsh_traverse_desc& desc);
void settle_strategy(const Context& context, rsh_trace_desc& desc);
void settle_strategy(const Context& context, rsh_shadow_desc& desc);
void settle_strategy(const Context& context, rsh_frame_desc& desc);

// Throws unless all but the buffers is right.
template <class Desc>
Desc settled_shape(const Context& context, Desc desc) {
    fill_defaults(context, desc);
    check_shape(desc);
    settle_strategy(context, desc);
    return desc;
}

}  // namespace rsh
