// aff_animation.hpp - a parsed AFF scene as an animation: camera, lights, transforms and
// morphing triangles at any time, over one topology. What is invisible collapses into a point.
#pragma once

#include "import/bart/aff_scene.hpp"

namespace render {

class AffAnimation : public Animation {
public:
    explicit AffAnimation(AffScene scene);

    double start() const override { return scene_.start; }
    double end() const override { return scene_.end; }
    int frames() const override { return scene_.frames; }
    // The materials hold the file's global ambient light: their ambient is meant for 1.
    Model at(double time) const override;

private:
    // The nodes at one time.
    struct Pose {
        std::vector<glm::dmat4> matrices;
        std::vector<bool> visible;
    };
    Pose pose(double time) const;
    const Track* track(const std::string& name) const;
    void place(uint32_t vertex, const Pose& pose, Mesh& mesh) const;
    void place_lights(double time, const Pose& pose, Model& model) const;
    void place_camera(double time, Model& model) const;

    AffScene scene_;
    Model rest_;                    // everything that stands still
    std::vector<uint32_t> moving_;  // vertices under an animated transform
};

}  // namespace render
