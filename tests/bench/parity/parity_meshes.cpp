#include "parity/parity_meshes.hpp"

#include <cstdlib>
#include <stdexcept>

#include "frame/still_scene.hpp"
#include "support/closed_meshes.hpp"

namespace bench::parity {
namespace {

test::Mesh needles() {
    test::Random random(81);
    return test::with_needles(random, test::star(71, 72, 0.2f), 3000);
}

test::Mesh box() {
    test::Random random(82);
    return test::lattice_box(random, 15);
}

// Six of its edges are those of a hole.
test::Mesh dragon() {
    const StillScene scene =
        read_still_scene({"dragon", Reflector::kFile, 0, RSH_PARITY_SCENE, true});
    test::Mesh mesh;
    for (const auto& p : scene.mesh.positions) mesh.vertices.push_back({p.x, p.y, p.z});
    for (const auto& triangle : scene.mesh.triangles)
        for (int k = 0; k < 3; ++k) mesh.indices.push_back(triangle[k]);
    return test::without_holes(mesh);
}

ClosedMesh scanned() {
    const char* folder = std::getenv("RSH_SCENES");
    const std::string why_not = !kReadsSceneFiles     ? "this rsh-bench reads no scene files"
                                : !folder || !*folder ? "RSH_SCENES is not set"
                                                      : "";
    return {"dragon", dragon, why_not};
}

}  // namespace

std::vector<ClosedMesh> closed_meshes() {
    return {{"sphere", [] { return test::sphere(72, 71); }},
            {"torus", [] { return test::torus(64, 80); }},
            {"trefoil", [] { return test::trefoil(24, 240); }},
            {"lattice_box", box},
            {"needles", needles},
            scanned()};
}

}  // namespace bench::parity
