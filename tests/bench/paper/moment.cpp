#include "paper/moment.hpp"

#include <utility>

#include "scene/device_structs.hpp"
#include "timing.hpp"

namespace bench::paper {
namespace {

// The paper's rays: reflections, and shadows where it tells of them.
rsh_features features_without(const Row& row) {
    return RSH_FEATURE_REFRACTION | (row.has_shadows ? 0 : RSH_FEATURE_SHADOW);
}

accuracy::Staged staged_for(const StillScene& still, Size size) {
    accuracy::Staged made = accuracy::staged(still);
    made.camera = render::device_camera(still.camera, float(size.width) / float(size.height));
    return made;
}

}  // namespace

Moment::Moment(const Device& device, StillScene scene, const Row& row)
    : device_(device),
      still_(std::move(scene)),
      staged_(staged_for(still_, row.size)),
      on_device_(device, staged_),
      scene_(on_device_.without(features_without(row))) {}

double Moment::upload() const {
    const render::Mesh& mesh = still_.mesh;
    return milliseconds([&] {
        send(scene_.geometry.vertices, mesh.positions);
        send(scene_.normals, mesh.normals);
    });
}

void Moment::send(cl_mem buffer, const std::vector<glm::vec3>& items) const {
    if (buffer && !items.empty())
        device_.queue().enqueueWriteBuffer(cl::Buffer(buffer, true), CL_TRUE, 0,
                                           items.size() * sizeof(glm::vec3), items.data());
}

}  // namespace bench::paper
