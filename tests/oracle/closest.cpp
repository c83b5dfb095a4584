// closest.cpp - gathers what every ray may hit.
#include "oracle/closest.hpp"

#include <algorithm>

#include "oracle/filter.hpp"
#include "oracle/on_all_cores.hpp"

namespace oracle {
namespace {

constexpr size_t kRaysAtOnce = 16;

struct Found {
    uint32_t triangle;
    Candidate candidate;
};

Answer summary(const std::vector<Found>& found) {
    Answer answer;
    double t = std::numeric_limits<double>::infinity();
    const Found* certain = nullptr;
    for (const Found& f : found) {
        const bool nearer =
            f.candidate.t < t || (f.candidate.t == t && f.triangle < answer.primitive);
        if (f.candidate.exact && nearer)
            t = answer.t = f.candidate.t, answer.primitive = f.triangle;
        if (!f.candidate.certain) ++answer.undecided;
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
                 Denormals denormals, size_t first, std::vector<Answer>* answers) {
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
                const Candidate candidate = intersect(rays[i], corners, denormals);
                if (candidate.possible) found[i - first].push_back({triangle, candidate});
            }
        }
    for (size_t i = first; i < last; ++i) (*answers)[i] = summary(found[i - first]);
}

}  // namespace

std::vector<Answer> closest(const test::Mesh& mesh, const std::vector<rsh_ray>& rays,
                            const std::vector<uint32_t>& skip, Denormals denormals) {
    const std::vector<Block> blocks = make_blocks(mesh);
    std::vector<Answer> answers(rays.size());
    on_all_cores((rays.size() + kRaysAtOnce - 1) / kRaysAtOnce, [&](size_t i) {
        answer_rays(blocks, mesh, rays, skip, denormals, i * kRaysAtOnce, &answers);
    });
    return answers;
}

double ambiguous_share(const std::vector<Answer>& answers) {
    size_t count = 0;
    for (const Answer& answer : answers) count += answer.ambiguous;
    return answers.empty() ? 0.0 : double(count) / double(answers.size());
}

}  // namespace oracle
