// point_tree.cpp - halves by the median of the longer side, down to eight places.
#include "model/point_tree.hpp"

#include <algorithm>

namespace render {
namespace {

// Does the box lie outside of the edge, beyond doubt?
bool is_outside(glm::dvec2 a, glm::dvec2 b, glm::dvec2 low, glm::dvec2 high) {
    const glm::dvec2 edge = b - a;  // inside is (-edge.y, edge.x)
    return turn(a, b, {edge.y > 0.0 ? low.x : high.x, edge.x > 0.0 ? high.y : low.y}) < 0.0;
}

}  // namespace

double turn(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
    const glm::dvec2 p = b - a, q = c - a;
    return p.x * q.y - p.y * q.x;
}

bool FlatTriangle::contains(glm::dvec2 p) const {
    return p != a && p != b && p != c && turn(a, b, p) >= 0.0 && turn(b, c, p) >= 0.0 &&
           turn(c, a, p) >= 0.0;
}

bool PointTree::Query::may_meet(const Node& node) const {
    const auto& [a, b, c] = triangle;
    return low.x <= node.high.x && low.y <= node.high.y && high.x >= node.low.x &&
           high.y >= node.low.y && !is_outside(a, b, node.low, node.high) &&
           !is_outside(b, c, node.low, node.high) && !is_outside(c, a, node.low, node.high);
}

PointTree::Range PointTree::Range::child(uint32_t second) const {
    const size_t middle = first + (end - first) / 2;
    if (second != 0) return {2 * node + 2, middle, end};
    return {2 * node + 1, first, middle};
}

PointTree::PointTree(const std::vector<glm::dvec2>& points, const std::vector<bool>& is_in)
    : of_point_(points.size(), kNoPlace) {
    std::vector<uint32_t> sorted;
    for (uint32_t i = 0; i < points.size(); ++i)
        if (is_in[i]) sorted.push_back(i);
    std::sort(sorted.begin(), sorted.end(), [&](uint32_t a, uint32_t b) {
        return points[a].x != points[b].x ? points[a].x < points[b].x
                                          : points[a].y < points[b].y;
    });
    for (const uint32_t point : sorted) {
        if (places_.empty() || places_.back().at != points[point])
            places_.push_back({points[point], 0, static_cast<uint32_t>(places_.size())});
        ++places_.back().points;
        of_point_[point] = places_.back().number;
    }
    build(root());
    std::vector<uint32_t> moved_to(places_.size());
    for (uint32_t i = 0; i < places_.size(); ++i) moved_to[places_[i].number] = i;
    for (const uint32_t point : sorted) of_point_[point] = moved_to[of_point_[point]];
}

void PointTree::build(Range range) {
    if (nodes_.size() <= range.node) nodes_.resize(2 * range.node + 1);
    Node& node = nodes_[range.node];
    node.taken = static_cast<uint32_t>(range.end - range.first);
    const auto first = places_.begin() + static_cast<std::ptrdiff_t>(range.first);
    const auto end = places_.begin() + static_cast<std::ptrdiff_t>(range.end);
    if (first == end) return;
    node.low = node.high = first->at;
    for (auto i = first; i != end; ++i) {
        node.low = glm::min(node.low, i->at);
        node.high = glm::max(node.high, i->at);
    }
    if (range.is_leaf()) return;
    const int axis = node.high.x - node.low.x > node.high.y - node.low.y ? 0 : 1;
    std::nth_element(first, first + (end - first) / 2, end,
                     [&](const Place& a, const Place& b) { return a.at[axis] < b.at[axis]; });
    build(range.child(0));
    build(range.child(1));
}

uint32_t PointTree::remove(uint32_t point) {
    const uint32_t place = of_point_[point];
    if (--places_[place].points > 0) return kNoPlace;
    Range range = root();
    --nodes_[range.node].taken;
    while (!range.is_leaf()) {
        range = range.child(place >= range.child(1).first);
        --nodes_[range.node].taken;
    }
    return place;
}

uint32_t PointTree::find_in(const FlatTriangle& t, uint32_t choice) const {
    const Query query{t, glm::min(glm::min(t.a, t.b), t.c), glm::max(glm::max(t.a, t.b), t.c)};
    return find(root(), query, choice);
}

uint32_t PointTree::find(Range range, const Query& query, uint32_t choice) const {
    const Node& node = nodes_[range.node];
    if (node.taken == 0 || !query.may_meet(node)) return kNoPlace;
    if (range.is_leaf()) {
        for (size_t i = range.first; i < range.end; ++i)
            if (places_[i].points > 0 && query.triangle.contains(places_[i].at))
                return static_cast<uint32_t>(i);
        return kNoPlace;
    }
    const uint32_t found = find(range.child(choice & 1), query, choice >> 1);
    return found != kNoPlace ? found : find(range.child(~choice & 1), query, choice >> 1);
}

}  // namespace render
