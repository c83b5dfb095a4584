// aff_text.hpp - AFF files of a few lines, for tests.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "files/text_scan.hpp"
#include "import/bart/aff_animation.hpp"
#include "temporary_folder.hpp"

namespace render {

inline std::unique_ptr<Animation> load_text(const std::string& text) {
    const TemporaryFolder folder;
    return load_aff(folder.write("a.aff", text));
}

// Fails the test if it loads.
inline std::string error_of(const std::string& text) {
    try {
        load_text(text);
    } catch (const LoadError& error) {
        return error.what();
    }
    ADD_FAILURE() << "loads, but must not:\n" << text;
    return {};
}

inline void expect_parts(const std::string& message, const std::vector<std::string>& parts) {
    for (const std::string& part : parts)
        EXPECT_NE(message.find(part), std::string::npos)
            << '"' << part << "\" is not in: " << message;
}

// The only warning of an animation has all of `parts`.
inline void expect_one_warning(const Animation& animation,
                               const std::vector<std::string>& parts) {
    const std::vector<std::string> warnings = animation.at(animation.start()).warnings;
    ASSERT_EQ(warnings.size(), 1u);
    expect_parts(warnings[0], parts);
}

}  // namespace render
