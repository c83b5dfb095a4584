#include "reduce/stream.hpp"

namespace bench {
namespace {

cl_uint word_of(cl_uint element, cl_uint w) {
    return element + w * 0x10001u;
}

bool is_element(const Stream& stream, const cl_uint* words, cl_uint i) {
    for (cl_uint w = 0; w < stream.words_per_element(); ++w)
        if (words[w] != word_of(i, w)) return false;
    return true;
}

bool is_in_order(const Stream& stream, const cl_uint* words) {
    for (cl_uint i = 0; i < stream.count(); ++i) {
        if (!stream.flags[i]) continue;
        if (!is_element(stream, words, i)) return false;
        words += stream.words_per_element();
    }
    return true;
}

// The first word of a kept element is its index: each kept one must come once, and whole.
bool is_permutation(const Stream& stream, const cl_uint* words) {
    std::vector<cl_uchar> missing = stream.flags;
    for (cl_uint k = 0; k < stream.kept_count; ++k, words += stream.words_per_element()) {
        const cl_uint i = *words;
        if (i >= stream.count() || !missing[i] || !is_element(stream, words, i)) return false;
        missing[i] = 0;
    }
    return true;
}

}  // namespace

Stream make_stream(const StreamSpec& spec, std::vector<cl_uchar> flags) {
    Stream stream = {spec, {}, std::move(flags)};
    stream.spec.count = cl_uint(stream.flags.size());
    const cl_uint per_element = stream.words_per_element();
    stream.words.resize(size_t{stream.count()} * per_element);
    cl_uint* element = stream.words.data();
    for (cl_uint i = 0; i < stream.count(); ++i, element += per_element) {
        for (cl_uint w = 0; w < per_element; ++w) element[w] = word_of(i, w);
        if (!stream.flags[i]) element[0] = RSH_NO_HIT;
        stream.kept_count += stream.flags[i];
    }
    return stream;
}

bool is_answer(const Stream& stream, const cl_uint* words, size_t count, bool is_stable) {
    if (count != stream.kept_count) return false;
    return is_stable ? is_in_order(stream, words) : is_permutation(stream, words);
}

}  // namespace bench
