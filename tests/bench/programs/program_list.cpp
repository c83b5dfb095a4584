#include "programs/program_list.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <sstream>

namespace bench {
namespace {

// What a frame launches, by what is worth knowing most; then its reductions.
constexpr std::array<const char*, 8> kOfAFrame = {
    "programs/paper_faithful", "programs/tiles",     "programs/surface", "camera/rasterize",
    "reduce/scan_scatter",     "reduce/scan_counts", "reduce/lookback",  "reduce/chunk"};

size_t rank_of(const std::string& stem) {
    return size_t(std::find(kOfAFrame.begin(), kOfAFrame.end(), stem) - kOfAFrame.begin());
}

}  // namespace

std::vector<ProgramName> read_program_list(std::istream& lines) {
    std::vector<ProgramName> first, others;
    std::set<std::string> stems;
    for (std::string line; std::getline(lines, line);) {
        ProgramName name;
        std::istringstream words(line);
        if (!(words >> name.stem)) continue;
        for (std::string word; words >> word;)
            name.options += (name.options.empty() ? "" : " ") + word;
        (stems.insert(name.stem).second ? first : others).push_back(name);
    }
    for (std::vector<ProgramName>* part : {&first, &others})
        std::stable_sort(part->begin(), part->end(),
                         [](const ProgramName& a, const ProgramName& b) {
                             return rank_of(a.stem) < rank_of(b.stem);
                         });
    first.insert(first.end(), others.begin(), others.end());
    return first;
}

}  // namespace bench
