// rays.cpp - the generators of rays.hpp. Knows no device.
#include "support/rays.hpp"

#include <limits>

namespace test {
namespace {

template <class Make>
Rays fill(uint32_t width, uint32_t height, Make make) {
    Rays made;
    made.width = width;
    made.height = height;
    made.rays.reserve(size_t(width) * height);
    for (uint32_t y = 0; y < height; ++y)
        for (uint32_t x = 0; x < width; ++x) made.rays.push_back(make(x, y));
    return made;
}

// -1 .. 1 over the pixels' centres.
float centred(uint32_t i, uint32_t count) {
    return 2 * (float(i) + 0.5f) / float(count) - 1;
}

rsh_ray invalid_ray(Random& random) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinity = std::numeric_limits<float>::infinity();
    const float bad[] = {nan, infinity, -infinity};
    rsh_ray ray = make_ray(random.in_cube(2), random.direction());
    switch (random.below(8)) {
        case 0:
            ray.origin_tmin.s[random.below(3)] = bad[random.below(3)];
            break;
        case 1:
            ray.direction_tmax.s[random.below(3)] = bad[random.below(3)];
            break;
        case 2:
            ray = make_ray(random.in_cube(), {0.0f, -0.0f, 0.0f});
            break;
        case 3:
            ray.origin_tmin.s[3] = nan;
            break;
        case 4:
            ray.direction_tmax.s[3] = nan;
            break;
        case 5:
            ray.origin_tmin.s[3] = 2, ray.direction_tmax.s[3] = 1;
            break;
        case 6:
            ray.direction_tmax.s[3] = -infinity;
            break;
        default:
            ray = inactive_ray();
            break;
    }
    return ray;
}

Float3 corner_of(Random& random, const Mesh& mesh, Corners* corners) {
    do {
    } while (!mesh.corners(random.below(mesh.triangle_count()), corners));
    return (*corners)[random.below(3)];
}

}  // namespace

rsh_ray make_ray(Float3 o, Float3 d, float tmin, float tmax) {
    rsh_ray ray;
    ray.origin_tmin = {{o.x, o.y, o.z, tmin}};
    ray.direction_tmax = {{d.x, d.y, d.z, tmax}};
    return ray;
}

bool is_active(const rsh_ray& r) {
    const Float3 d = direction(r);
    const float tmin = r.origin_tmin.s[3], tmax = r.direction_tmax.s[3];
    return finite(origin(r)) && finite(d) && (d.x != 0 || d.y != 0 || d.z != 0) && tmin <= tmax;
}

rsh_ray inactive_ray() {
    return make_ray({}, {1, 0, 0}, 1.0f, -1.0f);
}

Rays pinhole_rays(uint32_t width, uint32_t height, Float3 eye, Float3 at, float half) {
    const Float3 forward = at - eye;
    const Float3 right = half * normalize(cross(forward, Float3(0, 1, 0.01f)));
    const Float3 up = half * normalize(cross(right, forward));
    return fill(width, height, [&](uint32_t x, uint32_t y) {
        return make_ray(eye, forward + centred(x, width) * right - centred(y, height) * up);
    });
}

Rays random_rays(Random& random, uint32_t width, uint32_t height, float half) {
    return fill(width, height, [&](uint32_t, uint32_t) {
        const float tmin = random.chance(0.2f) ? random.between(0, 1) : 0.0f;
        const float tmax =
            random.chance(0.2f) ? random.between(0, 6) : std::numeric_limits<float>::infinity();
        return make_ray(random.in_cube(half), random.direction(), tmin, tmax);
    });
}

Rays reflected_rays(Random& random, uint32_t width, uint32_t height) {
    const float phase = random.between(0, 6);
    return fill(width, height, [&](uint32_t x, uint32_t y) {
        const float u = 1.3f * centred(x, width), v = 1.3f * centred(y, height);
        const float rest = 1 - u * u - v * v;
        if (rest <= 0) return inactive_ray();
        const Float3 bump = 0.05f * Float3(std::sin(9 * u + phase), std::sin(11 * v), 0);
        const Float3 n = normalize(Float3(u, v, std::sqrt(rest)) + bump);
        const Float3 in = normalize(Float3(u, v, std::sqrt(rest)) - Float3(0, 0, 4));
        return make_ray(0.5f * Float3(u, v, std::sqrt(rest)), in - (2 * dot(in, n)) * n, 1e-4f);
    });
}

Rays axis_rays(Random& random, uint32_t width, uint32_t height) {
    return fill(width, height, [&](uint32_t, uint32_t) {
        const float zero[] = {0.0f, -0.0f};
        float d[3] = {zero[random.below(2)], zero[random.below(2)], zero[random.below(2)]};
        const uint32_t axis = random.chance(0.6f) ? 2 : random.below(3);
        d[axis] = random.chance(0.5f) ? 1.0f : -1.0f;
        if (random.chance(0.2f)) d[(axis + 1) % 3] = d[axis];
        const auto step = [&] { return float(random.below(33)) / 16 - 1; };
        return make_ray(Float3(step(), step(), step()) - Float3(2 * d[0], 2 * d[1], 2 * d[2]),
                        {d[0], d[1], d[2]});
    });
}

Rays antiparallel_rays(Random& random, uint32_t width, uint32_t height) {
    const Float3 d = random.direction();
    return fill(width, height, [&](uint32_t x, uint32_t y) {
        const Float3 at = y % 2 ? Float3() : random.in_cube();
        return make_ray(at, x % 2 ? d : -1.0f * d);
    });
}

Rays coincident_rays(uint32_t width, uint32_t height) {
    return fill(width, height, [](uint32_t, uint32_t) {
        return make_ray({0.1f, 0.2f, 3.0f}, {-0.03f, -0.06f, -1.0f});
    });
}

Rays fan_rays(uint32_t width, uint32_t height, float degrees) {
    const float half = degrees * 3.14159265f / 360;
    return fill(width, height, [&](uint32_t x, uint32_t y) {
        const float a = half * centred(x, width), b = 0.5f * half * centred(y, height);
        return make_ray({0.05f, 0, 0},
                        {std::sin(a) * std::cos(b), std::sin(b), std::cos(a) * std::cos(b)});
    });
}

Rays converging_rays(Random& random, uint32_t width, uint32_t height, Float3 light) {
    Rays rays = random_rays(random, width, height);
    for (size_t i = 0; i < rays.rays.size(); ++i) {
        const float tmax = i % 7 == 0 ? 0.4f : i % 97 == 0 ? 3.0f : 1 - 0x1p-16f;
        rays.rays[i] = make_ray(origin(rays.rays[i]), light - origin(rays.rays[i]), 0, tmax);
    }
    return rays;
}

Rays long_rays(uint32_t width, uint32_t height) {
    Rays rays{{}, width, height};
    for (uint32_t i = 0; i < width * height; ++i)
        rays.rays.push_back(make_ray({0, 0, 0}, {0, 0, i % 2 ? 1e38f : -1e38f}));
    return rays;
}

Rays rays_from_afar(Random& random, const Mesh& mesh, uint32_t count, float distance) {
    Rays rays;
    rays.width = count;
    for (uint32_t i = 0; i < count; ++i) {
        Corners corners;
        mesh.corners(random.below(mesh.triangle_count()), &corners);
        const Float3 to = corners[random.below(3)], from = to + distance * random.direction();
        rays.rays.push_back(make_ray(from, to - from));
    }
    return rays;
}

Rays far_apart_rays(uint32_t count) {
    Rays rays{{}, count, 1};
    for (uint32_t i = 0; i < count; ++i) {
        const Float3 from = i < 2    ? Float3(i ? -3e38f : 3e38f, i ? -3e38f : 3e38f, 0)
                            : i < 16 ? Float3(100, 0, 0)
                                     : Float3(0, 0, 0);
        rays.rays.push_back(make_ray(from, {0, 0, 1}));
    }
    return rays;
}

Rays invalid_rays(Random& random, uint32_t width, uint32_t height) {
    return fill(width, height, [&](uint32_t, uint32_t) {
        if (random.chance(0.5f)) return invalid_ray(random);
        rsh_ray ray = make_ray(random.in_cube(2), random.direction());
        switch (random.below(5)) {
            case 0:
                ray.direction_tmax.s[random.below(3)] = 1e-42f;
                break;
            case 1:
                ray.origin_tmin.s[random.below(3)] = -1e-42f;
                break;
            case 2:
                ray.origin_tmin.s[3] = ray.direction_tmax.s[3] = 1;
                break;
            case 3:
                ray.origin_tmin.s[3] = -3;
                break;
            default:
                break;
        }
        return ray;
    });
}

Rays grazing_rays(Random& random, const Mesh& mesh, uint32_t width, uint32_t height) {
    return fill(width, height, [&](uint32_t, uint32_t) {
        Corners c;
        corner_of(random, mesh, &c);
        const Float3 in_plane = random.unit() * (c[1] - c[0]) + random.unit() * (c[2] - c[0]);
        const Float3 off = random.chance(0.3f) ? Float3() : random.in_cube(1e-4f);
        return make_ray(c[0] - 2.0f * in_plane + off, in_plane + random.in_cube(1e-5f));
    });
}

Float3 point_on_edge(Random& random, const Mesh& mesh) {
    Corners c;
    const Float3 corner = corner_of(random, mesh, &c);
    const float along = random.chance(0.3f) ? 0.5f : random.unit();
    return random.chance(0.5f) ? corner : c[0] + along * (c[1] - c[0]);
}

Rays rays_at_edges(Random& random, const Mesh& mesh, uint32_t width, uint32_t height) {
    return fill(width, height, [&](uint32_t, uint32_t) {
        const Float3 at = point_on_edge(random, mesh);
        const Float3 eye = 4.0f * normalize(random.direction());
        return make_ray(eye, random.chance(0.5f) ? at - eye : 0.3f * (at - eye));
    });
}

Rays leaving_rays(Random& random, const Mesh& mesh, uint32_t width, uint32_t height) {
    std::vector<uint32_t> skip;
    Rays rays = fill(width, height, [&](uint32_t, uint32_t) {
        const uint32_t triangle = random.below(mesh.triangle_count());
        Corners c;
        if (!mesh.corners(triangle, &c)) c = {};
        float u = random.unit(), v = random.unit();
        if (random.chance(0.7f)) u *= random.chance(0.5f) ? 0.0f : 0x1p-22f;
        if (u + v > 1) v = 1 - u;
        const Float3 p = c[0] + u * (c[1] - c[0]) + v * (c[2] - c[0]);
        const float ulp = 0x1p-23f * max_norm(p);
        skip.push_back(random.chance(0.9f)   ? triangle
                       : random.chance(0.5f) ? RSH_NO_HIT
                                             : random.below(2 * mesh.triangle_count()));
        return make_ray(p + random.in_cube(2 * ulp), random.direction());
    });
    rays.skip = std::move(skip);
    return rays;
}

Rays scaled(Rays rays, float scale, Float3 offset) {
    for (rsh_ray& ray : rays.rays) {
        const Float3 o = scale * origin(ray) + offset;
        ray =
            make_ray(o, scale * direction(ray), ray.origin_tmin.s[3], ray.direction_tmax.s[3]);
    }
    return rays;
}

}  // namespace test
