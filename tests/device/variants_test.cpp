// variants_test.cpp - which programs a context compiles for scenes that differ in their features: at most
// as many variants as it allows, and the general program where one is missing. That it gives the same
// bits: shade/general_test.cpp.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <future>
#include <memory>
#include <string>
#include <thread>

#include "api/calls.hpp"
#include "api/valid_calls.hpp"
#include "support/changed_kernels.hpp"
#include "support/prepare.hpp"

namespace {

using test::device;
using test::prepare_desc;
using test::programs_of;
using test::statistics_of;

constexpr rsh_features kAll = RSH_FEATURE_ALL;
constexpr rsh_features kFlat = kAll & ~RSH_FEATURE_SMOOTH_NORMAL;
constexpr rsh_features kPlain = kFlat & ~RSH_FEATURE_TEXTURE;

rsh_context_desc at_most(cl_uint variants) {
    rsh_context_desc desc = {};
    desc.max_variants = variants;
    return desc;
}

// A call that runs one kernel of a variant.
class OneKernel {
public:
    explicit OneKernel(rsh_features features) : scene_(valid_.scene.desc) {
        scene_.features = features;
        desc_ = valid_.find_surfaces();
        desc_.scene = &scene_;
    }
    OneKernel(const OneKernel&) = delete;
    OneKernel& operator=(const OneKernel&) = delete;

    rsh_status call(rsh_context context) const {
        const cl::CommandQueue queue(device().context, device().device);
        const rsh_status status =
            rsh_find_surfaces(context, queue(), &desc_, 0, nullptr, nullptr);
        queue.finish();
        return status;
    }
    // Programs: both, where it is `general`.
    rsh_status prepare(rsh_context context, bool general, bool background) const {
        rsh_prepare_desc prepare = prepare_desc();
        prepare.find_surfaces = &desc_;
        prepare.general = general;
        prepare.background = background;
        return rsh_prepare(context, &prepare);
    }
    const rsh_find_surfaces_desc& desc() const { return desc_; }

private:
    const test::ValidCalls valid_;
    rsh_scene scene_;
    rsh_find_surfaces_desc desc_;
};

// Counts the log's lines that say that a variant, or with `is_of_general` a general program, was
// compiled; holds the next one, whose program no call can take before.
class Compiled {
public:
    static void log(const char* message, void* user) {
        static_cast<Compiled*>(user)->hear(message);
    }

    void hold_next() { is_holding_ = true; }
    void wait_for_held() { is_held_.get_future().wait(); }
    void let_go() { may_go_on_.set_value(); }
    int variants() const { return variants_; }
    int failures() const { return failures_; }

private:
    void hear(const std::string& line) {
        if (line.find("variant fails") != std::string::npos) ++failures_;
        if (line.find("compiled in") == std::string::npos ||
            line.find("RSH_SMOOTH_NORMAL") == std::string::npos)
            return;
        ++variants_;
        if (!is_holding_.exchange(false)) return;
        is_held_.set_value();
        may_go_on_.get_future().wait();
    }

    std::atomic<bool> is_holding_{false};
    std::atomic<int> variants_{0}, failures_{0};
    std::promise<void> is_held_, may_go_on_;
};

rsh_context_desc heard_by(Compiled& compiled) {
    rsh_context_desc desc = {};
    desc.cache_dir = "";
    desc.log = Compiled::log;
    desc.log_user = &compiled;
    return desc;
}

TEST(Variants, AreAtMostAsManyAsTheContextAllows) {
    const test::OwnContext own(at_most(1));
    RSH_CHECK(rsh_count_statistics(own.get(), CL_TRUE));
    for (const rsh_features features : {kAll, kAll, kFlat, kPlain, kAll})
        RSH_CHECK(OneKernel(features).call(own.get()));
    const rsh_statistics sums = statistics_of(own.get());
    EXPECT_EQ(sums.variants, 1u);
    EXPECT_EQ(programs_of(own.get()), 2u) << "the variant and the general program";
    EXPECT_EQ(sums.general_launches, 2u) << "of flat and plain";
}

TEST(Variants, AreNoneWhereTheContextWantsNone) {
    const test::OwnContext own(at_most(RSH_NO_VARIANTS));
    RSH_CHECK(OneKernel(kAll).call(own.get()));
    RSH_CHECK(OneKernel(kFlat).prepare(own.get(), false, false));
    RSH_CHECK(OneKernel(kFlat).call(own.get()));
    EXPECT_EQ(statistics_of(own.get()).variants, 0u);
    EXPECT_EQ(programs_of(own.get()), 1u);
}

// Without rsh_prepare nothing is compiled for a call but what it runs.
TEST(Variants, AreCompiledByTheCallsThatNeedThem) {
    const test::OwnContext own;
    RSH_CHECK(rsh_count_statistics(own.get(), CL_TRUE));
    for (const rsh_features features : {kAll, kFlat, kPlain}) {
        RSH_CHECK(OneKernel(features).call(own.get()));
        RSH_CHECK(rsh_wait_prepared(own.get()));
    }
    const rsh_statistics sums = statistics_of(own.get());
    EXPECT_EQ(sums.variants, 3u);
    EXPECT_EQ(programs_of(own.get()), 3u);
    EXPECT_EQ(sums.general_launches, 0u);
}

TEST(Variants, FollowTheGeneralProgramOnceThatIsPrepared) {
    Compiled compiled;
    const test::OwnContext own(heard_by(compiled));
    const OneKernel flat(kFlat);
    RSH_CHECK(OneKernel(kAll).prepare(own.get(), true, false));
    EXPECT_EQ(programs_of(own.get()), 2u);
    RSH_CHECK(rsh_count_statistics(own.get(), CL_TRUE));
    compiled.hold_next();
    std::future<rsh_status> call =
        std::async(std::launch::async, [&] { return flat.call(own.get()); });
    compiled.wait_for_held();
    EXPECT_EQ(call.wait_for(std::chrono::minutes(2)), std::future_status::ready)
        << "it waits for the variant";
    EXPECT_EQ(statistics_of(own.get()).variants, 1u);
    RSH_CHECK(flat.call(own.get()));
    RSH_CHECK(OneKernel(kAll).call(own.get()));
    EXPECT_EQ(statistics_of(own.get()).general_launches, 2u);
    compiled.let_go();
    EXPECT_EQ(call.get(), RSH_SUCCESS);
    RSH_CHECK(rsh_wait_prepared(own.get()));
    RSH_CHECK(flat.call(own.get()));
    const rsh_statistics sums = statistics_of(own.get());
    EXPECT_EQ(sums.variants, 2u);
    EXPECT_EQ(sums.general_launches, 2u) << "the variant is there by now";
    EXPECT_EQ(compiled.variants(), 2) << "each is compiled once";
}

TEST(Variants, DoNotFollowWhereTheyAreTooMany) {
    const test::OwnContext own(at_most(1));
    RSH_CHECK(OneKernel(kAll).prepare(own.get(), true, false));
    RSH_CHECK(OneKernel(kFlat).call(own.get()));
    RSH_CHECK(OneKernel(kFlat).prepare(own.get(), false, false));
    RSH_CHECK(rsh_wait_prepared(own.get()));
    EXPECT_EQ(statistics_of(own.get()).variants, 1u);
    EXPECT_EQ(programs_of(own.get()), 2u);
}

// The programs that have no variant come with the general one, before the variants.
TEST(Variants, ArePreparedLast) {
    std::vector<std::string> lines;
    rsh_context_desc desc = {};
    desc.cache_dir = "";
    desc.log = [](const char* line, void* user) {
        static_cast<std::vector<std::string>*>(user)->push_back(line);
    };
    desc.log_user = &lines;
    const test::OwnContext own(desc);
    const OneKernel surfaces(kAll);
    const test::ValidCalls valid;
    const rsh_reduce_desc reduce = valid.reduce();
    rsh_prepare_desc prepare = prepare_desc();
    prepare.find_surfaces = &surfaces.desc();
    prepare.reduce = &reduce;
    prepare.general = CL_TRUE;
    RSH_CHECK(rsh_prepare(own.get(), &prepare));
    ASSERT_EQ(lines.size(), 3u);
    const auto has = [&](size_t line, const char* word) {
        return lines[line].find(word) != std::string::npos;
    };
    EXPECT_TRUE(has(0, "programs/surface") && !has(0, "RSH_SMOOTH_NORMAL")) << lines[0];
    EXPECT_TRUE(has(1, "reduce/")) << lines[1];
    EXPECT_TRUE(has(2, "programs/surface") && has(2, "RSH_SMOOTH_NORMAL")) << lines[2];
}

// Calls compile the general program themselves where the thread has not come to it.
TEST(Variants, AreNotWaitedForWhileTheGeneralProgramIsStillToCome) {
    const test::OwnContext own;
    RSH_CHECK(rsh_count_statistics(own.get(), CL_TRUE));
    RSH_CHECK(OneKernel(kAll).prepare(own.get(), true, true));
    const rsh_status status = OneKernel(kFlat).call(own.get());
    EXPECT_EQ(status, RSH_SUCCESS);
    EXPECT_EQ(statistics_of(own.get()).general_launches, 1u);
    RSH_CHECK(rsh_wait_prepared(own.get()));
    EXPECT_EQ(statistics_of(own.get()).variants, 2u);
    EXPECT_EQ(programs_of(own.get()), 3u);
}

TEST(Variants, ThatFailAreLeftToTheGeneralProgram) {
    Compiled compiled;
    const test::ChangedKernels broken("surface/features.h", "#define RSH_BY_SCENE 2",
                                      "#define RSH_BY_SCENE 2\n"
                                      "#ifdef RSH_SMOOTH_NORMAL\n#error broken\n#endif",
                                      Compiled::log, &compiled);
    const OneKernel flat(kFlat);
    EXPECT_EQ(OneKernel(kAll).prepare(broken.context(), true, false), RSH_BUILD_FAILED);
    test::expect_said({"programs/surface", "RSH_SMOOTH_NORMAL=1"});
    EXPECT_EQ(programs_of(broken.context()), 2u) << "with the variant, which is tried";
    for (int i = 0; i < 3; ++i) {
        RSH_CHECK(flat.call(broken.context()));
        EXPECT_EQ(rsh_wait_prepared(broken.context()), RSH_SUCCESS) << "nobody asked for it";
    }
    EXPECT_EQ(programs_of(broken.context()), 3u) << "it is tried once";
    EXPECT_EQ(compiled.failures(), 1);
    EXPECT_EQ(statistics_of(broken.context()).variants, 0u);
    EXPECT_EQ(flat.prepare(broken.context(), false, true), RSH_SUCCESS);
    EXPECT_EQ(rsh_wait_prepared(broken.context()), RSH_BUILD_FAILED) << "now it was asked for";
}

TEST(Variants, AreCompiledByCallsWhereTheGeneralProgramFails) {
    const test::ChangedKernels broken("surface/features.h", "#define RSH_BY_SCENE 2",
                                      "#define RSH_BY_SCENE 2\n"
                                      "#ifndef RSH_SMOOTH_NORMAL\n#error broken\n#endif");
    const OneKernel flat(kFlat);
    EXPECT_EQ(OneKernel(kAll).prepare(broken.context(), true, false), RSH_BUILD_FAILED);
    for (int i = 0; i < 2; ++i) RSH_CHECK(flat.call(broken.context()));
    RSH_CHECK(rsh_wait_prepared(broken.context()));
    EXPECT_EQ(statistics_of(broken.context()).variants, 2u);
    EXPECT_EQ(programs_of(broken.context()), 4u) << "the general one is tried once more";
}

// Threads that need each variant and the same ones.
TEST(Variants, OfSeveralThreadsAreEachCompiledOnce) {
    Compiled compiled;
    const test::OwnContext own(heard_by(compiled));
    RSH_CHECK(OneKernel(kAll).prepare(own.get(), true, true));
    std::vector<std::future<rsh_status>> calls;
    for (int thread = 0; thread < 4; ++thread)
        calls.push_back(std::async(std::launch::async, [&own, thread] {
            rsh_status status = RSH_SUCCESS;
            const OneKernel first(thread % 2 ? kFlat : kPlain), second(kAll);
            for (int i = 0; i < 8 && status == RSH_SUCCESS; ++i)
                status = (i % 2 ? second : first).call(own.get());
            return status;
        }));
    for (auto& call : calls) EXPECT_EQ(call.get(), RSH_SUCCESS);
    RSH_CHECK(rsh_wait_prepared(own.get()));
    EXPECT_EQ(statistics_of(own.get()).variants, 3u);
    EXPECT_EQ(compiled.variants(), 3);
    EXPECT_EQ(programs_of(own.get()), 4u);
}

TEST(Variants, AreWaitedForWhenTheContextIsReleased) {
    Compiled compiled;
    auto own = std::make_unique<test::OwnContext>(heard_by(compiled));
    RSH_CHECK(OneKernel(kAll).prepare(own->get(), true, false));
    compiled.hold_next();
    RSH_CHECK(OneKernel(kFlat).call(own->get()));
    compiled.wait_for_held();
    RSH_CHECK(OneKernel(kPlain).call(own->get()));
    std::future<void> released = std::async(std::launch::async, [&own] { own.reset(); });
    EXPECT_EQ(released.wait_for(std::chrono::milliseconds(200)), std::future_status::timeout);
    compiled.let_go();
    released.wait();
    EXPECT_EQ(compiled.variants(), 2) << "the last one is compiled for nobody";
}

}  // namespace
