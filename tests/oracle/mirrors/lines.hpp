// lines.hpp - the same paths by a tracer under test and by the ways to compare it with: the lines of
// a plot of errors over bounces.
#pragma once

#include <array>

#include "oracle/mirrors/path_errors.hpp"
#include "oracle/mirrors/waves.hpp"

namespace oracle {

enum Line {
    kTracer,       // the rays that it hands on, as they are
    kBestFloats,   // 113 bits, rounded to the nearest floats after every bounce
    kOffsetAlone,  // 113 bits, but every origin is where rsh's rule puts it
    kOneRounding,  // 113 bits, rounded to the nearest floats after the first bounce alone
    kLineCount
};

struct Followed {
    Followed(size_t paths, size_t bounces);
    void append(const Followed& more);

    std::array<ErrorTable, kLineCount> lines;
    std::vector<std::vector<double>> growth;  // of each path, see growth_along
    Faults faults;                            // of the tracer
};

// `start`: rays in the room, whose radius is `unit`. Throws std::runtime_error when an exact path
// ends.
Followed follow(const MirrorRoom& room, double unit, const std::vector<rsh_ray>& start,
                uint32_t bounces, Tracer& tracer);

// How many times the error of the best floats the tracer's is, on the same path, in the median; the
// largest of position, direction and next hit. Paths that both have lost do not count. Pairs tell
// more than medians of each line do: how much a path magnifies its errors, which differs by powers
// of ten, is the same for both.
double times_the_best(const Followed& followed, size_t bounce);

}  // namespace oracle
