#include "oracle/frame/reference_frame.hpp"

#include "oracle/on_all_cores.hpp"

namespace oracle {
namespace {

using test::Double3;

Double3 xyz(const rsh_float4& v) {
    return {v.s[0], v.s[1], v.s[2]};
}

Ray leaving(const Double3& point, const Double3& direction, uint32_t triangle, double reach) {
    Ray ray(point, direction);
    ray.tmin = std::ldexp(reach, -36) / length(direction);
    ray.skip = triangle;
    return ray;
}

}  // namespace

Ray camera_ray(const View& view, double x, double y) {
    const rsh_camera& c = view.camera;
    const Double3 way = xyz(c.forward) + (x / view.width * 2 - 1) * xyz(c.right) +
                        (1 - y / view.height * 2) * xyz(c.up);
    Ray ray(xyz(c.eye), normalize(way));
    ray.tmin = c.eye.s[3];
    if (c.forward.s[3] != 0) ray.tmax = c.forward.s[3];
    return ray;
}

// How a ray came to be, and where what it does not see is counted.
struct ReferenceFrame::Path {
    const PathLimits& limits;
    double& cut_weight;
    Double3 weight{1, 1, 1};
    uint32_t bounce = 0;
};

std::vector<ReferencePixel> ReferenceFrame::render(const View& view,
                                                   const PathLimits& limits) const {
    std::vector<ReferencePixel> pixels(size_t(view.width) * view.height);
    const double samples = double(limits.side) * limits.side;
    const auto render_pixel = [&](ReferencePixel& pixel, uint32_t x, uint32_t y) {
        for (uint32_t i = 0; i < limits.side * limits.side; ++i) {
            const double dx = (i % limits.side + 0.5) / limits.side;
            const double dy = (i / limits.side + 0.5) / limits.side;
            pixel.colour = pixel.colour + seen_by(camera_ray(view, x + dx, y + dy),
                                                  {limits, pixel.cut_weight});
        }
        pixel.colour = (1 / samples) * pixel.colour;
        pixel.cut_weight /= samples;
    };
    on_all_cores(view.height, [&](size_t y) {
        for (uint32_t x = 0; x < view.width; ++x)
            render_pixel(pixels[y * view.width + x], x, uint32_t(y));
    });
    return pixels;
}

std::vector<Hit> ReferenceFrame::first_hits(const View& view) const {
    std::vector<Hit> hits(size_t(view.width) * view.height);
    on_all_cores(view.height, [&](size_t y) {
        for (uint32_t x = 0; x < view.width; ++x)
            hits[y * view.width + x] = bvh_.closest(camera_ray(view, x + 0.5, double(y) + 0.5));
    });
    return hits;
}

Double3 ReferenceFrame::seen_by(const Ray& ray, Path path) const {
    const Hit hit = bvh_.closest(ray);
    if (hit.primitive == RSH_NO_HIT) return environment_at(scene_, ray.direction);
    const Surface surface = surface_at(scene_, ray, hit);
    return sent_by(scene_, surface, ray.direction, hidden_lights(surface, hit.primitive)) +
           seen_by(reflected(surface, ray), surface, hit.primitive, path) +
           seen_by(refracted(surface, ray), surface, hit.primitive, path);
}

Double3 ReferenceFrame::seen_by(const Secondary& secondary, const Surface& from,
                                uint32_t triangle, Path path) const {
    if (!secondary.exists) return {};
    path.weight = path.weight * secondary.weight;
    const double weight = max_norm(path.weight);
    if (path.bounce == path.limits.bounces || weight <= path.limits.min_weight) {
        path.cut_weight += weight;
        return secondary.weight * cut(secondary.direction);
    }
    ++path.bounce;
    const Ray ray = leaving(from.point, secondary.direction, triangle, bvh_.reach());
    return secondary.weight * seen_by(ray, path);
}

Double3 ReferenceFrame::cut(Double3 direction) const {
    if (scene_.cut == RSH_CUT_AMBIENT) return Double3(scene_.ambient);
    return scene_.cut == RSH_CUT_ENVIRONMENT ? environment_at(scene_, direction) : Double3();
}

uint32_t ReferenceFrame::hidden_lights(const Surface& surface, uint32_t triangle) const {
    uint32_t hidden = 0;
    for (uint32_t k = 0; k < scene_.lights.size(); ++k) {
        const rsh_light& light = scene_.lights[k];
        if (!light.casts_shadow || !reaches(light, surface)) continue;
        double distance;
        Double3 way = towards_light(light, surface.point, &distance);
        const bool is_far = std::isinf(distance);
        if (!is_far) way = distance * way;
        Ray ray = leaving(surface.point, way, triangle, bvh_.reach());
        if (!is_far) ray.tmax = 1 - std::ldexp(1.0, -16);
        hidden |= uint32_t(bvh_.is_hit(ray)) << k;
    }
    return hidden;
}

}  // namespace oracle
