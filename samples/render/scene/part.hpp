// part.hpp - one mesh entry of a scene at a moment: its model, placed and with its materials
// changed. Several parts make a World.
#pragma once

#include <memory>
#include <optional>

#include "model/model.hpp"
#include "scene/scene_description.hpp"

namespace render {

class Part {
public:
    explicit Part(MeshEntry entry);  // reads the files

    bool moves() const { return animation_ || !entry_.keys.empty(); }
    std::optional<Interval> time_span() const;  // none when it stands still
    int frames() const;                         // as the animation was made; 1 when it has none
    bool repeats() const { return animation_ && entry_.repeats; }

    // The whole model in world coordinates at `time` [s].
    const Model& at(double time);
    // Of that model: all others are as they were. Empty if it stands still.
    const std::vector<VertexRange>& moving_vertices() const { return moving_; }
    // Whether some triangles of that model are wound otherwise than in the one before it: an
    // animation has begun, or ceased, to mirror them.
    bool has_turned_triangles() const { return has_turned_triangles_; }
    const MeshEntry& entry() const { return entry_; }

private:
    double animation_time(double time) const;
    void smooth();
    void find_moving_vertices();
    void place(double time, const std::vector<VertexRange>& vertices);
    void place_triangles();
    void turn_triangles(const std::vector<glm::uvec3>& now);

    MeshEntry entry_;
    std::unique_ptr<Animation> animation_;
    glm::dmat4 transform_;
    Model rest_;  // before placing
    std::vector<uint32_t>
        uncut_;  // vertex of the file's mesh for each of `rest_`, if that is cut
    std::vector<glm::uvec3> animated_triangles_;  // as the animation wound them last
    bool has_turned_triangles_ = false;
    std::vector<VertexRange> moving_;
    Model placed_;  // kept, so that a moving part reuses its memory
};

}  // namespace render
