// suites.cpp - the list of suites. One row each.
#include "reduce/reduce_suite.hpp"
#include "suite.hpp"

namespace bench {

const std::vector<Suite*>& suites() {
    static ReduceSuite reduce;
    static const std::vector<Suite*> all = {&reduce};
    return all;
}

}  // namespace bench
