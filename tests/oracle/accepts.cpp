#include "oracle/accepts.hpp"

#include "oracle/crossings/judge_crossings.hpp"
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

namespace {

template <class Judge>
::testing::AssertionResult no_fault(const std::vector<rsh_ray>& rays, const Judge& judge) {
    for (size_t i = 0; i < rays.size(); ++i) {
        const Verdict verdict = judge(i);
        if (verdict.fault != Fault::kNone)
            return ::testing::AssertionFailure()
                   << "ray " << i << " " << rays[i] << " " << verdict.why;
    }
    return ::testing::AssertionSuccess();
}

}  // namespace

::testing::AssertionResult all_hits_are_correct(const std::vector<Crossings>& expected,
                                                const std::vector<rsh_ray>& rays,
                                                const std::vector<uint64_t>& offsets,
                                                const std::vector<rsh_hit>& hits) {
    if (offsets.size() != rays.size() + 1 || offsets.back() != hits.size())
        return ::testing::AssertionFailure()
               << offsets.size() << " offsets and " << hits.size() << " hits of " << rays.size()
               << " rays, the last offset " << offsets.back();
    return no_fault(rays, [&](size_t i) {
        if (offsets[i] > offsets[i + 1] || offsets[i + 1] > hits.size())
            return Verdict{Fault::kSpurious, "has offsets that do not ascend"};
        return judge_all(expected[i], hits.data() + offsets[i], offsets[i + 1] - offsets[i]);
    });
}

::testing::AssertionResult counts_are_correct(const std::vector<Crossings>& expected,
                                              const std::vector<rsh_ray>& rays,
                                              const std::vector<uint32_t>& counts) {
    if (counts.size() != rays.size())
        return ::testing::AssertionFailure() << counts.size() << " counts of " << rays.size();
    return no_fault(rays, [&](size_t i) { return judge_count(expected[i], counts[i]); });
}

}  // namespace oracle
