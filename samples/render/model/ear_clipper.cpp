// ear_clipper.cpp - a ring of the corners that are left, and a queue of ears.
#include "model/ear_clipper.hpp"

#include <utility>

#include "model/point_tree.hpp"

namespace render {
namespace {

std::vector<bool> not_left_turning(const std::vector<glm::dvec2>& corners) {
    std::vector<bool> result;
    for (size_t i = 0, n = corners.size(); i < n; ++i)
        result.push_back(
            !(turn(corners[(i + n - 1) % n], corners[i], corners[(i + 1) % n]) > 0.0));
    return result;
}

class EarClipper {
public:
    explicit EarClipper(const std::vector<glm::dvec2>& corners)
        : corners_(corners),
          is_obstacle_(not_left_turning(corners)),
          tree_(corners, is_obstacle_),
          is_gone_(corners.size()),
          queued_(corners.size(), kNotQueued),
          obstacle_(corners.size(), kNoPlace),
          waiting_(tree_.places()) {
        const auto count = static_cast<uint32_t>(corners.size());
        for (uint32_t i = 0; i < count; ++i) {
            before_.push_back((i + count - 1) % count);
            after_.push_back((i + 1) % count);
        }
    }

    std::vector<glm::uvec3> clip() {
        for (uint32_t i = 0; i < corners_.size(); ++i) test(i);
        while (triangles_.size() + 3 < corners_.size()) cut_off(next_ear());
        triangles_.push_back({first_, after_[first_], after_[after_[first_]]});
        return std::move(triangles_);
    }

private:
    static constexpr size_t kNotQueued = ~size_t{0};

    uint32_t next_ear() {
        for (; head_ < queue_.size(); ++head_)
            if (queued_[queue_[head_]] == head_) return queue_[head_++];
        return after_[first_];
    }

    void cut_off(uint32_t i) {
        const uint32_t before = before_[i], after = after_[i];
        triangles_.push_back({before, i, after});
        after_[before] = after;
        before_[after] = before;
        is_gone_[i] = true;
        queued_[i] = kNotQueued;
        if (i == first_) first_ = after;
        test(before);
        test(after);
        clear(i);
    }

    // A corner that is gone or turns to the left is in the way of none.
    void clear(uint32_t i) {
        if (!is_obstacle_[i]) return;
        is_obstacle_[i] = false;
        const uint32_t place = tree_.remove(i);
        if (place == kNoPlace) return;
        for (const uint32_t other : std::exchange(waiting_[place], {}))
            if (!is_gone_[other] && obstacle_[other] == place) test(other);
    }

    void test(uint32_t i) {
        queued_[i] = kNotQueued;
        const FlatTriangle t{corners_[before_[i]], corners_[i], corners_[after_[i]]};
        if (!(turn(t.a, t.b, t.c) > 0.0)) return;
        clear(i);
        const uint32_t last = obstacle_[i];
        if (last != kNoPlace && tree_.is_taken(last) && t.contains(tree_.at(last))) return;
        obstacle_[i] = tree_.find_in(t, i);
        if (obstacle_[i] != kNoPlace) {
            waiting_[obstacle_[i]].push_back(i);
            return;
        }
        queued_[i] = queue_.size();
        queue_.push_back(i);
    }

    const std::vector<glm::dvec2>& corners_;
    std::vector<bool> is_obstacle_;  // left, and does not turn to the left
    PointTree tree_;                 // of the obstacles
    std::vector<bool> is_gone_;
    std::vector<uint32_t> before_, after_;  // the ring of the corners that are left
    uint32_t first_ = 0;                    // of them
    std::vector<uint32_t> queue_;           // of ears, from `head_` on, and of former ones
    size_t head_ = 0;
    std::vector<size_t> queued_;                  // the place of an ear in the queue
    std::vector<uint32_t> obstacle_;              // a place in the way of a corner
    std::vector<std::vector<uint32_t>> waiting_;  // corners by their obstacle, and former ones
    std::vector<glm::uvec3> triangles_;
};

}  // namespace

std::vector<glm::uvec3> clip_ears(const std::vector<glm::dvec2>& corners) {
    return EarClipper(corners).clip();
}

}  // namespace render
