#include "document.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <utility>

#include "files/whole_file.hpp"
#include "left_out.hpp"

namespace bench {

namespace fs = std::filesystem;

Document::Document(nlohmann::json head, std::string path)
    : document_(std::move(head)), path_(std::move(path)) {
    if (!path_.empty()) render::require_place(path_);
    document_["format_version"] = kFormatVersion;
    document_["cases"] = nlohmann::json::array();
    document_["left_out"] = nlohmann::json::array();
    write();
}

void Document::add(const Case& c) {
    cases_.push_back(c);
    document_["cases"].push_back(
        {{"name", c.name}, {"params", c.params}, {"metrics", c.metrics}, {"ok", c.ok}});
    if (!c.ok) {
        ++wrong_count_;
        fmt::print(stderr, "wrong answer: {}\n", c.name);
    }
    std::fflush(stdout);
    write();
}

void Document::leave_out(const std::string& name, const std::string& why) {
    document_["left_out"].push_back({{"name", name}, {"why", why}});
    write();
}

void Document::finish() const {
    if (left_out_count() > 0) fmt::print("left out:\n{}", left_out_text(document_["left_out"]));
    store();
}

void Document::store() const {
    if (path_.empty()) return;
    render::WholeFile file(path_);
    file.write(document_.dump(1) + '\n');
    file.commit();
}

// A pipe takes it once, at the end.
void Document::write() const {
    if (!path_.empty() && (!fs::exists(path_) || fs::is_regular_file(path_))) store();
}

}  // namespace bench
