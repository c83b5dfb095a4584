#include "hits/contender.hpp"
#include "stability/traced_scene.hpp"
#include "upload.hpp"

namespace bench::hits {
namespace {

class RshContender final : public Contender {
public:
    RshContender(const DeviceScene& scene, const Column& column)
        : scene_(scene),
          tracer_(scene.device(), scene.geometry(), scene.size(), RSH_QUERY_CLOSEST, column) {
        tracer_.allocate();
        tracer_.set_converging(scene.host().is_converging);
        tracer_.spoil_answers();
    }

    double trace() override { return tracer_.trace(scene_.rays()).total; }
    std::vector<rsh_hit> hits() const override { return tracer_.hits(); }

private:
    const DeviceScene& scene_;
    RshTracer tracer_;
};

}  // namespace

DeviceScene::DeviceScene(const Device& device, const stability::Scene& scene)
    : device_(device),
      scene_(scene),
      vertices_(upload(device, scene.mesh.vertices)),
      indices_(upload(device, scene.mesh.indices)),
      rays_(upload(device, scene.rays.rays)) {
    geometry_.vertices = vertices_();
    geometry_.vertex_count = static_cast<cl_uint>(scene.mesh.vertices.size());
    geometry_.indices = indices_();
    geometry_.triangle_count = scene.mesh.triangle_count();
}

std::vector<ContenderKind> rsh_contenders(const Device& device) {
    std::vector<ContenderKind> kinds;
    for (const Column& column : stability::engines(device)) {
        const bool is_brute = column.engine == RSH_ENGINE_BRUTE_FORCE;
        kinds.push_back(
            {column.name(),
             is_brute ? column.engine_name : column.engine_name + '/' + column.bound_name,
             /*is_peer=*/false, column.engine != RSH_ENGINE_TILES, is_brute,
             [column](const DeviceScene& scene) {
                 return std::make_unique<RshContender>(scene, column);
             }});
    }
    return kinds;
}

}  // namespace bench::hits
