#include "bvh/bound.hpp"

#include "rays/bound.hpp"

namespace rsh {

void bound(Recorder& recorder, const rsh_bound_desc& desc) {
    find_bound(desc.bound).bound(recorder, desc);
}

}  // namespace rsh
