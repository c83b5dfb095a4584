// scene_source.hpp - a scene of the tests as a source of batches: as many triangles at a time as it likes.
#pragma once

#include <algorithm>
#include <cstring>

#include "support/device_scene.hpp"

namespace test {

class SceneSource {
public:
    // No batch has more than `most` triangles; how many, chance says, or all have as many as they can.
    SceneSource(const Scene& scene, uint32_t most, bool is_random = true)
        : scene_(scene), is_random_(is_random) {
        source_.struct_size = sizeof source_;
        source_.fill = [](rsh_batch* batch, void* self) {
            return static_cast<SceneSource*>(self)->fill(*batch);
        };
        source_.user = this;
        source_.triangle_count = scene.mesh.triangle_count();
        source_.batch_triangles = most;
        if (!scene.mesh.indices.empty()) source_.attributes |= RSH_BATCH_INDICES;
        if (!scene.normals.empty()) source_.attributes |= RSH_BATCH_NORMALS;
        if (!scene.texcoords.empty()) source_.attributes |= RSH_BATCH_TEXCOORDS;
        if (!scene.material_ids.empty()) source_.attributes |= RSH_BATCH_MATERIAL_IDS;
    }
    SceneSource(const SceneSource&) = delete;
    SceneSource& operator=(const SceneSource&) = delete;

    const rsh_batch_source* get() const { return &source_; }
    uint32_t batches() const { return batches_; }
    // That it has handed out; a scene is gone through more than once.
    uint32_t triangles() const { return triangles_; }
    void stop_after(uint32_t batches) { last_ = batches; }

private:
    // Each triangle brings its own three vertices.
    int fill(rsh_batch& batch) {
        if (batches_ == last_) return 1;
        ++batches_;
        const uint32_t left = source_.triangle_count - batch.first_triangle;
        const uint32_t most = std::min(batch.triangle_capacity, left);
        batch.triangle_count = is_random_ ? most - random_.below(most / 2 + 1) : most;
        triangles_ += batch.triangle_count;
        batch.vertex_count = 3 * batch.triangle_count;
        for (uint32_t k = 0; k < batch.vertex_count; ++k) {
            const uint32_t corner = 3 * batch.first_triangle + k;
            const uint32_t vertex =
                scene_.mesh.indices.empty() ? corner : scene_.mesh.indices[corner];
            // Out of range stays so.
            const bool is_there = vertex < scene_.mesh.vertices.size();
            if (batch.indices) batch.indices[k] = is_there ? k : 0xffffffffu;
            if (!is_there) continue;
            copy(scene_.mesh.vertices, vertex, batch.positions, k);
            copy(scene_.normals, vertex, batch.normals, k);
            copy(scene_.texcoords, vertex, batch.texcoords, k);
        }
        for (uint32_t i = 0; batch.material_ids && i < batch.triangle_count; ++i)
            batch.material_ids[i] = scene_.material_ids[batch.first_triangle + i];
        return 0;
    }

    template <class T>
    static void copy(const std::vector<T>& from, uint32_t i, float* to, uint32_t k) {
        if (to) std::memcpy(to + k * (sizeof(T) / 4), &from[i], sizeof(T));
    }

    const Scene& scene_;
    const bool is_random_;
    Random random_{5};
    rsh_batch_source source_ = {};
    uint32_t batches_ = 0, triangles_ = 0, last_ = 0xffffffffu;
};

// The scene without what its batches bring.
inline void leave_to_batches(rsh_scene& scene) {
    scene.geometry = {};
    scene.normals = scene.texcoords = scene.material_ids = nullptr;
}

}  // namespace test
