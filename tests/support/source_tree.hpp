// source_tree.hpp - where the sources are that some tests read: where they were compiled, or where
// RSH_SOURCE_TREE says, for a program that was carried to another machine.
#pragma once

#include <cstdlib>
#include <filesystem>

namespace test {

inline std::filesystem::path source_tree() {
    const char* const moved = std::getenv("RSH_SOURCE_TREE");
    return moved ? moved : RSH_COMPILED_SOURCE_TREE;
}

}  // namespace test
