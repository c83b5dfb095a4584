// closest.cpp - gathers what every ray may hit, and judges answers by it.
#include "oracle/closest.hpp"

#include <algorithm>
#include <atomic>
#include <thread>

#include "oracle/filter.hpp"
#include "support/compare.hpp"

namespace oracle {
namespace {

constexpr size_t kRaysAtOnce = 16;

struct Found {
    uint32_t triangle;
    Candidate candidate;
};

Answer judge(const std::vector<Found>& found) {
    Answer answer;
    double t = std::numeric_limits<double>::infinity();
    const Found* certain = nullptr;
    for (const Found& f : found) {
        const bool nearer =
            f.candidate.t < t || (f.candidate.t == t && f.triangle < answer.primitive);
        if (f.candidate.exact && nearer)
            t = answer.t = f.candidate.t, answer.primitive = f.triangle;
        if (f.candidate.certain && f.candidate.t_high < answer.certain_by)
            answer.certain_by = f.candidate.t_high, certain = &f;
    }
    answer.possible = !found.empty();
    for (const Found& f : found)
        if (&f != certain && f.candidate.t_low <= answer.certain_by) answer.ambiguous = true;
    return answer;
}

// All blocks against a few rays at a time, so that a block is read from memory once for them.
void answer_rays(const std::vector<Block>& blocks, const test::Mesh& mesh,
                 const std::vector<rsh_ray>& rays, const std::vector<uint32_t>& skip,
                 size_t first, std::vector<Answer>* answers) {
    const size_t last = std::min(first + kRaysAtOnce, rays.size());
    std::vector<Found> found[kRaysAtOnce];
    std::vector<uint32_t> passed;
    for (const Block& block : blocks)
        for (size_t i = first; i < last; ++i) {
            if (!test::is_active(rays[i])) continue;
            passed.clear();
            filter(block, rays[i], &passed);
            for (const uint32_t triangle : passed) {
                test::Corners corners;
                if (!mesh.corners(triangle, &corners)) continue;
                if (!skip.empty() && skip[i] == triangle) continue;
                const Candidate candidate = intersect(rays[i], corners);
                if (candidate.possible) found[i - first].push_back({triangle, candidate});
            }
        }
    for (size_t i = first; i < last; ++i) (*answers)[i] = judge(found[i - first]);
}

// Empty when the hit is right.
std::string objection(const Answer& answer, const test::Mesh& mesh, const rsh_ray& ray,
                      const rsh_hit& hit) {
    if (hit.primitive == RSH_NO_HIT)
        return std::isinf(answer.certain_by) ? "" : "misses a certain hit";
    test::Corners corners;
    if (hit.primitive >= mesh.triangle_count() || !mesh.corners(hit.primitive, &corners))
        return "names no valid triangle";
    const Candidate c = intersect(ray, corners);
    if (!c.possible) return "cannot hit that triangle";
    if (!(hit.t >= c.t_low && hit.t <= c.t_high))
        return "t is wrong, exactly " + std::to_string(c.t);
    if (hit.t > answer.certain_by) return "lies behind a certain hit";
    if (!(std::fabs(hit.u - c.u) <= c.uv_error && std::fabs(hit.v - c.v) <= c.uv_error))
        return "u, v are wrong, exactly " + std::to_string(c.u) + ", " + std::to_string(c.v);
    if (!answer.ambiguous && hit.primitive != answer.primitive) return "is the wrong triangle";
    return "";
}

}  // namespace

std::vector<Answer> closest(const test::Mesh& mesh, const std::vector<rsh_ray>& rays,
                            const std::vector<uint32_t>& skip) {
    const std::vector<Block> blocks = make_blocks(mesh);
    std::vector<Answer> answers(rays.size());
    std::atomic<size_t> next{0};
    const auto work = [&] {
        for (size_t first; (first = next.fetch_add(kRaysAtOnce)) < rays.size();)
            answer_rays(blocks, mesh, rays, skip, first, &answers);
    };
    std::vector<std::thread> threads;
    for (unsigned i = 1; i < std::thread::hardware_concurrency(); ++i)
        threads.emplace_back(work);
    work();
    for (std::thread& thread : threads) thread.join();
    return answers;
}

::testing::AssertionResult hits_are_correct(const std::vector<Answer>& answers,
                                            const test::Mesh& mesh,
                                            const std::vector<rsh_ray>& rays,
                                            const std::vector<rsh_hit>& hits) {
    size_t wrong = 0;
    ::testing::AssertionResult result = ::testing::AssertionFailure();
    for (size_t i = 0; i < rays.size(); ++i) {
        const std::string why = objection(answers[i], mesh, rays[i], hits[i]);
        if (why.empty() || wrong++ > 0) continue;
        result << "ray " << i << " " << rays[i] << ": hit " << hits[i] << " " << why
               << "; oracle: primitive " << answers[i].primitive << ", t " << answers[i].t
               << (answers[i].ambiguous ? ", ambiguous" : ", the only correct answer");
    }
    if (wrong == 0) return ::testing::AssertionSuccess();
    return result << "; " << wrong << " of " << rays.size() << " rays are wrong";
}

::testing::AssertionResult occlusion_is_correct(const std::vector<Answer>& answers,
                                                const std::vector<rsh_ray>& rays,
                                                const std::vector<uint32_t>& masks,
                                                uint32_t bit) {
    for (size_t i = 0; i < rays.size(); ++i) {
        const bool hit = masks[i] >> bit & 1;
        const bool certain = !std::isinf(answers[i].certain_by);
        if (hit ? answers[i].possible : !certain) continue;
        return ::testing::AssertionFailure()
               << "ray " << i << " " << rays[i]
               << (hit ? " hits nothing" : " misses a certain hit") << ", oracle: primitive "
               << answers[i].primitive << ", t " << answers[i].t;
    }
    return ::testing::AssertionSuccess();
}

double ambiguous_share(const std::vector<Answer>& answers) {
    size_t count = 0;
    for (const Answer& answer : answers) count += answer.ambiguous;
    return answers.empty() ? 0.0 : double(count) / double(answers.size());
}

}  // namespace oracle
