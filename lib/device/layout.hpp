// layout.hpp - a scratch buffer's parts, declared once: the same object answers the size query
// and, through Scratch, hands out the parts. Allocates nothing.
#pragma once

#include <algorithm>
#include <cstddef>
#include <stdexcept>
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
    void reuse_from(std::string_view name) { next_ = parts_[number_of(name)].offset; }
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
    bool has(std::string_view name) const { return find(name) < parts_.size(); }
    // Throws where there is none: a name that nobody added would be a buffer that is not there.
    size_t number_of(std::string_view name) const {
        if (!has(name))
            throw std::logic_error("scratch: has no part \"" + std::string(name) + '"');
        return find(name);
    }
    size_t bytes() const { return bytes_; }

private:
    size_t find(std::string_view name) const {
        const auto found = std::find_if(parts_.begin(), parts_.end(),
                                        [&](const Part& part) { return part.name == name; });
        return static_cast<size_t>(found - parts_.begin());
    }

    size_t alignment_;
    size_t next_ = 0, bytes_ = 0;
    std::vector<Part> parts_;
};

}  // namespace rsh
