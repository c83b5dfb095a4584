// strips.cpp - asks rsh_frame_query what fits.
#include "device/strips.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace render {
namespace {

constexpr uint32_t kLeastRows = 64;  // as PictureWriter takes them, and rsh_frame cuts
constexpr size_t kDefaultMost = size_t{3} << 29;
constexpr size_t kShareOfColours = 8;  // of the budget, its inverse

size_t default_budget(const rsh::Device& device) {
    const cl::Device own(device.device(), /*retainObject=*/true);
    const cl_ulong quarter = own.getInfo<CL_DEVICE_GLOBAL_MEM_SIZE>() / 4;
    const cl_ulong largest = own.getInfo<CL_DEVICE_MAX_MEM_ALLOC_SIZE>();
    return std::min<cl_ulong>({quarter, largest, kDefaultMost});
}

// Of a strip: once on the device, once on the host.
size_t colour_bytes(const rsh_frame_desc& picture, uint32_t rows) {
    return 2 * sizeof(rsh_float4) * picture.width * rows;
}

// What rsh_frame takes for so many rows of the picture; 0: it cannot with that budget.
size_t scratch_bytes(const rsh::Device& device, rsh_frame_desc picture, const StripPlan& plan) {
    picture.window = {0, 0, picture.width, picture.height};
    picture.height = plan.rows;
    picture.budget = plan.frame_budget;
    auto sizes = rsh::make<rsh_sizes>();
    const rsh_status status = rsh_frame_query(device.rsh(), &picture, &sizes);
    return status == RSH_SUCCESS ? sizes.scratch_bytes : 0;
}

uint32_t rows_by_share(const rsh_frame_desc& picture, size_t budget) {
    const size_t step = kShareOfColours * colour_bytes(picture, kLeastRows);
    const size_t rows = std::max<size_t>(budget / step, 1) * kLeastRows;
    return static_cast<uint32_t>(std::min<size_t>(rows, picture.height));
}

size_t least_budget(const rsh::Device& device, const rsh_frame_desc& picture, uint32_t rows) {
    const auto fits = [&](size_t bytes) {
        return scratch_bytes(device, picture, {rows, bytes}) > 0;
    };
    size_t most = 1;
    while (!fits(most)) most *= 2;
    size_t least = most / 2;  // does not fit
    while (most - least > 1) {
        const size_t middle = least + (most - least) / 2;
        (fits(middle) ? most : least) = middle;
    }
    return most + colour_bytes(picture, rows);
}

}  // namespace

StripPlan plan_strips(const rsh::Device& device, const rsh_frame_desc& picture, size_t budget) {
    const size_t most = budget ? budget : default_budget(device);
    const StripPlan whole{picture.height, 0};
    if (!budget &&
        colour_bytes(picture, whole.rows) + scratch_bytes(device, picture, whole) <= most)
        return whole;
    const uint32_t least_rows = std::min(kLeastRows, picture.height);
    for (const uint32_t rows : {rows_by_share(picture, most), least_rows}) {
        const size_t colours = colour_bytes(picture, rows);
        const StripPlan plan{rows, most - std::min(most, colours)};
        if (plan.frame_budget > 0 && scratch_bytes(device, picture, plan) > 0) return plan;
    }
    if (budget)
        throw std::runtime_error(fmt::format(
            "--budget: is {} bytes, must be 0 or at least {} for {} rows of {} pixels", budget,
            least_budget(device, picture, least_rows), least_rows, picture.width));
    return {least_rows, 0};
}

}  // namespace render
