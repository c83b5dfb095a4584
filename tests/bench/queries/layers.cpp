#include "queries/layers.hpp"

namespace bench::queries {
namespace {

using test::Float3;

constexpr uint32_t kLayers = 4;

Float3 bumpy(Float3 v, uint32_t layer) {
    const float phase = float(layer);
    const float bump =
        std::sin(9 * v.x + phase) + std::sin(11 * v.y) + std::sin(8 * v.z - phase);
    return (float(1 + layer) + 0.05f * bump) * v;
}

}  // namespace

stability::Scene layers(uint32_t triangles, uint32_t side, bool is_coherent) {
    const auto rings = uint32_t(std::sqrt(double(triangles) / kLayers / 4));
    const test::Mesh once = test::sphere(2 * rings, rings);
    test::Mesh mesh;
    for (uint32_t layer = 0; layer < kLayers; ++layer) {
        const auto first = uint32_t(mesh.vertices.size());
        for (const Float3& v : once.vertices) mesh.vertices.push_back(bumpy(v, layer));
        for (const uint32_t index : once.indices) mesh.indices.push_back(first + index);
    }
    if (is_coherent)
        return {mesh, test::pinhole_rays(side, side, {0.1f, 0.05f, 0.2f}, {1, 0.3f, -1})};
    test::Random random(91);
    test::Rays rays{{}, side, side};
    for (uint32_t i = 0; i < side * side; ++i)
        rays.rays.push_back(test::make_ray(random.in_cube(0.3f), random.direction()));
    return {mesh, rays};
}

}  // namespace bench::queries
