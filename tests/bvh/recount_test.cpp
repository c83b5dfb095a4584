// recount_test.cpp - bounds that are kept over frames with other numbers of triangles: whatever
// a refit finds in the buffer, the hits are those of brute force, and nothing outside is
// touched.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <memory>

#include "support/compare.hpp"
#include "support/kept_frames.hpp"
#include "support/ways.hpp"

namespace {

using test::DeviceMesh;
using test::Mesh;
using Counts = std::vector<uint32_t>;

// Back to an earlier number after less, more, or nothing; numbers that differ in few words of
// the shape, or in none but the number itself.
std::vector<Counts> recounts() {
    if (test::small()) return {{33, 17, 33}};
    return {{64, 32, 64},
            {1000, 500, 1000},
            {100, 90, 100},
            {69451, 34000, 69451},
            {1, 2, 1},
            {50, 0, 50},
            {0, 50, 0, 50},
            {33, 32, 31, 33},
            {16, 40, 300, 40, 16},
            {257, 256, 257, 256},
            {5000, 4999, 5000, 5001, 5000}};
}

std::string text_of(const Counts& counts) {
    std::string text;
    for (const uint32_t count : counts)
        text += (text.empty() ? "" : ", ") + std::to_string(count);
    return text + " triangles";
}

// The first of the same triangles in each frame, so that their order would serve.
Mesh first_of(const Mesh& mesh, uint32_t count) {
    Mesh first;
    first.vertices.assign(mesh.vertices.begin(), mesh.vertices.begin() + 3 * count);
    return first;
}

Mesh soup_for(const Counts& counts, test::Random& random) {
    const uint32_t most = *std::max_element(counts.begin(), counts.end());
    return test::random_soup(random, most, most > 10000 ? 0.03f : 0.3f);
}

TEST(Recount, LeavesTheHitsOfBruteForce) {
    for (const Counts& counts : recounts()) {
        SCOPED_TRACE(text_of(counts));
        test::Random random(60);
        const Mesh mesh = soup_for(counts, random);
        const uint32_t side = test::small() ? 12 : 48;
        const test::Rays rays = test::random_rays(random, side, side);
        std::vector<const DeviceMesh*> earlier;
        std::vector<std::unique_ptr<DeviceMesh>> frames;
        for (const uint32_t count : counts) {
            frames.push_back(std::make_unique<DeviceMesh>(first_of(mesh, count)));
            const auto expected = closest_hits(*frames.back(), rays, test::brute_force());
            for (test::TraceOptions way : test::all_ways()) {
                way.own_bounds = true;
                way.earlier = earlier;
                EXPECT_TRUE(
                    test::same_bits(closest_hits(*frames.back(), rays, way), expected, "hits"))
                    << name_of(way) << ", frame " << earlier.size();
            }
            earlier.push_back(frames.back().get());
        }
    }
}

rsh_bound_desc bound_desc(const rsh_geometry& geometry, cl_uint bound, cl_uint update) {
    rsh_bound_desc desc = {};
    desc.struct_size = sizeof desc;
    desc.geometry = geometry;
    desc.shape = bound;
    desc.mode = update;
    return desc;
}

size_t bounds_bytes(const rsh_bound_desc& desc) {
    rsh_sizes sizes = {};
    sizes.struct_size = sizeof sizes;
    RSH_CHECK(rsh_bound_query(test::device().rsh, &desc, &sizes));
    return sizes.output_bytes;
}

TEST(Recount, LeavesThePixelsOfBruteForce) {
    test::FrameOptions options;
    options.width = options.height = test::small() ? 12 : 40;
    options.bounces = 1;
    options.engine = RSH_ENGINE_BRUTE_FORCE;
    for (const Counts& counts : recounts()) {
        SCOPED_TRACE(text_of(counts));
        test::Random random(61);
        const Mesh mesh = soup_for(counts, random);
        const DeviceMesh largest(mesh);
        std::map<cl_uint, test::KeptFrames> kept;
        for (const test::TraceOptions& way : test::all_ways())
            kept.try_emplace(way.engine, way.engine, largest.geometry());
        for (const uint32_t count : counts) {
            const test::DeviceScene scene(test::mirror_scene(first_of(mesh, count)));
            const auto expected = test::frame(scene, options);
            for (auto& [engine, frames] : kept)
                EXPECT_TRUE(test::same_bits(frames.render(scene, options), expected, "pixels"))
                    << rsh_engine_name(engine) << ", frame of " << count;
        }
    }
}

// Words from `first` to `end` of bounds that were made in order become noise; then a refit.
void expect_update_within_buffers(const DeviceMesh& mesh, test::Random& random, size_t first,
                                  size_t end) {
    rsh_bound_desc desc = bound_desc(mesh.geometry(), RSH_SHAPE_BOX, RSH_BOUND_QUALITY);
    const test::Buffer<uint32_t> bounds(bounds_bytes(desc) / 4);
    desc.bounds = bounds.get();
    RSH_CHECK(
        rsh_bound(test::device().rsh, test::device().queue(), &desc, 0, nullptr, nullptr));
    std::vector<uint32_t> words = bounds.read();
    for (size_t i = first; i < end; ++i) words[i] = uint32_t(random.bits());
    bounds.write(words);
    desc.mode = RSH_BOUND_REFIT;
    RSH_CHECK(
        rsh_bound(test::device().rsh, test::device().queue(), &desc, 0, nullptr, nullptr));
    test::device().queue.finish();
    EXPECT_TRUE(bounds.guards_intact());
}

// With the head in order, the rest is believed to be bounds; numbers in it still lead nowhere
// else.
TEST(Recount, OfNoiseStaysWithinItsBuffers) {
    for (const uint32_t count : {1u, 40u, 3000u}) {
        if (test::small() && count > 40) continue;
        SCOPED_TRACE(std::to_string(count) + " triangles");
        test::Random random(62);
        const DeviceMesh mesh(test::random_soup(random, count));
        const bvh_layout shape = rsh::bvh_layouts_of(mesh.geometry())[RSH_MOVING_TREE];
        const size_t head = sizeof(bvh_head) / 4, order = RSH_ORDER_AT(shape);
        expect_update_within_buffers(mesh, random, head - 9, order); /* the head's groups too */
        expect_update_within_buffers(mesh, random, order, RSH_QUALITY_AT(shape));
        expect_update_within_buffers(mesh, random, RSH_PARTS_AT(shape), RSH_TREE_END(shape));
        expect_update_within_buffers(mesh, random, 0, RSH_TREE_END(shape));
    }
}

}  // namespace
