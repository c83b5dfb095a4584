#include "device/error.hpp"
#include "traverse/engine.hpp"

namespace rsh {

// Each in a file of its name.
const Engine& tiles_engine();
const Engine& paper_engine();
const Engine& paper_faithful_engine();
const Engine& brute_force_engine();

// In the order of preference; the last two suit any device.
Choices<Engine> engines() {
    static const Engine* const all[] = {&tiles_engine(), &paper_engine(),
                                        &paper_faithful_engine(), &brute_force_engine()};
    return all;
}

const Engine& find_engine(cl_uint id) {
    for (const Engine* engine : engines())
        if (engine->id() == id) return *engine;
    throw Error(RSH_INVALID_VALUE, "engine: is ", id, ", must be RSH_ENGINE_...");
}

const Engine& default_engine(const DeviceCaps& caps) noexcept {
    const Engine* const* engine = engines().begin();
    while (!(*engine)->suits(caps)) ++engine;
    return **engine;
}

}  // namespace rsh
