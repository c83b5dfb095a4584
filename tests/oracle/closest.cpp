// closest.cpp - sums up what every ray may hit.
#include "oracle/closest.hpp"

#include "oracle/found.hpp"

namespace oracle {
namespace {

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

}  // namespace

std::vector<Answer> closest(const test::Mesh& mesh, const std::vector<rsh_ray>& rays,
                            const std::vector<uint32_t>& skip, Denormals denormals) {
    std::vector<Answer> answers(rays.size());
    find_all(mesh, rays, skip, denormals,
             [&](size_t ray, std::vector<Found>& found) { answers[ray] = summary(found); });
    return answers;
}

double ambiguous_share(const std::vector<Answer>& answers) {
    size_t count = 0;
    for (const Answer& answer : answers) count += answer.ambiguous;
    return answers.empty() ? 0.0 : double(count) / double(answers.size());
}

}  // namespace oracle
