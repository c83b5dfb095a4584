// motion_schema.hpp - the scene file's "transform" lists and "keys".
#pragma once

#include <vector>

#include "files/json_value.hpp"
#include "scene/motion.hpp"

namespace render {

// One step or an array of steps {"translate": ...}, {"rotate": ...}, {"scale": ...},
// {"matrix": ...}, applied to the mesh in that order.
glm::dmat4 transform(const JsonValue& value);

std::vector<RigidKey> rigid_keys(const JsonValue& value);

// The "time" of a key [s].
double key_time(const JsonValue& key);

// At least one key, each read by read(item) and later than the one before.
template <typename Key, typename Read>
std::vector<Key> ascending_keys(const JsonValue& value, const Read& read) {
    std::vector<Key> keys;
    for (const JsonValue& item : value.items()) {
        const Key key = read(item);
        if (!keys.empty() && !(key.time > keys.back().time))
            item.member("time").fail("a time after the key before");
        keys.push_back(key);
    }
    if (keys.empty()) value.fail("an array of at least one key");
    return keys;
}

}  // namespace render
