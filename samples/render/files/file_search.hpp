// file_search.hpp - finds the files that a scene names: beside the scene file, then in the
// folders of RSH_SCENES, then in those of RSH_ASSETS. Opens nothing.
#pragma once

#include <string>
#include <vector>

namespace render {

// The folders in which a name used in a scene file that stands in `scene_folder` is looked up.
std::vector<std::string> search_folders(const std::string& scene_folder);

// The first `name` in `folders` that read_asset can open: the file itself, compressed, or in an
// archive. Throws with every folder that was tried; `where` starts the message.
std::string find_file(const std::string& name, const std::vector<std::string>& folders,
                      const std::string& where);

}  // namespace render
