// whitted.cpp - the sums of rsh_types.h, one function each.
#include "oracle/whitted.hpp"

#include <algorithm>
#include <cstring>
#include <limits>

namespace oracle {
namespace {

using test::Double3;
using test::Scene;

constexpr double kPi = 3.14159265358979323846;

Double3 rgb(const rsh_float4& v) {
    return {v.s[0], v.s[1], v.s[2]};
}

double decode_srgb(double encoded) {
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

int64_t wrapped(const rsh_texture& t, int64_t i, int64_t size) {
    return t.wrap == RSH_WRAP_CLAMP ? std::clamp<int64_t>(i, 0, size - 1)
                                    : ((i % size) + size) % size;
}

Double3 texel(const Scene& scene, const rsh_texture& t, int64_t x, int64_t y) {
    const int64_t column = wrapped(t, x, t.width);
    const int64_t row = wrapped(t, y, t.height);
    const uint64_t index = uint64_t(row) * t.width + uint64_t(column);
    if (t.format == RSH_TEXEL_SRGB8) {
        uint8_t c[4];
        std::memcpy(c, &scene.texels[t.first_word + index], 4);
        return {decode_srgb(c[0] / 255.0), decode_srgb(c[1] / 255.0),
                decode_srgb(c[2] / 255.0)};
    }
    float c[4];
    std::memcpy(c, &scene.texels[t.first_word + 4 * index], 16);
    return {c[0], c[1], c[2]};
}

template <class T>
test::Double3 mix(const Hit& hit, T a, T b, T c) {
    return (1 - hit.u - hit.v) * Double3(a) + hit.u * Double3(b) + hit.v * Double3(c);
}

void corner_indices(const Scene& scene, uint32_t triangle, uint32_t (&index)[3]) {
    for (uint32_t k = 0; k < 3; ++k)
        index[k] = scene.mesh.indices.empty() ? 3 * triangle + k
                                              : scene.mesh.indices[3 * triangle + k];
}

Double3 arriving(const rsh_light& light, Double3 to_light, double distance) {
    const Double3 colour = rgb(light.colour);
    if (light.kind == RSH_LIGHT_DIRECTIONAL) return colour;
    const auto* k = light.attenuation.s;
    double scale = 1;
    if (k[0] != 0 || k[1] != 0 || k[2] != 0)
        scale /= k[0] + k[1] * distance + k[2] * distance * distance;
    if (light.kind == RSH_LIGHT_SPOT) {
        const double cosine = -dot(rgb(light.direction), to_light);
        const double x = std::clamp(
            (cosine - light.cos_outer) / (double(light.cos_inner) - light.cos_outer), 0.0, 1.0);
        scale *= x * x * (3 - 2 * x);
    }
    return scale * colour;
}

Double3 lit_by(const rsh_light& light, const Surface& s, Double3 to_eye) {
    double distance;
    const Double3 l = towards_light(light, s.point, &distance);
    const double cosine = dot(s.normal, l);
    if (cosine <= 0 || dot(s.geometric, l) <= 0) return {};
    const Double3 half = normalize(l + to_eye);
    const double highlight =
        std::pow(std::max(0.0, dot(s.normal, half)), double(s.material.specular.s[3]));
    return arriving(light, l, distance) *
           (cosine * s.diffuse + highlight * rgb(s.material.specular));
}

// Of an unpolarized dielectric; eta: index in front over index behind. 1: total reflection.
double fresnel(double cos_in, double eta) {
    const double sin2 = eta * eta * (1 - cos_in * cos_in);
    if (sin2 >= 1) return 1;
    const double cos_out = std::sqrt(1 - sin2);
    const double parallel = (cos_in - eta * cos_out) / (cos_in + eta * cos_out);
    const double across = (eta * cos_in - cos_out) / (eta * cos_in + cos_out);
    return 0.5 * (parallel * parallel + across * across);
}

double eta_of(const Surface& s) {
    const double index = s.material.transmission.s[3];
    return s.from_inside ? index : 1 / index;
}

// An interpolated normal may send a direction to the wrong side; the plane mirrors it back.
Double3 kept_on_side(Double3 d, Double3 side) {
    const double height = dot(d, side);
    return height < 0 ? d - (2 * height) * side : d;
}

bool transmits(const rsh_material& m) {
    return test::max_norm(rgb(m.transmission)) > 0;
}

}  // namespace

Double3 texture_at(const Scene& scene, uint32_t texture, double u, double v) {
    const rsh_texture& t = scene.textures[texture];
    const double x = u * t.width - 0.5, y = (1 - v) * t.height - 0.5;
    const double left = std::floor(x), top = std::floor(y);
    const double fx = x - left, fy = y - top;
    const int64_t i = int64_t(left), j = int64_t(top);
    return (1 - fy) * ((1 - fx) * texel(scene, t, i, j) + fx * texel(scene, t, i + 1, j)) +
           fy * ((1 - fx) * texel(scene, t, i, j + 1) + fx * texel(scene, t, i + 1, j + 1));
}

Surface surface_at(const Scene& scene, const Ray& ray, const Hit& hit) {
    uint32_t i[3];
    corner_indices(scene, hit.primitive, i);
    const auto& p = scene.mesh.vertices;
    const Double3 d = ray.direction;
    Surface s;
    s.point = mix(hit, p[i[0]], p[i[1]], p[i[2]]);
    const Double3 a(p[i[0]]);
    s.geometric = normalize(cross(Double3(p[i[1]]) - a, Double3(p[i[2]]) - a));
    s.from_inside = dot(s.geometric, d) > 0;
    if (s.from_inside) s.geometric = -1.0 * s.geometric;
    s.normal = s.geometric;
    if (!scene.normals.empty()) {
        const auto& n = scene.normals;
        const Double3 smooth = mix(hit, n[i[0]], n[i[1]], n[i[2]]);
        if (max_norm(smooth) > 0) s.normal = normalize(smooth);
        if (dot(s.normal, s.geometric) < 0) s.normal = -1.0 * s.normal;
    }
    const uint32_t id = scene.material_ids.empty() ? 0 : scene.material_ids[hit.primitive];
    s.material = scene.materials[id < scene.materials.size() ? id : 0];
    s.diffuse = rgb(s.material.diffuse);
    s.ambient = rgb(s.material.ambient);
    if (s.material.texture != RSH_NO_TEXTURE && !scene.texcoords.empty()) {
        const auto at = [&](int k, int c) { return double(scene.texcoords[i[k]][size_t(c)]); };
        const auto mixed = [&](int c) {
            return (1 - hit.u - hit.v) * at(0, c) + hit.u * at(1, c) + hit.v * at(2, c);
        };
        const Double3 texel = texture_at(scene, s.material.texture, mixed(0), mixed(1));
        s.diffuse = s.diffuse * texel;
        s.ambient = s.ambient * texel;
    }
    return s;
}

Double3 sent_by(const Scene& scene, const Surface& s, Double3 direction, uint32_t hidden) {
    Double3 sum = rgb(s.material.emission) + s.ambient * Double3(scene.ambient);
    for (size_t k = 0; k < scene.lights.size(); ++k)
        if (!(hidden >> k & 1))
            sum = sum + lit_by(scene.lights[k], s, -1.0 * normalize(direction));
    return sum;
}

// Repeats in u only: above the topmost texel's centre there is that row again.
Double3 environment_at(const Scene& scene, Double3 d) {
    const Double3 plain(scene.environment);
    if (scene.environment_texture == 0) return plain;
    const uint32_t texture = scene.environment_texture - 1;
    const double half_row = 0.5 / scene.textures[texture].height;
    const Double3 n = normalize(d);
    const double u = 0.5 + std::atan2(n.x, -n.z) / (2 * kPi);
    const double v = 0.5 + std::asin(std::clamp(n.y, -1.0, 1.0)) / kPi;
    return plain * texture_at(scene, texture, u, std::clamp(v, half_row, 1 - half_row));
}

Double3 radiance(const Scene& scene, const Ray& ray, const Hit& hit, uint32_t hidden) {
    if (hit.primitive == RSH_NO_HIT) return environment_at(scene, ray.direction);
    return sent_by(scene, surface_at(scene, ray, hit), ray.direction, hidden);
}

Double3 towards_light(const rsh_light& light, Double3 point, double* distance) {
    *distance = std::numeric_limits<double>::infinity();
    if (light.kind == RSH_LIGHT_DIRECTIONAL) return -1.0 * normalize(rgb(light.direction));
    const Double3 way = rgb(light.position) - point;
    *distance = length(way);
    return normalize(way);
}

bool reaches(const rsh_light& light, const Surface& s) {
    double distance;
    const Double3 l = towards_light(light, s.point, &distance);
    return dot(l, s.normal) > 0 && dot(l, s.geometric) > 0 &&
           max_norm(arriving(light, l, distance)) > 0;
}

Secondary reflected(const Surface& s, const Ray& ray) {
    const Double3 d = normalize(ray.direction);
    const double cosine = -dot(d, s.normal);
    Secondary made;
    made.direction = kept_on_side(normalize(d + (2 * cosine) * s.normal), s.geometric);
    made.weight = rgb(s.material.reflection);
    if (transmits(s.material)) {
        const double f = fresnel(std::fabs(cosine), eta_of(s));
        made.weight = Double3(f, f, f) + (1 - f) * made.weight;
    }
    made.exists = max_norm(made.weight) > 0;
    return made;
}

Secondary refracted(const Surface& s, const Ray& ray) {
    Secondary made;
    if (!transmits(s.material)) return made;
    const Double3 d = normalize(ray.direction);
    const double eta = eta_of(s), cosine = -dot(d, s.normal);
    const double f = fresnel(std::fabs(cosine), eta);
    made.exists = f < 1;
    if (!made.exists) return made;
    const double cos_out = std::sqrt(1 - eta * eta * (1 - cosine * cosine));
    made.direction = kept_on_side(normalize(eta * d + (eta * cosine - cos_out) * s.normal),
                                  -1.0 * s.geometric);
    made.weight = (1 - f) * rgb(s.material.transmission);
    return made;
}

}  // namespace oracle
