// filter.cpp - the vectorized loop. Compiled with -fno-trapping-math, which it needs to
// vectorize.
#include "oracle/filter.hpp"

#include <algorithm>

#include "oracle/clones.hpp"
#include "support/rays.hpp"

namespace oracle {
namespace {

using test::Double3;

// Twice the constants of hit.hpp, where denormals may be flushed: this bound has to contain that
// one. What it has for large triangles is far below the error of their corners.
constexpr double kUnit = 0x1p-23;
constexpr double kShear = 16 * kUnit;
constexpr double kFloor = 0x1p-122;
constexpr double kFlushed = 0x1p-122;

inline double larger(double a, double b) {
    return a > b ? a : b;
}
inline double smaller(double a, double b) {
    return a < b ? a : b;
}
inline double largest_of(double a, double b, double c) {
    return larger(std::fabs(a), larger(std::fabs(b), std::fabs(c)));
}

struct Line {
    double ox, oy, oz, dx, dy, dz;
    double scale;  // largest component of the direction, and its reciprocal
    double inverse;
    double distance;  // of the origin from the block's centre
    double shear;     // error of a lateral coordinate, relative
};

// score > 0: two volumes lie outside of the error bound with different signs, a certain miss.
RSH_TEST_CLONES
void score_block(const double (*c)[kBlock], const double* reach, Line r, double* score) {
    for (uint32_t i = 0; i < kBlock; ++i) {
        const double ax = c[0][i] - r.ox, ay = c[1][i] - r.oy, az = c[2][i] - r.oz;
        const double bx = c[3][i] - r.ox, by = c[4][i] - r.oy, bz = c[5][i] - r.oz;
        const double cx = c[6][i] - r.ox, cy = c[7][i] - r.oy, cz = c[8][i] - r.oz;
        const double dax = r.dy * az - r.dz * ay, day = r.dz * ax - r.dx * az;
        const double daz = r.dx * ay - r.dy * ax;
        const double dbx = r.dy * bz - r.dz * by, dby = r.dz * bx - r.dx * bz;
        const double dbz = r.dx * by - r.dy * bx;
        const double dcx = r.dy * cz - r.dz * cy, dcy = r.dz * cx - r.dx * cz;
        const double dcz = r.dx * cy - r.dy * cx;
        const double w = dax * bx + day * by + daz * bz;
        const double v = -(dax * cx + day * cy + daz * cz);
        const double u = dbx * cx + dby * cy + dbz * cz;
        const double error = r.shear * (r.distance + reach[i]) + kFlushed;
        const double across =
            r.inverse * larger(largest_of(dax, day, daz),
                               larger(largest_of(dbx, dby, dbz), largest_of(dcx, dcy, dcz)));
        const double bound =
            r.scale * (2 * error * (2 * across + error) + 8 * kUnit * across * across + kFloor);
        score[i] = smaller(larger(larger(u, v), w) - bound, -smaller(smaller(u, v), w) - bound);
    }
}

void add(Block& block, uint32_t triangle, const test::Corners& corners) {
    const uint32_t i = block.count++;
    block.triangle[i] = triangle;
    for (int k = 0; k < 3; ++k) {
        block.corner[3 * k][i] = corners[k].x;
        block.corner[3 * k + 1][i] = corners[k].y;
        block.corner[3 * k + 2][i] = corners[k].z;
    }
}

void finish(Block& block) {
    block.centre = {block.corner[0][0], block.corner[1][0], block.corner[2][0]};
    const double centre[3] = {block.centre.x, block.centre.y, block.centre.z};
    for (uint32_t i = 0; i < kBlock; ++i) {
        block.reach[i] = 0;
        for (int k = 0; k < 9; ++k) {
            if (i >= block.count) block.corner[k][i] = centre[k % 3];
            block.reach[i] =
                larger(block.reach[i], std::fabs(block.corner[k][i] - centre[k % 3]));
        }
    }
}

}  // namespace

std::vector<Block> make_blocks(const test::Mesh& mesh) {
    std::vector<Block> blocks;
    for (uint32_t t = 0; t < mesh.triangle_count(); ++t) {
        test::Corners corners;
        if (!mesh.corners(t, &corners)) continue;
        if (!finite(corners[0]) || !finite(corners[1]) || !finite(corners[2])) continue;
        if (blocks.empty() || blocks.back().count == kBlock) blocks.emplace_back();
        add(blocks.back(), t, corners);
    }
    for (Block& block : blocks) finish(block);
    return blocks;
}

void filter(const Block& block, const rsh_ray& ray, std::vector<uint32_t>* out) {
    const Double3 o(test::origin(ray)), d(test::direction(ray));
    const double scale = max_norm(d);
    const Line line = {o.x,
                       o.y,
                       o.z,
                       d.x,
                       d.y,
                       d.z,
                       scale,
                       1 / scale,
                       max_norm(o - block.centre),
                       kShear + smaller(4.0, 0x1p-124 / scale)};
    alignas(64) double score[kBlock];
    score_block(block.corner, block.reach, line, score);
    for (uint32_t i = 0; i < block.count; ++i)
        if (!(score[i] > 0)) out->push_back(block.triangle[i]);
}

}  // namespace oracle
