#include "stability/stability_text.hpp"
#include "table/members.hpp"
#include "table/sections.hpp"

namespace bench {

std::string stability_section(const std::vector<ResultFile>& files) {
    std::vector<Case> cases;
    for (const ResultFile& file : files) {
        if (file.suite() != "stability") continue;
        for (const nlohmann::json& c : file.cases())
            if (!text_of(c["params"], "family", "").empty())
                cases.push_back({c["name"].get<std::string>(), c["params"], c["metrics"],
                                 c["ok"].get<bool>()});
    }
    if (cases.empty()) return "";
    const std::string table = stability::table_by_family(cases);
    return "STABILITY: " + table.substr(1);
}

}  // namespace bench
