// corners_test.cpp - triangles are read to the end of the caller's buffers and not behind it.
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstring>
#include <memory>
#include <stdexcept>
#include <vector>

#include "support/mesh.hpp"
#include "support/trace.hpp"

namespace {

// Memory that ends where a page begins that nobody may read: where a device uses the host's
// memory, reading behind it ends the program.
class LastBytes {
public:
    template <class T>
    explicit LastBytes(const std::vector<T>& data) {
        const size_t bytes = data.size() * sizeof(T), page = size_t(sysconf(_SC_PAGESIZE));
        const size_t room = (bytes + page - 1) / page * page;
        mapped_ = room + page;
        pages_ = static_cast<char*>(
            mmap(nullptr, mapped_, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0));
        if (pages_ == MAP_FAILED || mprotect(pages_ + room, page, PROT_NONE) != 0)
            throw std::runtime_error("no memory with a page behind it that is locked");
        void* const begin = pages_ + room - bytes;
        std::memcpy(begin, data.data(), bytes);
        buffer_ = std::make_unique<cl::Buffer>(
            test::device().context, CL_MEM_READ_ONLY | CL_MEM_USE_HOST_PTR, bytes, begin);
    }
    ~LastBytes() {
        buffer_.reset();
        munmap(pages_, mapped_);
    }
    LastBytes(const LastBytes&) = delete;
    LastBytes& operator=(const LastBytes&) = delete;

    cl_mem get() const { return (*buffer_)(); }

private:
    char* pages_ = nullptr;
    size_t mapped_ = 0;
    std::unique_ptr<cl::Buffer> buffer_;
};

// The bounds of a mesh, made, or refitted after that, as they lie in memory.
std::vector<uint8_t> bounds_of(const rsh_geometry& geometry, bool is_refit) {
    const rsh_context context = test::device().rsh;
    rsh_bound_desc desc = {};
    desc.struct_size = sizeof desc;
    desc.geometry = geometry;
    desc.shape = RSH_SHAPE_BOX;
    desc.mode = RSH_BOUND_QUALITY;
    rsh_sizes sizes = {};
    sizes.struct_size = sizeof sizes;
    RSH_CHECK(rsh_bound_query(context, &desc, &sizes));
    const test::Bytes bounds(sizes.output_bytes);
    const std::vector<uint8_t> blank(sizes.output_bytes, test::kCanary);
    bounds.write(blank.data(), blank.size());
    desc.bounds = bounds.get();
    const cl_command_queue queue = test::device().queue();
    RSH_CHECK(rsh_bound(context, queue, &desc, 0, nullptr, nullptr));
    desc.mode = RSH_BOUND_REFIT;
    if (is_refit) RSH_CHECK(rsh_bound(context, queue, &desc, 0, nullptr, nullptr));
    std::vector<uint8_t> bytes(sizes.output_bytes);
    bounds.read(bytes.data(), bytes.size());
    return bytes;
}

// Of 16 triangles at a time, none is left over; buffers are multiples of 128 bytes, as devices
// may want them. The last vertices are those of the first triangle.
TEST(Corners, AreNotReadBehindTheMesh) {
    test::Random random(31);
    for (const uint32_t count : {32u, 96u, 1024u}) {
        test::Mesh mesh = test::random_soup(random, count);
        for (uint32_t i = 3 * count; i > 0; --i) mesh.indices.push_back(i - 1);
        const LastBytes vertices(mesh.vertices), indices(mesh.indices);
        const test::DeviceMesh ordinary(mesh);
        rsh_geometry geometry = ordinary.geometry();
        geometry.vertices = vertices.get();
        geometry.indices = indices.get();
        for (const bool is_refit : {false, true})
            EXPECT_EQ(bounds_of(geometry, is_refit), bounds_of(ordinary.geometry(), is_refit))
                << count << " triangles" << (is_refit ? ", refitted" : ", made");
    }
}

}  // namespace
