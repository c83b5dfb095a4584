// parity_meshes.hpp - closed meshes of at least 10,000 triangles.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "support/mesh.hpp"

namespace bench::parity {

struct ClosedMesh {
    std::string name;
    std::function<test::Mesh()> make;
    std::string why_not = {};  // it cannot be made; empty: it can
};

// Made from code, and one that was scanned, if RSH_SCENES names the folder that it is in.
std::vector<ClosedMesh> closed_meshes();

}  // namespace bench::parity
