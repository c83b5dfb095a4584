// scene_bvh.hpp - closest and any hits in double precision, quickly enough for whole pictures: a
// binary tree over the triangles. Leaves rounding alone, which hit.hpp bounds.
#pragma once

#include <vector>

#include "oracle/ray.hpp"
#include "support/mesh.hpp"

namespace oracle {

class SceneBvh {
public:
    explicit SceneBvh(const test::Mesh& mesh);

    // Of equal t, the lowest triangle. Rays begin not much farther from the origin of the coordinates
    // than the mesh reaches.
    Hit closest(const Ray& ray) const;
    bool is_hit(const Ray& ray) const;

    // The largest absolute value of a coordinate.
    double reach() const { return reach_; }

private:
    struct Box {
        test::Double3 low, high;
    };
    // An inner node has count 0 and its children at `first` and first + 1, a leaf `count` triangles
    // from `first` on.
    struct Node {
        Box box;
        uint32_t first = 0, count = 0;
    };
    struct Triangle {
        test::Double3 corner[3];
        uint32_t number;
    };

    Box box_of(uint32_t begin, uint32_t end) const;
    void split(uint32_t node, uint32_t begin, uint32_t end);
    static bool is_entered(const Box& box, const Ray& ray, double tmax);
    template <class Take>
    void visit(const Ray& ray, const Take& take) const;

    double reach_ = 0;
    std::vector<Triangle> triangles_;
    std::vector<Node> nodes_;
};

// Whether the ray hits the triangle, edges and corners included, with t from tmin to tmax. Two
// triangles with an edge in common see the same signs at it, so nothing slips through between them.
bool intersect(const Ray& ray, const test::Double3 (&corner)[3], Hit* hit);

}  // namespace oracle
