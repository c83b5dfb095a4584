// approximate_test.cpp - an approximate frame is what rsh.h says: pixels that are traced have the bits of
// the frame that traces all, the others the mean of neighbours that are alike; whatever the budget, the
// engine and the strategy.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/compare.hpp"
#include "support/render.hpp"
#include "support/strategies.hpp"
#include "support/ways.hpp"

namespace {

using test::FrameOptions;

constexpr uint32_t kBand = 64, kWidestStep = 4;
constexpr float kTolerance = 0.02f;
// Square roots of OpenCL may be off by 3 units in the last place, quotients by 2.5.
constexpr double kUndecided = 1e-5;

FrameOptions sized(uint32_t width, uint32_t height) {
    FrameOptions options;
    options.width = test::small() ? std::min(width, 20u) : width;
    options.height = test::small() ? std::min(height, 14u) : height;
    options.bounces = 2;
    return options;
}

// What may become of a pixel.
enum class Verdict { kTraced, kBlended, kEither };

// From what the camera sees and the colours of coarser grids, by the words of rsh.h.
class Oracle {
private:
    struct Corners {
        size_t pixel;
        size_t index[4];  // here, to the right, below, across
        uint32_t dx, dy;  // of the pixel, in halves of the cell
        bool is_cut;      // one is beyond the screen or in the next band

        size_t operator[](int n) const { return index[n]; }
    };

    // Of a pixel that is not in the first grid: of the cell of the finest grid without it.
    Corners corners_of(uint32_t x, uint32_t y) const {
        const uint32_t half = (x | y) % 2 ? 1 : 2, step = 2 * half;
        const uint32_t left = x / step * step, top = y / step * step;
        Corners at = {size_t(y) * width_ + x, {}, (x - left) / half, (y - top) / half, false};
        for (uint32_t n = 0; n < 4; ++n)
            at.index[n] = size_t(top + n / 2 * step) * width_ + left + n % 2 * step;
        at.is_cut = left + step >= width_ || top + step >= height_ ||
                    top / kBand != (top + step) / kBand;
        return at;
    }

    template <class Value>
    static auto mean_of(const Corners& at, Value value) {
        const decltype(value(0)) half = 0.5f;
        if (at.dy == 0) return half * (value(at[0]) + value(at[1]));
        if (at.dx == 0) return half * (value(at[0]) + value(at[2]));
        return half *
               (half * (value(at[0]) + value(at[1])) + half * (value(at[2]) + value(at[3])));
    }

public:
    Oracle(std::vector<rsh_hit> hits, std::vector<uint32_t> material_ids,
           std::vector<cl_float4> picture, uint32_t width)
        : hits_(std::move(hits)),
          material_ids_(std::move(material_ids)),
          picture_(std::move(picture)),
          width_(width),
          height_(static_cast<uint32_t>(picture_.size() / width)) {}

    Verdict verdict(uint32_t x, uint32_t y) const {
        if (x % kWidestStep == 0 && y % kWidestStep == 0) return Verdict::kTraced;
        const Corners at = corners_of(x, y);
        if (at.is_cut) return Verdict::kTraced;
        for (const size_t corner : at.index)
            if (material(corner) != material(at.pixel)) return Verdict::kTraced;
        return judge(std::max(spread(at) - kTolerance, distance_off(at)));
    }

    // Of two corners or all four.
    cl_float4 mean(uint32_t x, uint32_t y) const {
        const Corners at = corners_of(x, y);
        cl_float4 made;
        for (int c = 0; c < 4; ++c)
            made.s[c] = mean_of(at, [&](size_t i) { return picture_[i].s[c]; });
        return made;
    }

private:
    // The id of what a pixel sees; none: nothing.
    uint32_t material(size_t pixel) const {
        const uint32_t primitive = hits_[pixel].primitive;
        return primitive == RSH_NO_HIT ? RSH_NO_HIT : material_ids_[primitive];
    }

    static Verdict judge(double excess) {
        if (!(excess <= kUndecided)) return Verdict::kTraced;
        return excess < -kUndecided ? Verdict::kBlended : Verdict::kEither;
    }

    double spread(const Corners& at) const {
        double most = 0;
        for (int c = 0; c < 3; ++c)
            for (const size_t a : at.index)
                for (const size_t b : at.index)
                    most = std::max(most, std::sqrt(double(picture_[a].s[c])) -
                                              std::sqrt(double(picture_[b].s[c])));
        return most;
    }

    // How much the inverse of the distance differs from the mean of the corners', less what it may.
    double distance_off(const Corners& at) const {
        const auto nearness = [&](size_t i) { return 1 / double(hits_[i].t); };
        const double here = nearness(at.pixel);
        if (here == 0) return -1;
        return std::abs(mean_of(at, nearness) / here - 1) - kTolerance;
    }

    std::vector<rsh_hit> hits_;
    std::vector<uint32_t> material_ids_;
    std::vector<cl_float4> picture_;
    uint32_t width_, height_;
};

bool same(const cl_float4& a, const cl_float4& b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

// Compares each pixel with what the oracle says of it. Returns how many are means for sure.
size_t expect_as_said(const test::Scene& gallery, rsh_context context) {
    const test::DeviceScene scene(gallery);
    FrameOptions options = sized(97, 139);
    options.context = context;
    const auto exact = test::frame(scene, options);
    options.tolerance = kTolerance;
    const auto picture = test::frame(scene, options);
    const Oracle oracle(test::rasterize(scene, options).hits, gallery.material_ids, picture,
                        options.width);
    size_t blended = 0, open = 0;
    for (size_t i = 0; i < picture.size(); ++i) {
        const auto x = static_cast<uint32_t>(i % options.width);
        const auto y = static_cast<uint32_t>(i / options.width);
        const Verdict verdict = oracle.verdict(x, y);
        const bool is_exact = same(picture[i], exact[i]);
        const bool is_mean = verdict != Verdict::kTraced && same(picture[i], oracle.mean(x, y));
        EXPECT_TRUE(verdict == Verdict::kBlended  ? is_mean
                    : verdict == Verdict::kTraced ? is_exact
                                                  : is_exact || is_mean)
            << "pixel " << x << ", " << y << " is " << picture[i] << ", traced it is "
            << exact[i];
        if (::testing::Test::HasFailure()) return blended;
        blended += verdict == Verdict::kBlended;
        open += verdict == Verdict::kEither;
    }
    EXPECT_LT(open, picture.size() / 100);
    return blended;
}

// By vectors of so many lanes, which shade with other last bits.
class ApproximateWidth : public ::testing::TestWithParam<cl_uint> {};

TEST_P(ApproximateWidth, TracesOrBlendsAsTheInterfaceSays) {
    const test::OwnContext context(GetParam());
    const size_t blended = expect_as_said(test::gallery(), context.get());
    if (test::small()) return;
    EXPECT_GT(blended, 97u * 139 / 8);
    EXPECT_LT(blended, 97u * 139 / 8 * 6);
}

// Every other triangle is of a copy of its material.
TEST(Approximate, TellsMaterialsApartThatLookTheSame) {
    test::Scene gallery = test::gallery();
    const std::vector<rsh_material> copies = gallery.materials;
    gallery.materials.insert(gallery.materials.end(), copies.begin(), copies.end());
    for (size_t i = 1; i < gallery.material_ids.size(); i += 2)
        gallery.material_ids[i] += static_cast<uint32_t>(copies.size());
    expect_as_said(gallery, test::device().rsh);
}

INSTANTIATE_TEST_SUITE_P(All, ApproximateWidth, ::testing::Values(1u, 4u, 8u, 16u));

TEST(Approximate, GivesTheSameBytesInEveryWay) {
    const test::DeviceScene scene(test::gallery());
    FrameOptions options = sized(61, 205);
    options.tolerance = kTolerance;
    const auto picture = test::frame(scene, options);
    for (const test::TraceOptions& way : test::all_ways()) {
        SCOPED_TRACE(name_of(way));
        options.engine = way.engine;
        options.budget = 0;
        EXPECT_TRUE(test::same_bits(test::frame(scene, options), picture, "pixels"));
        options.budget = test::least_budget(scene, options);
        options.own_scratch = true;
        EXPECT_TRUE(test::same_bits(test::frame(scene, options), picture, "pixels"));
        options.own_scratch = false;
    }
    options = sized(61, 205);
    options.tolerance = kTolerance;
    for (const cl_uint strategy : test::all_strategies()) {
        options.strategy = strategy;
        EXPECT_TRUE(test::same_bits(test::frame(scene, options), picture, "pixels"))
            << rsh_strategy_name(strategy);
    }
}

TEST(Approximate, TracesAllWhereNothingIsAlike) {
    const test::DeviceScene scene(test::gallery());
    for (const auto& [width, height] :
         {std::pair(1u, 1u), {2u, 1u}, {1u, 2u}, {3u, 3u}, {64u, 64u}, {5u, 130u}}) {
        FrameOptions options = sized(width, height);
        const auto exact = test::frame(scene, options);
        options.tolerance = 1e-30f;
        EXPECT_TRUE(test::same_bits(test::frame(scene, options), exact, "pixels"))
            << width << " x " << height;
    }
}

TEST(Approximate, MeansNothingWithoutRaysAfterTheCameras) {
    const test::DeviceScene scene(test::gallery(), RSH_FEATURE_SHADOW);
    FrameOptions options = sized(40, 30);
    options.bounces = 0;
    const auto exact = test::frame(scene, options);
    options.tolerance = 1;
    EXPECT_TRUE(test::same_bits(test::frame(scene, options), exact, "pixels"));
}

TEST(Approximate, TracesFewerRays) {
    const test::OwnContext context;
    const test::DeviceScene scene(test::gallery());
    FrameOptions options = sized(96, 72);
    options.context = context.get();
    const auto rays = [&](float tolerance) {
        options.tolerance = tolerance;
        RSH_CHECK(rsh_count_statistics(context.get(), CL_TRUE));
        test::frame(scene, options);
        rsh_statistics s = {};
        s.struct_size = sizeof s;
        RSH_CHECK(rsh_get_statistics(context.get(), &s));
        return s;
    };
    const rsh_statistics all = rays(0), some = rays(kTolerance);
    for (uint32_t bounce = 0; bounce <= options.bounces; ++bounce) {
        EXPECT_LT(some.active_rays[bounce], all.active_rays[bounce]) << "bounce " << bounce;
        EXPECT_LT(some.shadow_rays[bounce], all.shadow_rays[bounce]) << "bounce " << bounce;
    }
}

// A pixel that is NaN or infinite is like no other: one material shines so, and others mirror it.
TEST(Approximate, SpreadsNoNanAndNoInfinity) {
    const size_t materials = test::gallery().materials.size();
    for (size_t n = 0; n < 2 * materials; ++n) {
        test::Scene gallery = test::gallery();
        gallery.materials[n / 2].emission.s[1] = n % 2 ? NAN : INFINITY;
        const test::DeviceScene scene(gallery);
        FrameOptions options = sized(96, 72);
        const auto exact = test::frame(scene, options);
        options.tolerance = 0.5f;
        const auto picture = test::frame(scene, options);
        for (size_t i = 0; i < picture.size(); ++i) {
            const bool is_finite = std::isfinite(exact[i].s[1]);
            ASSERT_EQ(std::isfinite(picture[i].s[1]), is_finite)
                << "material " << n / 2 << ", pixel " << i;
            ASSERT_TRUE(is_finite || same(picture[i], exact[i])) << "pixel " << i;
        }
    }
}

}  // namespace
