// list_hits.hpp - all hits of each ray, in lists: an engine counts and records them in any order, then
// they are put in place (traverse/list_hits.cl).
#pragma once

#include "traverse/engine.hpp"

namespace rsh {

// Of all lists; the numbers of their records fit into 32 bits.
constexpr cl_ulong kMaxHits = cl_ulong{1} << 31;

Layout list_scratch(const Context& context, const rsh_traverse_desc& desc, BoundsFrom bounds);
void list_hits(Recorder& recorder, const rsh_traverse_desc& desc);

}  // namespace rsh
