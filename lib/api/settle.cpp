#include "api/settle.hpp"

#include "frame/memory.hpp"
#include "reduce/strategy.hpp"
#include "shadow/shadow.hpp"
#include "trace/trace.hpp"
#include "traverse/engine.hpp"

namespace rsh {
namespace {

void fill_engine(const Context& context, cl_uint& engine) {
    if (engine == RSH_ENGINE_DEFAULT) engine = default_engine(context.caps).id();
}

void fill_shape(const Context& context, cl_uint& shape) {
    if (shape == RSH_SHAPE_DEFAULT) shape = default_engine(context.caps).node_shape();
}

// Of calls that build nodes themselves.
template <class Desc>
void fill_engine_and_its_shape(const Context& context, Desc& desc) {
    fill_engine(context, desc.engine);
    if (desc.shape == RSH_SHAPE_DEFAULT) desc.shape = find_engine(desc.engine).node_shape();
    fill_shape(context, desc.shape);
}

}  // namespace

void fill_defaults(const Context& context, rsh_bound_desc& desc) {
    fill_shape(context, desc.shape);
}

void fill_defaults(const Context& context, rsh_build_desc& desc) {
    fill_shape(context, desc.shape);
}

// Bounds and nodes were made by other calls, which cannot know the engine.
void fill_defaults(const Context& context, rsh_traverse_desc& desc) {
    fill_engine(context, desc.engine);
    fill_shape(context, desc.shape);
}

void fill_defaults(const Context& context, rsh_trace_desc& desc) {
    fill_engine(context, desc.engine);
}

void fill_defaults(const Context& context, rsh_shadow_desc& desc) {
    fill_engine_and_its_shape(context, desc);
}

void fill_defaults(const Context& context, rsh_frame_desc& desc) {
    fill_engine_and_its_shape(context, desc);
}

void settle_strategy(const Context& context, rsh_reduce_desc& desc) {
    desc.strategy = chosen_strategy(context, desc.strategy, desc.count);
}

void settle_strategy(const Context& context, rsh_traverse_desc& desc) {
    desc.strategy = chosen_strategy(context, desc);
}

void settle_strategy(const Context& context, rsh_trace_desc& desc) {
    desc.strategy = chosen_strategy(context, desc);
}

void settle_strategy(const Context& context, rsh_shadow_desc& desc) {
    desc.strategy = chosen_strategy(context, desc);
}

void settle_strategy(const Context& context, rsh_frame_desc& desc) {
    desc.strategy = chosen_strategy(context, desc);
}

}  // namespace rsh
