#include "mirrors/mirrors_suite.hpp"

#include <fmt/format.h>

#include <optional>

#include "mirrors/mirror_cases.hpp"
#include "mirrors/mirrors_text.hpp"
#include "mirrors/room_on_device.hpp"
#include "progress.hpp"

namespace bench {
namespace {

using namespace mirrors;

constexpr uint32_t kBounces = 64;
constexpr uint32_t kLevel = 3;  // 5,120 triangles
constexpr uint32_t kPathsAtOnce = 128;
constexpr uint32_t kQuickRounds = 2;
constexpr uint32_t kRounds = 32;

// As many rounds as the limit leaves time for, one at least.
oracle::Followed follow_room(const Run& run, bool is_smooth, ProgressBar& progress) {
    const oracle::MirrorRoom room = oracle::mirror_room(kLevel, is_smooth);
    RoomOnDevice by_rsh(run.device, room);
    std::optional<oracle::Followed> all;
    const uint32_t rounds = run.quick ? kQuickRounds : kRounds;
    for (uint32_t i = 0; i < rounds && (i == 0 || !run.limit.has_passed()); ++i) {
        progress.begin(fmt::format("{} normals, round {}", name_of_normals(is_smooth), i + 1));
        test::Random random(i);
        const auto start = oracle::rays_in_mirror_room(random, kPathsAtOnce);
        const oracle::Followed one = oracle::follow(room, 1, start, kBounces, by_rsh);
        if (all)
            all->append(one);
        else
            all = one;
    }
    return *all;
}

}  // namespace

void MirrorsSuite::run(const Run& run) {
    ProgressBar progress(2 * (run.quick ? kQuickRounds : kRounds));
    for (const bool is_smooth : {true, false}) {
        if (run.limit.has_passed()) {
            run.results.leave_out(fmt::format("mirrors/normals:{}", name_of_normals(is_smooth)),
                                  run.limit.when_passed());
            continue;
        }
        const std::vector<Case> cases =
            cases_of(follow_room(run, is_smooth, progress), is_smooth);
        fmt::print("{}", table_of(cases));
        for (const Case& one : cases) run.results.add(one);
    }
}

}  // namespace bench
