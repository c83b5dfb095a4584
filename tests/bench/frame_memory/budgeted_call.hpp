// budgeted_call.hpp - a call of the library that takes a budget of memory, on one scene with one engine.
// It brings no scratch memory: the library allocates all that the call needs.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "frame/ray_maker.hpp"

namespace bench::memory {

using Record = std::array<cl_uint, 4>;  // a pixel or a hit, bit for bit

class BudgetedCall {
public:
    virtual ~BudgetedCall() = default;
    // Waits for its end. 0: without a budget.
    virtual void run(rsh_context context, size_t budget) = 0;
    // Bytes of scratch memory that the query asks for. Throws rsh::Error where it refuses the budget.
    virtual size_t scratch_bytes(rsh_context context, size_t budget) = 0;
    // Most bytes that it may allocate with that budget.
    virtual size_t allowed_bytes(rsh_context context, size_t budget) = 0;
    // Waves of rays or batches of triangles of the last run, as it told its progress.
    virtual size_t parts() const = 0;
    // Lest a run that writes nothing leave the answer of the one before.
    virtual void spoil_answer() = 0;
    virtual std::vector<Record> answer() const = 0;
};

// rsh_frame, whose budget is of all its scratch memory. Reads the scene's shadows and reflections.
std::unique_ptr<BudgetedCall> make_frame_call(const Device& device, const SceneOnDevice& scene,
                                              Size size, cl_uint bounces, cl_uint engine);

// rsh_trace of rays that outlive it, whose budget is of the streams of pairs alone: what it may allocate
// is what the query asks for.
std::unique_ptr<BudgetedCall> make_trace_call(const Device& device, const SceneOnDevice& scene,
                                              const RayMaker& rays, cl_uint engine);

}  // namespace bench::memory
