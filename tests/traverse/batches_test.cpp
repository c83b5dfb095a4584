// batches_test.cpp - a scene in batches: the answers of one geometry with all triangles, bit for bit, with
// every engine, whatever the batches are and in whatever order they come.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "support/compare.hpp"
#include "support/ways.hpp"

namespace {

using test::Buffer;
using test::DeviceMesh;
using test::Rays;
using test::TraceOptions;

struct Batch {
    uint32_t first, count;
};

test::Mesh part_of(const test::Mesh& mesh, const Batch& batch) {
    test::Mesh part = mesh;
    part.indices.clear();
    for (uint32_t i = 3 * batch.first; i < 3 * (batch.first + batch.count); ++i)
        part.indices.push_back(mesh.indices.empty() ? i : mesh.indices[i]);
    return part;
}

// Up to `count` of them, some empty, in any order.
std::vector<Batch> random_batches(test::Random& random, uint32_t triangles, uint32_t count) {
    std::vector<uint32_t> cuts = {0, triangles};
    for (uint32_t i = 1; i < count; ++i) cuts.push_back(random.below(triangles + 1));
    std::sort(cuts.begin(), cuts.end());
    std::vector<Batch> batches;
    for (size_t i = 0; i + 1 < cuts.size(); ++i)
        batches.push_back({cuts[i], cuts[i + 1] - cuts[i]});
    for (size_t i = batches.size(); i > 1; --i)
        std::swap(batches[i - 1], batches[random.below(uint32_t(i))]);
    return batches;
}

// The triangles that rays have left, ray by ray.
class Left {
public:
    Left(const test::Mesh& mesh, const Rays& rays) {
        for (size_t i = 0; i < rays.skip.size(); ++i) {
            places_.push_back(rays.skip[i] == RSH_NO_HIT ? RSH_NO_HIT : uint32_t(i));
            numbers_.push_back(rays.skip[i]);
            test::Corners corners = {};
            const bool is_one = rays.skip[i] < mesh.triangle_count();
            if (!is_one || !mesh.corners(rays.skip[i], &corners)) corners = {};
            corners_.insert(corners_.end(), corners.begin(), corners.end());
        }
        if (places_.empty()) return;
        place_buffer_.emplace(places_);
        number_buffer_.emplace(numbers_);
        corner_buffer_.emplace(corners_);
    }

    void name_in(rsh_trace_desc& desc) const {
        if (places_.empty()) return;
        desc.skip = place_buffer_->get();
        desc.skip_numbers = number_buffer_->get();
        desc.skip_corners = corner_buffer_->get();
        desc.skip_count = uint32_t(places_.size());
    }

private:
    std::vector<uint32_t> places_, numbers_;
    std::vector<test::Float3> corners_;
    std::optional<Buffer<uint32_t>> place_buffer_, number_buffer_;
    std::optional<Buffer<test::Float3>> corner_buffer_;
};

class Batches : public ::testing::Test {
protected:
    // One call per batch, all into the same answers.
    void trace(const test::Mesh& mesh, const Rays& rays, const std::vector<Batch>& batches,
               const TraceOptions& way, rsh_trace_desc desc) {
        const Buffer<rsh_ray> ray_buffer(rays.rays);
        const Left left(mesh, rays);
        desc.struct_size = sizeof desc;
        desc.width = rays.width;
        desc.height = rays.height;
        desc.rays = ray_buffer.get();
        desc.engine = way.engine;
        desc.budget = way.budget;
        desc.cull = way.cull;
        left.name_in(desc);
        for (const Batch& batch : batches) {
            const DeviceMesh part(part_of(mesh, batch));
            desc.geometry = part.geometry();
            desc.geometry.triangle_count = batch.count;
            desc.first_triangle = batch.first;
            RSH_CHECK(rsh_trace(test::device().rsh, test::device().queue(), &desc, 0, nullptr,
                                nullptr));
            test::device().queue.finish();
            desc.continued = 1;
        }
    }

    std::vector<rsh_hit> closest(const test::Mesh& mesh, const Rays& rays,
                                 const std::vector<Batch>& batches, const TraceOptions& way) {
        const Buffer<rsh_hit> hits(rays.rays.size());
        rsh_trace_desc desc = {};
        desc.query = RSH_QUERY_CLOSEST;
        desc.hits = hits.get();
        trace(mesh, rays, batches, way, desc);
        EXPECT_TRUE(hits.guards_intact());
        return hits.read();
    }

    std::vector<uint32_t> hidden(const test::Mesh& mesh, const Rays& rays,
                                 const std::vector<Batch>& batches, const TraceOptions& way,
                                 const std::vector<uint32_t>& masks, uint32_t bit) {
        const Buffer<uint32_t> occlusion(masks);
        rsh_trace_desc desc = {};
        desc.query = RSH_QUERY_ANY;
        desc.occlusion = occlusion.get();
        desc.occlusion_bit = bit;
        trace(mesh, rays, batches, way, desc);
        EXPECT_TRUE(occlusion.guards_intact());
        return occlusion.read();
    }

    void expect_answers_of_the_whole(const test::Mesh& mesh, const Rays& rays,
                                     const std::vector<uint32_t>& counts = {2, 7}) {
        const DeviceMesh whole(mesh);
        std::vector<uint32_t> masks(rays.rays.size());
        for (uint32_t& mask : masks) mask = uint32_t(random_.bits()) & ~4u;
        const auto hits = closest_hits(whole, rays, test::brute_force());
        const auto occlusion = test::occlusion(whole, rays, masks, 2, test::brute_force());
        for (const TraceOptions& way : test::brute_force_and_all_ways())
            for (const uint32_t count : counts) {
                const auto batches = random_batches(random_, mesh.triangle_count(), count);
                SCOPED_TRACE(name_of(way) + ", batches " + std::to_string(count));
                EXPECT_TRUE(test::same_bits(closest(mesh, rays, batches, way), hits, "hits"));
                EXPECT_TRUE(test::same_bits(hidden(mesh, rays, batches, way, masks, 2),
                                            occlusion, "masks"));
            }
    }

    test::Random random_{83};
};

class EveryCaseInBatches : public Batches,
                           public ::testing::WithParamInterface<test::NamedCase> {};

// The triangle that a ray has left may be of any batch.
TEST_P(EveryCaseInBatches, GivesTheAnswersOfTheWholeScene) {
    const test::Case made = GetParam().make(random_);
    expect_answers_of_the_whole(made.mesh, made.rays);
}

INSTANTIATE_TEST_SUITE_P(Batches, EveryCaseInBatches, ::testing::ValuesIn(test::all_cases()),
                         test::case_name);

// Of which many start beside an edge that a neighbour shares, which may be of another batch.
TEST_F(Batches, DoNotHitNeighboursOfWhatRaysHaveLeft) {
    for (const test::Float3 place : {test::Float3(900, -2000, 50), test::Float3(0, 30, 7)}) {
        const test::Mesh mesh = test::scaled(test::sphere(8, 5), 1, place);
        expect_answers_of_the_whole(mesh, test::leaving_rays(random_, mesh, 150, 100));
    }
}

// The triangle that a ray has left is often the last one before a batch.
TEST_F(Batches, OfFewTrianglesDoNotHitWhatRaysHaveLeft) {
    for (int i = 0; i < 4; ++i) {
        const test::Mesh mesh = test::degenerate_soup(random_, 25);
        expect_answers_of_the_whole(mesh, test::leaving_rays(random_, mesh, 60, 40), {60});
    }
}

// Copies of triangles in several batches: of equal t, the lower number in the scene stays.
TEST_F(Batches, KeepTheLowerNumberOfEqualHits) {
    const test::Mesh soup = test::random_soup(random_, 60, 0.6f);
    const test::Mesh copies = test::turned_copies(random_, soup, 300);
    expect_answers_of_the_whole(copies, test::pinhole_rays(33, 31));
}

// With streams that overflow.
TEST_F(Batches, KeepToABudget) {
    const test::Mesh soup = test::random_soup(random_, 900, 0.4f);
    const Rays rays = test::leaving_rays(random_, soup, test::small() ? 30 : 120, 90);
    const auto hits = closest_hits(DeviceMesh(soup), rays, test::brute_force());
    for (TraceOptions way : test::all_ways()) {
        way.budget = RSH_MIN_BUDGET;
        const auto batches = random_batches(random_, soup.triangle_count(), 3);
        EXPECT_TRUE(test::same_bits(closest(soup, rays, batches, way), hits, "hits"))
            << name_of(way);
    }
}

TEST_F(Batches, HaveSides) {
    const test::Mesh soup = test::random_soup(random_, 300, 0.4f);
    const Rays rays = test::pinhole_rays(test::small() ? 17 : 49, 31);
    TraceOptions whole = test::brute_force();
    whole.cull = RSH_CULL_BACK;
    const auto hits = closest_hits(DeviceMesh(soup), rays, whole);
    for (TraceOptions way : test::brute_force_and_all_ways())
        for (const size_t budget : {size_t{0}, size_t{RSH_MIN_BUDGET}}) {
            way.cull = RSH_CULL_BACK;
            way.budget = way.engine == RSH_ENGINE_BRUTE_FORCE ? 0 : budget;
            const auto batches = random_batches(random_, soup.triangle_count(), 3);
            EXPECT_TRUE(test::same_bits(closest(soup, rays, batches, way), hits, "hits"))
                << name_of(way) << ", budget " << budget;
        }
}

// Each field by its name, and what it may be.
TEST_F(Batches, AreRefusedWhereTheyAreNone) {
    const DeviceMesh mesh(test::grid(2));
    const Rays rays = test::pinhole_rays(8, 8);
    const Buffer<rsh_ray> ray_buffer(rays.rays);
    const Buffer<rsh_hit> hits(rays.rays.size());
    const Buffer<uint32_t> words(rays.rays.size());
    rsh_traverse_desc valid = {};
    valid.struct_size = sizeof valid;
    valid.geometry = mesh.geometry();
    valid.width = valid.height = 8;
    valid.rays = ray_buffer.get();
    valid.hits = hits.get();
    valid.occlusion = valid.hit_counts = words.get();
    valid.engine = RSH_ENGINE_BRUTE_FORCE;
    const auto expect_refused = [&](const rsh_traverse_desc& desc, const std::string& error) {
        EXPECT_EQ(rsh_traverse(test::device().rsh, test::device().queue(), &desc, 0, nullptr,
                               nullptr),
                  RSH_INVALID_VALUE);
        EXPECT_NE(std::string(rsh_last_error()).find(error), std::string::npos)
            << rsh_last_error();
    };
    rsh_traverse_desc desc = valid;
    desc.continued = 2;
    expect_refused(desc, "continued: is 2, must be 0 or 1");
    desc = valid;
    desc.first_triangle = 0xfffffff7u;
    expect_refused(desc, "first_triangle: is 4294967287, must be at most 4294967286");
    desc = valid;
    desc.query = RSH_QUERY_COUNT;
    desc.continued = 1;
    expect_refused(desc, "query: is 2, must be RSH_QUERY_CLOSEST or RSH_QUERY_ANY");
    desc = valid;
    desc.skip = words.get();
    desc.first_triangle = 1;
    expect_refused(desc, "skip_corners: is NULL");
    desc = valid;
    desc.skip_count = (1u << 28) + 1;
    expect_refused(desc, "skip_count: is 268435457, must be at most 268435456");
    desc = valid;
    desc.query = RSH_QUERY_COUNT;
    desc.skip_corners = words.get();
    desc.hits = nullptr;
    expect_refused(desc, "query: is 2, must be RSH_QUERY_CLOSEST or RSH_QUERY_ANY with skip");
}

// A hit may be of a triangle that is not there.
TEST_F(Batches, AreNotDescribed) {
    const DeviceMesh mesh(test::grid(2));
    const Buffer<float> floats(3 * 64);
    rsh_trace_desc desc = {};
    desc.struct_size = sizeof desc;
    desc.geometry = mesh.geometry();
    desc.width = desc.height = 8;
    desc.rays = desc.hits = floats.get();
    desc.first_triangle = 1;
    rsh_sizes sizes = {};
    sizes.struct_size = sizeof sizes;
    for (cl_mem rsh_trace_desc::*member :
         {&rsh_trace_desc::normals, &rsh_trace_desc::points, &rsh_trace_desc::geometry_ids}) {
        rsh_trace_desc wrong = desc;
        wrong.*member = floats.get();
        EXPECT_EQ(rsh_trace_query(test::device().rsh, &wrong, &sizes), RSH_INVALID_VALUE);
        EXPECT_NE(
            std::string(rsh_last_error()).find("must be NULL with continued or first_triangle"),
            std::string::npos)
            << rsh_last_error();
    }
}

TEST_F(Batches, OfWhichSomeAreLeftOutGiveTheHitsOfTheOthers) {
    const test::Mesh soup = test::random_soup(random_, 200, 0.5f);
    const Rays rays = test::pinhole_rays(33, 31);
    test::Mesh rest = part_of(soup, {0, 150});
    const auto hits = closest_hits(DeviceMesh(rest), rays, test::brute_force());
    for (const TraceOptions& way : test::brute_force_and_all_ways())
        EXPECT_TRUE(
            test::same_bits(closest(soup, rays, {{90, 60}, {0, 90}}, way), hits, "hits"))
            << name_of(way);
}

}  // namespace
