#include "oracle/mirrors/lines.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "oracle/mirrors/float_state.hpp"
#include "oracle/mirrors/growth.hpp"
#include "oracle/on_all_cores.hpp"

namespace oracle {
namespace {

MirrorRay exactly(const rsh_ray& ray) {
    return {Quad3(test::origin(ray)), Quad3(test::direction(ray)), RSH_NO_HIT};
}

void follow_path(const std::vector<Wave>& waves, size_t i, uint32_t bounces, double unit,
                 const Mirrors& mirrors, Followed* followed) {
    const MirrorRay start = exactly(waves[0].rays[i]);
    const Path exact = exact_path(mirrors, start, bounces);
    const auto with = [&](const State& state, uint32_t count) {
        return errors_of(path_with(state, count, mirrors, start, exact), exact);
    };
    followed->lines[kTracer].set(i, errors_of(path_of(waves, i, mirrors), exact));
    followed->lines[kBestFloats].set(i, with(rounded, bounces));
    followed->lines[kOffsetAlone].set(i, with(departed, bounces));
    followed->lines[kOneRounding].set(i, with(rounded, 1));
    followed->growth[i] = growth_along(exact, mirrors, unit);
}

void require_whole(const Followed& followed, uint32_t bounces) {
    for (size_t i = 0; i < followed.growth.size(); ++i)
        if (followed.growth[i].size() < bounces)
            throw std::runtime_error("exact path " + std::to_string(i) + " ends after " +
                                     std::to_string(followed.growth[i].size()) +
                                     " bounces, must have " + std::to_string(bounces));
}

}  // namespace

Followed::Followed(size_t paths, size_t bounces)
    : lines{ErrorTable(paths, bounces), ErrorTable(paths, bounces), ErrorTable(paths, bounces),
            ErrorTable(paths, bounces)},
      growth(paths) {}

void Followed::append(const Followed& more) {
    for (size_t line = 0; line < lines.size(); ++line) lines[line].append(more.lines[line]);
    growth.insert(growth.end(), more.growth.begin(), more.growth.end());
    faults.nan += more.faults.nan;
    faults.self_hits += more.faults.self_hits;
    faults.leaks += more.faults.leaks;
}

Followed follow(const MirrorRoom& room, double unit, const std::vector<rsh_ray>& start,
                uint32_t bounces, Tracer& tracer) {
    const Mirrors mirrors(room.mesh, room.normals);
    const std::vector<Wave> waves = trace_waves(tracer, start, bounces);
    Followed followed(start.size(), bounces);
    on_all_cores(start.size(),
                 [&](size_t i) { follow_path(waves, i, bounces, unit, mirrors, &followed); });
    require_whole(followed, bounces);
    followed.faults = faults_of(waves, room, mirrors);
    return followed;
}

double times_the_best(const Followed& followed, size_t bounce) {
    const ErrorTable &tracer = followed.lines[kTracer], &best = followed.lines[kBestFloats];
    double largest = 0;
    for (const auto error : {&Errors::position, &Errors::direction, &Errors::next_hit})
        largest = std::max(largest, tracer.median_of_ratios(best, bounce, error));
    return largest;
}

}  // namespace oracle
