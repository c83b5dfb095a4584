// automatic.cpp - picks a strategy for a stream: by the device and by the longest that the
// stream may be, here; by how much of a tile is kept, in the kernels (reduce/range.h). Never
// one that the self-test found wrong.
#include <array>
#include <stdexcept>

#include "device/error.hpp"
#include "reduce/launch.hpp"

namespace rsh {

#define RSH_ROW(strategy) const Strategy& strategy();
#include "reduce/list.inc"
#undef RSH_ROW

namespace {

// Up to here one launch by one core beats two.
constexpr cl_uint kShort = 1u << 16;

std::array<const Strategy*, 3> preferred(const Context& context, cl_uint count) {
    if (!has_single_items(context)) return {{&scan_scatter(), &lookback(), &chunk()}};
    if (count <= kShort) return {{&chunk(), &lookback(), &scan_scatter()}};
    return {{&lookback(), &chunk(), &scan_scatter()}};
}

class Automatic final : public Strategy {
public:
    cl_uint id() const noexcept override { return RSH_STRATEGY_AUTO; }
    const char* name() const noexcept override { return "auto"; }
    bool is_stable() const noexcept override { return true; }

    const Strategy& chosen(const Context& context, cl_uint count,
                           cl_uint unsafe) const override {
        for (const Strategy* strategy : preferred(context, count))
            if (!(unsafe >> strategy->id() & 1)) return *strategy;
        throw Error(
            RSH_UNSUPPORTED,
            "strategy: is auto, but rsh_device_selftest found all that it picks from to "
            "be wrong on this device; must be another one");
    }

    void reserve(Layout&, const Context&, const ReduceShape&) const override { refuse(); }
    void enqueue(Recorder&, const ReduceStream&, const Scratch&) const override { refuse(); }

private:
    [[noreturn]] static void refuse() { throw std::logic_error("auto is yet to be chosen"); }
};

}  // namespace

const Strategy& automatic() {
    static const Automatic strategy;
    return strategy;
}

}  // namespace rsh
