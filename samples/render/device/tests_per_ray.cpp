#include "device/tests_per_ray.hpp"

namespace render {

TestsPerRay::TestsPerRay(const rsh::Device& device, const rsh_frame_desc& picture,
                         uint32_t most_rows)
    : device_(device),
      geometry_(picture.scene->geometry),
      width_(picture.width),
      hits_(device.buffer(sizeof(rsh_hit) * width_ * most_rows)),
      tests_(device.buffer(sizeof(cl_uint) * width_ * most_rows)) {
    auto bound = rsh::make<rsh_bound_desc>();
    bound.geometry = geometry_;
    bound.shape = RSH_SHAPE_BOX;
    bounds_ = device.buffer(device.sizes_of(rsh_bound_query, bound).output_bytes);
    bound.bounds = bounds_.get();
    device.run(rsh_bound, bound);
    const rsh_build_desc build = this->build(hits_, most_rows);
    nodes_ = device.buffer(device.sizes_of(rsh_build_query, build).output_bytes);
}

rsh_build_desc TestsPerRay::build(const rsh::Buffer& rays, uint32_t rows) const {
    auto desc = rsh::make<rsh_build_desc>();
    desc.rays = rays.get();
    desc.width = width_;
    desc.height = rows;
    desc.nodes = nodes_.get();
    desc.shape = RSH_SHAPE_BOX;
    return desc;
}

rsh_traverse_desc TestsPerRay::traverse(const rsh::Buffer& rays, uint32_t rows) const {
    auto desc = rsh::make<rsh_traverse_desc>();
    desc.geometry = geometry_;
    desc.bounds = bounds_.get();
    desc.rays = rays.get();
    desc.width = width_;
    desc.height = rows;
    desc.nodes = nodes_.get();
    desc.hits = hits_.get();
    desc.engine = RSH_ENGINE_TILES;
    desc.shape = RSH_SHAPE_BOX;
    desc.tests_per_ray = tests_.get();
    return desc;
}

std::vector<uint32_t> TestsPerRay::count(const rsh::Buffer& rays, uint32_t rows) const {
    const size_t pixels = size_t{width_} * rows;
    device_.write(tests_.get(), std::vector<uint32_t>(pixels));  // counts are added
    device_.run(rsh_build, build(rays, rows));
    device_.run(rsh_traverse, traverse(rays, rows));
    return device_.download<uint32_t>(tests_.get(), pixels);
}

}  // namespace render
