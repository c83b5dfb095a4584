// layers.cpp - the definitions of shading (rsh_types.h, rsh_material), in double.
#include "device/layers.hpp"

#include <algorithm>
#include <cmath>

#include "device/tests_per_ray.hpp"

namespace render {
namespace {

struct PrimaryHits {
    std::vector<rsh_ray> rays;
    std::vector<rsh_hit> hits;
    std::vector<uint32_t> tests;
};

class Rasterizer {
public:
    Rasterizer(const rsh::Device& device, const rsh_frame_desc& picture)
        : device_(device),
          picture_(picture),
          rays_(device.buffer(sizeof(rsh_ray) * picture.width * kLayerRows)),
          hits_(device.buffer(sizeof(rsh_hit) * picture.width * kLayerRows)),
          tests_per_ray_(device, picture, kLayerRows) {}

    void find(uint32_t first_row, uint32_t rows, PrimaryHits& found) const {
        auto desc = rsh::make<rsh_rasterize_desc>();
        desc.geometry = picture_.scene->geometry;
        desc.camera = picture_.camera;
        desc.width = picture_.width;
        desc.height = rows;
        desc.rays = rays_.get();
        desc.hits = hits_.get();
        desc.window = {0, first_row, picture_.width, picture_.height};
        device_.run(rsh_rasterize, desc);
        const size_t pixels = size_t{picture_.width} * rows;
        found.rays = device_.download<rsh_ray>(rays_.get(), pixels);
        found.hits = device_.download<rsh_hit>(hits_.get(), pixels);
        found.tests = tests_per_ray_.count(rays_, rows);
    }

private:
    const rsh::Device& device_;
    const rsh_frame_desc& picture_;
    rsh::Buffer rays_, hits_;
    TestsPerRay tests_per_ray_;
};

// Turned to the side that the ray comes from.
glm::dvec3 shading_normal(const Mesh& mesh, const glm::uvec3& corners, glm::dvec3 geometric,
                          glm::dvec3 weights) {
    if (mesh.normals.empty()) return geometric;
    glm::dvec3 sum(0.0);
    for (int i = 0; i < 3; ++i) sum += weights[i] * glm::dvec3(mesh.normals[corners[i]]);
    const double length = glm::length(sum);
    if (!(length > 0.0 && std::isfinite(length))) return geometric;
    return (glm::dot(sum, geometric) < 0.0 ? -sum : sum) / length;
}

LayerPixel pixel_of(const World& world, const rsh_ray& ray, const rsh_hit& hit) {
    LayerPixel pixel;
    if (hit.primitive == RSH_NO_HIT) return pixel;
    const Mesh& mesh = world.mesh();
    const glm::uvec3 corners = mesh.triangles.at(hit.primitive);
    const glm::dvec3 v0 = mesh.positions[corners[0]], v1 = mesh.positions[corners[1]],
                     v2 = mesh.positions[corners[2]];
    const glm::dvec3 weights(1.0 - hit.u - hit.v, hit.u, hit.v);
    const auto& d = ray.direction_tmax.s;
    glm::dvec3 geometric = glm::normalize(glm::cross(v1 - v0, v2 - v0));
    if (glm::dot(geometric, glm::dvec3(d[0], d[1], d[2])) > 0.0) geometric = -geometric;
    pixel.depth = hit.t;
    pixel.normal = shading_normal(mesh, corners, geometric, weights);
    pixel.position = v0 + weights[1] * (v1 - v0) + weights[2] * (v2 - v0);
    pixel.primitive = world.triangle_number(hit.primitive);
    pixel.material = mesh.material_ids[hit.primitive];
    return pixel;
}

}  // namespace

void render_layers(const rsh::Device& device, const World& world, const rsh_frame_desc& picture,
                   const TakeLayers& take) {
    const Rasterizer rasterizer(device, picture);
    PrimaryHits found;
    LayerStrip strip;
    for (uint32_t row = 0; row < picture.height; row += kLayerRows) {
        strip.first_row = row;
        strip.rows = std::min(kLayerRows, picture.height - row);
        rasterizer.find(row, strip.rows, found);
        strip.pixels.resize(found.hits.size());
        for (size_t i = 0; i < found.hits.size(); ++i) {
            strip.pixels[i] = pixel_of(world, found.rays[i], found.hits[i]);
            strip.pixels[i].tests = found.tests[i];
        }
        take(strip);
    }
}

}  // namespace render
