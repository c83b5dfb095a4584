// not_empty.hpp - a list that a test goes through. Were it empty, the test would pass and have tested
// nothing.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace test {

template <class T>
std::vector<T> not_empty(std::vector<T> list, const std::string& of) {
    if (list.empty()) throw std::logic_error("there are no " + of + " to test");
    return list;
}

}  // namespace test
