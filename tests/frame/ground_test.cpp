// ground_test.cpp - the shadow and the mirror image of a thin slab on a ground of two triangles
// stay what they are when the ground grows, turned and seen from anywhere.
#include <gtest/gtest.h>

#include "support/bodies.hpp"
#include "support/render.hpp"

namespace {

using test::Double3;
using test::Float3;
using test::Scene;
using test::Turn;

rsh_float4 xyz(Double3 v, float w = 0) {
    return {{float(v.x), float(v.y), float(v.z), w}};
}

struct Sight {
    Double3 eye, at, up;
    double degrees;  // vertically
};

const Sight kFromAbove = {{0.01, 12, 0.02}, {0, 0, 0}, {0, 0, -1}, 30};
// What is seen of the ground is less than 10 away. Towards the sun the slab has its shadow in front,
// away from it a bright image of its side.
const Sight kToTheSun = {{-4, 1.4, 2.5}, {-0.4, 0.1, 0}, {0, 1, 0}, 20};
const Sight kFromTheSun = {{4, 1.4, 2.5}, {0.4, 0.1, 0}, {0, 1, 0}, 20};

rsh_camera camera_of(const Sight& sight, const Turn& turn) {
    const double half = std::tan(sight.degrees * 3.14159265358979323846 / 360);
    const Double3 forward = normalize(sight.at - sight.eye);
    const Double3 right = normalize(cross(forward, sight.up));
    rsh_camera camera = {};
    camera.eye = xyz(turned(turn, sight.eye), 1e-3f);
    camera.forward = xyz(turned(turn, forward));
    camera.right = xyz(half * turned(turn, right));
    camera.up = xyz(half * turned(turn, cross(right, forward)));
    return camera;
}

constexpr double kHeight = 0.2;

enum Effect { kShadow, kMirrorImage };

// 2 x 0.2 x 2, somewhere on a rectangle of two triangles.
Scene slab_on_ground(double size, const Turn& turn, Effect effect, bool is_there) {
    Scene scene;
    const test::Body slab = test::box_body({1, kHeight / 2, 1});
    for (const Double3 v : slab.vertices)
        scene.mesh.vertices.emplace_back(turned(turn, v + Double3(0, kHeight / 2, 0)));
    for (int i = 0; i < 4; ++i)
        scene.mesh.vertices.emplace_back(
            turned(turn, Double3(i & 1 ? 1.7 * size : -size, 0, i & 2 ? 1.3 * size : -size)));
    scene.mesh.indices = slab.indices;
    scene.mesh.indices.insert(scene.mesh.indices.end(), {8, 10, 9, 9, 10, 11});
    scene.material_ids.assign(scene.mesh.triangle_count(), 0);
    scene.material_ids[12] = scene.material_ids[13] = 1;
    const float lit = effect == kShadow ? 1 : 0, mirrored = effect == kMirrorImage && is_there;
    rsh_material ground = test::matte({lit, lit, lit});
    ground.reflection = {{mirrored, mirrored, mirrored, 0}};
    scene.materials = {test::matte({1, 1, 1}), ground};
    scene.lights = {test::directional_light(Float3(turned(turn, {-1, -1, 0})), {1, 1, 1})};
    scene.lights[0].casts_shadow = effect == kShadow && is_there;
    scene.ambient = scene.environment = {0, 0, 0};
    return scene;
}

uint32_t side() {
    return test::small() ? 16 : 128;
}

double mean(const Sight& sight, double size, const Turn& turn, Effect effect,
            bool is_there = true) {
    const rsh_camera camera = camera_of(sight, turn);
    test::FrameOptions options;
    options.width = options.height = side();
    options.bounces = 2;
    options.camera = &camera;
    double sum = 0;
    const test::DeviceScene scene(slab_on_ground(size, turn, effect, is_there));
    const auto picture = test::frame(scene, options);
    for (const cl_float4& pixel : picture) sum += double(pixel.s[0]);
    return sum / double(picture.size());
}

TEST(Ground, CarriesTheShadowOfASlabWhateverItsSize) {
    for (double size = 10; size < 2e7; size *= 10)
        EXPECT_NEAR(mean(kFromAbove, size, test::no_turn(), kShadow),
                    test::small() ? 0.7 : 0.70020, test::small() ? 0.01 : 5e-6)
            << "ground of " << size;
}

// The plane of a ground that lies across the axes is where the rounding of its corners puts it: the
// slab stands up to an ulp of them too deep or too high, and its shadow and its image grow and
// shrink by that share. Seen flat, t errs by an ulp or more, too, and ground may be seen in front
// of the foot of the slab. From above, along the axes, nothing is rounded.
void expect_same_on_any_ground(const Sight& sight, Double3 axis, double degrees,
                               Effect effect) {
    const Turn turn = test::turn_about(normalize(axis), degrees);
    const double expected = mean(sight, 10, turn, effect);
    const double share = std::fabs(mean(sight, 10, turn, effect, false) - expected);
    EXPECT_GT(share, test::small() ? -1 : 0.005) << "nothing to lose";
    const double a_few_pixels = 3.0 / (side() * side());
    for (double size = 100; size < 2e6; size *= 10) {
        const double ulp = 0x1p-23 * std::exp2(std::floor(std::log2(1.7 * size)));
        const bool is_exact = degrees == 0 && sight.degrees == kFromAbove.degrees;
        const double allowed = is_exact ? 2e-6 : share * ulp / kHeight + a_few_pixels;
        EXPECT_NEAR(mean(sight, size, turn, effect), expected, allowed)
            << "ground of " << size << ", turned by " << degrees << " about " << axis.x << " "
            << axis.y << " " << axis.z << ", seen with " << sight.degrees << " degrees";
    }
}

TEST(Ground, CarriesShadowsHoweverItIsTurnedAndSeen) {
    for (const Sight& sight : {kFromAbove, kToTheSun}) {
        expect_same_on_any_ground(sight, {1, 0, 0}, 0, kShadow);
        for (const Double3 axis :
             {Double3(1, 0, 0), Double3(0, 1, 0), Double3(0, 0, 1), Double3(1, 2, -2)})
            expect_same_on_any_ground(sight, axis, 30, kShadow);
    }
}

TEST(Ground, MirrorsHoweverItIsTurned) {
    expect_same_on_any_ground(kFromTheSun, {1, 0, 0}, 0, kMirrorImage);
    for (const Double3 axis :
         {Double3(1, 0, 0), Double3(0, 1, 0), Double3(0, 0, 1), Double3(1, 2, -2)})
        expect_same_on_any_ground(kFromTheSun, axis, 30, kMirrorImage);
}

}  // namespace
