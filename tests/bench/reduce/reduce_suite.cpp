// reduce_suite.cpp - stream by stream, everyone who takes part: checked, then timed in pairs, copy
// and contender in turn, because what is reported beside the time is a ratio.
#include "reduce/reduce_suite.hpp"

#include <fmt/format.h>

#include <cmath>

#include "limit.hpp"
#include "progress.hpp"
#include "reduce/needs.hpp"
#include "reduce/pair_stream.hpp"
#include "reduce/patterns.hpp"
#include "reduce/plugins/plugins.hpp"
#include "reduce/pyopencl_peer.hpp"
#include "timing.hpp"

namespace bench {
namespace {

constexpr size_t kLongestPairStream = 1u << 24;
constexpr double kFewestRuns = 5;  // one is checked, and of a series 4 at least

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
        rsh::check(rsh_create_context(&desc, &own_), "rsh_create_context");
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
    Track(const Device& device, const StreamSpec& spec, Keep keep)
        : stream(
              make_stream(spec, spec.pattern.rfind("pairs:", 0) == 0
                                    ? make_pair_flags(device, spec.pattern, kLongestPairStream)
                                    : make_flags(spec))),
          on_device(device, stream, keep),
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
            {"kept", stream.kept_count}};
}

class Race {
public:
    Race(const bench::Run& run, const ReduceOptions& options)
        : device_(run.device),
          limit_(run.limit),
          results_(run.results),
          rsh_(run.device, options.vector_width),
          budget_ms_(options.budget_ms > 0 ? options.budget_ms
                     : run.quick           ? 15
                                           : 150),
          pyopencl_(run.device),
          plugins_(options.plugins),
          heats_(select_heats(options, plugins_.names(), run.quick)) {}

    void run() {
        size_t cases = 0;
        for (const Heat& heat : heats_) cases += heat.contenders.size();
        ProgressBar bar(cases);
        for (const Heat& heat : heats_) {
            track_.reset();
            for (const std::string& name : heat.contenders) {
                bar.begin(title(heat, name));
                if (const std::string why = refusal(heat, name); !why.empty())
                    results_.leave_out(title(heat, name), why);
                else
                    start(heat, name);
            }
        }
        for (const Case& c : pyopencl_.run(budget_ms_, limit_, results_)) hand_in(c);
    }

private:
    // As the case will be called, unless the stream's pattern decides about count and share.
    static std::string title(const Heat& heat, const std::string& name) {
        const StreamSpec& s = heat.stream;
        return title(name, s.count, s.bytes, s.keep_percent, s.pattern, heat.keep);
    }
    static std::string title(const std::string& name, cl_uint count, cl_uint bytes,
                             double percent, const std::string& pattern, Keep keep) {
        return fmt::format("reduce/strategy:{}/n:{}/bytes:{}/keep:{}/pattern:{}/by:{}", name,
                           count, bytes, percent, pattern, name_of(keep));
    }

    std::string refusal(const Heat& heat, const std::string& name) const {
        const std::string late = estimate_.refusal(limit_, name, double(heat.stream.count));
        if (!late.empty()) return late;
        return memory_refusal(device_.memory(), buffers_of(heat, name, rsh_.get()),
                              host_bytes_of(heat, name));
    }

    // An error of the device makes a wrong case: the others may run all the same.
    void start(const Heat& heat, const std::string& name) {
        try {
            if (!track_) track_ = std::make_unique<Track>(device_, heat.stream, heat.keep);
            if (name == "peer:pyopencl")
                hand_over(*track_, name, heat.keep);
            else
                race(*track_, name, heat.keep);
        } catch (const std::exception& error) {
            Stream unmade;
            unmade.spec = heat.stream;
            Case failed = describe(name, track_ ? track_->stream : unmade, heat.keep);
            failed.ok = false;
            failed.metrics["error"] = describe_error(error);
            hand_in(failed);
        }
    }

    // Patterns with a density of their own report that.
    static Case describe(const std::string& name, const Stream& stream, Keep keep) {
        const StreamSpec& spec = stream.spec;
        const bool is_own = spec.pattern.find(':') != std::string::npos;
        const double percent =
            is_own ? std::round(stream.kept_percent() * 10) / 10 : double(spec.keep_percent);
        return {title(name, stream.count(), spec.bytes, percent, spec.pattern, keep),
                {{"strategy", name},
                 {"n", stream.count()},
                 {"bytes", spec.bytes},
                 {"keep", percent},
                 {"pattern", spec.pattern},
                 {"keep_by", name_of(keep)}},
                nlohmann::json::object()};
    }

    void hand_over(const Track& now, const std::string& name, Keep keep) {
        if (pyopencl_.is_there() && PyopenclPeer::takes(now.stream.spec))
            pyopencl_.add(now.stream, describe(name, now.stream, keep));
    }

    // Null if it cannot take the stream. Plug-ins say why.
    std::unique_ptr<Contender> make(const std::string& name, const Track& now) {
        if (!plugins_.has(name))
            return make_contender(name, device_, rsh_.get(), now.on_device);
        std::string refusal;
        auto contender = plugins_.make(name, device_, now.on_device, refusal);
        if (!contender)
            results_.leave_out(describe(name, now.stream, now.on_device.keep).name, refusal);
        return contender;
    }

    void race(Track& now, const std::string& name, Keep keep) {
        const auto contender = make(name, now);
        if (!contender) return;
        Case result = describe(name, now.stream, keep);
        spoil_answer(device_, now.on_device);
        contender->run();
        const double check_ms = milliseconds([&] { result.ok = contender->is_right(); });
        if (!result.ok) return hand_in(result);
        PairedTimes times;
        times.run_series([&] { now.copy->run(); }, [&] { contender->run(); }, budget_ms_, 200);
        const double pair_ms = times.base_ms().median + times.work_ms().median;
        estimate_.add(name, now.stream.count(), 1e-3 * (check_ms + kFewestRuns * pair_ms));
        result.metrics = metrics_of(times, now.stream);
        if (const cl_ulong launches = contender->launches())
            result.metrics["launches"] = launches;
        hand_in(result);
    }

    void hand_in(const Case& c) {
        if (c.metrics.contains("error"))
            fmt::print("{}\n    {}\n", c.name, c.metrics["error"].get<std::string>());
        if (c.ok)
            fmt::print("{}\n    {:.3f} ms, {:.2f} G elements/s, {:.2f} of the copy\n", c.name,
                       c.metrics["ms"].get<double>(),
                       1e-9 * c.metrics["elements_per_s"].get<double>(),
                       c.metrics["ratio_to_copy"].get<double>());
        results_.add(c);
    }

    const Device& device_;
    const Limit& limit_;
    Results& results_;
    WidthContext rsh_;
    double budget_ms_;
    PyopenclPeer pyopencl_;
    Plugins plugins_;
    std::vector<Heat> heats_;
    std::unique_ptr<Track> track_;
    Estimate estimate_;
};

}  // namespace

void ReduceSuite::add_options(CLI::App& app) {
    CLI::Option* const count =
        app.add_option("--n", options_.counts, "Elements, e.g. 65536,4194304")->delimiter(',');
    app.add_option("--bytes", options_.bytes, "Bytes per element: 4, 8, 12, 16")
        ->delimiter(',')
        ->check(CLI::IsMember({4, 8, 12, 16}));
    CLI::Option* const keep = app.add_option("--keep", options_.keeps, "Percents kept")
                                  ->delimiter(',')
                                  ->check(CLI::Range(0, 100));
    CLI::Option* const pattern =
        app.add_option("--pattern", options_.patterns,
                       "random, runs, alternating, sorted, mask:NAME, pairs:SCENE:LEVEL")
            ->delimiter(',');
    app.add_option("--strategy", options_.contenders,
                   "Strategies and peers; own: all of the library")
        ->delimiter(',');
    app.add_option("--keep-by", options_.keep_by, "not_null, flags, bits")->delimiter(',');
    app.add_option("--budget", options_.budget_ms, "Milliseconds of timing per case");
    app.add_option("--vector-width", options_.vector_width,
                   "Of the library's kernels: 1 shows those for GPUs");
    app.add_option("--streams", options_.streams,
                   "Reduce the files of this folder: .flags, .pairs, .pbm, .pgm")
        ->excludes(count)
        ->excludes(keep)
        ->excludes(pattern);
    app.add_option("--plugin", options_.plugins,
                   "Shared objects with reductions that take part: rsh_bench_plugin.h")
        ->delimiter(',');
    add_dump(app);
}

void ReduceSuite::add_dump(CLI::App& app) {
    CLI::Option* const folder = app.add_option(
        "--dump", options_.dump,
        "Reduce nothing: write the pairs of --scene to this folder, a file per level");
    CLI::Option* const scenes =
        app.add_option("--scene", options_.scenes, "Names of samples/scenes, for --dump")
            ->delimiter(',');
    folder->needs(scenes);
    scenes->needs(folder);
}

void ReduceSuite::run(const bench::Run& run) {
    if (!options_.dump.empty()) {
        for (const std::string& scene : options_.scenes)
            dump_pair_streams(run.device, scene, options_.dump);
        return;
    }
    Race race(run, options_);
    race.run();
}

}  // namespace bench
