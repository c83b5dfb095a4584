#include "device/tests_per_ray.hpp"

namespace render {

TestsPerRay::TestsPerRay(const Device& device, const rsh_frame_desc& picture,
                         uint32_t most_rows)
    : device_(device),
      geometry_(picture.scene->geometry),
      width_(picture.width),
      hits_(device.buffer(sizeof(rsh_hit) * width_ * most_rows)),
      tests_(device.buffer(sizeof(cl_uint) * width_ * most_rows)) {
    rsh_sizes sizes{};
    sizes.struct_size = sizeof sizes;
    rsh_bound_desc bound{};
    bound.struct_size = sizeof bound;
    bound.geometry = geometry_;
    bound.shape = RSH_SHAPE_BOX;
    require(rsh_bound_query(device.rsh(), &bound, &sizes), "rsh_bound_query");
    bounds_ = device.buffer(sizes.output_bytes);
    bound.bounds = bounds_();
    require(rsh_bound(device.rsh(), device.queue()(), &bound, 0, nullptr, nullptr),
            "rsh_bound");
    const rsh_build_desc build = this->build(hits_, most_rows);
    require(rsh_build_query(device.rsh(), &build, &sizes), "rsh_build_query");
    nodes_ = device.buffer(sizes.output_bytes);
}

rsh_build_desc TestsPerRay::build(const cl::Buffer& rays, uint32_t rows) const {
    rsh_build_desc desc{};
    desc.struct_size = sizeof desc;
    desc.rays = rays();
    desc.width = width_;
    desc.height = rows;
    desc.nodes = nodes_();
    desc.shape = RSH_SHAPE_BOX;
    return desc;
}

rsh_traverse_desc TestsPerRay::traverse(const cl::Buffer& rays, uint32_t rows) const {
    rsh_traverse_desc desc{};
    desc.struct_size = sizeof desc;
    desc.geometry = geometry_;
    desc.bounds = bounds_();
    desc.rays = rays();
    desc.width = width_;
    desc.height = rows;
    desc.nodes = nodes_();
    desc.hits = hits_();
    desc.engine = RSH_ENGINE_TILES;
    desc.shape = RSH_SHAPE_BOX;
    desc.tests_per_ray = tests_();
    return desc;
}

std::vector<uint32_t> TestsPerRay::count(const cl::Buffer& rays, uint32_t rows) const {
    std::vector<uint32_t> tests(size_t{width_} * rows);
    const cl::CommandQueue& queue = device_.queue();
    queue.enqueueFillBuffer(tests_, cl_uint{0}, 0, tests.size() * sizeof(cl_uint));
    const rsh_build_desc building = build(rays, rows);
    require(rsh_build(device_.rsh(), queue(), &building, 0, nullptr, nullptr), "rsh_build");
    const rsh_traverse_desc tracing = traverse(rays, rows);
    require(rsh_traverse(device_.rsh(), queue(), &tracing, 0, nullptr, nullptr),
            "rsh_traverse");
    queue.enqueueReadBuffer(tests_, CL_TRUE, 0, tests.size() * sizeof(cl_uint), tests.data());
    return tests;
}

}  // namespace render
