// point_tree.hpp - points of a plane, which are taken away one by one: is one of the rest in a
// triangle? A k-d tree; each node knows its box and how many places in it are taken.
#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace render {

constexpr uint32_t kNoPlace = 0xffffffffu;

// Twice the area of a triangle, positive if it turns to the left.
double turn(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c);

// A triangle that turns to the left.
struct FlatTriangle {
    glm::dvec2 a, b, c;
    // Inside or on an edge, and no corner.
    bool contains(glm::dvec2 p) const;
};

class PointTree {
public:
    // Of all `points` those with `is_in`. Equal ones share a place, which is taken as long as one
    // of them is left; places have numbers of their own.
    PointTree(const std::vector<glm::dvec2>& points, const std::vector<bool>& is_in);

    // Takes a point away that is in. The place that this leaves empty, or kNoPlace.
    uint32_t remove(uint32_t point);
    bool is_taken(uint32_t place) const { return places_[place].points > 0; }
    glm::dvec2 at(uint32_t place) const { return places_[place].at; }
    size_t places() const { return places_.size(); }

    // A place that is taken and that the triangle contains, or kNoPlace. `choice` picks one of
    // many, so that not all triangles meet the same.
    uint32_t find_in(const FlatTriangle& triangle, uint32_t choice) const;

private:
    struct Place {
        glm::dvec2 at{0.0};
        uint32_t points = 0;
        uint32_t number = 0;
    };
    struct Node {
        glm::dvec2 low{0.0}, high{0.0};
        uint32_t taken = 0;
    };
    struct Query {
        FlatTriangle triangle;
        glm::dvec2 low, high;
        bool may_meet(const Node& node) const;
    };
    struct Range {
        size_t node, first, end;  // children of node k: 2 k + 1, 2 k + 2
        bool is_leaf() const { return end - first <= 8; }
        Range child(uint32_t second) const;
    };
    Range root() const { return {0, 0, places_.size()}; }
    void build(Range range);
    uint32_t find(Range range, const Query& query, uint32_t choice) const;

    std::vector<Place> places_;       // those of a node side by side
    std::vector<uint32_t> of_point_;  // the place of each point that is in
    std::vector<Node> nodes_;
};

}  // namespace render
