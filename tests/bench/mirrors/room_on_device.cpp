#include "mirrors/room_on_device.hpp"

#include "upload.hpp"

namespace bench::mirrors {
namespace {

template <class T>
cl::Buffer output(const Device& device, size_t count) {
    return cl::Buffer(device.context(), CL_MEM_READ_WRITE, count * sizeof(T));
}

template <class T>
std::vector<T> read(const Device& device, const cl::Buffer& buffer, size_t count) {
    std::vector<T> items(count);
    device.queue().enqueueReadBuffer(buffer, CL_TRUE, 0, count * sizeof(T), items.data());
    return items;
}

cl::Buffer nodes_over(const Device& device, const cl::Buffer& rays, size_t count) {
    rsh_build_desc desc{};
    desc.struct_size = sizeof desc;
    desc.rays = rays();
    desc.width = static_cast<cl_uint>(count);
    rsh_sizes sizes{};
    sizes.struct_size = sizeof sizes;
    rsh::check(rsh_build_query(device.rsh(), &desc, &sizes), "rsh_build_query");
    cl::Buffer nodes(device.context(), CL_MEM_READ_WRITE, sizes.output_bytes);
    desc.nodes = nodes();
    rsh::check(rsh_build(device.rsh(), device.queue()(), &desc, 0, nullptr, nullptr),
               "rsh_build");
    return nodes;
}

}  // namespace

RoomOnDevice::RoomOnDevice(const Device& device, const oracle::MirrorRoom& room)
    : device_(device),
      vertices_(upload(device, room.mesh.vertices)),
      indices_(upload(device, room.mesh.indices)),
      normals_(upload(device, room.normals)) {
    const std::vector<rsh_material> materials = {oracle::mirror_material()};
    materials_ = upload(device, materials);
    scene_.struct_size = sizeof scene_;
    scene_.geometry.vertices = vertices_();
    scene_.geometry.vertex_count = static_cast<cl_uint>(room.mesh.vertices.size());
    scene_.geometry.indices = indices_();
    scene_.geometry.triangle_count = room.mesh.triangle_count();
    scene_.normals = normals_();
    scene_.materials = materials_();
    scene_.material_count = 1;
    rsh::check(rsh_find_features(&scene_, materials.data(), nullptr), "rsh_find_features");
}

std::vector<rsh_hit> RoomOnDevice::closest(const std::vector<rsh_ray>& rays,
                                           const std::vector<uint32_t>& skip) {
    const cl::Buffer in = upload(device_, rays), skipped = upload(device_, skip);
    const cl::Buffer nodes = nodes_over(device_, in, rays.size());
    const cl::Buffer hits = output<rsh_hit>(device_, rays.size());
    rsh_traverse_desc desc{};
    desc.struct_size = sizeof desc;
    desc.geometry = scene_.geometry;
    desc.rays = in();
    desc.skip = skipped();
    desc.nodes = nodes();
    desc.width = static_cast<cl_uint>(rays.size());
    desc.hits = hits();
    rsh::check(rsh_traverse(device_.rsh(), device_.queue()(), &desc, 0, nullptr, nullptr),
               "rsh_traverse");
    return read<rsh_hit>(device_, hits, rays.size());
}

oracle::Wave RoomOnDevice::mirrored(const oracle::Wave& wave) {
    const size_t count = wave.rays.size();
    const cl::Buffer rays = upload(device_, wave.rays), hits = upload(device_, wave.hits);
    const cl::Buffer spawned = output<rsh_ray>(device_, count);
    const cl::Buffer weights = output<cl_float4>(device_, count);
    const cl::Buffer skip = output<cl_uint>(device_, count);
    rsh_spawn_desc desc{};
    desc.struct_size = sizeof desc;
    desc.scene = &scene_;
    desc.kind = RSH_SPAWN_REFLECTION;
    desc.ray_count = static_cast<cl_uint>(count);
    desc.rays = rays();
    desc.hits = hits();
    desc.spawned_rays = spawned();
    desc.spawned_weights = weights();
    desc.spawned_skip = skip();
    rsh::check(rsh_spawn(device_.rsh(), device_.queue()(), &desc, 0, nullptr, nullptr),
               "rsh_spawn");
    return {read<rsh_ray>(device_, spawned, count), read<cl_uint>(device_, skip, count), {}};
}

}  // namespace bench::mirrors
