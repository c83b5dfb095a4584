#include "device/programs/kernel_source.hpp"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <set>

#include "device/error.hpp"

namespace rsh {
namespace {

std::string read_embedded(const std::string& name) {
    for (size_t i = 0; i < kEmbeddedFileCount; ++i)
        if (name == kEmbeddedFiles[i].name)
            return {reinterpret_cast<const char*>(kEmbeddedFiles[i].text),
                    kEmbeddedFiles[i].bytes};
    throw Error(RSH_INTERNAL_ERROR, "no embedded kernel file ", name);
}

// The types of the interface, rsh/..., live in include/, beside the folder of the kernels.
std::string read_from(const std::string& folder, const std::string& name) {
    const std::string path =
        folder + (name.rfind("rsh/", 0) == 0 ? "/../include/" : "/") + name;
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"),
                                                               std::fclose);
    std::string text;
    char part[4096];
    while (const size_t bytes = file ? std::fread(part, 1, sizeof part, file.get()) : 0)
        text.append(part, bytes);
    if (!file || std::ferror(file.get()))
        throw Error(RSH_INVALID_VALUE, "kernel_dir: cannot read ", path);
    return text;
}

std::string included_name(const std::string& line) {
    const std::string directive = "#include \"";
    if (line.compare(0, directive.size(), directive) != 0) return {};
    return line.substr(directive.size(), line.find('"', directive.size()) - directive.size());
}

bool begins_with(const std::string& line, const char* directive) {
    return line.rfind(directive, 0) == 0;
}

// How many conditions a line opens, less those that it closes.
int conditions_opened(const std::string& line) {
    return begins_with(line, "#if") ? 1 : begins_with(line, "#endif") ? -1 : 0;
}

// A header stands in the text once, where it is met first: never where a condition may leave it
// out, which a file met later would then miss. The guard of a header is no such condition.
void require_unconditional(int conditions, const std::string& name, int line) {
    const bool is_header = name.size() > 2 && name.compare(name.size() - 2, 2, ".h") == 0;
    if (conditions > (is_header ? 1 : 0))
        throw Error(RSH_INVALID_VALUE, "kernel ", name, ": line ", line,
                    " includes a file under a condition, must do so always");
}

// No streams: they take a want of memory for the end of the text.
class Expander {
public:
    explicit Expander(const std::string& folder) : folder_(folder) {}

    void expand(const std::string& name) {
        if (!seen_.insert(name).second) return;
        const std::string text =
            folder_.empty() ? read_embedded(name) : read_from(folder_, name);
        mark(1, name);
        int conditions = 0, number = 1;
        for (size_t begin = 0; begin < text.size(); ++number) {
            const size_t end = std::min(text.find('\n', begin), text.size());
            const std::string line = text.substr(begin, end - begin);
            const std::string include = included_name(line);
            conditions += conditions_opened(line);
            if (include.empty()) {
                out_ += line + '\n';
            } else {
                require_unconditional(conditions, name, number);
                expand(include);
                mark(number + 1, name);
            }
            begin = end + 1;
        }
    }
    std::string text() const { return out_; }

private:
    void mark(int line, const std::string& name) {
        out_ += "#line " + std::to_string(line) + " \"" + name + "\"\n";
    }

    std::string folder_;
    std::set<std::string> seen_;
    std::string out_;
};

}  // namespace

std::string kernel_source(const std::string& stem, const std::string& folder) {
    Expander expander(folder);
    expander.expand(stem + ".cl");
    return expander.text();
}

}  // namespace rsh
