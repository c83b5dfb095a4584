#include "rays/build.hpp"

#include "rays/bound.hpp"

namespace rsh {

void build(Recorder& recorder, const rsh_build_desc& desc) {
    find_bound(desc.bound).build(recorder, desc);
}

}  // namespace rsh
