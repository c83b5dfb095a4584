// leaving_test.cpp - rays that leave closed convex bodies of any size, anywhere: nothing stops
// those that go out, and those that go in get out where they should. RSH_TEST_RAYS asks for more.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "shade/leaving.hpp"
#include "support/bodies.hpp"
#include "support/changed_kernels.hpp"

namespace {

using test::Body;
using test::Placement;
using test::Random;
using test::Tally;

struct NamedBody {
    const char* name;
    Body body;
    double
        farthest;  // from the origin, in sizes: there is a body left when corners are rounded
};

std::ostream& operator<<(std::ostream& out, const NamedBody& named) {
    return out << named.name;
}

const std::vector<NamedBody>& bodies() {
    static const std::vector<NamedBody> all = {
        {"Sphere", test::sphere_body(32, 15), 1e4},
        {"Cube", test::box_body({1, 1, 1}), 1e4},
        {"Slab", test::box_body({1, 0.1, 1}), 1e4},
        {"Needle", test::box_body({1, 1e-2, 1e-2}), 1e4},
        {"Frustum", test::frustum(1e-2), 1e4},  // neighbours of very different size
        {"Sheet", test::box_body({1, 1e-4, 1}), 100},
        {"Hair", test::box_body({1, 1e-4, 1e-4}), 100},
    };
    return all;
}

// Every scale at every distance from the origin, turned and not.
std::vector<Placement> placements(Random& random, double farthest) {
    std::vector<Placement> all;
    for (const double scale : {1e-10, 1e-5, 1.0, 1e5, 1e10})
        for (const double distance : {0.0, 1.0, 0.01 * farthest, farthest})
            for (const bool is_turned : {false, true}) {
                Placement at;
                at.scale = scale;
                at.offset = distance * test::Double3(random.in_cube());
                if (is_turned) at.turn = test::random_turn(random);
                all.push_back(at);
            }
    if (!test::small()) return all;
    return {all.front(), all[all.size() / 2 + 1], all.back()};
}

Tally follow_all(const NamedBody& named, size_t rays, rsh_context context) {
    Random random(311);
    Tally tally;
    const auto all = placements(random, named.farthest);
    const float indices[] = {1.5f, 1.0f, 0.6f, 2.4f, 1 + 0x1p-12f};
    const std::vector<uint32_t> kinds = {RSH_SPAWN_REFLECTION, RSH_SPAWN_REFRACTION,
                                         RSH_SPAWN_SHADOW};
    for (size_t i = 0; i < all.size(); ++i) {
        const test::Mesh mesh = placed(named.body, all[i]);
        const test::Sending sending{kinds, indices[i % std::size(indices)], context};
        // About two leave where one hits.
        const auto count = uint32_t(rays / all.size() / 2 + 1);
        tally.add(follow(mesh, centre_of(all[i]), rays_at_body(random, mesh, all[i], count),
                         sending));
    }
    return tally;
}

void report(const Tally& tally) {
    testing::Test::RecordProperty("outwards", std::to_string(tally.outwards));
    testing::Test::RecordProperty("inwards", std::to_string(tally.inwards));
    testing::Test::RecordProperty("lost", std::to_string(tally.lost));
    testing::Test::RecordProperty("again", std::to_string(tally.again));
}

class Leaving : public ::testing::TestWithParam<NamedBody> {};

TEST_P(Leaving, IsStoppedByNothingAndGetsOutInPlace) {
    const size_t rays = test::ray_count(200000) / bodies().size();
    const Tally tally = follow_all(GetParam(), rays, nullptr);
    report(tally);
    EXPECT_GT(tally.outwards, rays / 4);
    EXPECT_GT(tally.inwards, rays / 4);
    EXPECT_EQ(tally.stopped.count, 0u)
        << "of " << tally.outwards << ", " << tally.stopped.first;
    EXPECT_EQ(tally.misplaced.count, 0u)
        << "of " << tally.inwards << ", " << tally.misplaced.first;
}

INSTANTIATE_TEST_SUITE_P(, Leaving, ::testing::ValuesIn(bodies()),
                         [](const auto& named) { return std::string(named.param.name); });

// The test above can fail.
size_t stopped_with(const NamedBody& body, const char* file, const char* from, const char* to) {
    const test::ChangedKernels changed(file, from, to);
    return follow_all(body, 20000, changed.context()).stopped.count;  // one in some thousand
}

TEST(LeavingIsStopped, WithoutAnOffset) {
    EXPECT_GT(stopped_with(bodies()[1], "shade/branch.h",
                           "rounded_to_side(start, side, sent.direction)", "from->point"),
              0u);
}

TEST(LeavingIsStopped, WhereNoPlaneSeparates) {
    EXPECT_GT(stopped_with(bodies()[3], "mesh/leaving.h",
                           "return separates(hit, left->rays[ray], hit, false) ||",
                           "return false &&"),
              0u);
}

// Grazing rays, aimed at the edges of triangles that stand apart. What passes an edge within
// rounding is hit or not; the plane may be met far beside that.
struct Grazed {
    test::Mesh mesh;
    test::Rays rays;
};

Grazed grazed_edges(Random& random, uint32_t count) {
    Grazed grazed{{}, {{}, count, 1}};
    for (uint32_t i = 0; i < count; ++i) {
        const test::Float3 place(4 * float(i % 64), 4 * float(i / 64 % 64),
                                 4 * float(i / 4096));
        for (int corner = 0; corner < 3; ++corner)
            grazed.mesh.vertices.push_back(place + random.in_cube());
        const test::Double3 a(grazed.mesh.vertices[3 * i]), b(grazed.mesh.vertices[3 * i + 1]),
            c(grazed.mesh.vertices[3 * i + 2]),
            normal = normalize(cross(b - a, c - a)),
            at = a + double(random.between(0.1f, 0.9f)) * (b - a),
            in_plane = normalize(a + double(random.between(0.1f, 0.9f)) * (c - a) - at),
            way = in_plane + std::exp2(double(random.between(-22, -6))) * normal;
        const test::Float3 eye(at - way);
        grazed.rays.rays.push_back(test::make_ray(eye, test::Float3(at) - eye));
    }
    return grazed;
}

bool is_at_box(test::Float3 point, const test::Corners& c) {
    const auto between = [&](float x, float p, float q, float r) {
        const float room = 0x1p-15f + 0x1p-20f * std::fabs(x);
        return x >= std::min({p, q, r}) - room && x <= std::max({p, q, r}) + room;
    };
    return between(point.x, c[0].x, c[1].x, c[2].x) &&
           between(point.y, c[0].y, c[1].y, c[2].y) && between(point.z, c[0].z, c[1].z, c[2].z);
}

// How many start far from the box of the triangle that they left; `seen`: of how many.
size_t far_starts(rsh_context context, const std::vector<uint32_t>& kinds, size_t* seen) {
    Random random(312);
    const Grazed grazed = grazed_edges(random, uint32_t(test::ray_count(20000)));
    const test::Sending sending{kinds, 1.5f, context};
    size_t far = 0;
    for (const test::Departures& from : send(grazed.mesh, grazed.rays, sending))
        for (size_t i = 0; i < from.rays.size(); ++i) {
            test::Corners c;
            if (!test::is_active(from.rays[i]) || !grazed.mesh.corners(from.skip[i], &c))
                continue;
            ++*seen;
            far += !is_at_box(test::origin(from.rays[i]), c);
        }
    return far;
}

const std::vector<uint32_t> kBranches = {RSH_SPAWN_REFLECTION, RSH_SPAWN_REFRACTION};

TEST(LeavingStarts, AtTheTriangleThatRoundingAloneHits) {
    for (const auto& kinds : {kBranches, {RSH_SPAWN_SHADOW}}) {
        size_t seen = 0;
        EXPECT_EQ(far_starts(nullptr, kinds, &seen), 0u) << "of " << seen;
        EXPECT_GT(seen, test::ray_count(20000) / 8);
    }
}

// The test above can fail.
size_t far_starts_with(const char* file, const char* from, const char* to,
                       const std::vector<uint32_t>& kinds) {
    const test::ChangedKernels changed(file, from, to);
    size_t seen = 0;
    return far_starts(changed.context(), kinds, &seen);
}

TEST(LeavingStarts, ElsewhereWhereRaysMeetThePlane) {
    EXPECT_GT(far_starts_with("surface/departure.h", "(fabs(way) <= 0x1p-18f",
                              "((floatv)(INFINITY) > 0x1p-18f", kBranches),
              0u);
}

TEST(LeavingStarts, ElsewhereWhereShadowRaysMeetThePlane) {
    EXPECT_GT(far_starts_with("surface/departure.h", "(fabs(way) <= 0x1p-18f",
                              "((floatv)(INFINITY) > 0x1p-18f", {RSH_SPAWN_SHADOW}),
              0u);
}

}  // namespace
