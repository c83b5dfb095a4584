// bodies.cpp - the shapes and rays of bodies.hpp. Knows no device.
#include "support/bodies.hpp"

#include <cmath>
#include <cstdlib>

namespace test {
namespace {

double unit(Random& random) {
    return double(random.bits() >> 11) * 0x1p-53;
}

// 2^-`lowest` .. 1, all magnitudes alike.
double any_magnitude(Random& random, double lowest) {
    return std::exp2(-lowest * unit(random));
}

Double3 any_direction(Random& random) {
    return normalize(Double3(random.direction()));
}

// Outwards, of a triangle of a body around that centre.
Double3 normal_of(const Corners& c, Double3 centre) {
    const Double3 a(c[0]);
    const Double3 normal = normalize(cross(Double3(c[1]) - a, Double3(c[2]) - a));
    return dot(normal, a - centre) < 0 ? -1.0 * normal : normal;
}

// The way from the eye to a point.
Double3 approach(Random& random, const Corners& c, Double3 centre, bool from_inside) {
    const Double3 outwards = (from_inside ? -1.0 : 1.0) * normal_of(c, centre);
    Double3 d = any_direction(random);
    if (dot(d, outwards) > 0) d = -1.0 * d;
    if (random.below(4) > 0) return d;
    return d - (dot(d, outwards) * (1 - any_magnitude(random, 14))) * outwards;
}

}  // namespace

size_t ray_count(size_t usual) {
    const char* asked = std::getenv("RSH_TEST_RAYS");
    if (asked) return std::strtoull(asked, nullptr, 10);
    return small() ? usual / 1000 : usual;
}

Body box_body(Double3 half) {
    Body body;
    for (int i = 0; i < 8; ++i)
        body.vertices.push_back(
            {i & 1 ? half.x : -half.x, i & 2 ? half.y : -half.y, i & 4 ? half.z : -half.z});
    body.indices = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                    2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
    return body;
}

Body frustum(double top) {
    Body body = box_body({1, 1, 1});
    for (Double3& v : body.vertices)
        if (v.y > 0) v = {top * v.x, v.y, top * v.z};
    return body;
}

Body sphere_body(uint32_t segments, uint32_t rings) {
    const Mesh mesh = sphere(segments, rings);
    return {std::vector<Double3>(mesh.vertices.begin(), mesh.vertices.end()), mesh.indices};
}

Body wedge(double degrees) {
    const double half = degrees * 3.14159265358979323846 / 360;
    Body body;
    body.vertices = {{0, 0, -0.5},
                     {0, 0, 0.5},
                     {std::cos(half), std::sin(half), 0},
                     {std::cos(half), -std::sin(half), 0}};
    body.indices = {0, 1, 2, 0, 3, 1, 0, 2, 3, 1, 3, 2};
    return body;
}

Body dart(double degrees) {
    const double half = degrees * 3.14159265358979323846 / 360;
    const double x = 0.25 + 0.75 * std::cos(half), y = 0.75 * std::sin(half);
    const Double3 around[] = {{-1, 0, 0}, {x, -y, 0}, {0.25, 0, 0}, {x, y, 0}};
    Body body;
    for (const double z : {-0.5, 0.5})
        for (const Double3 p : around) body.vertices.push_back({p.x, p.y, z});
    body.indices = {0, 2, 1, 0, 3, 2, 4, 5, 6, 4, 6, 7};
    for (uint32_t i = 0; i < 4; ++i) {
        const uint32_t next = (i + 1) % 4;
        for (const uint32_t corner : {i, next, next + 4, i, next + 4, i + 4})
            body.indices.push_back(corner);
    }
    return body;
}

Turn no_turn() {
    return {Double3{1, 0, 0}, Double3{0, 1, 0}, Double3{0, 0, 1}};
}

Turn random_turn(Random& random) {
    const Double3 x = any_direction(random);
    const Double3 y = normalize(cross(x, any_direction(random)));
    return {x, y, cross(x, y)};
}

Turn turn_about(Double3 k, double degrees) {
    const double angle = degrees * 3.14159265358979323846 / 180;
    const double c = std::cos(angle), s = std::sin(angle);
    const auto image = [&](Double3 v) {
        return c * v + s * cross(k, v) + ((1 - c) * dot(k, v)) * k;
    };
    return {image({1, 0, 0}), image({0, 1, 0}), image({0, 0, 1})};
}

Double3 turned(const Turn& turn, Double3 v) {
    return v.x * turn[0] + v.y * turn[1] + v.z * turn[2];
}

Mesh placed(const Body& body, const Placement& at) {
    Mesh mesh;
    for (const Double3 v : body.vertices)
        mesh.vertices.emplace_back(at.scale * (turned(at.turn, v) + at.offset));
    mesh.indices = body.indices;
    return mesh;
}

Double3 hard_point(Random& random, const Corners& corners) {
    const Double3 a(corners[0]), b(corners[1]), c(corners[2]);
    double u = unit(random), v = unit(random) * (1 - u);
    switch (random.below(4)) {
        case 0:
            break;
        case 1:
            v = any_magnitude(random, 27) * (1 - u);
            break;
        case 2:
            u = any_magnitude(random, 27), v = any_magnitude(random, 27) * (1 - u);
            break;
        default:
            v = 0;
            u = random.chance(0.2f) ? 0 : u;
            break;
    }
    const uint32_t first = random.below(3);
    const Double3 p[3] = {first == 0   ? a
                          : first == 1 ? b
                                       : c,
                          first == 0   ? b
                          : first == 1 ? c
                                       : a,
                          first == 0   ? c
                          : first == 1 ? a
                                       : b};
    return p[0] + u * (p[1] - p[0]) + v * (p[2] - p[0]);
}

Rays rays_at_body(Random& random, const Mesh& mesh, const Placement& at, uint32_t count) {
    Rays rays{{}, count, 1};
    const Double3 centre = centre_of(at);
    for (uint32_t i = 0; i < count; ++i) {
        Corners c;
        mesh.corners(random.below(mesh.triangle_count()), &c);
        const Double3 point = hard_point(random, c);
        const bool from_inside = random.chance(0.5f);
        Double3 eye = point - (at.scale * 8 * any_magnitude(random, 12)) *
                                  approach(random, c, centre, from_inside);
        if (from_inside && random.chance(0.7f)) {
            const Double3 other(mesh.vertices[random.below(uint32_t(mesh.vertices.size()))]);
            eye = centre + unit(random) * (other - centre);
        }
        const double length = any_magnitude(random, 8);
        rays.rays.push_back(make_ray(Float3(eye), Float3(length * (point - eye))));
    }
    return rays;
}

}  // namespace test
