// frame_scene.hpp - the scenes of rsh-bench frame: a closed room of any number of triangles
// with one kind of reflector, or a scene file; and the same with every vertex moved to a
// moment. Knows no device.
#pragma once

#include <glm/glm.hpp>

#include <vector>

#include "frame/still_scene.hpp"

namespace bench {

class FrameScene {
public:
    // Reads files; throws std::runtime_error when one is missing.
    explicit FrameScene(const SceneSpec& spec);
    // Of which the first vertices stay where they are.
    FrameScene(StillScene scene, size_t still_vertices);

    const render::Mesh& mesh() const { return still_.mesh; }  // at rest
    const std::vector<rsh_material>& materials() const { return still_.materials; }
    const std::vector<render::Light>& lights() const { return still_.lights; }
    const render::Camera& camera() const { return still_.camera; }

    // Writes all vertices at `time`; every one moves with it, smoothly in place and time.
    void move(double time, std::vector<glm::vec3>& positions) const;

    // What reflects little and refracts most: its second bounce is a refraction as well.
    bool is_glass() const { return is_glass_; }

    // Index of the first light whose shadow rays run towards a point; -1: there is none.
    int point_light() const;

private:
    void make_motion(bool is_rigid);

    StillScene still_;
    bool is_glass_;
    std::vector<glm::vec3> sway_;  // per vertex: where it goes from its place of rest
};

}  // namespace bench
