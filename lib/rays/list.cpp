#include "device/error.hpp"
#include "rays/box.hpp"
#include "rays/cone.hpp"

namespace rsh {

// The first one is the default.
const std::vector<const Bound*>& bounds() {
    static const Box box;
    static const Cone cone;
    static const std::vector<const Bound*> all = {&box, &cone};
    return all;
}

const Bound& find_bound(cl_uint id) {
    if (id == RSH_BOUND_DEFAULT) return *bounds().front();
    for (const Bound* bound : bounds())
        if (bound->id() == id) return *bound;
    throw Error(RSH_INVALID_VALUE,
                "bound: is " + std::to_string(id) + ", must be RSH_BOUND_...");
}

}  // namespace rsh
