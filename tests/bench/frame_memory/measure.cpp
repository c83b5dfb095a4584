#include "frame_memory/measure.hpp"

#include <fmt/format.h>

#include <chrono>
#include <deque>

#include "frame_memory/budgets_of.hpp"
#include "frame_memory/device_bytes.hpp"
#include "frame_memory/memory_text.hpp"
#include "timing.hpp"

namespace bench::memory {
namespace {

// A budget with a context of its own, so that scratch memory of another one is not found there.
struct Entry {
    Entry(const Device& shared, Budget which) : budget(std::move(which)), device(shared, 0) {}

    Budget budget;
    Device device;
    nlohmann::json metrics = nlohmann::json::object();
    bool is_wrong = false;
    std::vector<double> ms = {};
};

size_t count_differing(const std::vector<Record>& a, const std::vector<Record>& b) {
    size_t count = 0;
    for (size_t i = 0; i < a.size(); ++i) count += a[i] != b[i];
    return count;
}

rsh_statistics count_work(BudgetedCall& call, const Entry& entry) {
    const rsh_context context = entry.device.rsh();
    rsh::check(rsh_count_statistics(context, CL_TRUE), "rsh_count_statistics");
    call.run(context, entry.budget.bytes);
    rsh_statistics statistics = rsh::make<rsh_statistics>();
    rsh::check(rsh_get_statistics(context, &statistics), "rsh_get_statistics");
    rsh::check(rsh_count_statistics(context, CL_FALSE), "rsh_count_statistics");
    return statistics;
}

// Over the time without a budget in the same round; above 1, the budget makes it slower.
Spread slowdown(const std::vector<double>& with, const std::vector<double>& without) {
    std::vector<double> ratios;
    for (size_t i = 0; i < with.size(); ++i) ratios.push_back(with[i] / without[i]);
    return spread(ratios);
}

class Measurement {
public:
    Measurement(const Run& run, const Subject& subject, BudgetedCall& call, Expected& expected)
        : run_(run), subject_(subject), call_(call), expected_(expected) {}

    void check();
    void time(const Amount& amount);
    void hand_in() const;

private:
    size_t find_least() const;
    std::string refusal_of(size_t budget) const;
    void refuse_below(size_t least) const;
    Entry& add(const Budget& budget) { return entries_.emplace_back(run_.device, budget); }
    void check(Entry& entry);
    void time(Entry& entry);
    nlohmann::json params_of(const std::string& budget) const;
    nlohmann::json times_of(const Entry& entry) const;

    const Run& run_;
    const Subject& subject_;
    BudgetedCall& call_;
    Expected& expected_;
    DeviceBytes bytes_;
    std::deque<Entry> entries_;  // that without a budget comes first
};

std::string Measurement::refusal_of(size_t budget) const {
    try {
        call_.scratch_bytes(run_.device.rsh(), budget);
    } catch (const rsh::Error& error) {
        return error.what();
    }
    return {};
}

size_t Measurement::find_least() const {
    return least_named_by(refusal_of(1));
}

// A byte less than the least is an error that names it; the least itself is none, or check() fails.
void Measurement::refuse_below(size_t least) const {
    const std::string refusal = refusal_of(least - 1);
    Case c = {subject_.case_name("below"),
              params_of("below"),
              {{"budget", least - 1}, {"refusal", refusal}}};
    c.ok = is_refusal_below(refusal, least);
    fmt::print("{}", as_text(c));
    run_.results.add(c);
}

void Measurement::check() {
    const size_t whole = call_.scratch_bytes(run_.device.rsh(), 0), least = find_least();
    refuse_below(least);
    check(add({"none", 0}));
    for (const Budget& budget : budgets_from(least, whole, subject_.factor)) check(add(budget));
}

void Measurement::check(Entry& entry) {
    const rsh_context context = entry.device.rsh();
    const size_t budget = entry.budget.bytes, allowed = call_.allowed_bytes(context, budget);
    call_.spoil_answer();
    const size_t before = bytes_.alive();
    bytes_.restart_peak();
    call_.run(context, budget);
    const size_t peak = bytes_.peak() - before;
    const std::vector<Record> answer = call_.answer();
    if (expected_.empty()) expected_ = answer;
    const size_t mismatches = count_differing(answer, expected_);
    const rsh_statistics work = count_work(call_, entry);
    entry.metrics = {{"budget", budget},
                     {"bytes_allowed", allowed},
                     {"bytes_peak", peak},
                     {"mismatches", mismatches},
                     {"parts", call_.parts()},
                     {"batches", work.batches},
                     {"pairs_peak", work.peak_pairs}};
    entry.is_wrong = mismatches > 0 || !keeps_to(allowed, peak);
}

void Measurement::time(Entry& entry) {
    entry.ms.push_back(
        milliseconds([&] { call_.run(entry.device.rsh(), entry.budget.bytes); }));
}

void Measurement::time(const Amount& amount) {
    const auto start = std::chrono::steady_clock::now();
    const auto passed = [&] {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    };
    constexpr size_t kLeastRounds = 3;
    for (size_t round = 0; round < amount.rounds; ++round) {
        if (round >= kLeastRounds && passed() > amount.seconds) break;
        if (round > 0 && run_.limit.has_passed()) break;
        time(entries_.front());
        for (size_t i = 1; i < entries_.size(); ++i)
            if (!entries_[i].is_wrong) time(entries_[i]);
    }
}

nlohmann::json Measurement::params_of(const std::string& budget) const {
    nlohmann::json params = {{"call", subject_.call},        {"scene", subject_.scene},
                             {"width", subject_.size.width}, {"height", subject_.size.height},
                             {"engine", subject_.engine},    {"budget", budget}};
    params.update(subject_.params);
    return params;
}

nlohmann::json Measurement::times_of(const Entry& entry) const {
    const Spread ms = spread(entry.ms), ratio = slowdown(entry.ms, entries_.front().ms);
    return {{"ms", ms.median},           {"ms_low", ms.low},
            {"ms_high", ms.high},        {"slowdown", ratio.median},
            {"slowdown_low", ratio.low}, {"slowdown_high", ratio.high},
            {"rounds", entry.ms.size()}};
}

void Measurement::hand_in() const {
    for (const Entry& entry : entries_) {
        const std::string& budget = entry.budget.name;
        Case done = {subject_.case_name(budget), params_of(budget), entry.metrics,
                     !entry.is_wrong};
        if (done.ok) done.metrics.update(times_of(entry));
        fmt::print("{}", as_text(done));
        run_.results.add(done);
    }
}

}  // namespace

std::string Subject::case_name(const std::string& budget) const {
    return fmt::format("memory/call:{}/scene:{}/width:{}/engine:{}/budget:{}", call, scene,
                       size.width, engine, budget);
}

void measure(const Run& run, const Subject& subject, BudgetedCall& call, const Amount& amount,
             Expected& expected) {
    Measurement measured(run, subject, call, expected);
    measured.check();
    measured.time(amount);
    measured.hand_in();
}

}  // namespace bench::memory
