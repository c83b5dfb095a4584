// no_peers.cpp - in place of embree/, without RSH_BENCH_PEERS.
#include "hits/contender.hpp"

namespace bench::hits {

std::vector<ContenderKind> peer_contenders() {
    return {};
}

}  // namespace bench::hits
