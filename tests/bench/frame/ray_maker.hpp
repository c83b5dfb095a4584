// ray_maker.hpp - the rays that are traced: made of a scene's present moment by the library's
// own calls (diffuse ones on the host), in a device buffer and on the host. Times nothing.
#pragma once

#include "frame/scene_on_device.hpp"

namespace bench {

enum class RayKind {
    kPrimary,
    kReflection,
    kRefraction,
    kShadow,
    kSecond,
    kDiffuse,
    kShuffled
};

const char* name_of(RayKind kind);

struct Size {
    cl_uint width, height;
    size_t pixels() const { return size_t{width} * height; }
};

class RayMaker {
public:
    RayMaker(const Device& device, Size size);
    static std::vector<NamedBytes> needs(Size size);  // what that allocates on the device

    // One ray per pixel, inactive where there is none. kSecond: the reflection of the
    // reflection, for glass the refraction of the refraction; kShuffled: reflections in no
    // order. BLOCKS.
    void make(const SceneOnDevice& scene, RayKind kind);

    Size size() const { return size_; }
    const cl::Buffer& buffer() const { return rays_; }  // of the last make()
    const std::vector<rsh_ray>& rays() const;           // the same; BLOCKS the first time
    size_t active_count() const;

private:
    void see(const SceneOnDevice& scene);
    void spawn(const SceneOnDevice& scene, cl_uint kind);
    void trace(const SceneOnDevice& scene);
    void scatter(const SceneOnDevice& scene);
    void shuffle();

    const Device& device_;
    Size size_;
    cl::Buffer rays_, hits_, spawned_, weights_;
    mutable std::vector<rsh_ray> host_;
    mutable bool is_read_ = false;
};

bool is_active(const rsh_ray& ray);

}  // namespace bench
