// sources.hpp - scenes as sources of batches: a mesh on the host, and a mesh that is repeated so often that no
// memory would hold all of it.
#pragma once

#include <rsh/rsh.h>

#include "model/model.hpp"

namespace bench::paper {

// The triangles of a mesh, `most` at a time; 0: as many as the library has room for. The mesh must live on.
class MeshSource {
public:
    explicit MeshSource(const render::Mesh& mesh, cl_uint most = 0);
    MeshSource(const MeshSource&) = delete;
    MeshSource& operator=(const MeshSource&) = delete;

    const rsh_batch_source& get() const { return source_; }

private:
    int fill(rsh_batch& batch) const;

    const render::Mesh& mesh_;
    rsh_batch_source source_{};
};

// `count` copies of a mesh, whose longest side is 1, on a grid of step 1 in front of the origin, each turned
// in its own way. Whole copies at a time; neighbours follow each other.
class RepeatedSource {
public:
    RepeatedSource(const render::Mesh& mesh, cl_uint count, cl_uint most);
    RepeatedSource(const RepeatedSource&) = delete;
    RepeatedSource& operator=(const RepeatedSource&) = delete;

    const rsh_batch_source& get() const { return source_; }

private:
    int fill(rsh_batch& batch) const;
    void add_copy(cl_uint number, rsh_batch& batch) const;

    std::vector<glm::vec3> positions_;
    std::vector<glm::uvec3> triangles_;
    cl_uint count_;
    rsh_batch_source source_{};
};

}  // namespace bench::paper
