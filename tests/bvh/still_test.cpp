// still_test.cpp - a scene of which a part stands still: a refit leaves its bounds alone, and all
// engines find what brute force does. Bounds of another part are no bounds.
#include <gtest/gtest.h>

#include <limits>
#include <memory>

#include "support/compare.hpp"
#include "support/kept_frames.hpp"
#include "support/ways.hpp"

namespace {

using test::device;
using test::DeviceMesh;
using test::Float3;
using test::Mesh;
using test::Random;

struct Split {
    uint32_t triangles, still;
};

std::vector<Split> splits() {
    if (test::small()) return {{33, 17}};
    return {{2, 1},     {33, 0},    {33, 33},     {33, 1},      {33, 32},
            {300, 256}, {300, 150}, {5000, 4700}, {8000, 5000}, {3000, 40}};
}

std::string text_of(const Split& split) {
    return std::to_string(split.still) + " still of " + std::to_string(split.triangles);
}

// Every third corner belongs to two triangles if there is an index, one in either part.
Mesh scene_of(const Split& split, bool is_indexed, Random& random) {
    Mesh mesh =
        test::random_soup(random, split.triangles, split.triangles > 1000 ? 0.1f : 0.4f);
    if (!is_indexed) return mesh;
    mesh.indices.resize(3 * size_t{split.triangles});
    for (uint32_t i = 0; i < mesh.indices.size(); ++i)
        mesh.indices[i] = i % 3 ? i : random.below(uint32_t(mesh.vertices.size()));
    return mesh;
}

// The corners that no still triangle has.
std::vector<bool> moving_vertices(const Mesh& mesh, uint32_t still) {
    std::vector<bool> moves(mesh.vertices.size(), true);
    for (uint32_t i = 0; i < 3 * still; ++i)
        moves[mesh.indices.empty() ? i : mesh.indices[i]] = false;
    return moves;
}

// The scene frame by frame: what moves drifts, then is shaken until no order serves any more.
std::vector<Mesh> frames_of(const Mesh& first, uint32_t still, Random& random) {
    const std::vector<bool> moves = moving_vertices(first, still);
    std::vector<Mesh> frames = {first};
    for (const float by : {0.02f, 0.1f, 1.5f, 0.02f}) {
        Mesh next = frames.back();
        for (size_t i = 0; i < moves.size(); ++i)
            if (moves[i]) next.vertices[i] = next.vertices[i] + random.in_cube(by);
        frames.push_back(next);
    }
    return frames;
}

std::vector<std::unique_ptr<DeviceMesh>> on_device(const std::vector<Mesh>& frames,
                                                   uint32_t still) {
    std::vector<std::unique_ptr<DeviceMesh>> meshes;
    for (const Mesh& frame : frames) {
        meshes.push_back(std::make_unique<DeviceMesh>(frame));
        meshes.back()->stand_still(still);
    }
    return meshes;
}

struct Answers {
    std::vector<rsh_hit> hits;
    std::vector<uint32_t> masks, counts;
};

Answers answers_of(const DeviceMesh& mesh, const test::Rays& rays,
                   const test::TraceOptions& way) {
    const std::vector<uint32_t> none(rays.rays.size(), 0);
    return {closest_hits(mesh, rays, way), occlusion(mesh, rays, none, 3, way),
            hit_counts(mesh, rays, way)};
}

void expect_same(const Answers& actual, const Answers& expected) {
    EXPECT_TRUE(test::same_bits(actual.hits, expected.hits, "hits"));
    EXPECT_TRUE(test::same_bits(actual.masks, expected.masks, "masks"));
    EXPECT_TRUE(test::same_bits(actual.counts, expected.counts, "counts"));
}

// Bounds kept over all frames before, then bounds made for the last one alone, by the caller and
// by the traversal.
void expect_answers(const std::vector<std::unique_ptr<DeviceMesh>>& frames,
                    const test::Rays& rays, test::TraceOptions way,
                    const std::vector<Answers>& expected) {
    way.own_bounds = true;
    for (size_t frame = 0; frame < frames.size(); ++frame) {
        SCOPED_TRACE("frame " + std::to_string(frame));
        expect_same(answers_of(*frames[frame], rays, way), expected[frame]);
        way.earlier.push_back(frames[frame].get());
    }
    way.earlier = {};
    expect_same(answers_of(*frames.back(), rays, way), expected.back());
    way.own_bounds = false;
    expect_same(answers_of(*frames.back(), rays, way), expected.back());
}

TEST(Still, LeavesTheAnswersOfBruteForce) {
    for (const Split& split : splits())
        for (const bool is_indexed : {false, true}) {
            SCOPED_TRACE(text_of(split) + (is_indexed ? ", indexed" : ""));
            Random random(81);
            const Mesh mesh = scene_of(split, is_indexed, random);
            const auto frames = on_device(frames_of(mesh, split.still, random), split.still);
            const uint32_t side = test::small() ? 8 : 32;
            const test::Rays rays = test::random_rays(random, side, side);
            std::vector<Answers> expected;
            for (const auto& frame : frames)
                expected.push_back(answers_of(*frame, rays, test::brute_force()));
            for (const test::TraceOptions& way : test::all_ways()) {
                SCOPED_TRACE(name_of(way));
                expect_answers(frames, rays, way, expected);
            }
        }
}

TEST(Still, LeavesThePixelsOfBruteForce) {
    const Split split = test::small() ? Split{33, 17} : Split{600, 400};
    Random random(85);
    const std::vector<Mesh> frames =
        frames_of(scene_of(split, false, random), split.still, random);
    test::FrameOptions options;
    options.width = options.height = test::small() ? 12 : 40;
    options.bounces = 1;
    for (const test::TraceOptions& way : test::all_ways()) {
        SCOPED_TRACE(name_of(way));
        test::DeviceScene largest(test::mirror_scene(frames[0]));
        largest.desc.geometry.still_triangles = split.still;
        test::KeptFrames kept(way.engine, largest.desc.geometry);
        for (const Mesh& frame : frames) {
            test::DeviceScene scene(test::mirror_scene(frame));
            options.engine = RSH_ENGINE_BRUTE_FORCE;
            const auto expected = test::frame(scene, options);
            scene.desc.geometry.still_triangles = split.still;
            EXPECT_TRUE(test::same_bits(kept.render(scene, options), expected, "pixels"));
        }
    }
}

// Bounds in one buffer, made and refitted as a test asks for.
class KeptBounds {
public:
    KeptBounds(const DeviceMesh& mesh, cl_uint shape) : shape_(shape) {
        const rsh_bound_desc desc = desc_of(mesh, RSH_BOUND_QUALITY);
        rsh_sizes sizes = {};
        sizes.struct_size = sizeof sizes;
        RSH_CHECK(rsh_bound_query(device().rsh, &desc, &sizes));
        memory_ = std::make_unique<test::Buffer<uint8_t>>(
            std::vector<uint8_t>(sizes.output_bytes, 0xa5));
    }

    std::vector<uint8_t> bound(const DeviceMesh& mesh, cl_uint mode) const {
        rsh_bound_desc desc = desc_of(mesh, mode);
        desc.bounds = memory_->get();
        RSH_CHECK(rsh_bound(device().rsh, device().queue(), &desc, 0, nullptr, nullptr));
        device().queue.finish();
        EXPECT_TRUE(memory_->guards_intact());
        return memory_->read();
    }

    void write(const std::vector<uint8_t>& bytes) const { memory_->write(bytes); }
    cl_mem get() const { return memory_->get(); }

private:
    rsh_bound_desc desc_of(const DeviceMesh& mesh, cl_uint mode) const {
        rsh_bound_desc desc = {};
        desc.struct_size = sizeof desc;
        desc.geometry = mesh.geometry();
        desc.shape = shape_;
        desc.mode = mode;
        return desc;
    }

    cl_uint shape_;
    std::unique_ptr<test::Buffer<uint8_t>> memory_;
};

struct Bytes {
    size_t first, count;
};

// What the buffer holds of the triangles that stand still.
std::vector<Bytes> still_bytes(const rsh_geometry& geometry, cl_uint shape) {
    if (shape == RSH_SHAPE_CONE)
        return {{sizeof(spheres_head), sizeof(cl_float4) * geometry.still_triangles}};
    const bvh_layout still = rsh::bvh_layouts_of(geometry)[RSH_STILL_TREE];
    const size_t leaves = sizeof(bvh_head),
                 nodes = leaves + sizeof(bvh_leaf) * still.whole.leaves,
                 rest = 4 * RSH_ORDER_AT(still);
    return {{leaves, sizeof(bvh_leaf) * RSH_LEAVES(still)},
            {nodes, sizeof(bvh_node) * RSH_NODES(still)},
            {rest, 4 * RSH_TREE_END(still) - rest}};
}

std::vector<cl_uint> shapes() {
    return {RSH_SHAPE_CONE, RSH_SHAPE_BOX};
}

// The vertices of what stands still are not numbers by then, so that whoever reads them shows.
TEST(Still, IsNeitherReadNorWrittenByARefit) {
    rsh_device_status(device().rsh, device().queue());  // what tests before left
    const Split split = test::small() ? Split{33, 17} : Split{3000, 2500};
    Random random(82);
    Mesh mesh = scene_of(split, false, random);
    DeviceMesh first(mesh);
    first.stand_still(split.still);
    for (uint32_t i = 0; i < 3 * split.still; ++i)
        mesh.vertices[i] = Float3{std::numeric_limits<float>::quiet_NaN(), 0, 0};
    DeviceMesh second(mesh);
    second.stand_still(split.still);
    for (const cl_uint shape : shapes()) {
        const KeptBounds bounds(first, shape);
        const std::vector<uint8_t> made = bounds.bound(first, RSH_BOUND_QUALITY);
        const std::vector<uint8_t> refitted = bounds.bound(second, RSH_BOUND_REFIT);
        for (const Bytes& part : still_bytes(first.geometry(), shape)) {
            ASSERT_LE(part.first + part.count, made.size());
            EXPECT_EQ(
                std::memcmp(made.data() + part.first, refitted.data() + part.first, part.count),
                0)
                << rsh_shape_name(shape) << ", from byte " << part.first;
        }
        EXPECT_EQ(rsh_device_status(device().rsh, device().queue()), RSH_SUCCESS)
            << rsh_last_error();
    }
}

TEST(Still, CostsOneLaunchMoreThanWhatMovesAlone) {
    const Split split = test::small() ? Split{33, 17} : Split{3000, 2500};
    Random random(83);
    const Mesh mesh = scene_of(split, false, random);
    DeviceMesh both(mesh);
    both.stand_still(split.still);
    Mesh moving;
    moving.vertices.assign(mesh.vertices.begin() + 3 * split.still, mesh.vertices.end());
    const DeviceMesh alone(moving);
    const auto launches_of = [](const DeviceMesh& refitted) {
        const KeptBounds bounds(refitted, RSH_SHAPE_BOX);
        bounds.bound(refitted, RSH_BOUND_QUALITY);
        RSH_CHECK(rsh_count_statistics(device().rsh, CL_TRUE));
        bounds.bound(refitted, RSH_BOUND_REFIT);
        rsh_statistics sums = {};
        sums.struct_size = sizeof sums;
        RSH_CHECK(rsh_get_statistics(device().rsh, &sums));
        RSH_CHECK(rsh_count_statistics(device().rsh, CL_FALSE));
        return sums.launches;
    };
    EXPECT_EQ(launches_of(both), launches_of(alone) + 1);
}

class StillOfAnotherSplit : public ::testing::Test {
protected:
    StillOfAnotherSplit() { rsh_device_status(device().rsh, device().queue()); }
    ~StillOfAnotherSplit() override { rsh_device_status(device().rsh, device().queue()); }

    void expect_told() const {
        EXPECT_EQ(rsh_device_status(device().rsh, device().queue()), RSH_INVALID_VALUE);
        EXPECT_NE(std::string(rsh_last_error()).find("bounds: were not made"),
                  std::string::npos)
            << rsh_last_error();
    }

    size_t count_hits(const KeptBounds& bounds, cl_uint engine) const {
        const test::Buffer<rsh_ray> rays(rays_.rays);
        const test::Buffer<rsh_hit> hits(rays_.rays.size());
        rsh_build_desc build = {};
        build.struct_size = sizeof build;
        build.rays = rays.get();
        build.width = rays_.width;
        build.height = rays_.height;
        build.shape = rsh_engine_shape(engine);
        rsh_sizes sizes = {};
        sizes.struct_size = sizeof sizes;
        RSH_CHECK(rsh_build_query(device().rsh, &build, &sizes));
        const test::Buffer<uint8_t> nodes(sizes.output_bytes);
        build.nodes = nodes.get();
        RSH_CHECK(rsh_build(device().rsh, device().queue(), &build, 0, nullptr, nullptr));
        rsh_traverse_desc desc = {};
        desc.struct_size = sizeof desc;
        desc.geometry = mesh_.geometry();
        desc.bounds = bounds.get();
        desc.rays = rays.get();
        desc.nodes = nodes.get();
        desc.width = rays_.width;
        desc.height = rays_.height;
        desc.hits = hits.get();
        desc.engine = engine;
        desc.shape = rsh_engine_shape(engine);
        RSH_CHECK(rsh_traverse(device().rsh, device().queue(), &desc, 0, nullptr, nullptr));
        size_t found = 0;
        for (const rsh_hit& hit : hits.read()) found += hit.primitive != RSH_NO_HIT;
        return found;
    }

    Random random_{84};
    DeviceMesh mesh_{test::random_soup(random_, 500, 0.4f)};
    test::Rays rays_ = test::pinhole_rays(32, 32);
};

TEST_F(StillOfAnotherSplit, HasNoHits) {
    for (const cl_uint engine : {RSH_ENGINE_TILES, RSH_ENGINE_PAPER}) {
        mesh_.stand_still(400);
        const KeptBounds bounds(mesh_, RSH_SHAPE_BOX);
        bounds.bound(mesh_, RSH_BOUND_QUALITY);
        EXPECT_GT(count_hits(bounds, engine), 0u);
        for (const uint32_t still : {0u, 399u, 500u}) {
            mesh_.stand_still(still);
            EXPECT_EQ(count_hits(bounds, engine), 0u);
            expect_told();
        }
    }
}

// Whatever was there: noise, bounds of another split, bounds of which only the part that moves
// was made. Neither becomes bounds by a refit, which stays within the buffer.
TEST_F(StillOfAnotherSplit, IsNotRefitted) {
    for (const cl_uint engine : {RSH_ENGINE_TILES, RSH_ENGINE_PAPER}) {
        mesh_.stand_still(400);
        const KeptBounds bounds(mesh_, RSH_SHAPE_BOX);
        for (const uint32_t still : {400u, 250u, 100u}) {
            mesh_.stand_still(still);
            for (int again = 0; again < 2; ++again) {
                bounds.bound(mesh_, RSH_BOUND_REFIT);
                expect_told();
                EXPECT_EQ(count_hits(bounds, engine), 0u);
                expect_told();
            }
        }
        bounds.bound(mesh_, RSH_BOUND_FAST);
        bounds.bound(mesh_, RSH_BOUND_REFIT);
        EXPECT_GT(count_hits(bounds, engine), 0u);
        EXPECT_EQ(rsh_device_status(device().rsh, device().queue()), RSH_SUCCESS);
    }
}

TEST_F(StillOfAnotherSplit, HasNoSpheresToKeep) {
    mesh_.stand_still(400);
    const KeptBounds bounds(mesh_, RSH_SHAPE_CONE);
    bounds.bound(mesh_, RSH_BOUND_REFIT);
    expect_told();
    EXPECT_EQ(count_hits(bounds, RSH_ENGINE_PAPER_FAITHFUL), 0u);
    expect_told();
}

// The head in order, all else noise: numbers in it lead nowhere outside of the buffer.
TEST_F(StillOfAnotherSplit, OfNoiseStaysWithinItsBuffer) {
    mesh_.stand_still(400);
    const KeptBounds bounds(mesh_, RSH_SHAPE_BOX);
    std::vector<uint8_t> bytes = bounds.bound(mesh_, RSH_BOUND_QUALITY);
    for (size_t i = offsetof(bvh_head, nodes); i < bytes.size(); ++i)
        bytes[i] = uint8_t(random_.bits());
    bounds.write(bytes);
    bounds.bound(mesh_, RSH_BOUND_REFIT);
}

}  // namespace
