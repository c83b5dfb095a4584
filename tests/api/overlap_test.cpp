// overlap_test.cpp - memory that a call writes must not overlap what else it touches, whole
// buffers and parts of them: RSH_INVALID_VALUE names both members, and nothing is enqueued.
#include <gtest/gtest.h>

#include "api/calls.hpp"
#include "api/valid_calls.hpp"

namespace {

using test::call;
using test::device;

class Overlap : public ::testing::Test {
protected:
    // `member` is checked after `other`, and complains about it.
    template <class Desc>
    void refuses(const Desc& desc, const std::string& member, const std::string& other) {
        EXPECT_EQ(call(&desc), RSH_INVALID_VALUE) << member << ", " << other;
        const std::string message = rsh_last_error();
        EXPECT_NE(message.find(member + ": is bytes"), std::string::npos) << message;
        EXPECT_NE(message.find("overlap " + other), std::string::npos) << message;
        EXPECT_TRUE(valid_.outputs_untouched()) << member << ", " << other;
    }

    cl::Buffer part(size_t offset, size_t bytes) const {
        const cl_buffer_region region = {offset, bytes};
        cl::Buffer parent = whole_;
        return parent.createSubBuffer(CL_MEM_READ_WRITE, CL_BUFFER_CREATE_TYPE_REGION, &region);
    }

    test::ValidCalls valid_;
    static constexpr size_t kPage = 4096;  // sub-buffers begin at multiples of it
    cl::Buffer whole_{device().context, CL_MEM_READ_WRITE, 1u << 20};
};

TEST_F(Overlap, OfWholeBuffersIsRefusedByEveryCall) {
    auto rasterize = valid_.rasterize();
    rasterize.rays = rasterize.hits = whole_();
    refuses(rasterize, "hits", "rays");
    auto bound = valid_.bound();
    bound.geometry.vertices = bound.bounds = whole_();
    refuses(bound, "bounds", "geometry.vertices");
    auto build = valid_.build();
    build.rays = build.nodes = whole_();
    refuses(build, "nodes", "rays");
    auto traverse = valid_.traverse();
    traverse.rays = traverse.hits = whole_();
    refuses(traverse, "hits", "rays");
    traverse.engine = RSH_ENGINE_TILES;
    traverse.shape = RSH_SHAPE_BOX;
    traverse.rays = valid_.rays.get();
    traverse.nodes = whole_();
    refuses(traverse, "hits", "nodes");
    auto spawn = valid_.spawn();
    spawn.rays = spawn.spawned_rays = whole_();
    refuses(spawn, "spawned_rays", "rays");
    auto shade = valid_.shade();
    shade.rays = shade.colour = whole_();
    refuses(shade, "colour", "rays");
    auto frame = valid_.frame();
    rsh_scene scene = *frame.scene;
    scene.geometry.vertices = frame.colour = whole_();
    frame.scene = &scene;
    refuses(frame, "colour", "geometry.vertices");
}

TEST_F(Overlap, OfStreamsIsRefused) {
    auto reduce = valid_.reduce();
    reduce.input = reduce.output = whole_();
    refuses(reduce, "output", "input");
    reduce = valid_.reduce();
    reduce.flags = reduce.output = whole_();
    refuses(reduce, "output", "flags");
    reduce = valid_.reduce();
    reduce.output = reduce.output_count = whole_();
    refuses(reduce, "output_count", "output");
}

// What counts are the bytes that the call touches.
TEST_F(Overlap, OfPartsIsJudgedByTheirBytes) {
    auto reduce = valid_.reduce();
    const size_t bytes = size_t{reduce.count} * reduce.element_bytes;
    ASSERT_LE(bytes, kPage);
    const cl::Buffer first = part(0, 2 * kPage), second = part(kPage, kPage),
                     same = part(kPage, kPage);
    reduce.input = first();
    reduce.output = whole_();
    refuses(reduce, "output", "input");
    reduce.output = second();
    EXPECT_EQ(call(&reduce), RSH_SUCCESS) << rsh_last_error();
    reduce.input = second();
    reduce.output = same();
    EXPECT_EQ(call(&reduce), RSH_INVALID_VALUE) << "two parts of the same bytes";
    device().queue.finish();
}

TEST_F(Overlap, OfScratchIsRefused) {
    auto traverse = valid_.traverse();
    rsh_sizes sizes = {};
    sizes.struct_size = sizeof sizes;
    traverse.engine = RSH_ENGINE_PAPER_FAITHFUL;
    traverse.nodes = valid_.nodes.get();
    traverse.shape = RSH_SHAPE_CONE;
    traverse.budget = RSH_MIN_BUDGET;
    RSH_CHECK(rsh_traverse_query(device().rsh, &traverse, &sizes));
    const cl::Buffer memory(device().context, CL_MEM_READ_WRITE, sizes.scratch_bytes + kPage);
    const cl::Buffer nodes(device().context, CL_MEM_READ_WRITE, 1u << 16);
    traverse.nodes = nodes();
    traverse.scratch = traverse.hits = memory();
    refuses(traverse, "scratch", "hits");
}

TEST_F(Overlap, OfInputsIsAllowed) {
    auto reduce = valid_.reduce();
    reduce.flags = reduce.input;
    EXPECT_EQ(call(&reduce), RSH_SUCCESS) << rsh_last_error();
    device().queue.finish();
}

class Reserved : public Overlap {
protected:
    template <class Desc>
    void refuses(const Desc& desc, const std::string& words) {
        EXPECT_EQ(call(&desc), RSH_INVALID_VALUE);
        EXPECT_NE(std::string(rsh_last_error()).find(words), std::string::npos)
            << words << " is not in: " << rsh_last_error();
        EXPECT_TRUE(valid_.outputs_untouched());
    }
};

TEST_F(Reserved, StillTrianglesAreSomeOfAll) {
    auto bound = valid_.bound();
    bound.geometry.still_triangles = bound.geometry.triangle_count;
    EXPECT_EQ(call(&bound), RSH_SUCCESS) << rsh_last_error();
    bound.geometry.still_triangles += 1;
    const auto count = [](cl_uint triangles) { return std::to_string(triangles); };
    EXPECT_EQ(call(&bound), RSH_INVALID_VALUE);
    EXPECT_EQ(rsh_last_error(), "geometry.still_triangles: is " +
                                    count(bound.geometry.still_triangles) +
                                    ", must be at most geometry.triangle_count, " +
                                    count(bound.geometry.triangle_count));
}

// A library that does not know a wish must not take it for none.
TEST_F(Reserved, WordsMustBeZero) {
    auto bound = valid_.bound();
    bound.geometry.reserved[4] = 1;
    refuses(bound, "geometry.reserved: is 1, must be 0");
    bound = valid_.bound();
    bound.geometry.reserved_buffers[2] = whole_();
    refuses(bound, "geometry.reserved_buffers");
    auto frame = valid_.frame();
    frame.camera.reserved[0] = 3;
    refuses(frame, "camera.reserved: is 3, must be 0");
}

TEST_F(Reserved, WordsOfMaterialsAndLightsMustBeZero) {
    rsh_scene scene = valid_.scene.desc;
    std::vector<rsh_material> materials = valid_.host.materials;
    std::vector<rsh_light> lights = valid_.host.lights;
    materials.back().reserved[6] = 1;
    EXPECT_EQ(rsh_find_features(&scene, materials.data(), lights.data()), RSH_INVALID_VALUE);
    EXPECT_NE(std::string(rsh_last_error()).find("materials["), std::string::npos);
    materials.back().reserved[6] = 0;
    lights.back().reserved[11] = 1;
    EXPECT_EQ(rsh_find_features(&scene, materials.data(), lights.data()), RSH_INVALID_VALUE);
    EXPECT_NE(std::string(rsh_last_error()).find("lights["), std::string::npos);
}

}  // namespace
