// host_contender.cpp - std::copy_if on one core and, with the parallel policy (oneTBB), on all.
#include <algorithm>
#include <array>
#include <execution>

#include "reduce/contender.hpp"

namespace bench {
namespace {

template <size_t Words>
class HostCopyIf final : public Contender {
public:
    HostCopyIf(const Stream& stream, bool is_parallel)
        : stream_(stream),
          is_parallel_(is_parallel),
          input_(stream.count()),
          output_(stream.count()) {
        for (size_t i = 0; i < input_.size(); ++i)
            std::copy_n(stream.words.begin() + long(i * Words), Words, input_[i].begin());
    }

    void run() override {
        const auto is_kept = [](const Element& e) { return e[0] != RSH_NO_HIT; };
        end_ = is_parallel_
                   ? std::copy_if(std::execution::par, input_.begin(), input_.end(),
                                  output_.begin(), is_kept)
                   : std::copy_if(input_.begin(), input_.end(), output_.begin(), is_kept);
    }
    bool is_right() const override {
        std::vector<cl_uint> words;
        for (auto e = output_.begin(); e != end_; ++e)
            words.insert(words.end(), e->begin(), e->end());
        return is_answer(stream_, words, true);
    }

private:
    using Element = std::array<cl_uint, Words>;
    const Stream& stream_;
    bool is_parallel_;
    std::vector<Element> input_, output_;
    typename std::vector<Element>::iterator end_;
};

}  // namespace

std::unique_ptr<Contender> make_host(const std::string& name, const DeviceStream& stream) {
    const bool is_parallel = name == "peer:parallel_copy_if";
    switch (stream.host.words_per_element()) {
        case 1:
            return std::make_unique<HostCopyIf<1>>(stream.host, is_parallel);
        case 2:
            return std::make_unique<HostCopyIf<2>>(stream.host, is_parallel);
        case 3:
            return std::make_unique<HostCopyIf<3>>(stream.host, is_parallel);
        default:
            return std::make_unique<HostCopyIf<4>>(stream.host, is_parallel);
    }
}

}  // namespace bench
