// vertex_frames.hpp - a mesh whose vertices move from frame to frame, read from raw positions:
// little-endian float32 [frame][vertex][x, y, z] in the vertex order of the mesh file, beside a
// JSON object with frames, vertices, triangles, time_start and time_end. Linear between frames;
// the time is clamped, not repeated.
#pragma once

#include "import/mesh_file.hpp"

namespace render {

class VertexFrames : public Animation {
public:
    struct Span {
        double start = 0.0, end = 0.0;
        int frames = 1;  // the first at `start`, the last at `end`
    };
    VertexFrames(NumberedModel base, std::vector<glm::vec3> positions, Span span);

    double start() const override { return span_.start; }
    double end() const override { return span_.end; }
    int frames() const override { return span_.frames; }
    // Normals are computed anew if the mesh file has any.
    Model at(double time) const override;

private:
    void compute_normals(Mesh& mesh) const;

    NumberedModel base_;
    std::vector<glm::vec3> positions_;
    Span span_;
    std::vector<uint32_t> normal_groups_;  // per vertex; empty without normals
};

}  // namespace render
