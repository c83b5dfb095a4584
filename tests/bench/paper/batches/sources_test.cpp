// sources_test.cpp - a mesh in batches is the mesh, and copies are copies. Needs no device.
#include <gtest/gtest.h>

#include "paper/batches/sources.hpp"

namespace bench::paper {
namespace {

render::Mesh fan(uint32_t triangles) {
    render::Mesh mesh;
    mesh.positions.push_back({0, 0, 0});
    for (uint32_t i = 0; i <= triangles; ++i)
        mesh.positions.push_back({float(i), 1 + float(i * i), float(i % 3)});
    for (uint32_t i = 0; i < triangles; ++i) {
        mesh.triangles.push_back({0, i + 1, i + 2});
        mesh.material_ids.push_back(i % 4);
    }
    return mesh;
}

struct Filled {
    std::vector<glm::vec3> corners;  // three per triangle
    std::vector<uint32_t> material_ids;
    size_t batches = 0;
};

// Everything that a source hands out, with room for so many triangles at a time.
Filled all_of(const rsh_batch_source& source, cl_uint capacity) {
    Filled all;
    while (all.corners.size() < size_t{3} * source.triangle_count) {
        std::vector<glm::vec3> positions(3 * capacity);
        std::vector<cl_uint> indices(3 * capacity), material_ids(capacity);
        rsh_batch batch{};
        batch.struct_size = sizeof batch;
        batch.first_triangle = cl_uint(all.corners.size() / 3);
        batch.triangle_capacity = capacity;
        batch.vertex_capacity = 3 * capacity;
        batch.positions = &positions[0].x;
        if (source.attributes & RSH_BATCH_INDICES) batch.indices = indices.data();
        batch.material_ids = material_ids.data();
        EXPECT_EQ(source.fill(&batch, source.user), 0);
        EXPECT_LE(batch.triangle_count, capacity);
        EXPECT_LE(batch.vertex_count, 3 * capacity);
        if (batch.triangle_count == 0) break;
        for (cl_uint i = 0; i < 3 * batch.triangle_count; ++i)
            all.corners.push_back(positions.at(batch.indices ? indices[i] : i));
        all.material_ids.insert(all.material_ids.end(), material_ids.begin(),
                                material_ids.begin() + batch.triangle_count);
        ++all.batches;
    }
    return all;
}

TEST(BatchSources, HandOutTheMesh) {
    const render::Mesh mesh = fan(100);
    const MeshSource source(mesh, 7);
    EXPECT_EQ(source.get().batch_triangles, 7u);
    const Filled all = all_of(source.get(), 7);
    EXPECT_EQ(all.batches, 15u);
    ASSERT_EQ(all.corners.size(), 300u);
    for (size_t i = 0; i < all.corners.size(); ++i)
        EXPECT_EQ(all.corners[i], mesh.positions[mesh.triangles[i / 3][int(i % 3)]]) << i;
    EXPECT_EQ(all.material_ids, mesh.material_ids);
}

TEST(BatchSources, RepeatAMeshOfSizeOne) {
    const render::Mesh mesh = fan(10);
    const RepeatedSource source(mesh, 9, 0);
    EXPECT_EQ(source.get().triangle_count, 90u);
    const Filled all = all_of(source.get(), 25);  // two copies at a time
    EXPECT_EQ(all.batches, 5u);
    ASSERT_EQ(all.corners.size(), 270u);
    for (size_t copy = 0; copy < 9; ++copy) {
        float low = INFINITY, high = -INFINITY;
        for (size_t i = 30 * copy; i < 30 * copy + 30; ++i)
            low = std::min(low, all.corners[i].y), high = std::max(high, all.corners[i].y);
        EXPECT_NEAR(high - low, 1.0f, 1e-5f) << "copy " << copy;
        for (size_t other = 0; other < copy; ++other)
            EXPECT_NE(all.corners[30 * copy], all.corners[30 * other]);
    }
}

}  // namespace
}  // namespace bench::paper
