// mirrors_test.cpp - whether paths between mirrors are compared right. Needs no device.
#include <gtest/gtest.h>

#include <limits>

#include "oracle/mirrors/float_state.hpp"
#include "oracle/mirrors/growth.hpp"
#include "oracle/mirrors/path_errors.hpp"
#include "oracle/mirrors/room.hpp"

namespace {

using oracle::Errors;
using oracle::ErrorTable;
using oracle::MirrorRay;
using oracle::MirrorRoom;
using oracle::Mirrors;
using oracle::Path;
using oracle::Quad3;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::vector<MirrorRay> starts(uint32_t count) {
    test::Random random(3);
    std::vector<MirrorRay> rays;
    for (const rsh_ray& ray : oracle::rays_in_mirror_room(random, count))
        rays.push_back({Quad3(test::origin(ray)), Quad3(test::direction(ray)), RSH_NO_HIT});
    return rays;
}

Mirrors mirrors_of(const MirrorRoom& room) {
    return {room.mesh, room.normals};
}

TEST(MirrorPaths, StayInTheRoom) {
    for (const bool is_smooth : {true, false}) {
        const MirrorRoom room = oracle::mirror_room(2, is_smooth);
        const Mirrors mirrors = mirrors_of(room);
        for (const MirrorRay& start : starts(16)) {
            const Path path = exact_path(mirrors, start, 32);
            ASSERT_EQ(path.size(), 32u);
            for (const oracle::Step& step : path) {
                const uint32_t triangle = step.next.triangle;
                ASSERT_NE(triangle, RSH_NO_HIT);
                const bool is_against =
                    dot(mirrors.plane_normal(triangle), step.ray.direction) < 0;
                EXPECT_EQ(is_against, faces_the_room(room, triangle)) << triangle;
            }
        }
    }
}

TEST(MirrorPaths, AreTheirOwnWithNothingChanged) {
    const Mirrors mirrors = mirrors_of(oracle::mirror_room(2, true));
    const auto unchanged = [](const MirrorRay& ray, const Quad3&) { return ray; };
    for (const MirrorRay& start : starts(8)) {
        const Path exact = exact_path(mirrors, start, 24);
        for (const Errors& e :
             errors_of(path_with(unchanged, 24, mirrors, start, exact), exact)) {
            EXPECT_EQ(e.position, 0);
            EXPECT_EQ(e.direction, 0);
            EXPECT_EQ(e.next_hit, 0);
        }
    }
}

// To first order, so that they agree as long as the error is small.
TEST(MirrorPaths, LetTheFirstRoundingGrowAsGrowthSays) {
    const Mirrors mirrors = mirrors_of(oracle::mirror_room(2, true));
    size_t compared = 0;
    for (const MirrorRay& start : starts(16)) {
        const Path exact = exact_path(mirrors, start, 12);
        const auto errors =
            errors_of(path_with(oracle::rounded, 1, mirrors, start, exact), exact);
        const std::vector<double> growth = growth_along(exact, mirrors, 1);
        const double first = length(test::Double3(errors[0].position, errors[0].direction, 0));
        for (size_t k = 0; k < exact.size(); ++k) {
            const double size =
                length(test::Double3(errors[k].position, errors[k].direction, 0));
            if (size > 1e-5) break;
            EXPECT_NEAR(size / (first * growth[k]), 1, 1e-3) << "bounce " << k + 1;
            ++compared;
        }
    }
    EXPECT_GT(compared, 100u);
}

TEST(MirrorPaths, AreLostFromTheBounceAtAnotherTriangleOn) {
    const Mirrors mirrors = mirrors_of(oracle::mirror_room(1, true));
    const Path exact = exact_path(mirrors, starts(1)[0], 6);
    Path path = exact;
    path[2].next.triangle = path[3].ray.skip = RSH_NO_HIT;
    const std::vector<Errors> errors = errors_of(path, exact);
    EXPECT_EQ(errors[2].position, 0);
    EXPECT_EQ(errors[2].next_hit, kInfinity);
    for (size_t k = 3; k < 6; ++k) EXPECT_EQ(errors[k].position, kInfinity) << k;
    path.resize(2);
    EXPECT_EQ(errors_of(path, exact)[1].direction, 0);
    EXPECT_EQ(errors_of(path, exact)[2].direction, kInfinity);
}

// Path i errs by i + 1, and is lost from bounce i + 2 on.
ErrorTable stairs(size_t paths) {
    ErrorTable table(paths, paths);
    for (size_t i = 0; i < paths; ++i) {
        std::vector<Errors> row;
        for (size_t k = 0; k < paths; ++k) {
            const double error = k > i ? kInfinity : double(i + 1);
            row.push_back({error, 2 * error, 3 * error});
        }
        table.set(i, row);
    }
    return table;
}

TEST(ErrorTable, CountsWhatIsLost) {
    const ErrorTable table = stairs(5);
    EXPECT_EQ(table.lost_by(1), 0u);
    EXPECT_EQ(table.lost_by(3), 2u);
    EXPECT_EQ(table.bounce_when_lost(0.5), 4u);
    EXPECT_EQ(table.bounce_when_lost(0.8), 0u);
}

TEST(ErrorTable, TakesLostPathsForTheWorst) {
    const ErrorTable table = stairs(5);
    EXPECT_EQ(table.quantile(1, &Errors::position, 0.5), 3);
    EXPECT_EQ(table.quantile(3, &Errors::position, 0), 3);
    EXPECT_EQ(table.quantile(3, &Errors::direction, 0.5), 10);
    EXPECT_EQ(table.quantile(4, &Errors::position, 0.5), kInfinity);
}

TEST(ErrorTable, ComparesPathByPath) {
    ErrorTable twice = stairs(5);
    const ErrorTable once = stairs(5);
    for (size_t i = 0; i < 5; ++i)
        twice.set(i, std::vector<Errors>(5, {2.0 * double(i + 1), 0, 0}));
    EXPECT_EQ(twice.median_of_ratios(once, 1, &Errors::position), 2);
    EXPECT_EQ(once.median_of_ratios(once, 4, &Errors::position), 1);
    EXPECT_EQ(once.median_of_ratios(twice, 5, &Errors::position), kInfinity);
}

}  // namespace
