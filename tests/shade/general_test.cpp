// general_test.cpp - the general program gives the bits of each variant, in every call that runs one.
#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>

#include "support/prepare.hpp"
#include "support/render.hpp"
#include "support/trace.hpp"

namespace {

using test::Buffer;
using test::device;
using Outputs = std::map<std::string, std::vector<uint8_t>>;  // by what they come from

constexpr rsh_features kFeatures[] = {RSH_FEATURE_REFRACTION, RSH_FEATURE_TEXTURE,
                                      RSH_FEATURE_SMOOTH_NORMAL, RSH_FEATURE_ENVIRONMENT_IMAGE};

// The bits of one of the 16 sets of features.
rsh_features set_of(uint32_t number) {
    rsh_features set = 0;
    for (uint32_t k = 0; k < 4; ++k)
        if (number >> k & 1) set |= kFeatures[k];
    return set;
}

template <class T>
void append(std::vector<uint8_t>& bytes, const std::vector<T>& data) {
    const auto* const first = reinterpret_cast<const uint8_t*>(data.data());
    bytes.insert(bytes.end(), first, first + data.size() * sizeof(T));
}

template <class... T>
std::vector<uint8_t> bytes_of(const T&... vectors) {
    std::vector<uint8_t> bytes;
    (append(bytes, vectors), ...);
    return bytes;
}

// With light for rays that are not traced, too.
test::Scene scene() {
    test::Scene scene = test::gallery();
    scene.cut = RSH_CUT_ENVIRONMENT;
    return scene;
}

// All calls over a picture of the gallery, some of whose features are left out.
class Calls {
public:
    Calls(rsh_context context, rsh_features without)
        : context_(context),
          scene_(scene(), without),
          in_rays_(rays().rays),
          in_hits_(hits()),
          in_weights_(std::vector<cl_float4>(kRays, cl_float4{{0.9f, 0.7f, 0.5f, 0}})) {}

    Outputs outputs() {
        Outputs all = {{"find_surfaces", surfaces()}, {"shadow", shadow()}};
        all["frame"] = frame();
        for (const cl_uint kind :
             {RSH_SPAWN_REFLECTION, RSH_SPAWN_REFRACTION, RSH_SPAWN_SHADOW})
            all["spawn " + std::to_string(kind)] = spawn(kind);
        all["spawn_wave"] = spawn_wave();
        all["gather_wave"] = gather_wave();
        all["shade"] = shade();
        return all;
    }

    // As of rsh_frame, which runs what no other call does.
    std::vector<uint8_t> frame() const {
        test::FrameOptions options;
        options.bounces = 2;
        options.min_weight = 0.05f;
        options.context = context_;
        return bytes_of(test::frame(scene_, options));
    }

private:
    static constexpr uint32_t kWidth = 45, kHeight = 29, kRays = kWidth * kHeight;

    static test::Rays rays() {
        return test::pinhole_rays(kWidth, kHeight, {0.4f, 2.2f, 5.5f}, {0, 0.8f, 0}, 3);
    }
    static std::vector<rsh_hit> hits() {
        return closest_hits(test::DeviceMesh(test::gallery().mesh), rays());
    }

    // What descriptors of calls over hits have in common.
    template <class Desc>
    Desc desc_of() const {
        Desc desc = {};
        desc.struct_size = sizeof desc;
        desc.scene = &scene_.desc;
        desc.rays = in_rays_.get();
        desc.hits = in_hits_.get();
        return desc;
    }
    template <class Desc, class Call>
    void run(Call call, const Desc& desc) const {
        RSH_CHECK(call(context_, device().queue(), &desc, 0, nullptr, nullptr));
        device().queue.finish();
    }

    std::vector<uint8_t> surfaces() const {
        const Buffer<rsh_surface> found(kRays);
        auto desc = desc_of<rsh_find_surfaces_desc>();
        desc.ray_count = kRays;
        desc.surfaces = found.get();
        run(rsh_find_surfaces, desc);
        return bytes_of(found.read());
    }

    std::vector<uint8_t> spawn(cl_uint kind) const {
        const Buffer<rsh_ray> spawned(kRays);
        const Buffer<cl_float4> weights(kRays);
        const Buffer<uint32_t> skip(kRays), count(std::vector<uint32_t>{0});
        auto desc = desc_of<rsh_spawn_desc>();
        desc.kind = kind;
        desc.ray_count = kRays;
        desc.weights = in_weights_.get();
        desc.spawned_rays = spawned.get();
        desc.spawned_weights = kind == RSH_SPAWN_SHADOW ? nullptr : weights.get();
        desc.spawned_skip = skip.get();
        desc.active_count = count.get();
        run(rsh_spawn, desc);
        return bytes_of(spawned.read(), weights.read(), skip.read(), count.read());
    }

    std::vector<uint8_t> spawn_wave() {
        const Buffer<rsh_ray> spawned(2 * kRays);
        const Buffer<cl_float4> weights(2 * kRays);
        const Buffer<uint32_t> skip(2 * kRays), parents(2 * kRays);
        auto desc = desc_of<rsh_spawn_wave_desc>();
        desc.width = kWidth;
        desc.height = kHeight;
        desc.weights = in_weights_.get();
        desc.capacity = 2 * kRays;
        desc.branches = branches_.get();
        desc.spawned_rays = spawned.get();
        desc.spawned_weights = weights.get();
        desc.spawned_skip = skip.get();
        desc.spawned_count = spawned_count_.get();
        desc.spawned_parents = parents.get();
        run(rsh_spawn_wave, desc);
        return bytes_of(branches_.read(), spawned_count_.read(), spawned.read(), weights.read(),
                        skip.read(), parents.read());
    }

    // After spawn_wave.
    std::vector<uint8_t> gather_wave() const {
        const Buffer<cl_float4> seen(
            std::vector<cl_float4>(2 * kRays, cl_float4{{0.1f, 0.2f, 0.3f, 0}}));
        const Buffer<cl_float4> colour(std::vector<cl_float4>(kRays, cl_float4{}));
        rsh_gather_wave_desc desc = {};
        desc.struct_size = sizeof desc;
        desc.scene = &scene_.desc;
        desc.width = kWidth;
        desc.height = kHeight;
        desc.capacity = 2 * kRays;
        desc.branches = branches_.get();
        desc.spawned_count = spawned_count_.get();
        desc.spawned_colour = seen.get();
        desc.colour = colour.get();
        run(rsh_gather_wave, desc);
        return bytes_of(colour.read());
    }

    std::vector<uint8_t> shadow() {
        auto desc = desc_of<rsh_shadow_desc>();
        desc.width = kWidth;
        desc.height = kHeight;
        desc.occlusion = occlusion_.get();
        run(rsh_shadow, desc);
        return bytes_of(occlusion_.read());
    }

    // After shadow.
    std::vector<uint8_t> shade() const {
        const Buffer<cl_float4> colour(
            std::vector<cl_float4>(kRays, cl_float4{{0.5f, 0.25f, 0, 1}}));
        auto desc = desc_of<rsh_shade_desc>();
        desc.ray_count = kRays;
        desc.weights = in_weights_.get();
        desc.occlusion = occlusion_.get();
        desc.colour = colour.get();
        run(rsh_shade, desc);
        return bytes_of(colour.read());
    }

    const rsh_context context_;
    const test::DeviceScene scene_;
    const Buffer<rsh_ray> in_rays_;
    const Buffer<rsh_hit> in_hits_;
    const Buffer<cl_float4> in_weights_;
    const Buffer<uint32_t> branches_{2 * kRays}, spawned_count_{2}, occlusion_{kRays};
};

// One context for variants, one for the general program.
class GeneralProgram : public ::testing::TestWithParam<cl_uint> {
protected:
    static rsh_context_desc desc_with(cl_uint max_variants) {
        rsh_context_desc desc = {};
        desc.vector_width = GetParam();
        desc.max_variants = max_variants;
        return desc;
    }

    void expect_same(rsh_features without) const {
        const Outputs expected = Calls(variants_.get(), without).outputs();
        for (const auto& [call, bytes] : Calls(general_.get(), without).outputs())
            EXPECT_TRUE(bytes == expected.at(call))
                << call << " without the features " << without << ", vector_width "
                << GetParam();
    }

    const test::OwnContext variants_{desc_with(0)}, general_{desc_with(RSH_NO_VARIANTS)};
};

TEST_P(GeneralProgram, GivesTheBitsOfEachVariant) {
    RSH_CHECK(rsh_count_statistics(variants_.get(), CL_TRUE));
    RSH_CHECK(rsh_count_statistics(general_.get(), CL_TRUE));
    // Of GPUs' programs, which are slow to compile here, the first and the last.
    const uint32_t step = GetParam() == 0 ? 1 : 15;
    for (uint32_t number = 0; number < 16; number += step) expect_same(set_of(number));
    const rsh_statistics special = test::statistics_of(variants_.get());
    EXPECT_EQ(special.variants, step == 1 ? 8u : 2u);
    EXPECT_EQ(special.general_launches, 0u);
    const rsh_statistics general = test::statistics_of(general_.get());
    EXPECT_EQ(general.variants, 0u);
    EXPECT_GT(general.general_launches, 0u);
    EXPECT_LT(general.general_launches, general.launches);
}

INSTANTIATE_TEST_SUITE_P(Widths, GeneralProgram, ::testing::Values(0u, 1u),
                         [](const auto& width) {
                             return width.param == 0 ? "OfTheDevice" : "One";
                         });

// Else the test above would show less than it says.
TEST(GeneralProgramsFeatures, EachChangeThePicture) {
    const test::OwnContext own([] {
        rsh_context_desc desc = {};
        desc.max_variants = RSH_NO_VARIANTS;
        return desc;
    }());
    std::set<std::vector<uint8_t>> pictures;
    for (uint32_t number = 0; number < 16; ++number)
        pictures.insert(Calls(own.get(), set_of(number)).frame());
    EXPECT_EQ(pictures.size(), 16u);
}

}  // namespace
