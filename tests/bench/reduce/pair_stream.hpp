// pair_stream.hpp - streams that a traversal has to reduce: the tested pairs of one level of the
// hierarchy over a frame's reflected rays, four per pair of the level above, in the order in
// which the engine "paper_faithful" writes them. The library builds rays, hierarchy and bounds; the
// tests are done again here, on the host, because the library hands no stream out.
#pragma once

#include <filesystem>

#include "device.hpp"

namespace bench {

// RSH_SCENES is set, and this program reads scene files: there are frames to take.
bool has_scenes();

// "pairs:chinese_dragon_20k:3": tested pairs of level 3 for samples/scenes/chinese_dragon_20k.json
// at 512 x 512; 1 where one survives. At most `most` of them. Throws std::runtime_error when the
// numbers of pairs are not those that the library counted.
std::vector<cl_uchar> make_pair_flags(const Device& device, const std::string& pattern,
                                      size_t most);

// Writes the tested pairs of each level to FOLDER/SCENE_level_N.pairs. Throws as make_pair_flags does.
void dump_pair_streams(const Device& device, const std::string& scene,
                       const std::filesystem::path& folder);

}  // namespace bench
