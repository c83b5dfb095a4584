// cases.cpp - the table of cases; sizes shrink on an emulator.
#include "support/cases.hpp"

namespace test {
namespace {

uint32_t size(uint32_t full) {
    return small() ? std::max(3u, full / 8) : full;
}
uint32_t tris(uint32_t full) {
    return small() ? std::max(8u, full / 16) : full;
}

Case soup(Random& random, Rays rays) {
    return {random_soup(random, tris(800)), std::move(rays)};
}

Case at_scale(Random& random, float scale) {
    const Mesh mesh = random_soup(random, tris(400));
    return {scaled(mesh, scale), scaled(reflected_rays(random, size(48), size(32)), scale)};
}

void add_ordinary(std::vector<NamedCase>& cases) {
    cases.push_back(
        {"Pinhole", [](Random& r) { return soup(r, pinhole_rays(size(64), size(48))); }, true});
    cases.push_back({"Random",
                     [](Random& r) { return soup(r, random_rays(r, size(40), size(40))); },
                     true});
    cases.push_back(
        {"RandomList", [](Random& r) { return soup(r, random_rays(r, size(1009), 1)); }, true});
    cases.push_back({"Reflected",
                     [](Random& r) { return soup(r, reflected_rays(r, size(61), size(53))); },
                     true});
    cases.push_back(
        {"Fan90", [](Random& r) { return soup(r, fan_rays(size(64), size(16), 100)); }, true});
    cases.push_back(
        {"Fan180", [](Random& r) { return soup(r, fan_rays(size(64), size(16), 190)); }, true});
    cases.push_back(
        {"Fan360", [](Random& r) { return soup(r, fan_rays(size(64), size(16), 360)); }, true});
    cases.push_back(
        {"Antiparallel",
         [](Random& r) { return soup(r, antiparallel_rays(r, size(33), size(31))); }, true});
    cases.push_back({"Coincident",
                     [](Random& r) { return soup(r, coincident_rays(size(33), size(17))); },
                     true});
    cases.push_back({"Torus",
                     [](Random& r) {
                         return Case{torus(tris(32), 24), random_rays(r, size(48), size(48))};
                     },
                     true});
}

void add_adversarial(std::vector<NamedCase>& cases) {
    cases.push_back(
        {"Strewn", [](Random& r) {
             return Case{random_soup(r, tris(4000), 0.02f), pinhole_rays(size(64), size(48))};
         }});
    cases.push_back({"Axes", [](Random& r) {
                         return Case{grid(small() ? 4 : 16), axis_rays(r, size(64), size(40))};
                     }});
    cases.push_back({"AxesList", [](Random& r) {
                         return Case{grid(8), axis_rays(r, size(1000), 1)};
                     }});
    cases.push_back({"SphereEdges", [](Random& r) {
                         const Mesh mesh = sphere(small() ? 8 : 24, small() ? 5 : 15);
                         return Case{mesh, rays_at_edges(r, mesh, size(64), size(64))};
                     }});
    cases.push_back({"Grazing", [](Random& r) {
                         const Mesh mesh = random_soup(r, tris(200));
                         return Case{mesh, grazing_rays(r, mesh, size(40), size(40))};
                     }});
    cases.push_back(
        {"Degenerate", [](Random& r) {
             return Case{degenerate_soup(r, tris(400)), random_rays(r, size(40), size(40))};
         }});
    cases.push_back({"DegenerateEdges", [](Random& r) {
                         const Mesh mesh = degenerate_soup(r, tris(200));
                         return Case{mesh, rays_at_edges(r, mesh, size(40), size(24))};
                     }});
    cases.push_back({"InvalidRays",
                     [](Random& r) { return soup(r, invalid_rays(r, size(48), size(48))); }});
    cases.push_back(
        {"InvalidRaysList", [](Random& r) { return soup(r, invalid_rays(r, size(999), 1)); }});
    cases.push_back(
        {"LargeNextToTiny", [](Random& r) {
             return Case{large_next_to_tiny(r, tris(800)), pinhole_rays(size(48), size(48))};
         }});
    cases.push_back({"FarFromOrigin", [](Random& r) {
                         const Float3 far(10000, -20000, 5000);
                         return Case{scaled(random_soup(r, tris(400)), 1, far),
                                     scaled(reflected_rays(r, size(48), size(48)), 1, far)};
                     }});
    cases.push_back({"ScaleHuge", [](Random& r) { return at_scale(r, 1e18f); }});
    cases.push_back({"ScaleLarge", [](Random& r) { return at_scale(r, 1e9f); }});
    cases.push_back({"ScaleSmall", [](Random& r) { return at_scale(r, 1e-9f); }});
    cases.push_back({"ScaleTiny", [](Random& r) { return at_scale(r, 1e-18f); }});
    cases.push_back({"LongDirections", [](Random&) {
                         Mesh mesh;
                         mesh.add({-1e-12f, -1e-12f, -1e-8f}, {1e-12f, -1e-12f, -1e-8f},
                                  {0, 1e-12f, -1e-8f});
                         return Case{mesh, long_rays(8, 8)};
                     }});
    cases.push_back({"CornersFromAfar", [](Random& r) {
                         const Mesh mesh = square_triangles(r, tris(200));
                         return Case{mesh, rays_from_afar(r, mesh, size(40) * size(40), 4096)};
                     }});
    cases.push_back({"LeavingSphere", [](Random& r) {
                         const Mesh mesh = sphere(small() ? 8 : 24, small() ? 5 : 15);
                         return Case{mesh, leaving_rays(r, mesh, size(48), size(48))};
                     }});
    cases.push_back({"LeavingGrid", [](Random& r) {
                         const Mesh mesh = grid(small() ? 2 : 4);
                         return Case{mesh, leaving_rays(r, mesh, size(1009), 1)};
                     }});
    cases.push_back({"LeavingDegenerate", [](Random& r) {
                         const Mesh mesh = degenerate_soup(r, tris(400));
                         return Case{mesh, leaving_rays(r, mesh, size(40), size(40))};
                     }});
    cases.push_back({"LeavingFarFromOrigin", [](Random& r) {
                         const Mesh mesh = scaled(sphere(8, 5), 1, Float3(900, -2000, 50));
                         return Case{mesh, leaving_rays(r, mesh, size(40), size(40))};
                     }});
    cases.push_back({"FarApart", [](Random&) {
                         Mesh mesh;
                         mesh.add({99, -1, 5}, {101, -1, 5}, {100, 1, 5});
                         return Case{mesh, far_apart_rays(256)};
                     }});
}

// Sizes where an off-by-one lives; a group is 64 or 256 nearly everywhere.
void add_sizes(std::vector<NamedCase>& cases) {
    const auto sized = [&](const char* name, uint32_t triangles, uint32_t width,
                           uint32_t height) {
        cases.push_back(
            {name, [=](Random& r) {
                 return Case{random_soup(r, triangles, 1.0f), random_rays(r, width, height)};
             }});
    };
    sized("OneTriangleOneRay", 1, 1, 1);
    sized("NoTriangles", 0, 16, 16);
    sized("OneRow", 64, 257, 1);
    sized("OneColumn", 65, 1, 63);
    sized("TwoByTwo", 63, 2, 2);
    sized("GroupLess", 255, 15, 17);
    sized("Group", 256, 16, 16);
    sized("GroupMore", 257, 17, 13);
    sized("Primes", small() ? 101 : 1009, small() ? 13 : 67, small() ? 7 : 41);
}

}  // namespace

const std::vector<NamedCase>& all_cases() {
    static const std::vector<NamedCase> cases = [] {
        std::vector<NamedCase> made;
        add_ordinary(made);
        add_adversarial(made);
        add_sizes(made);
        return made;
    }();
    return cases;
}

const NamedCase& case_of_name(const std::string& name) {
    for (const NamedCase& named : all_cases())
        if (named.name == name) return named;
    throw std::logic_error("there is no case " + name);
}

}  // namespace test
