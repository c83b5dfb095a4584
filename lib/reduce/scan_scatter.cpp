// scan_scatter.cpp - prefix sums in work-groups, then scatter (reduce/scan_scatter.cl). The
// usual choice on devices with many small cores.
#include <algorithm>

#include "reduce/launch.hpp"

namespace rsh {
namespace {

cl_uint group_count(const Context& context, cl_uint count) {
    return std::clamp(divided_up(count, group_tile(context)), 1u, most_scan_groups(context));
}

class ScanScatter final : public Strategy {
public:
    cl_uint id() const noexcept override { return RSH_STRATEGY_SCAN_SCATTER; }
    const char* name() const noexcept override { return "scan_scatter"; }
    bool is_stable() const noexcept override { return true; }

    void reserve(Layout& scratch, const Context& context,
                 const ReduceShape& shape) const override {
        scratch.add_array<cl_uint>("reduce counts", group_count(context, shape.count));
    }

    void enqueue(Recorder& recorder, const ReduceStream& stream,
                 const Scratch& scratch) const override {
        const Context& context = recorder.context();
        const cl_uint count = group_count(context, stream.count);
        const cl_mem counts = scratch["reduce counts"];
        const auto kernel = [&](const char* name) {
            return kernel_for(stream, "reduce/scan_scatter", name);
        };
        launch(recorder, stream, kernel("rsh_reduce_scan_scatter_count"),
               groups(context, count), counts, group_words(context));
        scan_counts(recorder, stream, counts, count);
        launch(recorder, stream, kernel("rsh_reduce_scan_scatter_write"),
               groups(context, count), counts, stream.output, group_words(context));
    }
};

}  // namespace

const Strategy& scan_scatter() {
    static const ScanScatter strategy;
    return strategy;
}

}  // namespace rsh
