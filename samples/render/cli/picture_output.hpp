// picture_output.hpp - the picture of a frame, and its layers, as files that rsh-render leaves, written
// strip by strip.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>

#include "device/layers.hpp"
#include "files/whole_file.hpp"
#include "picture/picture_writer.hpp"

namespace render {

class PictureOutput {
public:
    PictureOutput() = default;  // takes strips, and leaves no file
    // description: as PictureWriter has it.
    PictureOutput(const std::string& path, glm::uvec2 size, const std::string& description);

    void write(const Strip& strip);  // the first one begins the file
    // As write_output.
    void commit();

private:
    std::string path_;
    glm::uvec2 size_{0};
    std::string description_;
    std::optional<WholeFile> file_;
    std::optional<PictureWriter> writer_;  // into file_
};

// Finds them and writes them; the world is as it is in the picture.
void write_layers(const std::string& path, const rsh::Device& device, const World& world,
                  const rsh_frame_desc& picture);

}  // namespace render
