#include <fmt/format.h>

#include <stdexcept>

#include "budgets/bound.hpp"

namespace bench::budgets {
namespace {

struct Measured {
    std::string file;
    std::vector<const char*> stems;
    std::vector<Change> changes;
};

// mesh/triangles.h and mesh/algebra.h are part of every program.
const std::vector<Change> kOfMesh = {
    {"const float3 w = v / scale;", "const float3 w = rough3(v / scale);"},
    {"scale * sqrt(w.x * w.x + w.y * w.y + w.z * w.z);",
     "scale * rough(sqrt(w.x * w.x + w.y * w.y + w.z * w.z));"},
    {"return w / sqrt(dot3(w, w));", "return rough3(w / rough(sqrt(dot3(w, w))));"},
    {"r.slope_x = pick_x(r, x, y, z) / kz;", "r.slope_x = rough(pick_x(r, x, y, z) / kz);"},
    {"r.slope_y = pick_y(r, x, y, z) / kz;", "r.slope_y = rough(pick_y(r, x, y, z) / kz);"},
    {"r.inverse_z = (floatv)(1.0f) / kz;", "r.inverse_z = rough(1.0f / kz);"},
    {"floatv inverse = (floatv)(1.0f) / area;", "floatv inverse = rough(1.0f / area);"},
};

// What is granted must stand there as bounds.cpp has it: changed to itself.
constexpr Change granted(const char* piece) {
    return {piece, piece, true};
}

const std::vector<Change> kOfBoxes = {
    granted("{ return 0x1p-18f * largest + 0x1p-124f; }"),
    {"to_low = 1.0f / direction_low, to_high = 1.0f / direction_high;",
     "to_low = rough(1.0f / direction_low), to_high = rough(1.0f / direction_high);"},
    {"#define RSH_RAISED (1.0f + 0x1p-19f)", "#define RSH_RAISED 1.0f", true},
};

const std::vector<Change> kOfCones = {
    granted("#define RSH_LEAF_SINE 0x1p-20f"),
    granted("return widest + 0x1p-18f;"),
    granted("return radius * (1.0f + 0x1p-20f) + 0x1p-124f;"),
    granted("return radius * (1.0f + 0x1p-18f) + 0x1p-124f;"),
    {"const float3 scaled = d / scale;", "const float3 scaled = rough3(d / scale);"},
    {"scaled / sqrt(scaled.x * scaled.x + scaled.y * scaled.y + scaled.z * scaled.z);",
     "rough3(scaled / rough(sqrt(dot3(scaled, scaled))));"},
    {"const float sin_theta = sqrt(dot3(n, n));",
     "const float sin_theta = rough(sqrt(dot3(n, n)));"},
    {"sqrt(fmax(0.0f, 1.0f - sin_alpha * sin_alpha));",
     "rough(sqrt(fmax(0.0f, 1.0f - sin_alpha * sin_alpha)));"},
    {"? sum / length_of_sum :", "? rough3(sum / length_of_sum) :"},
    {"centre_z, centre_radius;", "centre_z, centre_radius, pad;", true},
    {"0x1p-17f * (fabs(wx)", "l->pad * (fabs(wx)", true},
};

// tmin stands for the threshold: the test does not look at it.
const std::vector<Change> kOfLeaving = {
    granted("0x1p-42f * dot3(plane->products, fabs(to_corner.high))"),
    {"0x1p-18f * largest3(fabs(a))", "ray.origin_tmin.w * largest3(fabs(a))", true},
};

const std::vector<Change> kOfSpawn = {
    granted("#define RSH_GRAZING 0x1p-16f"),
    granted("select(0x1p-21f * surface->edges.extent, from->error, is_kept);"),
    {"const floatv quotient = a.high / b.high;",
     "const floatv quotient = rough(a.high / b.high);"},
    {"return (twofoldv){quotient, rest / b.high};",
     "return (twofoldv){quotient, rough(rest / b.high)};"},
    {"const floatv inverse = (floatv)(1.0f) / sqrt(dot_v(w.high, w.high));",
     "const floatv inverse = rough((floatv)(1.0f) / rough(sqrt(dot_v(w.high, w.high))));"},
    {"const floatv along = (floatv)(1.0f) / dot_v(normal, d);",
     "const floatv along = rough((floatv)(1.0f) / dot_v(normal, d));"},
    {"/ sqrt(dot_v(normal, normal)) +", "/ rough(sqrt(dot_v(normal, normal))) +"},
};

// The struct's last word stands for the constant.
const std::vector<Change> kOfCamera = {
    {"0x1p-18f * fmax(fabs(w.x)", "as_float(screen->padding) * fmax(fabs(w.x)", true},
    {"load_lanes(from_centre_x) / (floatv)(screen->picture_width);",
     "rough(load_lanes(from_centre_x) / (floatv)(screen->picture_width));"},
    {"load_lanes(from_centre_y) / (floatv)(screen->picture_height);",
     "rough(load_lanes(from_centre_y) / (floatv)(screen->picture_height));"},
    {"length = sqrt(dx * dx + dy * dy + dz * dz);",
     "length = rough(sqrt(dx * dx + dy * dy + dz * dz));"},
    {"direction[0] = dx / length;", "direction[0] = rough(dx / length);"},
    {"direction[1] = dy / length;", "direction[1] = rough(dy / length);"},
    {"direction[2] = dz / length;", "direction[2] = rough(dz / length);"},
};

const std::vector<Measured> kMeasured = {
    {"algebra", {"traverse/brute_force"}, {}},
    {"hits", {"traverse/brute_force"}, {}},
    {"boxes", {"traverse/tiles/traverse_tiles"}, kOfBoxes},
    {"cones",
     {"traverse/brute_force", "bvh/spheres", "rays/build_cones",
      "traverse/paper_faithful/traverse_level"},
     kOfCones},
    {"leaving", {"traverse/brute_force"}, kOfLeaving},
    {"camera", {"bvh/spheres", "camera/rasterize"}, kOfCamera},
    {"spawn", {"traverse/brute_force", "shade/spawn"}, kOfSpawn},
};

const Measured& measured(const std::string& file) {
    for (const Measured& one : kMeasured)
        if (one.file == file) return one;
    throw std::logic_error("no kernels called " + file);
}

}  // namespace

std::vector<const char*> stems_of(const std::string& file) {
    return measured(file).stems;
}

std::vector<Change> changes_of(const std::string& file) {
    std::vector<Change> changes = kOfMesh;
    const std::vector<Change>& own = measured(file).changes;
    changes.insert(changes.end(), own.begin(), own.end());
    return changes;
}

}  // namespace bench::budgets
