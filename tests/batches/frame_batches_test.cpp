// frame_batches_test.cpp - frames of scenes that come in batches have the bits of those that do not.
#include <gtest/gtest.h>

#include "batches/scene_source.hpp"
#include "support/compare.hpp"
#include "support/render.hpp"
#include "support/ways.hpp"

namespace {

using test::DeviceScene;
using test::FrameOptions;
using test::SceneSource;

// Copies of triangles, coincident and turned, and some that are none.
test::Scene with_copies(test::Scene scene) {
    const test::Mesh mesh = scene.mesh;
    test::Random random(29);
    for (uint32_t i = 0; i < 60; ++i) {
        const uint32_t triangle = random.below(mesh.triangle_count());
        for (uint32_t k = 0; k < 3; ++k)
            scene.mesh.indices.push_back(mesh.indices[3 * triangle + (k + i) % 3]);
        scene.material_ids.push_back(random.below(uint32_t(scene.materials.size())));
    }
    for (const uint32_t index : {0u, 1u, 1u << 30}) scene.mesh.indices.push_back(index);
    scene.material_ids.push_back(0);
    return scene;
}

class FrameBatches : public ::testing::Test {
protected:
    FrameBatches() {
        options_.width = test::small() ? 9 : 61;
        options_.height = test::small() ? 70 : 133;
        options_.bounces = 2;
        test::leave_to_batches(batched_.desc);
    }

    std::vector<cl_float4> in_batches(const SceneSource& source, FrameOptions options) {
        options.batches = source.get();
        return test::frame(batched_, options);
    }

    void expect_bits_of_the_whole(const FrameOptions& options) {
        const auto whole = test::frame(whole_, options);
        for (const uint32_t most : {1u << 20, scene_.mesh.triangle_count(), 1000u, 150u}) {
            const SceneSource source(scene_, most);
            EXPECT_TRUE(test::same_bits(in_batches(source, options), whole, "pixels"))
                << "batches of at most " << most;
            EXPECT_GT(source.batches(), 0u);
        }
    }

    const test::Scene scene_ = with_copies(test::gallery());
    const DeviceScene whole_{scene_};
    DeviceScene batched_{scene_};
    FrameOptions options_;
};

TEST_F(FrameBatches, HaveTheBitsOfTheWholeScene) {
    for (const test::TraceOptions& way : test::brute_force_and_all_ways()) {
        SCOPED_TRACE(name_of(way));
        options_.engine = way.engine;
        expect_bits_of_the_whole(options_);
    }
}

TEST_F(FrameBatches, HaveThemWithAnyNumberOfBounces) {
    for (options_.bounces = 0; options_.bounces < 5; ++options_.bounces) {
        SCOPED_TRACE("bounces " + std::to_string(options_.bounces));
        expect_bits_of_the_whole(options_);
    }
}

TEST_F(FrameBatches, HaveThemWhereTheyAreApproximate) {
    options_.tolerance = 0.05f;
    expect_bits_of_the_whole(options_);
}

TEST_F(FrameBatches, HaveThemWithoutLightsThatCastShadows) {
    rsh_scene& scene = batched_.desc;
    scene.features &= ~RSH_FEATURE_SHADOW;
    const DeviceScene whole(scene_, RSH_FEATURE_SHADOW);
    for (options_.bounces = 0; options_.bounces < 2; ++options_.bounces) {
        const SceneSource source(scene_, 200);
        EXPECT_TRUE(test::same_bits(in_batches(source, options_), test::frame(whole, options_),
                                    "pixels"));
    }
}

// Whose waves are worked off in parts, too.
TEST_F(FrameBatches, HaveThemWithEveryBudget) {
    const auto whole = test::frame(whole_, options_);
    const SceneSource source(scene_, 0);
    options_.batches = source.get();
    const size_t least = test::least_budget(batched_, options_);
    for (const bool own_scratch : {false, true})
        for (const size_t budget : {least, least + least / 4, 2 * least, 5 * least}) {
            options_.budget = budget;
            options_.own_scratch = own_scratch;
            EXPECT_TRUE(test::same_bits(test::frame(batched_, options_), whole, "pixels"))
                << "budget " << budget << " from " << least;
        }
}

// Layouts are those of the batches: packed, whatever the scene says of buffers that it does not have.
TEST_F(FrameBatches, HaveThemWhereTheSceneHasStridesOfItsOwn) {
    const auto whole = test::frame(whole_, options_);
    batched_.desc.geometry.vertex_stride = 24;
    batched_.desc.geometry.vertices_offset = 1u << 20;
    batched_.desc.geometry.indices_offset = 1u << 20;
    batched_.desc.normal_stride = 24;
    batched_.desc.normals_offset = 12;
    const SceneSource source(scene_, 400);
    EXPECT_TRUE(test::same_bits(in_batches(source, options_), whole, "pixels"));
}

TEST_F(FrameBatches, OfNoTrianglesShowTheEnvironment) {
    test::Scene empty = scene_;
    empty.mesh = {};
    const SceneSource source(empty, 0);
    rsh_batch_source none = *source.get();
    none.attributes |= RSH_BATCH_NORMALS | RSH_BATCH_TEXCOORDS;
    options_.batches = &none;
    const auto pixels = test::frame(batched_, options_);
    for (const cl_float4& pixel : pixels) EXPECT_EQ(pixel.s[3], 0.0f);
    options_.budget = size_t{1} << 28;
    EXPECT_TRUE(test::same_bits(test::frame(batched_, options_), pixels, "pixels"));
}

// Strips that were finished stay.
TEST_F(FrameBatches, ThatStopHaveTheStripsBefore) {
    const auto whole = test::frame(whole_, options_);
    SceneSource source(scene_, 0);
    options_.batches = source.get();
    const size_t least = test::least_budget(batched_, options_);
    options_.budget = least;
    test::frame(batched_, options_);
    const uint32_t all = source.batches();
    SceneSource stopping(scene_, 0);
    stopping.stop_after(all - 1);
    const test::Buffer<cl_float4> colour(whole.size());
    rsh_frame_desc desc = {};
    desc.struct_size = sizeof desc;
    desc.scene = &batched_.desc;
    desc.camera = test::gallery_camera(options_.width, options_.height);
    desc.width = options_.width;
    desc.height = options_.height;
    desc.bounces = options_.bounces;
    desc.budget = least;
    desc.batches = stopping.get();
    desc.colour = colour.get();
    EXPECT_EQ(rsh_frame(test::device().rsh, test::device().queue(), &desc, 0, nullptr, nullptr),
              RSH_CANCELLED);
    test::device().queue.finish();
    auto expected = whole, actual = colour.read();
    const size_t finished = 64 * options_.width;
    expected.resize(finished);
    actual.resize(finished);
    EXPECT_TRUE(test::same_bits(actual, expected, "pixels"));
}

TEST_F(FrameBatches, AreRefusedWhereTheSceneHasMore) {
    const SceneSource source(scene_, 0);
    const auto expect_refused = [&](const DeviceScene& scene, const char* error) {
        rsh_frame_desc desc = {};
        desc.struct_size = sizeof desc;
        desc.scene = &scene.desc;
        desc.camera = test::gallery_camera(8, 8);
        desc.width = desc.height = 8;
        desc.batches = source.get();
        desc.audit_rays = std::string(error).rfind("audit", 0) == 0;
        rsh_sizes sizes = {};
        sizes.struct_size = sizeof sizes;
        EXPECT_EQ(rsh_frame_query(test::device().rsh, &desc, &sizes), RSH_INVALID_VALUE);
        EXPECT_EQ(std::string(rsh_last_error()).rfind(error, 0), 0u) << rsh_last_error();
    };
    expect_refused(whole_, "geometry.triangle_count: is ");
    DeviceScene scene(scene_);
    scene.desc.geometry = {};
    expect_refused(scene, "scene.normals: is set, must be NULL with batches");
    scene.desc.normals = nullptr;
    expect_refused(scene, "scene.texcoords: is set, must be NULL with batches");
    scene.desc.texcoords = nullptr;
    expect_refused(scene, "scene.material_ids: is set, must be NULL with batches");
    scene.desc.material_ids = nullptr;
    expect_refused(scene, "audit_rays: is 1, must be 0 with batches");
    rsh_batch_source bare = *source.get();
    bare.attributes = 0;
    FrameOptions options;
    options.batches = &bare;
    EXPECT_THROW(test::frame(scene, options), std::runtime_error);
    EXPECT_NE(
        std::string(rsh_last_error()).find("with RSH_BATCH_NORMALS for RSH_FEATURE_SMOOTH"),
        std::string::npos)
        << rsh_last_error();
}

// A scene that fits is asked for once.
TEST_F(FrameBatches, AreNotAskedForTwiceIfOneIsAll) {
    const SceneSource source(scene_, 1u << 20, false);
    in_batches(source, options_);
    EXPECT_EQ(source.batches(), 1u);
}

}  // namespace
