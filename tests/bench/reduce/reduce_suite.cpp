// reduce_suite.cpp - the cases and how one is run: checked, then timed in pairs with a copy by
// Google Benchmark.
#include "reduce/reduce_suite.hpp"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <random>

#include "progress.hpp"
#include "timing.hpp"

namespace bench {
namespace {

struct Stream {
    cl_uint count, keep_percent;
    std::vector<cl_uint> input, expected;
    std::vector<cl_uchar> flags;
};

Stream make_stream(cl_uint count, cl_uint keep_percent) {
    Stream stream = {count, keep_percent, {}, {}, {}};
    std::mt19937 random(count + keep_percent);
    for (cl_uint i = 0; i < count; ++i) {
        const bool keeps = random() % 100 < keep_percent;
        stream.input.push_back(i);
        stream.flags.push_back(keeps);
        if (keeps) stream.expected.push_back(i);
    }
    return stream;
}

// A stream on the device and the strategy that reduces it.
class Reduction {
public:
    Reduction(const Device& device, cl_uint strategy, Stream& stream)
        : device_(device),
          stream_(stream),
          input_(device.context(), CL_MEM_COPY_HOST_PTR, bytes(), stream.input.data()),
          flags_(device.context(), CL_MEM_COPY_HOST_PTR, stream.count, stream.flags.data()),
          output_(device.context(), CL_MEM_READ_WRITE, bytes()),
          kept_(device.context(), CL_MEM_READ_WRITE, sizeof(cl_uint)) {
        desc_.struct_size = sizeof desc_;
        desc_.strategy = strategy;
        desc_.keep = RSH_KEEP_FLAGS;
        desc_.element_bytes = sizeof(cl_uint);
        desc_.count = stream.count;
        desc_.input = input_();
        desc_.flags = flags_();
        desc_.output = output_();
        desc_.output_count = kept_();
    }

    void reduce() const {
        require(rsh_reduce(device_.rsh(), device_.queue()(), &desc_, 0, nullptr, nullptr),
                "rsh_reduce");
        device_.queue().finish();
    }
    void copy() const {
        device_.queue().enqueueCopyBuffer(input_, output_, 0, 0, bytes());
        device_.queue().finish();
    }
    bool is_right() const {
        reduce();
        cl_uint count = 0;
        device_.queue().enqueueReadBuffer(kept_, CL_TRUE, 0, sizeof count, &count);
        if (count != stream_.expected.size()) return false;
        std::vector<cl_uint> output(count);
        if (count > 0)
            device_.queue().enqueueReadBuffer(output_, CL_TRUE, 0, count * sizeof(cl_uint),
                                              output.data());
        return output == stream_.expected;
    }

private:
    size_t bytes() const { return stream_.count * sizeof(cl_uint); }

    const Device& device_;
    Stream& stream_;
    cl::Buffer input_, flags_, output_, kept_;
    rsh_reduce_desc desc_{};
};

void time_case(benchmark::State& state, const Device& device, cl_uint strategy, Stream& stream,
               Case& result) {
    const Reduction reduction(device, strategy, stream);
    result.ok = reduction.is_right();
    if (!result.ok) {
        state.SkipWithError("wrong answer");
        return;
    }
    PairedTimes times;
    for (auto _ : state)
        state.SetIterationTime(
            times.run_pair([&] { reduction.copy(); }, [&] { reduction.reduce(); }));
    const Spread ms = times.work_ms();
    result.metrics = {{"ms", ms.median},
                      {"ms_low", ms.low},
                      {"ms_high", ms.high},
                      {"elements_per_s", stream.count / ms.median * 1e3},
                      {"ratio_to_copy", times.ratio().median}};
}

// Shows where the run is; the times are kept by the cases.
class Progress final : public benchmark::BenchmarkReporter {
public:
    explicit Progress(size_t cases) : bar_(cases) {}
    bool ReportContext(const Context&) override { return true; }
    void ReportRuns(const std::vector<benchmark::BenchmarkReporter::Run>& runs) override {
        bar_.begin("after " + runs.front().benchmark_name());
    }

private:
    ProgressBar bar_;
};

}  // namespace

void ReduceSuite::add_options(CLI::App&) {}

std::vector<Case> ReduceSuite::run(const bench::Run& run) {
    std::vector<Stream> streams;
    for (const cl_uint keep : {10u, 50u, 90u}) streams.push_back(make_stream(1u << 20, keep));
    std::vector<cl_uint> strategies;
    for (cl_uint id = 1; rsh_strategy_name(id); ++id) strategies.push_back(id);
    std::vector<Case> cases(streams.size() * strategies.size());
    size_t at = 0;
    for (Stream& stream : streams)
        for (const cl_uint strategy : strategies) {
            Case& result = cases[at++];
            const char* name = rsh_strategy_name(strategy);
            result.name = fmt::format("reduce/strategy:{}/n:{}/bytes:4/keep:{}/pattern:random",
                                      name, stream.count, stream.keep_percent);
            result.params = {{"strategy", name},
                             {"n", stream.count},
                             {"bytes", 4},
                             {"keep", stream.keep_percent},
                             {"pattern", "random"}};
            benchmark::RegisterBenchmark(
                result.name.c_str(),
                [&run, strategy, &stream, &result](benchmark::State& state) {
                    time_case(state, run.device, strategy, stream, result);
                })
                ->UseManualTime()
                ->Iterations(run.quick ? 10 : 50);
        }
    Progress progress(cases.size());
    benchmark::RunSpecifiedBenchmarks(&progress);
    return cases;
}

}  // namespace bench
