// statistics_test.cpp - counts of a traversal do not wrap round at 2^32.
#include <gtest/gtest.h>

#include "support/changed_kernels.hpp"
#include "support/ways.hpp"

namespace {

constexpr cl_ulong kMany = 0x90000001u;

struct Traversal {
    test::DeviceMesh mesh;
    test::Rays rays;
    test::TraceOptions options;

    explicit Traversal(cl_uint engine) : mesh(soup()), rays(test::pinhole_rays(64, 32)) {
        options.engine = engine;
        options.budget = RSH_MIN_BUDGET;
    }

    rsh_statistics count(rsh_context context) const {
        test::TraceOptions counted = options;
        counted.context = context;
        return test::statistics_of(mesh, rays, counted);
    }

private:
    static test::Mesh soup() {
        test::Random random(9);
        return test::random_soup(random, test::small() ? 500 : 5000, 0.6f);
    }
};

TEST(Statistics, OfTilesCountPast32Bits) {
    const Traversal traversal(RSH_ENGINE_TILES);
    const test::OwnContext plain;
    const test::ChangedKernels many("traverse/tiles/traverse_tiles.cl",
                                    "state->node_tests = state->ray_tests = 0;",
                                    "state->node_tests = state->ray_tests = 0x90000001u;");
    const rsh_statistics expected = traversal.count(plain.get());
    const rsh_statistics actual = traversal.count(many.context());
    const cl_ulong tiles = 4 * 2;
    EXPECT_EQ(actual.node_tests, expected.node_tests + tiles * kMany);
    EXPECT_EQ(actual.ray_tests, expected.ray_tests + tiles * kMany);
}

// Several tiles finish what the streams cannot hold.
TEST(Statistics, OfRunsCountPast32Bits) {
    const Traversal traversal(RSH_ENGINE_PAPER);
    const test::OwnContext plain;
    const test::ChangedKernels many("traverse/paper/intersect_ranges.cl",
                                    "RSH_TALLY_FINISHED, range.count)",
                                    "RSH_TALLY_FINISHED, 0x90000001ul + range.count)");
    const cl_ulong more =
        traversal.count(many.context()).node_tests - traversal.count(plain.get()).node_tests;
    EXPECT_EQ(more % (16 * kMany), 0u);
    EXPECT_GE(more, (test::small() ? 1 : 2) * 16 * kMany);
}

}  // namespace
