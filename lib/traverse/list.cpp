#include "device/error.hpp"
#include "traverse/brute_force.hpp"
#include "traverse/paper/paper.hpp"
#include "traverse/paper_faithful/paper_faithful.hpp"
#include "traverse/tiles/tiles.hpp"

namespace rsh {

// The first one is the default.
const std::vector<const Engine*>& engines() {
    static const Tiles tiles;
    static const Paper paper;
    static const PaperFaithful paper_faithful;
    static const BruteForce brute_force;
    static const std::vector<const Engine*> all = {&tiles, &paper, &paper_faithful,
                                                   &brute_force};
    return all;
}

const Engine& find_engine(cl_uint id) {
    if (id == RSH_ENGINE_DEFAULT) return *engines().front();
    for (const Engine* engine : engines())
        if (engine->id() == id) return *engine;
    throw Error(RSH_INVALID_VALUE,
                "engine: is " + std::to_string(id) + ", must be RSH_ENGINE_...");
}

}  // namespace rsh
