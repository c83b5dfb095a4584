// suites.cpp - the list of suites. One row each.
#include "frame/frame_suite.hpp"
#include "reduce/reduce_suite.hpp"
#include "suite.hpp"

namespace bench {

const std::vector<Suite*>& suites() {
    static FrameSuite frame;
    static ReduceSuite reduce;
    static const std::vector<Suite*> all = {&frame, &reduce};
    return all;
}

}  // namespace bench
