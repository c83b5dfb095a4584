// frame_features.cpp - features of frames. The absent ones of a row see one and the same picture.
#include "ablation/features.hpp"
#include "ablation/frame_work.hpp"

namespace bench::ablation {
namespace {

using Change = std::function<void(FrameSetup&)>;

constexpr int kFloor = 0, kMirror = 1, kGlass = 2;

// The scene of the tests without all that a frame can leave out.
FrameSetup bare() {
    FrameSetup setup;
    test::Scene& scene = setup.scene = test::gallery();
    for (rsh_material& material : scene.materials) {
        material.reflection = material.transmission = {};
        material.texture = RSH_NO_TEXTURE;
    }
    for (rsh_light& light : scene.lights) light.casts_shadow = 0;
    scene.normals.clear();
    scene.texcoords.clear();
    scene.textures.clear();
    scene.texels.clear();
    scene.environment = {0.2f, 0.3f, 0.5f};
    scene.environment_texture = 0;
    return setup;
}

std::function<std::unique_ptr<Work>(const Stage&)> frame_of(Change base, Change change = {}) {
    return [=](const Stage& stage) {
        FrameSetup setup = bare();
        base(setup);
        if (change) change(setup);
        return std::make_unique<FrameWork>(stage.device, setup, stage.width, stage.height);
    };
}

Feature feature(const char* name, const Change& base, const Change& compiled_in,
                const Change& used) {
    return {name,
            {{kLeftOut, frame_of(base), ""},
             {kCompiledIn, frame_of(base, compiled_in), ""},
             {kUsed, frame_of(base, used), ""}},
            true};
}

// One that programs are compiled with or without, so that a general program knows neither.
Feature variant(const char* name, const Change& base, const Change& compiled_in,
                const Change& used) {
    Feature made = feature(name, base, compiled_in, used);
    State general = made.states[0];
    general.name = kGeneral;
    general.is_general = true;
    made.states.insert(made.states.begin() + 2, general);
    return made;
}

void nothing(FrameSetup&) {}

Change also(rsh_features features) {
    return [=](FrameSetup& setup) { setup.also = features; };
}

void add_mirror(FrameSetup& setup) {
    setup.bounces = 1;
    setup.scene.materials[kMirror] = test::gallery().materials[kMirror];
}

void add_second_mirror(FrameSetup& setup) {
    setup.scene.materials[kFloor].reflection = {{0.3f, 0.3f, 0.3f, 0}};
}

void add_images(FrameSetup& setup) {
    const test::Scene full = test::gallery();
    setup.scene.texcoords = full.texcoords;
    setup.scene.textures = full.textures;
    setup.scene.texels = full.texels;
    setup.also = RSH_FEATURE_TEXTURE;
}

Feature reflection() {
    return feature(
        "reflection", [](FrameSetup& setup) { setup.bounces = 1; },
        also(RSH_FEATURE_REFLECTION), add_mirror);
}

Feature refraction() {
    return variant("refraction", add_mirror, also(RSH_FEATURE_REFRACTION), [](FrameSetup& s) {
        s.scene.materials[kGlass] = test::gallery().materials[kGlass];
    });
}

Feature shadow() {
    return feature("shadow", nothing, also(RSH_FEATURE_SHADOW), [](FrameSetup& setup) {
        for (rsh_light& light : setup.scene.lights) light.casts_shadow = 1;
    });
}

Feature texture() {
    return variant("texture", nothing, add_images, [](FrameSetup& setup) {
        add_images(setup);
        setup.scene.materials[kFloor].texture = test::gallery().materials[kFloor].texture;
    });
}

// Normals of zero count as none.
Feature smooth_normals() {
    return variant(
        "smooth_normals", nothing,
        [](FrameSetup& setup) { setup.scene.normals.resize(setup.scene.mesh.vertices.size()); },
        [](FrameSetup& setup) { setup.scene.normals = test::gallery().normals; });
}

// An image of one white texel is the plain colour.
Feature environment_image() {
    return variant(
        "environment_image", nothing,
        [](FrameSetup& setup) {
            const std::vector<float> white = {1, 1, 1, 1};
            setup.scene.environment_texture = 1 + setup.scene.add_texture(1, 1, white);
        },
        [](FrameSetup& setup) {
            const test::Scene full = test::gallery();
            setup.scene.textures = full.textures;
            setup.scene.texels = full.texels;
            setup.scene.environment_texture = full.environment_texture;
        });
}

// A single mirror, which does not see itself, sends no ray twice.
Feature second_bounce() {
    return feature(
        "second_bounce", add_mirror, [](FrameSetup& setup) { setup.bounces = 2; },
        [](FrameSetup& setup) {
            setup.bounces = 2;
            add_second_mirror(setup);
        });
}

// Behind a single mirror no ray is cut.
Feature cut() {
    return feature(
        "cut", add_mirror, [](FrameSetup& setup) { setup.scene.cut = RSH_CUT_ENVIRONMENT; },
        [](FrameSetup& setup) {
            setup.scene.cut = RSH_CUT_ENVIRONMENT;
            add_second_mirror(setup);
        });
}

Feature audit() {
    Feature made =
        feature("audit", add_mirror, {}, [](FrameSetup& setup) { setup.audit_rays = 64; });
    made.states[1] = {
        kCompiledIn, {}, "a program of its own, which only frames that audit launch"};
    return made;
}

// Without times, with times that nobody asks for, counted.
Feature statistics() {
    const Change profiled = [](FrameSetup& setup) { setup.is_profiled = true; };
    Feature made = feature("statistics", add_mirror, profiled, profiled);
    made.states[2].is_counted = true;
    return made;
}

}  // namespace

std::vector<Feature> frame_features() {
    return {reflection(),        refraction(),    shadow(), texture(), smooth_normals(),
            environment_image(), second_bounce(), cut(),    audit(),   statistics()};
}

}  // namespace bench::ablation
