#include "device/error.hpp"
#include "traverse/engine.hpp"

namespace rsh {

// Each in a file of its name.
const Engine& tiles_engine();
const Engine& paper_engine();
const Engine& paper_faithful_engine();
const Engine& brute_force_engine();

// The first one is the default.
Choices<Engine> engines() {
    static const Engine* const all[] = {&tiles_engine(), &paper_engine(),
                                        &paper_faithful_engine(), &brute_force_engine()};
    return all;
}

const Engine& find_engine(cl_uint id) {
    if (id == RSH_ENGINE_DEFAULT) return engines().front();
    for (const Engine* engine : engines())
        if (engine->id() == id) return *engine;
    throw Error(RSH_INVALID_VALUE, "engine: is ", id, ", must be RSH_ENGINE_...");
}

}  // namespace rsh
