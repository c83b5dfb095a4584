// rows.hpp - the figures of the paper's talk, a row each: the scene that stands for the paper's, its size,
// which rays it traces, and the milliseconds that the talk tells of a GeForce 8800 GTS (2007).
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "frame/ray_maker.hpp"

namespace bench::paper {

// What makes the scene. All but kFile are generated.
enum class Source { kSphere, kCovering, kSeveral, kStatue, kLayers, kFile };

struct SceneKind {
    Source source;
    std::string name;       // of the scene that is rendered, in the results
    int64_t triangles = 0;  // of a generated scene, about
    cl_uint layers = 1;     // of kLayers: sheets, of which the first hides the others
    std::string file;       // of samples/scenes, of kFile
    bool moves = false;     // from frame to frame
    // Of kFile: what is changed to have more rays: files of meshes that become mirrors, and where a
    // camera that sees them stands and looks.
    std::vector<std::string> mirrors = {};
    std::optional<std::pair<glm::vec3, glm::vec3>> eye_and_target = {};
};

struct Row {
    std::string name;  // "one_reflector"
    SceneKind scene;
    Size size{512, 512};
    cl_uint bounces = 1;  // reflections
    bool has_shadows = false;
    std::optional<double> paper_ms = {};
    bool is_quick = false;  // part of --quick, with the engine `tiles`
    // What the stand-in must be like to stand for the paper's scene: the share of pixels that spawn rays,
    // and how many reflecting things are seen.
    double least_spawn_share = 0;
    size_t least_reflectors = 0;
    std::string strategy = {};  // RSH_STRATEGY_..., by name; empty: the library's choice

    // Only paper_faithful reduces by a strategy.
    bool takes(const std::string& engine) const {
        return strategy.empty() || engine == "paper_faithful";
    }
};

// A row of one name at several numbers of triangles, pixels or layers, or with several strategies, is a
// series.
std::vector<Row> rows();

// "paper/row:patio/triangles:700000/size:512x512/engine:tiles"; behind the triangles "/layers:4" or
// "/strategy:chunk", if the row is of these.
std::string case_name(const Row& row, const std::string& engine);

// The row without a scene: the hierarchy over 1 M rays, against a copy of their bytes.
constexpr const char* kBuildRow = "build";
constexpr double kBuildPaperMs = 2;
constexpr double kMostBuildOverCopy = 1.2;

constexpr const char* kEngines[] = {"paper_faithful", "paper", "tiles"};

}  // namespace bench::paper
