// pyopencl_peer.hpp - pyopencl.algorithm.copy_if, called by a Python script
// (pyopencl_peer.py) that checks and times it in its own process, paired with its own copy.
#pragma once

#include "reduce/stream.hpp"
#include "suite.hpp"

namespace bench {

class PyopenclPeer {
public:
    explicit PyopenclPeer(const Device& device);
    ~PyopenclPeer();  // removes the files
    PyopenclPeer(const PyopenclPeer&) = delete;
    PyopenclPeer& operator=(const PyopenclPeer&) = delete;

    // A Python with pyopencl was found.
    bool is_there() const { return !python_.empty(); }
    // The type that its users would choose: none has 12 bytes.
    static bool takes(const StreamSpec& spec);

    // Writes the stream to a file, for run().
    void add(const Stream& stream, const Case& named);
    // All that were added; none, and `results` is told so, when the limit has passed.
    std::vector<Case> run(double budget_ms, const Limit& limit, Results& results);

private:
    std::string python_, folder_, platform_, device_;
    nlohmann::json jobs_ = nlohmann::json::array();
    std::vector<Case> cases_;
};

}  // namespace bench
