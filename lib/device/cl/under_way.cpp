#include "device/cl/under_way.hpp"

#include "device/objects/waiting.hpp"

namespace rsh {

// Events are released, and their callbacks run, without the lock.
void UnderWay::keep(Calls call) noexcept {
    Calls ended;
    const std::lock_guard<std::mutex> lock(mutex_);
    for (auto at = calls_.begin(); at != calls_.end();) {
        const auto next = std::next(at);
        if (has_ended(at->back().get())) ended.splice(ended.end(), calls_, at);
        at = next;
    }
    if (!call.front().empty()) calls_.splice(calls_.end(), call);
}

}  // namespace rsh
