#include "device/cl/under_way.hpp"

#include "device/objects/waiting.hpp"

namespace rsh {
namespace {

constexpr std::chrono::seconds kGoodWhile{1};

}  // namespace

// Events are released, and their callbacks run, without the lock.
void UnderWay::keep(Calls call) noexcept {
    Calls ended;
    const std::lock_guard<std::mutex> lock(mutex_);
    for (auto at = calls_.begin(); at != calls_.end();) {
        const auto next = std::next(at);
        if (is_done_with(*at)) ended.splice(ended.end(), calls_, at);
        at = next;
    }
    if (!call.front().commands.empty()) calls_.splice(calls_.end(), call);
}

bool UnderWay::is_done_with(Call& call) noexcept {
    const cl_int status = status_of(call.commands.back().get());
    if (status >= CL_COMPLETE) return status == CL_COMPLETE;
    const auto now = std::chrono::steady_clock::now();
    if (call.failed == std::chrono::steady_clock::time_point()) call.failed = now;
    return now - call.failed > kGoodWhile;
}

}  // namespace rsh
