// layout.hpp - a scratch buffer's parts, declared once: the same object answers the size query
// and, through Scratch, hands out the parts. Allocates nothing.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rsh {

class Layout {
public:
    explicit Layout(size_t alignment) : alignment_(alignment) {}

    void add(std::string name, size_t bytes) {
        parts_.push_back({std::move(name), next_, bytes});
        next_ += (bytes + alignment_ - 1) / alignment_ * alignment_;
        bytes_ = std::max(bytes_, next_);
    }

    // What is added from now on lies where this part and those after it do: for parts that are
    // not needed at the same time.
    void reuse_from(std::string_view name) {
        for (const Part& part : parts_)
            if (part.name == name) next_ = part.offset;
    }
    template <class T>
    void add_array(std::string name, size_t count) {
        add(std::move(name), count * sizeof(T));
    }

    struct Part {
        std::string name;
        size_t offset;
        size_t bytes;
    };
    const std::vector<Part>& parts() const { return parts_; }
    size_t bytes() const { return bytes_; }

private:
    size_t alignment_;
    size_t next_ = 0, bytes_ = 0;
    std::vector<Part> parts_;
};

}  // namespace rsh
