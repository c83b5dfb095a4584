// stream.hpp - a stream to reduce, on the host: elements, which of them are kept, and the answer.
#pragma once

#include <rsh/rsh.h>

#include <string>
#include <vector>

namespace bench {

struct StreamSpec {
    std::string pattern;    // see patterns.hpp
    cl_uint count = 0;      // elements; 0: as many as the pattern has
    cl_uint bytes = 4;      // of an element
    int keep_percent = 50;  // what patterns without a density of their own aim at
};

struct Stream {
    StreamSpec spec;  // with the count that it came to
    std::vector<cl_uint> words;
    std::vector<cl_uchar> flags;  // 1: kept; dropped elements begin with RSH_NO_HIT as well
    std::vector<cl_uint> kept;    // the answer, in order
    cl_uint count() const { return spec.count; }
    cl_uint words_per_element() const { return spec.bytes / 4; }
    cl_uint kept_count() const { return cl_uint(kept.size()) / words_per_element(); }
    double kept_percent() const { return count() ? 100.0 * kept_count() / count() : 0.0; }
    size_t bytes() const { return words.size() * sizeof(cl_uint); }
};

// `flags` as from the pattern.
Stream make_stream(const StreamSpec& spec, std::vector<cl_uchar> flags);

// The answer is right: the same elements, in order or, if that is not promised, in any.
bool is_answer(const Stream& stream, const std::vector<cl_uint>& words, bool is_stable);

}  // namespace bench
