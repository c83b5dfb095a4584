// rooms_test.cpp - rays stay in closed rooms, beside the edges as well, and between walls that
// nearly touch. RSH_TEST_RAYS asks for more of them.
#include <gtest/gtest.h>

#include "shade/leaving.hpp"
#include "support/bodies.hpp"
#include "support/compare.hpp"

namespace {

using test::Body;
using test::Departures;
using test::Double3;
using test::Float3;
using test::Placement;
using test::Random;

constexpr double kUlp = 0x1p-23;  // of what is 1 to 2 in size

rsh_ray from_to(Double3 eye, Double3 point) {
    return test::make_ray(Float3(eye), Float3(point - eye));
}

// Any point inside a body around the origin.
Double3 inside(Random& random, const Body& body) {
    Double3 sum = {};
    double weights = 0;
    for (const Double3 v : body.vertices) {
        const double weight = double(random.unit()) + 1e-3;
        sum = sum + weight * v;
        weights += weight;
    }
    return (1 / weights) * sum;
}

// Rays from inside to such points.
template <class Point>
test::Rays rays_inside(Random& random, const Body& body, const Placement& at, uint32_t count,
                       Point point) {
    test::Rays rays{{}, count, 1};
    const auto place = [&](Double3 v) { return at.scale * (turned(at.turn, v) + at.offset); };
    for (uint32_t i = 0; i < count; ++i)
        rays.rays.push_back(from_to(place(inside(random, body)), place(point())));
    return rays;
}

std::vector<Placement> unturned_and_turned(Random& random, int turns) {
    std::vector<Placement> all(1);
    for (int i = 0; i < turns; ++i) {
        all.emplace_back();
        all.back().turn = test::random_turn(random);
    }
    return all;
}

// On a face, from 16 ulp of the room's size to half of it away from the nearest edge.
Double3 beside_an_edge(Random& random) {
    const double size = 2, nearest = 16 * size * kUlp;
    const auto near_end = [&] {
        const double off = nearest * std::exp2(double(random.unit()) * std::log2(1 / nearest));
        return random.chance(0.5f) ? 1 - off : off - 1;
    };
    const double u = near_end(), v = near_end(), side = random.chance(0.5f) ? 1 : -1;
    const uint32_t axis = random.below(3);
    return axis == 0   ? Double3(side, u, v)
           : axis == 1 ? Double3(u, side, v)
                       : Double3(u, v, side);
}

TEST(Rooms, KeepReflectionsInACube) {
    Random random(320);
    const Body cube = test::box_body({1, 1, 1});
    const auto placements = unturned_and_turned(random, 3);
    const auto count = uint32_t(test::ray_count(100000) / placements.size());
    for (const Placement& at : placements) {
        const test::Mesh mesh = placed(cube, at);
        const auto rays =
            rays_inside(random, cube, at, count, [&] { return beside_an_edge(random); });
        const test::Tally tally = follow(mesh, {}, rays, {{RSH_SPAWN_REFLECTION}, 0});
        EXPECT_EQ(tally.inwards, count) << "hit and stay";
        EXPECT_EQ(tally.lost, 0u) << "leave the room, of " << tally.inwards;
        EXPECT_EQ(tally.misplaced.count, 0u) << tally.misplaced.first;
    }
}

// Of the reflections at 1e-3 from the edge between the large faces.
size_t count_leaving(Random& random, double degrees, uint32_t count, const Placement& at) {
    const Body room = test::wedge(degrees);
    const auto point = [&] {
        const Double3 along = normalize(room.vertices[2 + random.below(2)]);
        return Double3(0, 0, double(random.between(-0.45f, 0.45f))) + 1e-3 * along;
    };
    const test::Mesh mesh = placed(room, at);
    const auto rays = rays_inside(random, room, at, count, point);
    size_t leaving = 0, active = 0;
    for (const Departures& spawned : send(mesh, rays, {{RSH_SPAWN_REFLECTION}, 0}))
        for (size_t i = 0; i < spawned.rays.size(); ++i) {
            active += test::is_active(spawned.rays[i]);
            leaving +=
                test::is_active(spawned.rays[i]) && spawned.hits[i].primitive == RSH_NO_HIT;
        }
    EXPECT_EQ(active, count);
    return leaving;
}

// With offsets that grew with the triangle 0.22, 2.4 and 26 % left.
TEST(Rooms, KeepReflectionsBesideSharpEdges) {
    Random random(321);
    const std::pair<double, double> rooms[] = {{60, 0.0022}, {6, 0.024}, {0.6, 0.26}};
    const auto placements = unturned_and_turned(random, 3);
    const auto count = uint32_t(test::ray_count(100000) / placements.size());
    for (const auto& [degrees, share] : rooms) {
        size_t leaving = 0;
        for (const Placement& at : placements)
            leaving += count_leaving(random, degrees, count, at);
        const double rays = double(count) * double(placements.size());
        EXPECT_LE(100 * double(leaving), share * rays)
            << leaving << " of " << rays << " leave, " << degrees << " degrees";
        RecordProperty("leaving_" + std::to_string(degrees), std::to_string(leaving));
    }
}

// Two squares of two triangles each, `gap` apart, in front of z = 1.
Body walls(double gap) {
    Body body;
    for (const double z : {1.0, 1 + gap})
        for (int i = 0; i < 4; ++i)
            body.vertices.push_back({i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, z});
    body.indices = {0, 1, 2, 1, 3, 2, 4, 5, 6, 5, 7, 6};
    return body;
}

// At wall 0 or 1, from the gap or from outside.
test::Rays rays_at_walls(Random& random, double gap, const Placement& at, bool from_gap,
                         uint32_t count) {
    test::Rays rays{{}, count, 1};
    for (uint32_t i = 0; i < count; ++i) {
        const bool is_far = random.chance(0.5f);
        Double3 d(random.direction());
        d.z = (is_far == from_gap ? 1 : -1) * (0.1 + std::fabs(d.z));
        const Double3 point(double(random.between(-0.7f, 0.7f)),
                            double(random.between(-0.7f, 0.7f)), is_far ? 1 + gap : 1);
        const double way = from_gap ? gap / 2 : double(random.between(0.01f, 3));
        const Double3 eye = point - (way / std::fabs(d.z)) * d;
        rays.rays.push_back(
            test::make_ray(Float3(turned(at.turn, eye)), Float3(turned(at.turn, d))));
    }
    return rays;
}

// What goes into the gap hits the other wall, what goes out hits nothing.
void expect_held(const Departures& spawned, bool into_gap) {
    size_t active = 0, wrong = 0, first = 0;
    for (size_t i = spawned.rays.size(); i-- > 0;) {
        if (!test::is_active(spawned.rays[i])) continue;
        ++active;
        const uint32_t hit = spawned.hits[i].primitive;
        const bool is_held = hit != RSH_NO_HIT && hit / 2 != spawned.skip[i] / 2;
        if (into_gap ? is_held : hit == RSH_NO_HIT) continue;
        ++wrong;
        first = i;
    }
    EXPECT_GT(active, 0u);
    EXPECT_EQ(wrong, 0u) << "of " << active << ", first " << spawned.rays[first] << ", left "
                         << spawned.skip[first] << ", hit " << spawned.hits[first];
}

TEST(Rooms, KeepRaysBetweenParallelWalls) {
    Random random(322);
    const std::vector<uint32_t> kinds = {RSH_SPAWN_REFLECTION, RSH_SPAWN_REFRACTION,
                                         RSH_SPAWN_SHADOW};
    const auto placements = unturned_and_turned(random, 3);
    const auto count = uint32_t(test::ray_count(100000) / placements.size() / 10 + 20);
    for (const double ulps : {16.0, 17.0, 64.0, 1024.0})
        for (const Placement& at : placements)
            for (const bool from_gap : {false, true}) {
                const double gap = ulps * kUlp;
                const auto rays = rays_at_walls(random, gap, at, from_gap, count);
                const auto spawned = send(placed(walls(gap), at), rays, {kinds, 1});
                for (size_t k = 0; k < kinds.size(); ++k) {
                    SCOPED_TRACE(std::to_string(ulps) + " ulp, kind " +
                                 std::to_string(kinds[k]) +
                                 (from_gap ? ", from the gap" : ", from outside") + ", turn " +
                                 std::to_string(&at - placements.data()));
                    expect_held(spawned[k], (kinds[k] == RSH_SPAWN_REFRACTION) != from_gap);
                }
            }
}

}  // namespace
