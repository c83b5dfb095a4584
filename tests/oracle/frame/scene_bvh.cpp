#include "oracle/frame/scene_bvh.hpp"

#include <algorithm>

namespace oracle {
namespace {

using test::Double3;

constexpr uint32_t kMostInLeaf = 4;
constexpr uint32_t kMostDepth = 64;  // halves 2^32 triangles

double component(const Double3& v, int axis) {
    return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

Double3 least(const Double3& a, const Double3& b) {
    return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
}

Double3 most(const Double3& a, const Double3& b) {
    return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
}

int longest_axis(const Double3& extent) {
    if (extent.x >= extent.y && extent.x >= extent.z) return 0;
    return extent.y >= extent.z ? 1 : 2;
}

}  // namespace

SceneBvh::SceneBvh(const test::Mesh& mesh) {
    for (uint32_t i = 0; i < mesh.triangle_count(); ++i) {
        test::Corners c;
        if (!mesh.corners(i, &c) || !finite(c[0]) || !finite(c[1]) || !finite(c[2])) continue;
        triangles_.push_back({{Double3(c[0]), Double3(c[1]), Double3(c[2])}, i});
        for (const test::Float3& corner : c)
            reach_ = std::max(reach_, double(max_norm(corner)));
    }
    if (triangles_.empty()) return;
    nodes_.emplace_back();
    split(0, 0, uint32_t(triangles_.size()));
}

// Grown by thousands of times what intersect() errs by.
SceneBvh::Box SceneBvh::box_of(uint32_t begin, uint32_t end) const {
    Box box = {triangles_[begin].corner[0], triangles_[begin].corner[0]};
    for (uint32_t i = begin; i < end; ++i)
        for (const Double3& corner : triangles_[i].corner)
            box = {least(box.low, corner), most(box.high, corner)};
    const double room = std::ldexp(reach_, -40);
    return {box.low - Double3(room, room, room), box.high + Double3(room, room, room)};
}

// In halves, by the sums of the corners along the longest axis.
void SceneBvh::split(uint32_t node, uint32_t begin, uint32_t end) {
    const Box box = box_of(begin, end);
    if (end - begin <= kMostInLeaf) {
        nodes_[node] = {box, begin, end - begin};
        return;
    }
    const int axis = longest_axis(box.high - box.low);
    const auto place = [axis](const Triangle& t) {
        return component(t.corner[0] + t.corner[1] + t.corner[2], axis);
    };
    const uint32_t middle = begin + (end - begin) / 2;
    std::nth_element(triangles_.begin() + begin, triangles_.begin() + middle,
                     triangles_.begin() + end,
                     [&](const Triangle& a, const Triangle& b) { return place(a) < place(b); });
    const uint32_t child = uint32_t(nodes_.size());
    nodes_[node] = {box, child, 0};
    nodes_.resize(nodes_.size() + 2);
    split(child, begin, middle);
    split(child + 1, middle, end);
}

bool SceneBvh::is_entered(const Box& box, const Ray& ray, double tmax) {
    double enter = ray.tmin, leave = tmax;
    for (int axis = 0; axis < 3; ++axis) {
        const double o = component(ray.origin, axis), d = component(ray.direction, axis);
        const double low = component(box.low, axis), high = component(box.high, axis);
        if (d == 0) {
            if (o < low || o > high) return false;
            continue;
        }
        const double a = (low - o) / d, b = (high - o) / d;
        enter = std::max(enter, std::min(a, b));
        leave = std::min(leave, std::max(a, b));
    }
    return enter <= leave;
}

// take(triangle) returns how far to look from now on; below tmin: no farther.
template <class Take>
void SceneBvh::visit(const Ray& ray, const Take& take) const {
    if (nodes_.empty()) return;
    uint32_t stack[kMostDepth] = {0};
    double tmax = ray.tmax;
    for (uint32_t size = 1; size > 0 && tmax >= ray.tmin;) {
        const Node& node = nodes_[stack[--size]];
        if (!is_entered(node.box, ray, tmax)) continue;
        for (uint32_t i = 0; i < node.count; ++i) tmax = take(triangles_[node.first + i]);
        if (node.count > 0) continue;
        const Box &a = nodes_[node.first].box, &b = nodes_[node.first + 1].box;
        const bool is_second_nearer =
            dot(b.low + b.high, ray.direction) < dot(a.low + a.high, ray.direction);
        stack[size++] = node.first + !is_second_nearer;
        stack[size++] = node.first + is_second_nearer;
    }
}

Hit SceneBvh::closest(const Ray& ray) const {
    Hit best;
    best.t = ray.tmax;
    visit(ray, [&](const Triangle& triangle) {
        Hit hit;
        if (triangle.number != ray.skip && intersect(ray, triangle.corner, &hit) &&
            (hit.t < best.t || (hit.t == best.t && triangle.number < best.primitive))) {
            best = hit;
            best.primitive = triangle.number;
        }
        return best.t;
    });
    return best;
}

bool SceneBvh::is_hit(const Ray& ray) const {
    bool is_hit = false;
    visit(ray, [&](const Triangle& triangle) {
        Hit hit;
        is_hit |= triangle.number != ray.skip && intersect(ray, triangle.corner, &hit);
        return is_hit ? -1.0 : ray.tmax;
    });
    return is_hit;
}

// The signs of the volumes that the ray spans with the edges; they are the weights of the corners, and
// t is that of the weighted mean.
bool intersect(const Ray& ray, const Double3 (&corner)[3], Hit* hit) {
    const Double3 a = corner[0] - ray.origin, b = corner[1] - ray.origin,
                  c = corner[2] - ray.origin;
    const double of_a = dot(ray.direction, cross(b, c)), of_b = dot(ray.direction, cross(c, a)),
                 of_c = dot(ray.direction, cross(a, b));
    const bool has_one_sign =
        (of_a >= 0 && of_b >= 0 && of_c >= 0) || (of_a <= 0 && of_b <= 0 && of_c <= 0);
    const double sum = of_a + of_b + of_c;
    if (!has_one_sign || sum == 0) return false;
    hit->u = of_b / sum;
    hit->v = of_c / sum;
    const Double3 point = (of_a / sum) * a + hit->u * b + hit->v * c;
    hit->t = dot(point, ray.direction) / dot(ray.direction, ray.direction);
    return hit->t >= ray.tmin && hit->t <= ray.tmax;
}

}  // namespace oracle
