// audit_test.cpp - rsh_audit finds every planted error, and none where there is none.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <optional>

#include "support/compare.hpp"
#include "support/render.hpp"
#include "support/trace.hpp"

namespace {

using test::Buffer;

// Rays in front of a mesh, their answers by the default engine, and audits of these.
class Audit : public ::testing::Test {
protected:
    rsh_audit_report audit(const std::vector<rsh_hit>& hits, cl_uint sample = 0,
                           cl_uint seed = 0) const {
        const Buffer<rsh_hit> buffer(hits);
        rsh_audit_desc desc = empty(sample, seed);
        desc.hits = buffer.get();
        return audit(desc);
    }

    rsh_audit_report audit(const std::vector<uint32_t>& masks, cl_uint bit) const {
        const Buffer<uint32_t> buffer(masks);
        rsh_audit_desc desc = empty(0, 0);
        desc.query = RSH_QUERY_ANY;
        desc.occlusion = buffer.get();
        desc.occlusion_bit = bit;
        return audit(desc);
    }

    rsh_audit_report audit_counts(const std::vector<uint32_t>& counts) const {
        const Buffer<uint32_t> buffer(counts);
        rsh_audit_desc desc = empty(0, 0);
        desc.query = RSH_QUERY_COUNT;
        desc.hit_counts = buffer.get();
        return audit(desc);
    }

    rsh_audit_report audit(const test::HitLists& lists) const {
        const Buffer<uint64_t> offsets(lists.offsets);
        const Buffer<rsh_hit> buffer(lists.hits);
        rsh_audit_desc desc = empty(0, 0);
        desc.query = RSH_QUERY_ALL;
        desc.hit_offsets = offsets.get();
        desc.hits = buffer.get();
        desc.hit_capacity = lists.hits.size();
        return audit(desc);
    }

    size_t count() const { return rays_.rays.size(); }
    std::vector<rsh_hit> hits() const { return closest_hits(device_mesh_, rays_); }

    test::Scene scene_ = test::gallery();
    test::DeviceMesh device_mesh_{scene_.mesh};
    test::Rays rays_ = test::pinhole_rays(37, 23);
    Buffer<rsh_ray> ray_buffer_{rays_.rays};
    std::optional<cl_uint> list_count_;

private:
    rsh_audit_desc empty(cl_uint sample, cl_uint seed) const {
        rsh_audit_desc desc = {};
        desc.struct_size = sizeof desc;
        desc.geometry = device_mesh_.geometry();
        desc.ray_count = static_cast<cl_uint>(count());
        desc.rays = ray_buffer_.get();
        desc.sample = sample;
        desc.seed = seed;
        return desc;
    }

    // Twice: what the report held before must not matter.
    rsh_audit_report audit(rsh_audit_desc desc) const {
        const Buffer<rsh_audit_report> report(1);
        const Buffer<uint32_t> list_count(std::vector<uint32_t>{list_count_.value_or(0)});
        desc.report = report.get();
        if (list_count_) desc.list_count = list_count.get();
        for (int i = 0; i < 2; ++i)
            RSH_CHECK(rsh_audit(test::device().rsh, test::device().queue(), &desc, 0, nullptr,
                                nullptr));
        EXPECT_TRUE(report.guards_intact());
        return report.read()[0];
    }
};

void expect_report(const rsh_audit_report& report, size_t rays, size_t differences,
                   size_t first_ray) {
    EXPECT_EQ(report.rays, rays);
    EXPECT_EQ(report.differences, differences);
    EXPECT_EQ(report.first_ray, first_ray);
    EXPECT_EQ(size_t{report.missed} + report.spurious + report.wrong, differences);
}

TEST_F(Audit, FindsNothingWhereHitsAreRight) {
    expect_report(audit(hits()), count(), 0, RSH_NO_HIT);
    const std::vector<uint32_t> none(count(), 0);
    for (const cl_uint bit : {0u, 31u})
        expect_report(audit(occlusion(device_mesh_, rays_, none, bit), bit), count(), 0,
                      RSH_NO_HIT);
}

TEST_F(Audit, FindsAnyBitThatDiffers) {
    const auto flip = [](float& value) {
        uint32_t bits;
        std::memcpy(&bits, &value, sizeof bits);
        bits ^= 1;
        std::memcpy(&value, &bits, sizeof bits);
    };
    const std::vector<rsh_hit> right = hits();
    const size_t ray = count() / 2;
    std::vector<rsh_hit> wrong[4] = {right, right, right, right};
    flip(wrong[0][ray].t);
    flip(wrong[1][ray].u);
    flip(wrong[2][ray].v);
    wrong[3][ray].primitive ^= 1;
    for (const auto& hits : wrong) expect_report(audit(hits), count(), 1, ray);
}

TEST_F(Audit, CountsEveryPlantedErrorAndNamesTheFirst) {
    for (const size_t errors : {size_t{1}, size_t{2}, size_t{64}, count()}) {
        std::vector<rsh_hit> wrong = hits();
        std::vector<uint32_t> masks(count(), 0);
        masks = occlusion(device_mesh_, rays_, masks, 5);
        for (size_t i = count() - errors; i < count(); ++i) {
            wrong[i].primitive ^= 1;
            masks[i] ^= 1u << 5;
        }
        expect_report(audit(wrong), count(), errors, count() - errors);
        expect_report(audit(masks, 5), count(), errors, count() - errors);
    }
}

struct Kinds {
    cl_uint missed, spurious, wrong;
};

void expect_kinds(const rsh_audit_report& report, const Kinds& kinds) {
    EXPECT_EQ(report.missed, kinds.missed);
    EXPECT_EQ(report.spurious, kinds.spurious);
    EXPECT_EQ(report.wrong, kinds.wrong);
}

TEST_F(Audit, TellsKindsApart) {
    const std::vector<rsh_hit> right = hits();
    const auto is_hit = [](const rsh_hit& hit) { return hit.primitive != RSH_NO_HIT; };
    const size_t hit = size_t(std::find_if(right.begin(), right.end(), is_hit) - right.begin());
    const size_t miss =
        size_t(std::find_if_not(right.begin(), right.end(), is_hit) - right.begin());
    ASSERT_LT(std::max(hit, miss), count());
    const auto with = [&](size_t ray, rsh_hit answer) {
        std::vector<rsh_hit> hits = right;
        hits[ray] = answer;
        return audit(hits);
    };
    const rsh_hit found = right[hit], none = right[miss];
    expect_kinds(with(hit, {rays_.rays[hit].direction_tmax.s[3], 0, 0, RSH_NO_HIT}), {1, 0, 0});
    expect_kinds(with(hit, {2 * found.t, found.u, found.v, found.primitive}), {1, 0, 0});
    expect_kinds(with(hit, {0.5f * found.t, found.u, found.v, found.primitive}), {0, 1, 0});
    expect_kinds(with(hit, {NAN, found.u, found.v, found.primitive}), {0, 1, 0});
    expect_kinds(with(hit, {found.t, found.u, found.v, found.primitive ^ 1}), {0, 0, 1});
    expect_kinds(with(hit, {found.t, 2 * found.u, found.v, found.primitive}), {0, 0, 1});
    expect_kinds(with(miss, {1, 0, 0, 0}), {0, 1, 0});
    expect_kinds(with(miss, {none.t, 1, 0, RSH_NO_HIT}), {0, 0, 1});
}

TEST_F(Audit, TellsKindsOfOcclusionApart) {
    std::vector<uint32_t> masks(count(), 0);
    masks = occlusion(device_mesh_, rays_, masks, 5);
    for (const uint32_t bit : {1u << 5, 0u}) {
        std::vector<uint32_t> wrong = masks;
        const size_t ray = size_t(
            std::find_if(wrong.begin(), wrong.end(), [&](uint32_t m) { return m == bit; }) -
            wrong.begin());
        ASSERT_LT(ray, count());
        wrong[ray] ^= 1u << 5;
        expect_kinds(audit(wrong, 5), bit ? Kinds{1, 0, 0} : Kinds{0, 1, 0});
    }
}

TEST_F(Audit, LooksAtTheBitOfTheQueryOnly) {
    const std::vector<uint32_t> others(count(), ~(1u << 5));
    expect_report(audit(occlusion(device_mesh_, rays_, others, 5), 5), count(), 0, RSH_NO_HIT);
}

// Where every answer is wrong, the differences are the rays that were traced.
TEST_F(Audit, TracesAsManyRaysAsItIsAskedTo) {
    std::vector<rsh_hit> wrong = hits();
    for (rsh_hit& hit : wrong) hit.primitive ^= 1;
    for (const cl_uint sample : {1u, 2u, 63u, 64u, 65u, 850u, 851u, 852u, 0xffffffffu}) {
        const rsh_audit_report report = audit(wrong, sample);
        const size_t expected = std::min<size_t>(sample, count());
        EXPECT_EQ(report.rays, expected);
        EXPECT_EQ(report.differences, expected);
        EXPECT_LT(report.first_ray, count() / expected + 1);  // one in the first range
    }
}

TEST_F(Audit, TakesRaysByTheSeed) {
    std::vector<rsh_hit> wrong = hits();
    for (rsh_hit& hit : wrong) hit.primitive ^= 1;
    std::vector<cl_uint> first;
    for (cl_uint seed = 0; seed < 16; ++seed) {
        first.push_back(audit(wrong, 1, seed).first_ray);
        EXPECT_EQ(audit(wrong, 1, seed).first_ray, first.back());
    }
    std::sort(first.begin(), first.end());
    EXPECT_GT(std::unique(first.begin(), first.end()) - first.begin(), 8);
}

TEST_F(Audit, LeavesInactiveRaysOut) {
    const size_t active[] = {3, 500, 501};
    for (size_t i = 0; i < count(); ++i)
        if (std::find(std::begin(active), std::end(active), i) == std::end(active))
            rays_.rays[i] = test::inactive_ray();
    ray_buffer_.write(rays_.rays);
    std::vector<rsh_hit> wrong = hits();
    for (rsh_hit& hit : wrong) hit.primitive ^= 1;
    expect_report(audit(wrong), 3, 3, 3);
    EXPECT_EQ(audit(wrong, 1).differences, 1u);
    expect_report(audit(wrong, 2), 2, 2, 3);  // ranges of 425 and 426 rays
}

// What lies behind them may be anything, and is.
TEST_F(Audit, TracesTheRaysThatTheDeviceCounts) {
    const std::vector<rsh_hit> right = hits();
    for (const cl_uint known : {0u, 1u, 300u, 850u, 0xffffffffu}) {
        const size_t rays = std::min<size_t>(known, count());
        std::vector<rsh_hit> wrong = right;
        for (size_t i = rays; i < count(); ++i) wrong[i].primitive ^= 1;
        list_count_ = known;
        for (const cl_uint sample : {0u, 7u, 851u}) {
            const size_t traced = sample ? std::min<size_t>(sample, rays) : rays;
            expect_report(audit(wrong, sample), traced, 0, RSH_NO_HIT);
        }
    }
}

// Of the frame's waves, as the statistics count them.
TEST(AuditOfAFrame, TracesTheRaysOfAllWaves) {
    const test::OwnContext context;
    const Buffer<rsh_audit_report> report(1);
    test::FrameOptions options;
    options.width = options.height = 16;
    options.bounces = 2;
    options.context = context.get();
    options.audit_rays = 256;
    options.audit = report.get();
    RSH_CHECK(rsh_count_statistics(context.get(), CL_TRUE));
    test::frame(test::DeviceScene(test::gallery()), options);
    rsh_statistics s = {};
    s.struct_size = sizeof s;
    RSH_CHECK(rsh_get_statistics(context.get(), &s));
    size_t rays = 256 + s.shadow_rays[0];
    for (int bounce = 1; bounce <= 2; ++bounce)
        rays += s.active_rays[bounce] + s.shadow_rays[bounce];
    EXPECT_GT(s.active_rays[2], 0u);
    expect_report(report.read()[0], rays, 0, RSH_NO_HIT);

    options.audit_rays = 1;
    test::frame(test::DeviceScene(test::gallery()), options);
    const rsh_audit_report sampled = report.read()[0];
    EXPECT_GT(sampled.rays, 1u);
    EXPECT_LE(sampled.rays, 1 + s.traversals);
}

// Neither a launch nor a bit.
TEST(AuditOfAFrame, IsNotThereUnlessItIsAskedFor) {
    const test::OwnContext context;
    const Buffer<rsh_audit_report> report(1);
    const test::DeviceScene scene(test::gallery());
    test::FrameOptions options;
    options.width = options.height = 16;
    options.bounces = 1;
    options.context = context.get();
    cl_ulong launches[2];
    std::vector<cl_float4> images[2];
    for (int i = 0; i < 2; ++i) {
        RSH_CHECK(rsh_count_statistics(context.get(), CL_TRUE));
        images[i] = test::frame(scene, options);
        rsh_statistics s = {};
        s.struct_size = sizeof s;
        RSH_CHECK(rsh_get_statistics(context.get(), &s));
        launches[i] = s.launches - (options.audit_rays ? s.traversals + 1 + 2 : 0);
        if (i == 0) {
            EXPECT_TRUE(report.untouched());
        }
        options.audit_rays = 7;
        options.audit = report.get();
    }
    EXPECT_EQ(launches[0], launches[1]);
    EXPECT_TRUE(test::same_bits(images[1], images[0], "pixels"));
}

TEST_F(Audit, FindsWrongCounts) {
    auto counts = hit_counts(device_mesh_, rays_);
    expect_report(audit_counts(counts), count(), 0, RSH_NO_HIT);
    ASSERT_GT(counts[200], 0u);
    --counts[200];
    ++counts[300];
    const rsh_audit_report report = audit_counts(counts);
    expect_report(report, count(), 2, 200);
    EXPECT_EQ(report.missed, 1u);
    EXPECT_EQ(report.spurious, 1u);
}

TEST_F(Audit, FindsWrongLists) {
    const test::HitLists right = all_hits(device_mesh_, rays_);
    expect_report(audit(right), count(), 0, RSH_NO_HIT);
    size_t ray = 0;  // the first one with two hits
    while (right.offsets[ray + 1] - right.offsets[ray] < 2) ++ray;
    test::HitLists lists = right;
    std::swap(lists.hits[right.offsets[ray]], lists.hits[right.offsets[ray] + 1]);
    expect_report(audit(lists), count(), 1, ray);
    lists = right;
    lists.hits[right.offsets[ray]].u += 0.25f;
    const rsh_audit_report report = audit(lists);
    expect_report(report, count(), 1, ray);
    EXPECT_EQ(report.wrong, 1u);
    lists = right;
    for (size_t i = ray; i < lists.offsets.size(); ++i) ++lists.offsets[i];
    lists.hits.resize(lists.hits.size() + 1);
    EXPECT_GT(audit(lists).differences, 1u);
    lists = right;
    lists.offsets[ray] += uint64_t{1} << 40;  // behind all hits
    lists.offsets[ray + 1] += uint64_t{1} << 40;
    EXPECT_EQ(audit(lists).wrong, 1u);
}

TEST_F(Audit, OfListsThatDidNotFitLooksAtTheirLengths) {
    const uint64_t all = all_hits(device_mesh_, rays_).offsets.back();
    expect_report(audit(hit_lists(device_mesh_, rays_, all - 1)), count(), 0, RSH_NO_HIT);
}

}  // namespace
