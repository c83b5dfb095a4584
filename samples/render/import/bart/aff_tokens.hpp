// aff_tokens.hpp - words and numbers of AFF files, followed through their includes. Knows no
// command of AFF but the include that it is told of.
#pragma once

#include <glm/glm.hpp>

#include <string>
#include <vector>

namespace render {

class AffTokens {
public:
    // Throws LoadError, as all functions here do; messages name file and line.
    explicit AffTokens(const std::string& path);

    // Goes on in `name`, a file beside the present one (see references.hpp), and comes back after its
    // end. False: there is no such file.
    bool include(const std::string& name);

    // The next word; empty at the end of the last file.
    std::string next();
    std::string peek();
    std::string word(const char* what);  // next(), which must not be at the end
    double number(const char* what);
    // Of things with `numbers` numbers each, which must fit into what is left of the files.
    size_t count(const char* what, size_t numbers);
    glm::dvec3 vector(const char* what);
    void expect(const char* word);
    const std::string& location() const { return files_.back().location; }
    std::string where();  // "a.aff, line 3"
    [[noreturn]] void fail(const std::string& what);

private:
    struct File {
        std::string location;
        std::string text;
        size_t at = 0;
        size_t line = 1, lines_until = 0;  // counted as far as there
    };

    void open(const std::string& path);

    // Moves to the next word, out of files that have ended; false at the end of all.
    bool find_word();

    std::vector<File> files_;
    size_t opened_ = 0;
};

}  // namespace render
