#include "paper/batches/sources.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/gtc/matrix_transform.hpp>

namespace bench::paper {
namespace {

// Far from a whole number of turns: no two neighbours look alike.
constexpr float kTurn = 2.4f;  // radians, from copy to copy

void write(const glm::vec3& v, float* to) {
    std::memcpy(to, &v, sizeof v);
}

// Every second bit, from bit `first` on: a place on a curve in Z to a column or a row.
cl_uint every_second_bit(cl_uint place, cl_uint first) {
    cl_uint found = 0;
    for (cl_uint bit = 0; bit < 16; ++bit) found |= (place >> (2 * bit + first) & 1) << bit;
    return found;
}

std::vector<glm::vec3> at_origin(std::vector<glm::vec3> positions) {
    glm::vec3 low(INFINITY), high(-INFINITY);
    for (const glm::vec3& p : positions) low = glm::min(low, p), high = glm::max(high, p);
    const glm::vec3 side = high - low;
    for (glm::vec3& p : positions)
        p = (p - 0.5f * (low + high)) / std::max({side.x, side.y, side.z});
    return positions;
}

}  // namespace

MeshSource::MeshSource(const render::Mesh& mesh, cl_uint most) : mesh_(mesh) {
    source_.struct_size = sizeof source_;
    source_.fill = [](rsh_batch* batch, void* self) {
        return static_cast<const MeshSource*>(self)->fill(*batch);
    };
    source_.user = this;
    source_.triangle_count = static_cast<cl_uint>(mesh.triangles.size());
    source_.batch_triangles = most;
    source_.attributes = RSH_BATCH_MATERIAL_IDS;
    if (!mesh.normals.empty()) source_.attributes |= RSH_BATCH_NORMALS;
}

// Each triangle with vertices of its own.
int MeshSource::fill(rsh_batch& batch) const {
    batch.triangle_count =
        std::min(batch.triangle_capacity, source_.triangle_count - batch.first_triangle);
    batch.vertex_count = 3 * batch.triangle_count;
    for (cl_uint i = 0; i < batch.vertex_count; ++i) {
        const cl_uint vertex = mesh_.triangles[batch.first_triangle + i / 3][int(i % 3)];
        write(mesh_.positions[vertex], batch.positions + 3 * i);
        if (batch.normals) write(mesh_.normals[vertex], batch.normals + 3 * i);
    }
    std::copy_n(mesh_.material_ids.begin() + batch.first_triangle, batch.triangle_count,
                batch.material_ids);
    return 0;
}

RepeatedSource::RepeatedSource(const render::Mesh& mesh, cl_uint count, cl_uint most)
    : positions_(at_origin(mesh.positions)), triangles_(mesh.triangles), count_(count) {
    source_.struct_size = sizeof source_;
    source_.fill = [](rsh_batch* batch, void* self) {
        return static_cast<const RepeatedSource*>(self)->fill(*batch);
    };
    source_.user = this;
    source_.triangle_count = count * static_cast<cl_uint>(triangles_.size());
    source_.batch_triangles = most;
    source_.attributes = RSH_BATCH_INDICES;
}

int RepeatedSource::fill(rsh_batch& batch) const {
    const cl_uint triangles = static_cast<cl_uint>(triangles_.size()),
                  vertices = static_cast<cl_uint>(positions_.size());
    batch.triangle_count = batch.vertex_count = 0;
    for (cl_uint copy = batch.first_triangle / triangles;
         copy < count_ && batch.triangle_count + triangles <= batch.triangle_capacity &&
         batch.vertex_count + vertices <= batch.vertex_capacity;
         ++copy)
        add_copy(copy, batch);
    return batch.triangle_count == 0;
}

void RepeatedSource::add_copy(cl_uint number, rsh_batch& batch) const {
    const float columns = std::ceil(std::sqrt(float(count_)));
    const glm::vec3 place(float(every_second_bit(number, 0)) - 0.5f * columns, 0.3f,
                          -float(every_second_bit(number, 1)));
    const glm::mat3 turn(
        glm::rotate(glm::mat4(1.0f), kTurn * float(number), glm::vec3(0, 1, 0)));
    float* position = batch.positions + 3 * batch.vertex_count;
    for (const glm::vec3& p : positions_) write(turn * p + place, position), position += 3;
    cl_uint* index = batch.indices + 3 * batch.triangle_count;
    for (const glm::uvec3& triangle : triangles_)
        for (int k = 0; k < 3; ++k) *index++ = triangle[k] + batch.vertex_count;
    batch.vertex_count += static_cast<cl_uint>(positions_.size());
    batch.triangle_count += static_cast<cl_uint>(triangles_.size());
}

}  // namespace bench::paper
