// tally.hpp - what a case adds up: rays, decisions of the oracle, and every kind of fault. Knows no
// device.
#pragma once

#include <nlohmann/json.hpp>

#include "oracle/judge.hpp"
#include "stability/all_hits.hpp"
#include "stability/expected.hpp"
#include "stability/spawned/spawn_faults.hpp"

namespace bench::stability {

// Active rays, times triangles.
uint64_t count_pairs(const Scene& scene);

// `reference`: what brute force answers.
class Tally {
public:
    void add_hits(const Scene& scene, const Expected& expected,
                  const std::vector<rsh_hit>& reference, const std::vector<rsh_hit>& hits);
    void add_occlusion(const Scene& scene, const Expected& expected,
                       const std::vector<rsh_hit>& reference,
                       const std::vector<cl_uint>& masks);
    void add_counts(const Scene& scene, const Expected& expected, const AllHits& reference,
                    const std::vector<cl_uint>& counts);
    void add_all(const Scene& scene, const Expected& expected, const AllHits& reference,
                 const AllHits& all);

    // Of the rays themselves, the same for all engines.
    void add_spawned(const SpawnFaults& faults);

    nlohmann::json metrics() const;
    // Undecided pairs are a fault on lattices, and beyond 1e-4 where rays are random.
    bool is_good(Kind kind) const;

private:
    void add_scene(const Scene& scene, const Expected& expected, uint64_t undecided);
    void add(const oracle::Verdict& verdict, size_t ray);
    void check_parity(const Scene& scene, const Expected& expected, size_t ray, uint64_t count);
    void check_self_hit(const Scene& scene, size_t ray, uint32_t hit);
    void check_hit(const Scene& scene, size_t ray, const rsh_hit& hit);
    void note(size_t ray, const std::string& fault);
    void add_hash(const std::string& hash);

    uint64_t rays_ = 0, pairs_ = 0, decisions_ = 0, undecided_ = 0;
    uint64_t missed_ = 0, spurious_ = 0, wrong_triangle_ = 0, differ_ = 0, nan_out_ = 0,
             self_hits_ = 0;
    double t_error_of_budget_ = 0;
    std::string hash_;
    std::string first_fault_;
};

}  // namespace bench::stability
