#include "ablation/measure.hpp"

#include <fmt/format.h>

#include <ctime>
#include <stdexcept>

#include "ablation/ablation_text.hpp"
#include "ablation/unseen_kernels.hpp"
#include "timing.hpp"

namespace bench::ablation {
namespace {

struct Entry {
    const State& state;
    std::unique_ptr<Work> work;
    nlohmann::json metrics = nlohmann::json::object();
    bool ok = true;
    std::vector<double> ms = {};
};

rsh_statistics counted(rsh_context context, Work& work) {
    rsh::check(rsh_count_statistics(context, CL_TRUE), "rsh_count_statistics");
    work.run(context);
    rsh_statistics statistics = rsh::make<rsh_statistics>();
    rsh::check(rsh_get_statistics(context, &statistics), "rsh_get_statistics");
    rsh::check(rsh_count_statistics(context, CL_FALSE), "rsh_count_statistics");
    return statistics;
}

// Of the whole process.
double cpu_ms() {
    return 1000.0 * double(std::clock()) / CLOCKS_PER_SEC;
}

rsh_context_desc context_desc(const Device& device, bool is_general) {
    rsh_context_desc desc = rsh::make<rsh_context_desc>();
    desc.context = device.context()();
    desc.device = device.device()();
    if (is_general) desc.max_variants = RSH_NO_VARIANTS;
    return desc;
}

rsh::Context fresh_context(const Device& device, bool is_general, const std::string& kernels) {
    rsh_context_desc desc = context_desc(device, is_general);
    desc.cache_dir = "";
    desc.kernel_dir = kernels.c_str();
    return rsh::Context(desc);
}

double cpu_ms_of_run(rsh_context context, Work& work) {
    const double start = cpu_ms();
    work.run(context);
    return cpu_ms() - start;
}

Compiled compile(const Device& device, Work& work, bool is_general, bool finishes) {
    const UnseenKernels kernels;
    const rsh::Context context = fresh_context(device, is_general, kernels.folder());
    rsh::check(rsh_count_statistics(context.get(), CL_TRUE), "rsh_count_statistics");
    Compiled taken;
    const double start = cpu_ms();
    work.prepare(context.get());
    taken.compile_ms = cpu_ms() - start;
    rsh_statistics statistics = rsh::make<rsh_statistics>();
    rsh::check(rsh_get_statistics(context.get(), &statistics), "rsh_get_statistics");
    taken.programs = size_t(statistics.programs_built);
    if (!finishes) return taken;
    const double first = cpu_ms_of_run(context.get(), work);
    taken.finish_ms = first - cpu_ms_of_run(context.get(), work);
    return taken;
}

class FeatureRun {
public:
    FeatureRun(const Run& run, const Stage& stage, const Feature& feature)
        : run_(run),
          feature_(feature),
          special_(stage.device.rsh()),
          general_(context_desc(stage.device, true)) {
        for (const State& state : feature.states) {
            if (state.make)
                entries_.push_back({state, state.make(stage)});
            else
                run.results.leave_out(case_name(feature, state), state.why_not);
        }
    }

    void check();
    void compile(CompiledBy& known, bool finishes);
    void time(size_t rounds);
    void hand_in();

private:
    void run_once(Entry& entry) const;
    rsh_context context_of(const Entry& entry) const {
        return entry.state.is_general ? general_.get() : special_;
    }

    const Run& run_;
    const Feature& feature_;
    const rsh_context special_;
    const rsh::Context general_;
    std::vector<Entry> entries_;
};

// What the scene does not have must not show.
void FeatureRun::check() {
    std::vector<uint8_t> absent;
    for (Entry& entry : entries_) {
        const rsh_context context = context_of(entry);
        entry.work->run(context);
        entry.metrics["is_right"] = entry.ok = entry.work->is_right(context);
        if (entry.state.name != std::string(kUsed)) {
            const std::vector<uint8_t> answer = entry.work->answer();
            if (absent.empty()) absent = answer;
            entry.metrics["is_same"] = answer == absent;
            entry.ok &= answer == absent;
        }
        entry.metrics["bytes"] = entry.work->bytes();
        entry.metrics["launches"] = counted(context, *entry.work).launches;
    }
}

void FeatureRun::compile(CompiledBy& known, bool finishes) {
    for (Entry& entry : entries_) {
        const bool is_general = entry.state.is_general;
        const std::string programs = entry.work->programs() + (is_general ? " general" : "");
        if (known.count(programs) == 0)
            known[programs] = ablation::compile(run_.device, *entry.work, is_general, finishes);
        const Compiled& taken = known[programs];
        entry.metrics["compile_ms"] = taken.compile_ms;
        if (finishes) entry.metrics["finish_ms"] = taken.finish_ms;
        entry.metrics["programs"] = taken.programs;
    }
}

void FeatureRun::run_once(Entry& entry) const {
    entry.ms.push_back(milliseconds([&] {
        if (entry.state.is_counted)
            counted(context_of(entry), *entry.work);
        else
            entry.work->run(context_of(entry));
    }));
}

// Each state is first, second and third equally often.
void FeatureRun::time(size_t rounds) {
    for (const Entry& entry : entries_)
        if (!entry.ok) return;
    for (size_t round = 0; round < rounds; ++round)
        for (size_t k = 0; k < entries_.size(); ++k)
            run_once(entries_[(round + k) % entries_.size()]);
    for (Entry& entry : entries_) {
        std::vector<double> ratios;
        for (size_t round = 0; round < rounds; ++round)
            ratios.push_back(entry.ms[round] / entries_[0].ms[round]);
        const Spread ms = spread(entry.ms), ratio = spread(ratios);
        entry.metrics["ms"] = ms.median;
        entry.metrics["ms_low"] = ms.low;
        entry.metrics["ms_high"] = ms.high;
        entry.metrics["ratio"] = ratio.median;
        entry.metrics["ratio_low"] = ratio.low;
        entry.metrics["ratio_high"] = ratio.high;
        entry.metrics["rounds"] = rounds;
    }
}

void FeatureRun::hand_in() {
    for (const Entry& entry : entries_) {
        const Case made = {case_name(feature_, entry.state),
                           {{"feature", feature_.name}, {"state", entry.state.name}},
                           entry.metrics,
                           entry.ok};
        fmt::print("{}", as_text(made));
        run_.results.add(made);
    }
}

}  // namespace

std::string case_name(const Feature& feature, const State& state) {
    return fmt::format("ablation/feature:{}/state:{}", feature.name, state.name);
}

void measure(const Run& run, const Stage& stage, const Feature& feature, const Amount& amount,
             CompiledBy& known) {
    FeatureRun one(run, stage, feature);
    one.check();
    one.compile(known, amount.finishes);
    one.time(amount.rounds);
    one.hand_in();
}

}  // namespace bench::ablation
