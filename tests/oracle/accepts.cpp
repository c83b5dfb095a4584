#include "oracle/accepts.hpp"

#include "oracle/judge.hpp"
#include "support/compare.hpp"

namespace oracle {

::testing::AssertionResult hits_are_correct(const std::vector<Answer>& answers,
                                            const test::Mesh& mesh,
                                            const std::vector<rsh_ray>& rays,
                                            const std::vector<rsh_hit>& hits) {
    size_t wrong = 0;
    ::testing::AssertionResult result = ::testing::AssertionFailure();
    for (size_t i = 0; i < rays.size(); ++i) {
        const Verdict verdict = judge_hit(answers[i], mesh, rays[i], hits[i]);
        if (verdict.fault == Fault::kNone || wrong++ > 0) continue;
        result << "ray " << i << " " << rays[i] << ": hit " << hits[i] << " " << verdict.why
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
        const Verdict verdict = judge_occlusion(answers[i], masks[i] >> bit & 1);
        if (verdict.fault == Fault::kNone) continue;
        return ::testing::AssertionFailure()
               << "ray " << i << " " << rays[i] << " " << verdict.why << ", oracle: primitive "
               << answers[i].primitive << ", t " << answers[i].t;
    }
    return ::testing::AssertionSuccess();
}

}  // namespace oracle
