// picture_output.cpp - a WholeFile and what writes into it.
#include "cli/picture_output.hpp"

#include "cli/interrupt.hpp"
#include "cli/write_output.hpp"

namespace render {

PictureOutput::PictureOutput(const std::string& path, glm::uvec2 size,
                             const std::string& description)
    : path_(path), size_(size), description_(description) {}

void PictureOutput::write(const Strip& strip) {
    if (path_.empty()) return;
    if (!file_) {
        file_.emplace(path_);
        writer_.emplace(*file_, path_, size_.x, size_.y, description_);
    }
    writer_->write(strip);
}

void PictureOutput::commit() {
    if (path_.empty()) return;
    writer_->finish();
    commit_output(*file_);
}

void write_layers(const std::string& path, const rsh::Device& device, const World& world,
                  const rsh_frame_desc& picture) {
    WholeFile file(path);
    LayerWriter writer(file, path, {picture.width, picture.height});
    render_layers(device, world, picture, [&](const LayerStrip& strip) {
        stop_if_interrupted();
        writer.write(strip);
    });
    writer.finish();
    commit_output(file);
}

}  // namespace render
