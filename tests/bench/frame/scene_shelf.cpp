#include "frame/scene_shelf.hpp"

namespace bench {

SceneOnDevice& SceneShelf::get(const SceneSpec& spec) {
    for (const auto& kept : kept_)
        if (kept->name == spec.name) return kept->on_device;
    constexpr size_t kMost = 3;
    if (kept_.size() == kMost) kept_.pop_back();
    kept_.push_front(std::make_unique<Kept>(device_, spec));
    return kept_.front()->on_device;
}

}  // namespace bench
