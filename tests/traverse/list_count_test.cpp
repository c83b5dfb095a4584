// list_count_test.cpp - a list whose length only the device knows: the answers, and the work, of a
// call with that width, whatever lies behind it; and nothing behind it is written.
#include <gtest/gtest.h>

#include <functional>

#include "support/compare.hpp"
#include "support/strategies.hpp"
#include "support/ways.hpp"

namespace {

using test::DeviceMesh;
using test::Rays;
using test::TraceOptions;

struct NamedRays {
    std::string name;
    std::function<Rays(test::Random&, const test::Mesh&, uint32_t)> make;
};

void PrintTo(const NamedRays& rays, std::ostream* out) {
    *out << rays.name;
}

// Lists in an order of their own and lists that are sorted, with inactive rays and without.
const std::vector<NamedRays>& all_rays() {
    static const std::vector<NamedRays> all = {
        {"Coherent", [](auto&, auto&, uint32_t width) { return test::pinhole_rays(width, 1); }},
        {"Random", [](auto& random, auto&,
                      uint32_t width) { return test::random_rays(random, width, 1); }},
        {"Invalid", [](auto& random, auto&,
                       uint32_t width) { return test::invalid_rays(random, width, 1); }},
        {"Leaving", [](auto& random, auto& mesh, uint32_t width) {
             return test::leaving_rays(random, mesh, width, 1);
         }}};
    return all;
}

Rays first_of(const Rays& rays, uint32_t count) {
    Rays first = rays;
    first.width = std::min(count, rays.width);
    first.rays.resize(first.width);
    if (!first.skip.empty()) first.skip.resize(first.width);
    return first;
}

template <class T>
void append(std::vector<T>& to, const std::vector<T>& all) {
    to.insert(to.end(), all.begin() + ptrdiff_t(to.size()), all.end());
}

class ListCount : public ::testing::TestWithParam<NamedRays> {
protected:
    std::vector<uint32_t> counts() {
        const uint32_t width = rays_.width, some = 1 + random_.below(width - 1);
        if (test::small()) return {0, some, width + 1};
        return {0, 1, 16, 257, some, width - 1, width, 0xffffffffu};
    }

    test::Random random_{31};
    const test::Mesh host_ = test::random_soup(random_, test::small() ? 50 : 800, 0.3f);
    const DeviceMesh mesh_{host_};
    const Rays rays_ = GetParam().make(random_, host_, test::small() ? 300 : 3001);
};

TEST_P(ListCount, FindsTheHitsOfAListOfThatWidth) {
    const std::vector<rsh_hit> untouched = test::Buffer<rsh_hit>(rays_.rays.size()).read();
    for (TraceOptions way : test::brute_force_and_all_ways())
        for (const uint32_t count : counts()) {
            SCOPED_TRACE(name_of(way) + ", " + std::to_string(count));
            way.list_count.reset();
            auto expected = closest_hits(mesh_, first_of(rays_, count), way);
            append(expected, untouched);
            way.list_count = count;
            way.own_scratch = true;
            for (const size_t budget : {size_t{0}, size_t{RSH_MIN_BUDGET}}) {
                way.budget = budget;
                EXPECT_TRUE(test::same_bits(closest_hits(mesh_, rays_, way), expected, "hits"))
                    << "budget " << budget;
            }
        }
}

TEST_P(ListCount, FindsTheOcclusionOfAListOfThatWidth) {
    const std::vector<uint32_t> masks(rays_.rays.size(), 0xa5a50000u);
    for (TraceOptions way : test::brute_force_and_all_ways())
        for (const uint32_t count : counts()) {
            SCOPED_TRACE(name_of(way) + ", " + std::to_string(count));
            way.list_count.reset();
            const Rays first = first_of(rays_, count);
            auto expected =
                occlusion(mesh_, first, {masks.begin(), masks.begin() + first.width}, 3, way);
            append(expected, masks);
            way.list_count = count;
            EXPECT_TRUE(
                test::same_bits(occlusion(mesh_, rays_, masks, 3, way), expected, "masks"));
        }
}

void expect_same_work(const rsh_statistics& actual, const rsh_statistics& expected) {
    EXPECT_EQ(actual.node_tests, expected.node_tests);
    EXPECT_EQ(actual.ray_tests, expected.ray_tests);
    EXPECT_EQ(actual.peak_pairs, expected.peak_pairs);
    for (int level = 0; level <= RSH_MAX_LEVELS; ++level) {
        EXPECT_EQ(actual.pairs_tested[level], expected.pairs_tested[level]) << level;
        EXPECT_EQ(actual.pairs_walked[level], expected.pairs_walked[level]) << level;
    }
}

TEST_P(ListCount, TakesTheTestsOfAListOfThatWidth) {
    const test::OwnContext context;
    for (TraceOptions way : test::brute_force_and_all_ways())
        for (const size_t budget : {size_t{RSH_MIN_BUDGET}, size_t{64} << 20})
            for (const uint32_t count : {0u, 200u, 290u, rays_.width + 1}) {
                SCOPED_TRACE(name_of(way) + ", " + std::to_string(count) + ", budget " +
                             std::to_string(budget));
                way.context = context.get();
                way.budget = budget;
                way.list_count.reset();
                const auto expected = statistics_of(mesh_, first_of(rays_, count), way);
                way.list_count = count;
                expect_same_work(statistics_of(mesh_, rays_, way), expected);
            }
}

INSTANTIATE_TEST_SUITE_P(All, ListCount, ::testing::ValuesIn(all_rays()),
                         [](const auto& named) { return named.param.name; });

// The stream of pairs begins at the root of the rays that there are.
TEST(ListCountOfPairs, IsReducedByEveryStrategy) {
    test::Random random(33);
    const DeviceMesh mesh(test::random_soup(random, test::small() ? 50 : 300, 0.5f));
    const Rays rays = test::random_rays(random, 3001, 1);
    for (TraceOptions way : test::ways_of(RSH_ENGINE_PAPER_FAITHFUL))
        for (way.strategy = 1; rsh_strategy_name(way.strategy); ++way.strategy)
            for (const uint32_t count : {0u, 3u, 70u}) {
                SCOPED_TRACE(test::strategy_name(way.strategy) + ", " + std::to_string(count));
                way.list_count = count;
                auto hits = closest_hits(mesh, rays, way);
                hits.resize(count);
                EXPECT_TRUE(test::same_bits(
                    hits, closest_hits(mesh, first_of(rays, count), test::brute_force()),
                    "hits"));
            }
}

// As nodes of another list are; see wrong_buffers_test.cpp.
TEST(ListCountOfNodes, IsThatOfTheTraversal) {
    test::Random random(32);
    const DeviceMesh mesh(test::random_soup(random, 50, 0.5f));
    const Rays rays = test::pinhole_rays(600, 1);
    for (TraceOptions way : test::all_ways()) {
        SCOPED_TRACE(name_of(way));
        way.list_count = 300;
        way.nodes_count = 301;
        const auto hits = closest_hits(mesh, rays, way);
        for (size_t i = 0; i < 300; ++i) EXPECT_EQ(hits[i].primitive, RSH_NO_HIT) << i;
        EXPECT_EQ(rsh_device_status(test::device().rsh, test::device().queue()),
                  RSH_INVALID_VALUE);
    }
}

}  // namespace
