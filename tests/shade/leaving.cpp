// leaving.cpp - spawns and traces for leaving.hpp, as rsh_frame does.
#include "shade/leaving.hpp"

#include "support/trace.hpp"

namespace test {
namespace {

Scene scene_of(const Mesh& mesh, float index) {
    Scene scene;
    scene.mesh = mesh;
    rsh_material material = matte({1, 1, 1});
    material.reflection = {{1, 1, 1, 0}};
    if (index != 0) material.transmission = {{1, 1, 1, index}};
    scene.materials = {material};
    scene.lights = {directional_light({0.3f, -0.8f, 0.5f}, {1, 1, 1})};
    return scene;
}

}  // namespace

std::vector<Departures> send(const Mesh& mesh, const Rays& rays, const Sending& sending) {
    const DeviceScene scene(scene_of(mesh, sending.index));
    const DeviceMesh on_device(mesh);
    const std::vector<rsh_hit> hits = closest_hits(on_device, rays);
    TraceOptions trace;
    trace.context = sending.context;
    std::vector<Departures> all;
    for (const uint32_t kind : sending.kinds) {
        SpawnOptions options;
        options.kind = kind;
        options.context = sending.context;
        const Spawned spawned = spawn(scene, rays.rays, hits, options);
        const Rays next{spawned.rays, uint32_t(spawned.rays.size()), 1, spawned.skip};
        all.push_back({spawned.rays, spawned.skip, closest_hits(on_device, next, trace), {}});
    }
    return all;
}

Tally follow(const Mesh& mesh, Double3 centre, const Rays& rays, const Sending& sending) {
    Tally tally;
    for (Departures& departures : send(mesh, rays, sending)) {
        departures.exact = oracle::closest(mesh, departures.rays, departures.skip);
        tally.add(judge({mesh, centre}, departures));
    }
    return tally;
}

}  // namespace test
