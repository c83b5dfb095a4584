#include "reduce/selftest.hpp"

#include <algorithm>
#include <cstring>

#include "device/error.hpp"
#include "device/objects/host_read.hpp"
#include "reduce/launch.hpp"

namespace rsh {
namespace {

constexpr cl_uint kCanary = 0xa5a5a5a5u;
constexpr cl_uint kGuard = 64;  // elements behind the longest output that must stay as they are

// What drivers got wrong before: groups that are not full, conditional stores to local memory,
// scans over several blocks, loops around barriers, counts that only the device knows.
struct Pattern {
    const char* name;
    bool (*keeps)(cl_uint i, cl_uint length);
};
const Pattern kPatterns[] = {
    {"none", [](cl_uint, cl_uint) { return false; }},
    {"all", [](cl_uint, cl_uint) { return true; }},
    {"every second", [](cl_uint i, cl_uint) { return i % 2 == 1; }},
    {"the last", [](cl_uint i, cl_uint length) { return i + 1 == length; }},
    {"scattered", [](cl_uint i, cl_uint) { return (i * 2654435761u >> 16) % 5 < 2; }},
};

struct Stream {
    std::string name;
    cl_uint length;  // on the device; the host says `count`
    cl_uint count;
    std::vector<cl_uchar> flags;
    std::vector<cl_uint> expected;
};

// Distinct, and no element is its index.
cl_uint element(cl_uint i) {
    return i * 2654435761u + 12345u;
}

Stream make_stream(const Pattern& pattern, cl_uint length, cl_uint count) {
    Stream stream = {std::to_string(length) + " elements, kept: " + pattern.name,
                     length,
                     count,
                     std::vector<cl_uchar>(count, 1),
                     {}};
    for (cl_uint i = 0; i < length; ++i) {
        stream.flags[i] = pattern.keeps(i, length);
        if (stream.flags[i]) stream.expected.push_back(element(i));
    }
    return stream;
}

constexpr cl_uint kLong = 70001;

// On a device with many compute units, each group of scan_scatter takes a single tile of kLong
// elements: its loop goes round from here on.
cl_uint several_tiles_per_group(const Context& context) {
    return 2 * most_scan_groups(context) * group_tile(context) + 3;
}

// The longest last.
std::vector<Stream> make_streams(const Context& context) {
    const cl_uint group = static_cast<cl_uint>(context.caps.group_size);
    const Pattern& scattered = kPatterns[4];
    std::vector<Stream> streams;
    for (const cl_uint length : {1u, group - 1, group, group + 1, 4 * group + 3, 4099u, kLong})
        for (const Pattern& pattern : kPatterns)
            streams.push_back(make_stream(pattern, length, length));
    for (const cl_uint length : {0u, 4099u})
        streams.push_back(make_stream(scattered, length, kLong));
    const cl_uint longest = several_tiles_per_group(context);
    if (longest > kLong) streams.push_back(make_stream(scattered, longest, longest));
    return streams;
}

class Bench {
public:
    Bench(Context& context, cl_command_queue queue, cl_uint longest)
        : context_(context), queue_(queue), room_(longest + kGuard) {
        finish();  // what the caller enqueued, and may fail, is not the strategies' fault
        std::vector<cl_uint> elements(longest);
        for (cl_uint i = 0; i < longest; ++i) elements[i] = element(i);
        input_ = buffer_of(elements);
    }

    // What is wrong with the answer; "" if nothing is.
    std::string try_strategy(const Strategy& strategy, const Stream& stream) {
        const Buffer flags = buffer_of(stream.flags);
        const Buffer counts = buffer_of(std::vector<cl_uint>{stream.length, kCanary});
        const Buffer output = buffer_of(std::vector<cl_uint>(room_, kCanary));
        const bool is_known = stream.length == stream.count;
        run(strategy,
            {RSH_KEEP_FLAGS, sizeof(cl_uint), stream.count, is_known ? nullptr : counts.get(),
             input_.get(), flags.get(), output.get(), counts.get(), 1, nullptr});
        const std::vector<cl_uint> kept = read(counts.get(), 2);
        return compare(strategy, stream.expected, kept[1], read(output.get(), room_));
    }

private:
    // With its contents from the beginning: a write that failed might still read them later.
    template <class Item>
    Buffer buffer_of(const std::vector<Item>& items) const {
        return new_buffer(context_.cl.get(), CL_MEM_READ_WRITE, items.size() * sizeof(Item),
                          items.data());
    }

    void finish() const { require_success(opencl(queue_).clFinish(queue_), "clFinish"); }

    std::vector<cl_uint> read(cl_mem buffer, size_t word_count) const {
        const HostRead read(queue_, buffer, word_count, {0, nullptr});
        const cl_uint* const words = read.wait();
        return {words, words + word_count};
    }

    void run(const Strategy& strategy, const ReduceStream& stream) const {
        Recorder recorder(context_, {queue_, 0, nullptr}, nullptr);
        Layout layout(context_.caps.alignment);
        strategy.reserve(layout, context_, {stream.count, sizeof(cl_uint)});
        const Scratch scratch(recorder, layout, nullptr);
        strategy.enqueue(recorder, stream, scratch);
        finish();
    }

    static std::string compare(const Strategy& strategy, std::vector<cl_uint> expected,
                               cl_uint kept, std::vector<cl_uint> found) {
        if (kept != expected.size())
            return "count is " + std::to_string(kept) + ", must be " +
                   std::to_string(expected.size());
        if (!strategy.is_stable()) {
            std::sort(expected.begin(), expected.end());
            std::sort(found.begin(), found.begin() + kept);
        }
        expected.resize(found.size(), kCanary);
        const auto wrong = std::mismatch(found.begin(), found.end(), expected.begin());
        if (wrong.first == found.end()) return "";
        return "element " + std::to_string(wrong.first - found.begin()) + " is " +
               std::to_string(*wrong.first) + ", must be " + std::to_string(*wrong.second);
    }

    Context& context_;
    cl_command_queue queue_;
    cl_uint room_;
    Buffer input_;
};

// A driver may also refuse to compile or to run what it cannot do. Host memory that is short is no
// fault of the strategy's.
std::string first_failure(Bench& bench, const Strategy& strategy,
                          const std::vector<Stream>& streams, cl_uint& cases) {
    try {
        for (const Stream& stream : streams) {
            ++cases;
            const std::string wrong = bench.try_strategy(strategy, stream);
            if (!wrong.empty()) return stream.name + ": " + wrong;
        }
        return "";
    } catch (const Error& error) {
        return error.what();
    }
}

}  // namespace

void selftest(Context& context, cl_command_queue queue, rsh_selftest& report) {
    const std::vector<Stream> streams = make_streams(context);
    Bench bench(context, queue, streams.back().count);
    for (const Strategy* strategy : strategies()) {
        if (strategy->id() == RSH_STRATEGY_AUTO) continue;
        const std::string failure = first_failure(bench, *strategy, streams, report.cases);
        report.tested_strategies |= 1u << strategy->id();
        if (failure.empty()) continue;
        report.unsafe_strategies |= 1u << strategy->id();
        const std::string text = std::string(strategy->name()) + ": " + failure;
        context.log("strategy masked: " + text);
        if (report.first_failure[0] == '\0')
            std::strncpy(report.first_failure, text.c_str(), sizeof report.first_failure - 1);
    }
    context.unsafe_strategies = report.unsafe_strategies;
}

}  // namespace rsh
