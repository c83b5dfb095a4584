#include "reduce/stream.hpp"

namespace bench {
namespace {

cl_uint word_of(cl_uint element, cl_uint w) {
    return element + w * 0x10001u;
}

// The first word of a kept element is its index: each kept one must come once, and whole.
bool is_permutation(const Stream& stream, const std::vector<cl_uint>& words) {
    const cl_uint per_element = stream.words_per_element();
    std::vector<cl_uchar> missing = stream.flags;
    for (size_t at = 0; at < words.size(); at += per_element) {
        const cl_uint i = words[at];
        if (i >= stream.count() || !missing[i]) return false;
        missing[i] = 0;
        for (cl_uint w = 1; w < per_element; ++w)
            if (words[at + w] != word_of(i, w)) return false;
    }
    return true;
}

}  // namespace

Stream make_stream(const StreamSpec& spec, std::vector<cl_uchar> flags) {
    Stream stream = {spec, {}, std::move(flags), {}};
    stream.spec.count = cl_uint(stream.flags.size());
    const cl_uint per_element = stream.words_per_element();
    stream.words.resize(size_t{stream.count()} * per_element);
    for (cl_uint i = 0; i < stream.count(); ++i) {
        cl_uint* element = stream.words.data() + size_t{i} * per_element;
        for (cl_uint w = 0; w < per_element; ++w) element[w] = word_of(i, w);
        if (stream.flags[i])
            stream.kept.insert(stream.kept.end(), element, element + per_element);
        else
            element[0] = RSH_NO_HIT;
    }
    return stream;
}

bool is_answer(const Stream& stream, const std::vector<cl_uint>& words, bool is_stable) {
    if (words.size() != stream.kept.size()) return false;
    return is_stable ? words == stream.kept : is_permutation(stream, words);
}

}  // namespace bench
