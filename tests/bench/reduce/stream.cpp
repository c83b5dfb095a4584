#include "reduce/stream.hpp"

#include <atomic>
#include <utility>

#include "reduce/parts.hpp"

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
    std::atomic<bool> is_right{true};
    for_parts(stream.count(), [&](const Part& part) {
        const cl_uint* at =
            words + size_t{stream.kept_before[part.index]} * stream.words_per_element();
        for (cl_uint i = part.begin; i < part.end; ++i) {
            if (!stream.flags[i]) continue;
            if (!is_element(stream, at, i)) {
                is_right = false;
                return;
            }
            at += stream.words_per_element();
        }
    });
    return is_right;
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

// Returns how many elements of the part are kept.
cl_uint fill(Stream& stream, const Part& part) {
    const cl_uint per_element = stream.words_per_element();
    cl_uint* element = stream.words.data() + size_t{part.begin} * per_element;
    cl_uint kept = 0;
    for (cl_uint i = part.begin; i < part.end; ++i, element += per_element) {
        for (cl_uint w = 0; w < per_element; ++w) element[w] = word_of(i, w);
        if (!stream.flags[i]) element[0] = RSH_NO_HIT;
        kept += stream.flags[i];
    }
    return kept;
}

}  // namespace

Stream make_stream(const StreamSpec& spec, std::vector<cl_uchar> flags) {
    Stream stream;
    stream.spec = spec;
    stream.flags = std::move(flags);
    stream.spec.count = cl_uint(stream.flags.size());
    stream.words.resize(size_t{stream.count()} * stream.words_per_element());
    std::vector<cl_uint> kept(part_count(stream.count()));
    for_parts(stream.count(), [&](const Part& part) { kept[part.index] = fill(stream, part); });
    for (const cl_uint of_part : kept) {
        stream.kept_before.push_back(stream.kept_count);
        stream.kept_count += of_part;
    }
    return stream;
}

bool is_answer(const Stream& stream, const cl_uint* words, size_t count, bool is_stable) {
    if (count != stream.kept_count) return false;
    return is_stable ? is_in_order(stream, words) : is_permutation(stream, words);
}

}  // namespace bench
