// gltf_builder.hpp - small glTF files for tests: accessors are added one by one and their bytes kept in one
// buffer, everything else is JSON of the test's own.
#pragma once

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace render {

class GltfBuilder {
public:
    // Each returns the accessor's number. `type`: "SCALAR", "VEC3", ...
    int floats(const std::string& type, const std::vector<float>& numbers);
    int bytes(const std::string& type, const std::vector<uint8_t>& numbers);  // unsigned
    int shorts(const std::string& type, const std::vector<uint16_t>& numbers);
    // Zeros but for some elements, which are floats.
    int sparse(const std::string& type, size_t count, const std::vector<uint8_t>& places,
               const std::vector<float>& numbers);
    // A view of bytes, without an accessor.
    int view(const std::string& bytes);

    // A mesh of one primitive, in a node of its own.
    void add_mesh(const nlohmann::json& primitive);
    // A triangle (0, 0, 0), (1, 0, 0), (0, 1, 0) as add_mesh.
    void add_triangle(const nlohmann::json& material = nullptr);
    // A channel for a member of a node in the one animation, with keys at these times.
    void animate(int node, const char* path, const char* interpolation,
                 const std::vector<float>& times, int output);

    std::string text() const;    // .gltf
    std::string binary() const;  // .glb

    nlohmann::json json{{"asset", {{"version", "2.0"}}}};  // without buffers

private:
    int add(const std::string& type, int component, const std::string& bytes, size_t numbers);

    std::string bytes_;
};

}  // namespace render
