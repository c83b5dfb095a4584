// frame_families.cpp - bounds that were made for other frames and kept: what moved, collapsed, went
// elsewhere or was NaN in between must be found where it is now.
#include <algorithm>
#include <limits>
#include <utility>

#include "stability/family.hpp"

namespace bench::stability {
namespace {

using test::Float3;
using test::Mesh;
using test::Random;
using Frame = std::vector<Float3>;

Scene soup_after(Random& random, Extent e, Mesh mesh, std::vector<Frame> earlier) {
    return {std::move(mesh), test::random_rays(random, e.side, e.side), false,
            std::move(earlier)};
}

// Every corner its own way: far, so that bounds are made anew, then so little that they are fitted.
Scene kept_moving(Random& random, Extent e) {
    const Mesh mesh = test::random_soup(random, e.triangles);
    std::vector<Frame> earlier;
    for (const float far : {2.0f, 0.5f, 0.02f}) {
        Frame frame = mesh.vertices;
        for (Float3& v : frame) v = v + random.in_cube(far);
        earlier.push_back(frame);
    }
    return soup_after(random, e, mesh, earlier);
}

// All in one point, then in one plane.
Scene kept_collapsed(Random& random, Extent e) {
    const Mesh mesh = test::random_soup(random, e.triangles);
    Frame flat = mesh.vertices;
    for (Float3& v : flat) v.z = 0;
    const Frame point(flat.size(), random.in_cube());
    return soup_after(random, e, mesh, {mesh.vertices, point, flat});
}

// Each triangle where another was: boxes around what was near hold what is far apart.
Scene kept_swapped(Random& random, Extent e) {
    const Mesh mesh = test::random_soup(random, e.triangles);
    Frame swapped = mesh.vertices;
    for (uint32_t i = mesh.triangle_count(); i-- > 1;)
        std::swap_ranges(swapped.begin() + 3 * i, swapped.begin() + 3 * i + 3,
                         swapped.begin() + 3 * random.below(i));
    return soup_after(random, e, mesh, {swapped});
}

// First all, then some corners are none; some stay so.
Scene kept_nan(Random& random, Extent e) {
    const float bad[] = {
        std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
        -std::numeric_limits<float>::infinity(), std::numeric_limits<float>::max()};
    const auto spoil = [&](Frame& frame, float share) {
        for (Float3& v : frame)
            if (random.chance(share)) v.y = bad[random.below(3)];
    };
    Mesh mesh = test::random_soup(random, e.triangles);
    Frame all = mesh.vertices, some = mesh.vertices;
    spoil(all, 1);
    spoil(some, 0.3f);
    spoil(mesh.vertices, 0.01f);
    return soup_after(random, e, mesh, {all, some});
}

Frame soup_frame(Random& random, uint32_t triangles) {
    return test::random_soup(random, triangles).vertices;
}

// More triangles in every frame, from none and one on.
Scene kept_growing(Random& random, Extent e) {
    const Mesh mesh = test::random_soup(random, e.triangles);
    const auto first = [&](uint32_t triangles) {
        return Frame(mesh.vertices.begin(), mesh.vertices.begin() + 3 * triangles);
    };
    return soup_after(random, e, mesh, {{}, first(1), first(17), first(e.triangles / 2)});
}

// Fewer: what is behind the last triangle was one in the frame before.
Scene kept_shrinking(Random& random, Extent e) {
    Frame more = soup_frame(random, 2 * e.triangles);
    Frame one_more(more.begin(), more.begin() + 3 * (e.triangles + 1));
    const Mesh mesh = {Frame(more.begin(), more.begin() + 3 * e.triangles), {}};
    return soup_after(random, e, mesh, {std::move(more), std::move(one_more)});
}

}  // namespace

std::vector<Family> frame_families() {
    return {{"kept_moving", Kind::kRandom, kept_moving},
            {"kept_collapsed", Kind::kRandom, kept_collapsed},
            {"kept_swapped", Kind::kRandom, kept_swapped},
            {"kept_nan", Kind::kRandom, kept_nan},
            {"kept_growing", Kind::kRandom, kept_growing},
            {"kept_shrinking", Kind::kRandom, kept_shrinking}};
}

}  // namespace bench::stability
