// trace_test.cpp - rsh_trace finds what rsh_bound, rsh_build and rsh_traverse find, however rays are handed
// over; and costs no more than they do where nothing else is asked for.
#include <gtest/gtest.h>

#include "support/compare.hpp"
#include "support/ways.hpp"
#include "trace/trace_call.hpp"

namespace {

using test::DeviceMesh;
using test::Handed;
using test::Rays;
using test::TraceOptions;
using test::TraceWay;

// Brute force and every engine, each with bounds and scratch of its own and without.
std::vector<TraceOptions> engines() {
    std::vector<TraceOptions> all;
    for (TraceOptions way : test::brute_force_and_all_ways())
        for (const bool own : {false, true}) {
            way.own_bounds = own && way.engine != RSH_ENGINE_BRUTE_FORCE;
            way.own_scratch = own;
            all.push_back(way);
        }
    return all;
}

class Trace : public ::testing::TestWithParam<Handed> {
protected:
    Trace() {
        rays_.push_back(test::pinhole_rays(test::small() ? 17 : 53, 19));
        rays_.push_back(test::random_rays(random_, test::small() ? 100 : 1001, 1));
        rays_.push_back(test::invalid_rays(random_, test::small() ? 100 : 700, 1));
        rays_.push_back(test::leaving_rays(random_, host_, test::small() ? 16 : 40, 11));
        rays_.push_back(test::pinhole_rays(1, 1));
        rays_.push_back(Rays{});
        if (GetParam() == Handed::interleaved)
            for (Rays& rays : rays_) rays = test::without_intervals(rays);
    }

    TraceWay way_of(const TraceOptions& options) const {
        TraceWay way;
        way.options = options;
        way.handed = GetParam();
        return way;
    }

    test::Random random_{61};
    const test::Mesh host_ = test::random_soup(random_, test::small() ? 50 : 600, 0.3f);
    const DeviceMesh mesh_{host_};
    std::vector<Rays> rays_;
};

TEST_P(Trace, FindsTheHitsOfBruteForce) {
    for (const Rays& rays : rays_) {
        const auto expected = closest_hits(mesh_, rays, test::brute_force());
        for (const TraceOptions& options : engines()) {
            SCOPED_TRACE(name_of(options) + ", " + std::to_string(rays.width) + " wide");
            EXPECT_TRUE(test::same_bits(trace_hits(mesh_, rays, way_of(options)).hits, expected,
                                        "hits"));
        }
    }
}

TEST_P(Trace, FindsTheOcclusionOfBruteForce) {
    for (const Rays& rays : rays_) {
        const std::vector<uint32_t> masks(rays.rays.size(), 0xa5a50000u);
        const auto expected = occlusion(mesh_, rays, masks, 3, test::brute_force());
        for (const TraceOptions& options : engines()) {
            SCOPED_TRACE(name_of(options) + ", " + std::to_string(rays.width) + " wide");
            EXPECT_TRUE(test::same_bits(trace_occlusion(mesh_, rays, masks, 3, way_of(options)),
                                        expected, "masks"));
        }
    }
}

TEST_P(Trace, FindsTheCountsAndListsOfBruteForce) {
    for (const Rays& rays : rays_) {
        const auto counts = hit_counts(mesh_, rays, test::brute_force());
        const test::HitLists lists = all_hits(mesh_, rays, test::brute_force());
        for (const TraceOptions& options : engines()) {
            SCOPED_TRACE(name_of(options) + ", " + std::to_string(rays.width) + " wide");
            EXPECT_TRUE(
                test::same_bits(trace_counts(mesh_, rays, way_of(options)), counts, "counts"));
            const auto actual = trace_lists(mesh_, rays, lists.offsets.back(), way_of(options));
            EXPECT_TRUE(test::same_bits(actual.offsets, lists.offsets, "offsets"));
            EXPECT_TRUE(test::same_bits(actual.answers.hits, lists.hits, "hits"));
        }
    }
}

TEST_P(Trace, FindsTheHitsOfTheSidesAndMeshesThatRaysSee) {
    DeviceMesh mesh(host_);
    mesh.divide({{0, 1, 1, 0}, {20, 2, 2, 0}});
    Rays rays = rays_[0];
    for (size_t i = 0; i < rays.rays.size(); ++i) rays.masks.push_back(uint32_t(i) % 4);
    for (TraceOptions options : engines()) {
        SCOPED_TRACE(name_of(options));
        options.cull = RSH_CULL_BACK;
        EXPECT_TRUE(test::same_bits(trace_hits(mesh, rays, way_of(options)).hits,
                                    closest_hits(mesh, rays, options), "hits"));
    }
}

TEST_P(Trace, FindsTheHitsOfRaysThatConverge) {
    Rays rays = test::converging_rays(random_, 31, 23, {0.1f, 0.2f, 0.3f});
    if (GetParam() == Handed::interleaved) rays = test::without_intervals(rays);
    const auto expected = closest_hits(mesh_, rays, test::brute_force());
    for (TraceOptions options : engines()) {
        SCOPED_TRACE(name_of(options));
        options.converging = true;
        EXPECT_TRUE(
            test::same_bits(trace_hits(mesh_, rays, way_of(options)).hits, expected, "hits"));
    }
}

TEST_P(Trace, OfAListTouchesNothingBehindItsCount) {
    const Rays& rays = rays_[1];
    const std::vector<rsh_mesh_range> ranges = {{0, 7, ~0u, 0}};
    for (TraceOptions options : engines())
        for (const uint32_t count : {0u, 1u, 77u, ~0u}) {
            SCOPED_TRACE(name_of(options) + ", " + std::to_string(count));
            options.list_count = count;
            TraceWay way = way_of(options);
            way.normals = way.points = true;
            way.ranges = ranges;
            const auto actual = trace_hits(mesh_, rays, way);
            const auto hits = closest_hits(mesh_, rays, options);
            EXPECT_TRUE(test::same_bits(actual.hits, hits, "hits"));
            const auto untouched = test::Buffer<uint32_t>(1).read()[0];
            for (size_t i = std::min<size_t>(count, hits.size()); i < hits.size(); ++i) {
                uint32_t words[6];
                std::memcpy(words, &actual.normals[i], sizeof words / 2);
                std::memcpy(words + 3, &actual.points[i], sizeof words / 2);
                for (const uint32_t word : words)
                    EXPECT_EQ(word, untouched) << "normal and point " << i;
                EXPECT_EQ(actual.ids[i], untouched) << "id " << i;
            }
        }
}

INSTANTIATE_TEST_SUITE_P(All, Trace,
                         ::testing::Values(Handed::whole, Handed::interleaved, Handed::apart),
                         [](const auto& handed) {
                             return handed.param == Handed::whole         ? "whole"
                                    : handed.param == Handed::interleaved ? "interleaved"
                                                                          : "apart";
                         });

rsh_statistics counted(const std::function<void(rsh_context)>& call) {
    const test::OwnContext own;
    RSH_CHECK(rsh_count_statistics(own.get(), CL_TRUE));
    call(own.get());
    rsh_statistics sums = {};
    sums.struct_size = sizeof sums;
    RSH_CHECK(rsh_get_statistics(own.get(), &sums));
    return sums;
}

class TraceCosts : public ::testing::Test {
protected:
    // What rsh_trace launches, and the programs that it needs, more than the three calls.
    void expect_more(const TraceWay& way, cl_ulong launches, cl_ulong programs) {
        const auto actual = counted([&](rsh_context context) {
            TraceWay own = way;
            own.options.context = context;
            trace_hits(mesh_, rays_, own);
        });
        const auto expected = counted([&](rsh_context context) {
            TraceOptions own = way.options;
            own.context = context;
            closest_hits(mesh_, rays_, own);
        });
        EXPECT_EQ(actual.launches, expected.launches + launches);
        EXPECT_EQ(actual.programs_built + actual.programs_loaded,
                  expected.programs_built + expected.programs_loaded + programs);
    }

    test::Random random_{62};
    const DeviceMesh mesh_{test::random_soup(random_, 200)};
    const Rays rays_ = test::pinhole_rays(32, 24);
};

TEST_F(TraceCosts, AreThoseOfTheThreeCallsAndWhatIsAskedFor) {
    for (const TraceOptions& options : test::brute_force_and_all_ways()) {
        SCOPED_TRACE(name_of(options));
        TraceWay way;
        way.options = options;
        expect_more(way, 0, 0);
        way.handed = Handed::apart;
        expect_more(way, 1, 1);
        way.normals = true;
        expect_more(way, 2, 2);
        way.points = true;
        expect_more(way, 2, 2);
        way.ranges = {{0, 1, ~0u, 0}};
        expect_more(way, 2, 2);
    }
}

TEST_F(TraceCosts, OfMemoryAreThoseOfRaysThatArePacked) {
    const test::Buffer<uint8_t> some(4);
    rsh_trace_desc desc = {};
    desc.struct_size = sizeof desc;
    desc.geometry = mesh_.geometry();
    desc.width = desc.height = 64;
    const auto bytes = [&] {
        rsh_sizes sizes = {};
        sizes.struct_size = sizeof sizes;
        RSH_CHECK(rsh_trace_query(test::device().rsh, &desc, &sizes));
        EXPECT_EQ(sizes.output_bytes, 64u * 64 * sizeof(rsh_hit));
        return sizes.scratch_bytes;
    };
    const size_t packed = bytes();
    desc.rays = some.get();
    const size_t whole = bytes();
    EXPECT_EQ(packed - whole, 64u * 64 * sizeof(rsh_ray));
    desc.normals = desc.points = desc.geometry_ids = some.get();
    EXPECT_EQ(bytes(), whole);
}

}  // namespace
