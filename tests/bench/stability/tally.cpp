#include "stability/tally.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "frame/checksum.hpp"
#include "oracle/crossings/judge_crossings.hpp"
#include "oracle/lattice.hpp"
#include "oracle/leaving/separated.hpp"

namespace bench::stability {
namespace {

using oracle::Fault;
using oracle::Verdict;

// Share of the decisions that may stay open.
double open_share(Kind kind) {
    return kind == Kind::kLattice ? 0 : kind == Kind::kRandom ? 1e-4 : 1;
}

bool is_same(const rsh_hit& a, const rsh_hit& b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

// What a ray that hits nothing must hold; tmax may be NaN.
bool holds_nothing(const rsh_hit& hit, float tmax) {
    return std::memcmp(&hit.t, &tmax, sizeof tmax) == 0 && hit.u == 0 && hit.v == 0;
}

// Of equal triangles the lowest, unless it is skipped.
Verdict judge_twin(const Scene& scene, const Expected& expected, size_t ray, uint32_t found) {
    if (found == RSH_NO_HIT || expected.twins[found] == found) return {};
    const uint32_t twin = expected.twins[found];
    if (!scene.rays.skip.empty() && scene.rays.skip[ray] == twin) return {};
    return {Fault::kWrongTriangle, fmt::format("is {} as well, with a lower number", twin)};
}

Verdict judge(const Scene& scene, const Expected& expected, size_t k, const rsh_hit& hit) {
    const size_t ray = expected.rays[k];
    const oracle::Answer& answer = expected.answers[k];
    const rsh_ray& of = scene.rays.rays[ray];
    const Verdict verdict =
        expected.is_exact ? oracle::judge_exact(answer, scene.mesh, of, hit)
                          : oracle::judge_hit(answer, scene.mesh, of, hit, expected.denormals);
    if (verdict.fault != Fault::kNone) return verdict;
    const Verdict twin = judge_twin(scene, expected, ray, hit.primitive);
    return twin.fault != Fault::kNone ? twin : verdict;
}

bool has_nan(const rsh_hit& hit) {
    return std::isnan(hit.t) || std::isnan(hit.u) || std::isnan(hit.v);
}

// Of the triangle that the ray has left, or of one that it does not meet for certain.
bool is_self_hit(const Scene& scene, size_t ray, uint32_t hit) {
    test::Corners left, corners;
    if (scene.rays.skip.empty()) return false;
    const uint32_t skip = scene.rays.skip[ray];
    if (skip == hit) return true;
    return skip < scene.mesh.triangle_count() && scene.mesh.corners(skip, &left) &&
           hit < scene.mesh.triangle_count() && scene.mesh.corners(hit, &corners) &&
           oracle::is_separated(scene.rays.rays[ray], left, corners);
}

}  // namespace

uint64_t count_pairs(const Scene& scene) {
    uint64_t active = 0;
    for (const rsh_ray& ray : scene.rays.rays) active += test::is_active(ray);
    return active * scene.mesh.triangle_count();
}

void Tally::add_hits(const Scene& scene, const Expected& expected,
                     const std::vector<rsh_hit>& reference, const std::vector<rsh_hit>& hits) {
    add_scene(scene, expected, expected.undecided);
    for (size_t i = 0; i < hits.size(); ++i) {
        differ_ += !is_same(hits[i], reference[i]);
        check_hit(scene, i, hits[i]);
    }
    for (size_t k = 0; k < expected.rays.size(); ++k)
        add(judge(scene, expected, k, hits[expected.rays[k]]), expected.rays[k]);
    add_hash(checksum(hits));
}

void Tally::add_occlusion(const Scene& scene, const Expected& expected,
                          const std::vector<rsh_hit>& reference,
                          const std::vector<cl_uint>& masks) {
    add_scene(scene, expected, expected.undecided);
    for (size_t i = 0; i < masks.size(); ++i)
        differ_ += masks[i] != cl_uint{reference[i].primitive != RSH_NO_HIT};
    for (size_t k = 0; k < expected.rays.size(); ++k)
        add(oracle::judge_occlusion(expected.answers[k], masks[expected.rays[k]] != 0),
            expected.rays[k]);
    add_hash(checksum(masks));
}

void Tally::add_spawned(const SpawnFaults& faults) {
    missed_ += faults.missed;
    spurious_ += faults.spurious;
    nan_out_ += faults.nan_out;
    if (first_fault_.empty()) first_fault_ = faults.first;
}

void Tally::add_counts(const Scene& scene, const Expected& expected, const AllHits& reference,
                       const std::vector<cl_uint>& counts) {
    add_scene(scene, expected, expected.undecided_crossings);
    for (size_t i = 0; i < counts.size(); ++i) {
        differ_ += counts[i] != reference.count(i);
        check_parity(scene, expected, i, counts[i]);
    }
    for (size_t k = 0; k < expected.rays.size(); ++k)
        add(oracle::judge_count(expected.crossings[k], counts[expected.rays[k]]),
            expected.rays[k]);
    add_hash(checksum(counts));
}

void Tally::add_all(const Scene& scene, const Expected& expected, const AllHits& reference,
                    const AllHits& all) {
    add_scene(scene, expected, expected.undecided_crossings);
    for (size_t i = 0; i < scene.rays.rays.size(); ++i) {
        const size_t count = all.count(i);
        differ_ += count != reference.count(i) ||
                   !std::equal(all.of(i), all.of(i) + count, reference.of(i), is_same);
        check_parity(scene, expected, i, count);
        for (const rsh_hit* hit = all.of(i); hit < all.of(i) + count; ++hit) {
            nan_out_ += has_nan(*hit);
            check_self_hit(scene, i, hit->primitive);
        }
    }
    for (size_t k = 0; k < expected.rays.size(); ++k) {
        const size_t ray = expected.rays[k];
        add(oracle::judge_all(expected.crossings[k], all.of(ray), all.count(ray)), ray);
    }
    add_hash(checksum(all.offsets));
    add_hash(checksum(all.hits));
}

void Tally::check_parity(const Scene& scene, const Expected& expected, size_t ray,
                         uint64_t count) {
    if (expected.is_inside && test::is_active(scene.rays.rays[ray]))
        add(oracle::judge_parity(count, *expected.is_inside), ray);
}

void Tally::add_scene(const Scene& scene, const Expected& expected, uint64_t undecided) {
    rays_ += scene.rays.rays.size();
    pairs_ += count_pairs(scene);
    decisions_ += expected.decisions;
    undecided_ += undecided;
}

void Tally::check_self_hit(const Scene& scene, size_t ray, uint32_t hit) {
    if (!is_self_hit(scene, ray, hit)) return;
    ++self_hits_;
    note(ray, fmt::format("hits {}, which lies behind it as it leaves {}", hit,
                          scene.rays.skip[ray]));
}

void Tally::check_hit(const Scene& scene, size_t ray, const rsh_hit& hit) {
    const float tmax = scene.rays.rays[ray].direction_tmax.s[3];
    if (hit.primitive != RSH_NO_HIT) {
        nan_out_ += has_nan(hit);
        check_self_hit(scene, ray, hit.primitive);
    } else if (!holds_nothing(hit, tmax)) {
        nan_out_ += has_nan(hit) && !std::isnan(tmax);
        add({Fault::kSpurious, fmt::format("hits nothing at t {}, u {}, v {}: must be {}, 0, 0",
                                           hit.t, hit.u, hit.v, tmax)},
            ray);
    }
}

void Tally::add(const Verdict& verdict, size_t ray) {
    missed_ += verdict.fault == Fault::kMissed;
    spurious_ += verdict.fault == Fault::kSpurious;
    wrong_triangle_ += verdict.fault == Fault::kWrongTriangle;
    t_error_of_budget_ = std::max(t_error_of_budget_, verdict.t_error_of_budget);
    if (verdict.fault != Fault::kNone) note(ray, verdict.why);
}

void Tally::note(size_t ray, const std::string& fault) {
    if (first_fault_.empty()) first_fault_ = fmt::format("ray {} {}", ray, fault);
}

// Of several rounds, the hash of their hashes.
void Tally::add_hash(const std::string& hash) {
    const std::string both = hash_ + hash;
    hash_ = hash_.empty() ? hash : checksum(std::vector<char>(both.begin(), both.end()));
}

nlohmann::json Tally::metrics() const {
    nlohmann::json metrics = {{"rays", rays_},
                              {"pairs", pairs_},
                              {"decisions", decisions_},
                              {"undecided", undecided_},
                              {"missed", missed_},
                              {"spurious", spurious_},
                              {"wrong_triangle", wrong_triangle_},
                              {"differ", differ_},
                              {"nan_out", nan_out_},
                              {"self_hits", self_hits_},
                              {"t_error_of_budget", t_error_of_budget_},
                              {"hash", hash_}};
    if (!first_fault_.empty()) metrics["why"] = first_fault_;
    return metrics;
}

bool Tally::is_good(Kind kind) const {
    const bool is_decided = double(undecided_) <= open_share(kind) * double(decisions_);
    return is_decided &&
           missed_ + spurious_ + wrong_triangle_ + differ_ + nan_out_ + self_hits_ == 0;
}

}  // namespace bench::stability
