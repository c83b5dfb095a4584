#include "stability/spawned/spawn.hpp"

#include <algorithm>

#include "stability/traced_scene.hpp"
#include "upload.hpp"

namespace bench::stability {
namespace {

// The scene on the device, as rsh_spawn wants it.
class SpawnScene {
public:
    SpawnScene(const Device& device, const Scene& scene, const std::vector<rsh_hit>& hits)
        : device_(device),
          count_(hits.size()),
          vertices_(upload(device, scene.mesh.vertices)),
          indices_(upload(device, scene.mesh.indices)),
          material_ids_(upload(device, scene.spawning->material_ids)),
          materials_(upload(device, scene.spawning->materials)),
          lights_(upload(device, std::vector<rsh_light>{scene.spawning->light})),
          rays_(upload(device, scene.rays.rays)),
          hits_(upload(device, hits)),
          spawned_rays_(upload(device, std::vector<rsh_ray>(count_))),
          weights_(upload(device, std::vector<cl_float4>(count_))),
          skip_(upload(device, std::vector<cl_uint>(count_))) {
        desc_.struct_size = sizeof desc_;
        desc_.geometry.vertices = vertices_();
        desc_.geometry.vertex_count = static_cast<cl_uint>(scene.mesh.vertices.size());
        desc_.geometry.indices = indices_();
        desc_.geometry.triangle_count = scene.mesh.triangle_count();
        desc_.material_ids = material_ids_();
        desc_.materials = materials_();
        desc_.material_count = static_cast<cl_uint>(scene.spawning->materials.size());
        desc_.lights = lights_();
        desc_.light_count = 1;
        rsh::check(
            rsh_find_features(&desc_, scene.spawning->materials.data(), &scene.spawning->light),
            "rsh_find_features");
    }

    // Of those rays whose kind it is.
    void spawn(cl_uint kind, Scene& scene, Spawned& spawned) const {
        rsh_spawn_desc desc{};
        desc.struct_size = sizeof desc;
        desc.scene = &desc_;
        desc.kind = kind;
        desc.ray_count = static_cast<cl_uint>(count_);
        desc.rays = rays_();
        desc.hits = hits_();
        desc.spawned_rays = spawned_rays_();
        desc.spawned_weights = kind == RSH_SPAWN_SHADOW ? nullptr : weights_();
        desc.spawned_skip = skip_();
        rsh::check(rsh_spawn(device_.rsh(), device_.queue()(), &desc, 0, nullptr, nullptr),
                   "rsh_spawn");
        const auto rays = read<rsh_ray>(spawned_rays_);
        const auto weights = read<cl_float4>(weights_);
        const auto skip = read<cl_uint>(skip_);
        for (size_t i = 0; i < count_; ++i) {
            if (scene.spawning->kinds[i] != kind) continue;
            scene.rays.rays[i] = rays[i];
            scene.rays.skip[i] = skip[i];
            spawned.weights[i] = kind == RSH_SPAWN_SHADOW ? cl_float4{} : weights[i];
        }
    }

private:
    template <class T>
    std::vector<T> read(const cl::Buffer& buffer) const {
        std::vector<T> items(count_);
        device_.queue().enqueueReadBuffer(buffer, CL_TRUE, 0, count_ * sizeof(T), items.data());
        return items;
    }

    const Device& device_;
    size_t count_;
    cl::Buffer vertices_, indices_, material_ids_, materials_, lights_, rays_, hits_,
        spawned_rays_, weights_, skip_;
    rsh_scene desc_{};
};

}  // namespace

Spawned spawn(const Device& device, Scene& scene) {
    Column brute_force;
    brute_force.engine = RSH_ENGINE_BRUTE_FORCE;
    Spawned spawned;
    spawned.seen = scene.rays;
    spawned.hits = TracedScene(device, scene).closest(brute_force, false);
    spawned.weights.resize(spawned.hits.size());
    const SpawnScene on_device(device, scene, spawned.hits);
    scene.rays.skip.assign(spawned.hits.size(), RSH_NO_HIT);
    const std::vector<uint32_t>& kinds = scene.spawning->kinds;
    for (const cl_uint kind : {RSH_SPAWN_REFLECTION, RSH_SPAWN_REFRACTION, RSH_SPAWN_SHADOW})
        if (std::find(kinds.begin(), kinds.end(), kind) != kinds.end())
            on_device.spawn(kind, scene, spawned);
    return spawned;
}

}  // namespace bench::stability
