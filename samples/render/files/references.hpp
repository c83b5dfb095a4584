// references.hpp - the files that a line of a mesh or material file names. Names are as exporters
// write them: with blanks, quotes, backslashes, in other letters' case, or with the folders of the
// machine they come from. Reads no file, only folders and lists of archives.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace render {

// The path, for read_asset, of the file that `name` means in the file at `location`. Looks for
//   the name as it is written, in any case of letters,
//   then for the name without its first folders, one by one, down to the bare name,
//   then for the bare name in folders called textures, maps, materials, images
// beside `location`, or in the archive that it is in. Whole paths that are there stay as they are.
// Without a find, the path beside `location`.
std::string find_reference(const std::string& location, std::string_view name);

// The same for a line of one or several names, which blanks, quotes or both separate. As blanks may
// stand in a name too, the longest name that is there is taken; of those that are not, each ends
// behind an `ending`, such as ".mtl".
std::vector<std::string> find_references(const std::string& location, std::string_view line,
                                         std::string_view ending);

}  // namespace render
