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
    std::string path = {};  // of the pattern file:NAME
};

struct Stream {
    StreamSpec spec;  // with the count that it came to
    std::vector<cl_uint> words;
    std::vector<cl_uchar> flags;  // 1: kept; dropped elements begin with RSH_NO_HIT as well
    cl_uint kept_count = 0;
    std::vector<cl_uint> kept_before;  // of the parts of parts.hpp, each
    cl_uint count() const { return spec.count; }
    cl_uint words_per_element() const { return spec.bytes / 4; }
    double kept_percent() const { return count() ? 100.0 * kept_count / count() : 0.0; }
    size_t bytes() const { return words.size() * sizeof(cl_uint); }
};

// `flags` as from the pattern.
Stream make_stream(const StreamSpec& spec, std::vector<cl_uchar> flags);

// The `count` elements at `words` are the kept ones: in order or, if that is not promised, in any.
bool is_answer(const Stream& stream, const cl_uint* words, size_t count, bool is_stable);

}  // namespace bench
