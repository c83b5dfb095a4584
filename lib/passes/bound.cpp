#include "passes/bound.hpp"

#include "passes/mesh.hpp"

namespace rsh {

void bound(Recorder& recorder, const rsh_bound_desc& desc) {
    const rsh_geometry& geometry = desc.geometry;
    recorder.launch(RSH_STAGE_BOUND, {"program_traverse", "rsh_bound"},
                    recorder.range(geometry.triangle_count), mesh_of(geometry),
                    geometry.vertices, geometry.indices, desc.spheres);
}

}  // namespace rsh
