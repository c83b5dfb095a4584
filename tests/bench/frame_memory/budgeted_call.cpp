// budgeted_call.cpp - descriptors of both calls, and the buffer that takes the answer.
#include "frame_memory/budgeted_call.hpp"

#include "scene/device_structs.hpp"

namespace bench::memory {
namespace {

static_assert(sizeof(Record) == sizeof(rsh_hit) && sizeof(Record) == sizeof(cl_float4),
              "an answer is an array of records");

// A record per pixel.
class Answer {
public:
    Answer(const Device& device, size_t count)
        : queue_(device.queue()),
          count_(count),
          buffer_(device.context(), CL_MEM_READ_WRITE, count * sizeof(Record)) {}

    cl_mem get() const { return buffer_(); }
    void spoil() { queue_.enqueueFillBuffer(buffer_, cl_uint{0xa5a5a5a5}, 0, bytes()); }
    std::vector<Record> read() const {
        std::vector<Record> records(count_);
        queue_.enqueueReadBuffer(buffer_, CL_TRUE, 0, bytes(), records.data());
        return records;
    }

private:
    size_t bytes() const { return count_ * sizeof(Record); }

    cl::CommandQueue queue_;
    size_t count_;
    cl::Buffer buffer_;
};

int count_part(cl_uint, cl_uint, void* parts) {
    ++*static_cast<size_t*>(parts);
    return 0;
}

template <class Desc, rsh::Query<Desc> kQuery, rsh::Call<Desc> kCall>
class Call : public BudgetedCall {
public:
    Call(const Device& device, Size size) : answer_(device, size.pixels()), device_(device) {
        desc_.width = size.width;
        desc_.height = size.height;
        desc_.progress = count_part;
        desc_.progress_user = &parts_;
    }
    Call(const Call&) = delete;
    Call& operator=(const Call&) = delete;

    void run(rsh_context context, size_t budget) override {
        parts_ = 0;
        desc_.budget = budget;
        rsh::check(kCall(context, device_.queue()(), &desc_, 0, nullptr, nullptr));
        device_.queue().finish();
    }
    size_t scratch_bytes(rsh_context context, size_t budget) override {
        desc_.budget = budget;
        return rsh::sizes_of(kQuery, context, desc_).scratch_bytes;
    }
    size_t parts() const override { return parts_; }
    void spoil_answer() override { answer_.spoil(); }
    std::vector<Record> answer() const override { return answer_.read(); }

protected:
    Answer answer_;
    Desc desc_ = rsh::make<Desc>();

private:
    const Device& device_;
    size_t parts_ = 0;
};

class Frame final : public Call<rsh_frame_desc, rsh_frame_query, rsh_frame> {
public:
    Frame(const Device& device, const SceneOnDevice& scene, Size size, cl_uint bounces,
          cl_uint engine)
        : Call(device, size) {
        desc_.scene = &scene.scene();
        desc_.camera = render::device_camera(scene.frame_scene().camera(),
                                             float(size.width) / float(size.height));
        desc_.bounces = bounces;
        desc_.engine = engine;
        desc_.colour = answer_.get();
    }
    size_t allowed_bytes(rsh_context context, size_t budget) override {
        return budget > 0 ? budget : scratch_bytes(context, 0);
    }
};

class Trace final : public Call<rsh_trace_desc, rsh_trace_query, rsh_trace> {
public:
    Trace(const Device& device, const SceneOnDevice& scene, const RayMaker& rays,
          cl_uint engine)
        : Call(device, rays.size()) {
        desc_.geometry = scene.geometry();
        desc_.rays = rays.buffer()();
        desc_.engine = engine;
        desc_.hits = answer_.get();
    }
    size_t allowed_bytes(rsh_context context, size_t budget) override {
        return scratch_bytes(context, budget);
    }
};

}  // namespace

std::unique_ptr<BudgetedCall> make_frame_call(const Device& device, const SceneOnDevice& scene,
                                              Size size, cl_uint bounces, cl_uint engine) {
    return std::make_unique<Frame>(device, scene, size, bounces, engine);
}

std::unique_ptr<BudgetedCall> make_trace_call(const Device& device, const SceneOnDevice& scene,
                                              const RayMaker& rays, cl_uint engine) {
    return std::make_unique<Trace>(device, scene, rays, engine);
}

}  // namespace bench::memory
