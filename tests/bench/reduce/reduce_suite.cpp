// reduce_suite.cpp - runs the cases by Google Benchmark. One iteration is a series of pairs, copy
// and contender in turn: what is reported beside the time is a ratio, and that needs pairs.
#include "reduce/reduce_suite.hpp"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cmath>
#include <deque>

#include "progress.hpp"
#include "reduce/pair_stream.hpp"
#include "reduce/patterns.hpp"
#include "reduce/pyopencl_peer.hpp"
#include "timing.hpp"

namespace bench {
namespace {

constexpr size_t kLongestPairStream = 1u << 24;

// An rsh_context with the vector width that was asked for, or the device's own.
class WidthContext {
public:
    WidthContext(const Device& device, cl_uint width) : context_(device.rsh()) {
        if (width == 0) return;
        rsh_context_desc desc{};
        desc.struct_size = sizeof desc;
        desc.context = device.context()();
        desc.device = device.device()();
        desc.vector_width = width;
        require(rsh_create_context(&desc, &own_), "rsh_create_context");
        context_ = own_;
    }
    ~WidthContext() { rsh_release_context(own_); }
    WidthContext(const WidthContext&) = delete;
    WidthContext& operator=(const WidthContext&) = delete;

    rsh_context get() const { return context_; }

private:
    rsh_context own_ = nullptr;
    rsh_context context_;
};

// The stream that is being worked on, and the copy that it is compared with.
struct Track {
    Track(const Device& device, const StreamSpec& spec)
        : stream(
              make_stream(spec, spec.pattern.rfind("pairs:", 0) == 0
                                    ? make_pair_flags(device, spec.pattern, kLongestPairStream)
                                    : make_flags(spec))),
          on_device(device, stream),
          copy(make_copy("peer:copy", device, on_device, on_device.copied)) {}

    Stream stream;
    DeviceStream on_device;
    std::unique_ptr<Contender> copy;
};

nlohmann::json metrics_of(const PairedTimes& times, const Stream& stream) {
    const Spread ms = times.work_ms(), ratio = times.ratio();
    return {{"ms", ms.median},
            {"ms_low", ms.low},
            {"ms_high", ms.high},
            {"elements_per_s", stream.count() / ms.median * 1e3},
            {"ratio_to_copy", ratio.median},
            {"ratio_low", ratio.low},
            {"ratio_high", ratio.high},
            {"copy_ms", times.base_ms().median},
            {"pairs", times.pairs()},
            {"kept", stream.kept_count()}};
}

bool same(const StreamSpec& a, const StreamSpec& b) {
    return a.pattern == b.pattern && a.bytes == b.bytes && a.keep_percent == b.keep_percent &&
           (a.count == b.count || a.count == 0 || b.count == 0);
}

class Race {
public:
    Race(const bench::Run& run, const ReduceOptions& options)
        : device_(run.device),
          rsh_(run.device, options.vector_width),
          budget_ms_(options.budget_ms > 0 ? options.budget_ms
                     : run.quick           ? 15
                                           : 150),
          pyopencl_(run.device),
          heats_(select_heats(options, run.quick)) {
        for (const Heat& heat : heats_)
            for (const std::string& name : heat.contenders) add(heat, name);
    }

    std::vector<Case> run() {
        Progress progress(cases_.size());
        benchmark::RunSpecifiedBenchmarks(&progress);
        std::vector<Case> done;
        for (const Case& c : cases_)
            if (is_done(c)) done.push_back(c);
        for (const Case& c : pyopencl_.run(budget_ms_)) done.push_back(c);
        return done;
    }

private:
    // Shows where the run is; the times are kept by the cases.
    class Progress final : public benchmark::BenchmarkReporter {
    public:
        explicit Progress(size_t cases) : bar_(cases) { bar_.begin("the first"); }
        bool ReportContext(const Context&) override { return true; }
        void ReportRuns(const std::vector<benchmark::BenchmarkReporter::Run>& runs) override {
            bar_.begin("after " + runs.front().benchmark_name());
        }

    private:
        ProgressBar bar_;
    };

    // A contender that could not take the stream leaves no case behind.
    static bool is_done(const Case& c) { return !c.params.is_null(); }

    void add(const Heat& heat, const std::string& name) {
        Case& result = cases_.emplace_back();
        const std::string title =
            fmt::format("reduce/strategy:{}/n:{}/bytes:{}/keep:{}/pattern:{}/by:{}", name,
                        heat.stream.count, heat.stream.bytes, heat.stream.keep_percent,
                        heat.stream.pattern, name_of(heat.keep));
        benchmark::RegisterBenchmark(title.c_str(),
                                     [this, &heat, name, &result](benchmark::State& state) {
                                         work(state, heat, name, result);
                                     })
            ->UseManualTime()
            ->Iterations(1);
    }

    Track& track(const StreamSpec& spec) {
        if (track_ && same(track_->stream.spec, spec)) return *track_;
        track_.reset();
        track_ = std::make_unique<Track>(device_, spec);
        return *track_;
    }

    // Patterns with a density of their own report that.
    static void describe(Case& result, const std::string& name, const Stream& stream,
                         Keep keep) {
        const StreamSpec& spec = stream.spec;
        const bool is_own = spec.pattern.find(':') != std::string::npos;
        const double percent =
            is_own ? std::round(stream.kept_percent() * 10) / 10 : double(spec.keep_percent);
        result.params = {{"strategy", name},        {"n", stream.count()},
                         {"bytes", spec.bytes},     {"keep", percent},
                         {"pattern", spec.pattern}, {"keep_by", name_of(keep)}};
        result.name =
            fmt::format("reduce/strategy:{}/n:{}/bytes:{}/keep:{}/pattern:{}/by:{}", name,
                        stream.count(), spec.bytes, percent, spec.pattern, name_of(keep));
    }

    void work(benchmark::State& state, const Heat& heat, const std::string& name,
              Case& result) {
        Track& now = track(heat.stream);
        double seconds = 0;
        if (name == "peer:pyopencl")
            hand_over(now, name, heat.keep);
        else
            seconds = race(now, name, heat.keep, result);
        if (!result.ok) {
            state.SkipWithError("wrong answer");
            return;
        }
        for (auto _ : state) state.SetIterationTime(seconds);
    }

    void hand_over(const Track& now, const std::string& name, Keep keep) {
        if (!pyopencl_.is_there() || !PyopenclPeer::takes(now.stream.spec)) return;
        Case named;
        describe(named, name, now.stream, keep);
        pyopencl_.add(now.stream, named);
    }

    double race(Track& now, const std::string& name, Keep keep, Case& result) {
        const auto contender = make_contender(name, device_, rsh_.get(), now.on_device, keep);
        if (!contender) return 0;
        describe(result, name, now.stream, keep);
        contender->run();
        result.ok = contender->is_right();
        if (!result.ok) return 0;
        PairedTimes times;
        times.run_series([&] { now.copy->run(); }, [&] { contender->run(); }, budget_ms_, 200);
        result.metrics = metrics_of(times, now.stream);
        if (const cl_ulong launches = contender->launches())
            result.metrics["launches"] = launches;
        return times.work_ms().median * 1e-3;
    }

    const Device& device_;
    WidthContext rsh_;
    double budget_ms_;
    PyopenclPeer pyopencl_;
    std::vector<Heat> heats_;
    std::deque<Case> cases_;  // stay where they are
    std::unique_ptr<Track> track_;
};

}  // namespace

void ReduceSuite::add_options(CLI::App& app) {
    app.add_option("--n", options_.counts, "Elements, e.g. 65536,4194304")->delimiter(',');
    app.add_option("--bytes", options_.bytes, "Bytes per element: 4, 8, 12, 16")
        ->delimiter(',')
        ->check(CLI::IsMember({4, 8, 12, 16}));
    app.add_option("--keep", options_.keeps, "Percents kept")
        ->delimiter(',')
        ->check(CLI::Range(0, 100));
    app.add_option("--pattern", options_.patterns,
                   "random, runs, alternating, sorted, mask:NAME, pairs:SCENE:LEVEL")
        ->delimiter(',');
    app.add_option("--strategy", options_.contenders, "Strategies and peers")->delimiter(',');
    app.add_option("--keep-by", options_.keep_by, "not_null, flags, bits")->delimiter(',');
    app.add_option("--budget", options_.budget_ms, "Milliseconds of timing per case");
    app.add_option("--vector-width", options_.vector_width,
                   "Of the library's kernels: 1 shows those for GPUs");
}

std::vector<Case> ReduceSuite::run(const bench::Run& run) {
    Race race(run, options_);
    return race.run();
}

}  // namespace bench
