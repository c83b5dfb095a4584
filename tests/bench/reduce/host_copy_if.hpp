// host_copy_if.hpp - std::copy_if over a copy of the stream in host memory, by a policy or by none.
#pragma once

#include <algorithm>
#include <array>

#include "reduce/contender.hpp"

namespace bench {

// Policy()(first, last, output, is_kept) calls std::copy_if.
template <class Policy, size_t Words>
class HostCopyIf final : public Contender {
public:
    explicit HostCopyIf(const Stream& stream)
        : stream_(stream), input_(stream.count()), output_(stream.count()) {
        for (size_t i = 0; i < input_.size(); ++i)
            std::copy_n(stream.words.begin() + long(i * Words), Words, input_[i].begin());
    }

    void run() override {
        const auto is_kept = [](const Element& e) { return e[0] != RSH_NO_HIT; };
        end_ = Policy()(input_.begin(), input_.end(), output_.begin(), is_kept);
    }
    bool is_right() const override {
        return is_answer(stream_, output_.front().data(), size_t(end_ - output_.begin()), true);
    }

private:
    using Element = std::array<cl_uint, Words>;
    const Stream& stream_;
    std::vector<Element> input_, output_;
    typename std::vector<Element>::iterator end_;
};

template <class Policy>
std::unique_ptr<Contender> make_host_copy_if(const Stream& stream) {
    switch (stream.words_per_element()) {
        case 1:
            return std::make_unique<HostCopyIf<Policy, 1>>(stream);
        case 2:
            return std::make_unique<HostCopyIf<Policy, 2>>(stream);
        case 3:
            return std::make_unique<HostCopyIf<Policy, 3>>(stream);
        default:
            return std::make_unique<HostCopyIf<Policy, 4>>(stream);
    }
}

}  // namespace bench
