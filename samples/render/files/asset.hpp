// asset.hpp - the bytes behind a path: a plain file, a compressed file, or a member of an
// archive. Unpacks in memory; writes nothing.
//
// A path is one of
//   dir/x.ply             the file; if it is absent, x.ply.xz (or .gz, .bz2, .zst) beside it
//   dir/x.ply.xz          a compressed file
//   dir/a.tar.xz:b/x.obj  member b/x.obj of an archive (tar, compressed tar, zip)
//   dir/x.obj             if both are absent and dir/x.tar.xz holds x.obj: that member
#pragma once

#include <optional>
#include <string>

namespace render {

struct Asset {
    std::string location;  // where the bytes were found, one of the first three forms
    std::string bytes;
};

// Throws LoadError when there is nothing to read, or what there is cannot be unpacked.
Asset read_asset(const std::string& path);

// The path of what read_asset would read for `path`, in the case of letters that it has there;
// nothing if it is not there in any case of letters.
std::optional<std::string> find_asset(const std::string& path);

// The path of `name` as a file at `location` refers to it: beside it, in its archive if it is
// in one. An absolute `name` stays as it is.
std::string sibling_path(const std::string& location, const std::string& name);

// Lower-case ending of the file inside: "ply" for x.ply.xz and for a.tar.xz:x.ply.
std::string inner_extension(const std::string& location);

}  // namespace render
