// gltf_clip.cpp - channels and samplers -> curves, whose times ascend and whose values are complete.
#include "import/gltf/gltf_clip.hpp"

#include <fmt/format.h>

#include <cmath>
#include <set>
#include <stdexcept>

#include "files/json_value.hpp"

namespace render {
namespace {

class ClipReader {
public:
    ClipReader(const GltfDocument& document, size_t clip, const GltfScene& scene,
               const std::vector<size_t>& targets)
        : accessors_(document),
          animation_(document.model.animations[clip]),
          where_(fmt::format("animations[{}]", clip)),
          scene_(scene),
          targets_(targets) {}

    std::vector<GltfCurve> read() const {
        std::vector<GltfCurve> curves;
        std::set<std::pair<int, std::string>> known;
        for (size_t i = 0; i < animation_.channels.size(); ++i) {
            const auto& channel = animation_.channels[i];
            const std::string where = fmt::format("{}.channels[{}]", where_, i);
            if (!known.insert({channel.target_node, channel.target_path}).second)
                accessors_.fail(where + ".target",
                                fmt::format("nodes[{}] has a channel for {} already, one is "
                                            "allowed",
                                            channel.target_node, channel.target_path));
            curves.push_back(curve(channel, where));
        }
        return curves;
    }

private:
    GltfCurve curve(const tinygltf::AnimationChannel& channel, const std::string& where) const {
        GltfCurve c;
        c.node = static_cast<uint32_t>(channel.target_node);
        set_path(channel.target_path, where + ".target", c);
        const auto& sampler = animation_.samplers[static_cast<size_t>(channel.sampler)];
        const std::string place = fmt::format("{}.samplers[{}]", where_, channel.sampler);
        c.interpolation = sampler.interpolation == "STEP" ? GltfInterpolation::step
                          : sampler.interpolation == "CUBICSPLINE"
                              ? GltfInterpolation::cubic_spline
                              : GltfInterpolation::linear;
        read_times(sampler.input, place + ".input", c);
        read_values(sampler.output, place + ".output", c);
        return c;
    }

    void set_path(const std::string& path, const std::string& where, GltfCurve& c) const {
        if (path != "weights" && scene_.nodes[c.node].matrix)
            accessors_.fail(where, fmt::format("nodes[{}] has a matrix, must have translation, "
                                               "rotation and scale",
                                               c.node));
        if (path == "weights" && targets_[c.node] == 0)
            accessors_.fail(where,
                            fmt::format("the mesh of nodes[{}] has no morph targets, must "
                                        "have some",
                                        c.node));
        c.path = path == "translation" ? GltfPath::translation
                 : path == "rotation"  ? GltfPath::rotation
                 : path == "scale"     ? GltfPath::scale
                                       : GltfPath::weights;
        c.width = c.path == GltfPath::weights    ? targets_[c.node]
                  : c.path == GltfPath::rotation ? 4
                                                 : 3;
    }

    void read_times(int input, const std::string& where, GltfCurve& c) const {
        c.times = accessors_.floats(input, TINYGLTF_TYPE_SCALAR, GltfNumbers::floats, where);
        for (size_t i = 0; i < c.times.size(); ++i) {
            if (!std::isfinite(c.times[i]))
                accessors_.fail(
                    where, fmt::format("key {} is {}, must be a finite time", i, c.times[i]));
            if (i > 0 && !(c.times[i] > c.times[i - 1]))
                accessors_.fail(where, fmt::format("key {} is {}, must be after {}, the one "
                                                   "before",
                                                   i, c.times[i], c.times[i - 1]));
        }
    }

    void read_values(int output, const std::string& where, GltfCurve& c) const {
        const bool is_scalar = c.path == GltfPath::weights;
        const size_t per_time = (c.interpolation == GltfInterpolation::cubic_spline ? 3 : 1) *
                                (is_scalar ? c.width : size_t{1});
        if (const size_t count = accessors_.count(output); count != per_time * c.times.size())
            accessors_.fail(where,
                            fmt::format("accessors[{}] has {} elements, must have {} for "
                                        "each of {} keys",
                                        output, count, per_time, c.times.size()));
        const int type = is_scalar                      ? TINYGLTF_TYPE_SCALAR
                         : c.path == GltfPath::rotation ? TINYGLTF_TYPE_VEC4
                                                        : TINYGLTF_TYPE_VEC3;
        const bool is_vector = c.path == GltfPath::translation || c.path == GltfPath::scale;
        c.values = accessors_.floats(
            output, type,
            is_vector ? GltfNumbers::floats : GltfNumbers::floats_or_signed_normalized, where);
    }

    GltfAccessors accessors_;
    const tinygltf::Animation& animation_;
    std::string where_;
    const GltfScene& scene_;
    const std::vector<size_t>& targets_;
};

}  // namespace

std::optional<size_t> choose_clip(GltfDocument& document, const std::string& clip) {
    const auto& animations = document.model.animations;
    std::vector<std::string> names;
    for (size_t i = 0; i < animations.size(); ++i) {
        names.push_back(animations[i].name.empty() ? std::to_string(i) : animations[i].name);
        if (!clip.empty() && names.back() == clip) return i;
    }
    for (size_t i = 0; i < names.size(); ++i)
        if (std::to_string(i) == clip) return i;
    if (!clip.empty())
        throw std::runtime_error(fmt::format(
            "{}: clip: found \"{}\", which the file does not have; nearest: \"{}\", "
            "allowed: {}",
            document.location, clip, nearest_word(clip, names),
            names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "))));
    if (names.empty()) return std::nullopt;
    if (names.size() > 1)
        document.warnings.push_back(
            fmt::format("{}: has {} clips, of which \"{}\" plays; \"clip\" of a scene file "
                        "chooses among {}",
                        document.location, names.size(), names[0], fmt::join(names, ", ")));
    return 0;
}

std::vector<GltfCurve> read_clip(const GltfDocument& document, size_t clip,
                                 const GltfScene& scene, const std::vector<size_t>& targets) {
    return ClipReader(document, clip, scene, targets).read();
}

}  // namespace render
