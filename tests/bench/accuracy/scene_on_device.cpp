#include "accuracy/scene_on_device.hpp"

#include "support/placed_scene.hpp"
#include "timing.hpp"
#include "upload.hpp"

namespace bench::accuracy {
namespace {

template <class T>
std::vector<T> read(const Device& device, const cl::Buffer& buffer, size_t count) {
    std::vector<T> items(count);
    device.queue().enqueueReadBuffer(buffer, CL_TRUE, 0, count * sizeof(T), items.data());
    return items;
}

template <class Query, class Desc>
cl::Buffer scratch_of(const Device& device, Query query, const Desc& desc) {
    rsh_sizes sizes = rsh::make<rsh_sizes>();
    rsh::check(query(device.rsh(), &desc, &sizes), "the query of scratch");
    if (sizes.scratch_bytes == 0) return cl::Buffer();
    return cl::Buffer(device.context(), CL_MEM_READ_WRITE, sizes.scratch_bytes);
}

}  // namespace

Image image_of(const std::vector<cl_float4>& pixels, uint32_t width, uint32_t height) {
    Image image = {width, height, {}};
    for (const cl_float4& p : pixels) image.pixels.push_back({p.s[0], p.s[1], p.s[2]});
    return image;
}

SceneOnDevice::SceneOnDevice(const Device& device, const Staged& staged)
    : device_(device), camera_(staged.camera) {
    const test::Scene& scene = staged.scene;
    scene_ = test::placed(scene, [this](const auto& items) {
        buffers_.push_back(upload(device_, items));
        return buffers_.back()();
    });
    rsh::check(rsh_find_features(&scene_, scene.materials.data(), scene.lights.data()),
               "rsh_find_features");
}

rsh_scene SceneOnDevice::without(rsh_features features) const {
    rsh_scene scene = scene_;
    scene.features &= ~features;
    if (features & RSH_FEATURE_SHADOW) scene.shadow_lights = 0;
    return scene;
}

std::vector<rsh_ray> SceneOnDevice::first_rays(cl_uint width, cl_uint height,
                                               std::vector<rsh_hit>* hits) const {
    const size_t count = size_t{width} * height;
    const cl::Buffer rays(device_.context(), CL_MEM_READ_WRITE, count * sizeof(rsh_ray));
    const cl::Buffer found(device_.context(), CL_MEM_READ_WRITE, count * sizeof(rsh_hit));
    rsh_rasterize_desc desc = rsh::make<rsh_rasterize_desc>();
    desc.geometry = scene_.geometry;
    desc.camera = camera_;
    desc.width = width;
    desc.height = height;
    desc.rays = rays();
    desc.hits = found();
    rsh::check(rsh_rasterize(device_.rsh(), device_.queue()(), &desc, 0, nullptr, nullptr),
               "rsh_rasterize");
    *hits = read<rsh_hit>(device_, found, count);
    return read<rsh_ray>(device_, rays, count);
}

FrameOnDevice::FrameOnDevice(const SceneOnDevice& scene, cl_uint width, cl_uint height,
                             const Setting& setting)
    : device_(scene.device()), scene_(scene.without(setting.without)) {
    desc_ = rsh::make<rsh_frame_desc>();
    desc_.scene = &scene_;
    desc_.camera = scene.camera();
    desc_.width = width;
    desc_.height = height;
    desc_.bounces = setting.bounces;
    desc_.min_weight = setting.min_weight;
    desc_.engine = setting.engine;
    desc_.tolerance = setting.tolerance;
    colour_ = cl::Buffer(device_.context(), CL_MEM_READ_WRITE,
                         size_t{width} * height * sizeof(cl_float4));
    desc_.colour = colour_();
    scratch_ = scratch_of(device_, rsh_frame_query, desc_);
    desc_.scratch = scratch_();
}

double FrameOnDevice::render() {
    return milliseconds([&] {
        rsh::check(rsh_frame(device_.rsh(), device_.queue()(), &desc_, 0, nullptr, nullptr),
                   "rsh_frame");
        device_.queue().finish();
    });
}

std::vector<cl_float4> FrameOnDevice::pixels() const {
    return read<cl_float4>(device_, colour_, size_t{desc_.width} * desc_.height);
}

}  // namespace bench::accuracy
