// every_call.hpp - a valid call of every function of rsh.h, over small buffers, with what must come
// before and after it.
#pragma once

#include <functional>
#include <vector>

#include "api/valid_calls.hpp"

namespace test {

struct Call {
    const char* name;
    std::function<rsh_status()> run;
    std::function<void()> before = [] {};
    std::function<void()> after = [] {};  // also after a failure
};

class EveryCall {
public:
    EveryCall();

    std::vector<Call> all() const;

    // What a few calls leave on the device, to be compared with what they left before.
    std::vector<rsh_hit> traced() const;

private:
    void add_information(std::vector<Call>& calls) const;
    void add_contexts(std::vector<Call>& calls) const;
    void add_queries(std::vector<Call>& calls) const;
    void add_passes(std::vector<Call>& calls) const;
    void add_blocking(std::vector<Call>& calls) const;

    // A call that enqueues; `after` waits for what it did.
    template <class Function, class Desc>
    Call pass(const char* name, Function function, const Desc& desc) const {
        return {name, [=] { return function(rsh_.get(), queue_(), &desc, 0, nullptr, &done_); },
                [this] { done_ = nullptr; }, [this] { finish(); }};
    }
    template <class Function, class Desc>
    Call query(const char* name, Function function, const Desc& desc) const {
        return {name, [=] {
                    rsh_sizes sizes = {};
                    sizes.struct_size = sizeof sizes;
                    return function(rsh_.get(), &desc, &sizes);
                }};
    }
    rsh_bound_desc bound(cl_uint mode) const;
    rsh_build_desc build(bool is_list) const;
    rsh_traverse_desc traverse(cl_uint engine) const;
    rsh_trace_desc trace() const;
    rsh_frame_desc frame() const;
    void finish() const;

    OwnContext rsh_;
    cl::CommandQueue queue_{device().context, device().device};
    ValidCalls valid_;
    Buffer<uint8_t> box_bounds_{1u << 20}, box_nodes_{1u << 16}, list_nodes_{1u << 16};
    Buffer<float> normals_{3 * kRays}, points_{3 * kRays};
    Buffer<uint32_t> ids_{kRays};
    mutable cl_event done_ = nullptr;
    mutable rsh_context made_ = nullptr;
};

}  // namespace test
