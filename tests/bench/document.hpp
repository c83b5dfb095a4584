// document.hpp - the JSON of a run, written anew, whole, after every case, so that a run that is
// killed leaves what it had.
#pragma once

#include "results.hpp"

namespace bench {

// Raised when a name, a parameter or a metric comes to mean something else than before, so that
// files of both versions must not be compared. Files without this member mean what version 1 means.
constexpr int kFormatVersion = 1;

class Document final : public Results {
public:
    // `head`: what stands beside the cases and the version of the format. An empty path: nothing is
    // written. Throws std::runtime_error when the path cannot be written to.
    Document(nlohmann::json head, std::string path);

    void add(const Case& c) override;
    void leave_out(const std::string& name, const std::string& why) override;
    const std::vector<Case>& cases() const override { return cases_; }
    // Prints what was left out, and writes for the last time: the only one for what is no file.
    void finish() const;

    size_t wrong_count() const { return wrong_count_; }
    size_t left_out_count() const { return document_["left_out"].size(); }

private:
    void write() const;
    void store() const;

    nlohmann::json document_;
    std::string path_;
    std::vector<Case> cases_;
    size_t wrong_count_ = 0;
};

}  // namespace bench
