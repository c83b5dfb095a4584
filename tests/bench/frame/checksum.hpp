// checksum.hpp - one number for all answers of a frame, so that two commits can be compared in
// every bit (tests/same_bits.sh). Says nothing about whether the answers are right.
#pragma once

#include <string>
#include <type_traits>
#include <vector>

namespace bench {

// FNV-1a with 64 bits, as 16 hexadecimal digits.
std::string checksum(const unsigned char* bytes, size_t count);

// Over the bytes of rsh_hit or of occlusion words, neither of which has padding, in ray order.
template <class Answer>
std::string checksum(const std::vector<Answer>& answers) {
    static_assert(std::is_trivially_copyable_v<Answer>);
    return checksum(reinterpret_cast<const unsigned char*>(answers.data()),
                    answers.size() * sizeof(Answer));
}

}  // namespace bench
