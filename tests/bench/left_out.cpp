#include "left_out.hpp"

#include <fmt/format.h>

#include <vector>

#include "table/members.hpp"
#include "table/text_table.hpp"

namespace bench {
namespace {

// Cases of one row: their name but for the contender's part of it, and their contenders.
struct Group {
    std::string row, why, contenders;
};

struct SplitName {
    std::string row, contender;
};

// The part that says who it is: "reduce/strategy:auto/n:4" into "reduce/n:4" and "auto". Of a batch
// of tests it is the part of the batch.
SplitName split(const std::string& name) {
    for (const std::string mark : {"/strategy:", "/engine:"}) {
        const size_t begin = name.find(mark);
        if (begin == std::string::npos) continue;
        const size_t end = std::min(name.find('/', begin + mark.size()), name.size());
        return {name.substr(0, begin) + name.substr(end),
                name.substr(begin + mark.size(), end - begin - mark.size())};
    }
    if (name.rfind("tests/", 0) == 0)
        return {name.substr(0, name.rfind('/')), name.substr(name.rfind('/') + 1)};
    return {name, ""};
}

void add(std::vector<Group>& groups, const SplitName& name, const std::string& why) {
    for (Group& group : groups)
        if (group.row == name.row && group.why == why) {
            group.contenders += ", " + name.contender;
            return;
        }
    groups.push_back({name.row, why, name.contender});
}

}  // namespace

std::string left_out_text(const nlohmann::json& left_out) {
    std::vector<Group> groups;
    for (const nlohmann::json& one : left_out)
        add(groups, split(text_of(one, "name")), text_of(one, "why"));
    std::string text;
    for (const Group& group : groups)
        text +=
            wrapped(fmt::format("{}{}{}: {}", group.row, group.contenders.empty() ? "" : ": ",
                                group.contenders, group.why));
    return text;
}

}  // namespace bench
