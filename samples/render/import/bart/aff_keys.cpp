// aff_keys.cpp - reads lists of keys, one at a time.
#include "import/bart/aff_keys.hpp"

#include <cmath>

namespace render {

// Which keys of a list are kept.
struct AffKeys::Order {
    bool is_first = true, has_restarted = false;
    double latest = 0.0;          // of the keys kept
    double first_left_out = 0.0;  // its time ...
    double latest_then = 0.0;     // ... and the latest before it
    size_t left_out = 0;

    bool keeps(double time) {
        const bool is_later = has_restarted ? time > latest : time >= latest;
        if (is_first || is_later) {
            is_first = has_restarted = false;
            latest = time;
            return true;
        }
        if (left_out++ == 0) first_left_out = time, latest_then = latest;
        has_restarted = true;
        return false;
    }

    void warn(const std::string& what, AffTokens& tokens,
              std::vector<std::string>& warnings) const {
        if (left_out == 0) return;
        warnings.push_back(tokens.where() + ": " + what + ": " + std::to_string(left_out) +
                           " keys are left out, as a key at " + std::to_string(first_left_out) +
                           " s comes after one at " + std::to_string(latest_then) + " s");
    }
};

double AffKeys::time() {
    const double time = tokens_.number("time");
    if (!std::isfinite(time))
        tokens_.fail("the time of a key is " + std::to_string(time) + ", but must be finite");
    return time;
}

std::vector<CurveKey> AffKeys::curve(const std::string& kind, const std::string& name) {
    const bool is_rotation = kind == "rot";
    const size_t count = tokens_.count("keys", is_rotation ? 8 : 7);
    if (count < kMinCurveKeys)
        tokens_.fail("a curve needs at least 4 keys, but has " + std::to_string(count));
    std::vector<CurveKey> keys;
    Order order;
    for (size_t i = 0; i < count; ++i) {
        CurveKey key;
        key.time = time();
        key.value = tokens_.vector("value");
        if (is_rotation) key.degrees = tokens_.number("angle");
        key.tension = tokens_.number("tension");
        key.continuity = tokens_.number("continuity");
        key.bias = tokens_.number("bias");
        if (order.keeps(key.time)) keys.push_back(key);
    }
    order.warn(kind + " of '" + name + "'", tokens_, warnings_);
    while (keys.size() < kMinCurveKeys) keys.push_back(keys.back());
    return keys;
}

std::vector<VisibilityKey> AffKeys::visibility(const std::string& name) {
    std::vector<VisibilityKey> keys;
    Order order;
    for (size_t i = 0, count = tokens_.count("keys", 2); i < count; ++i) {
        VisibilityKey key;
        key.time = time();
        key.is_visible = tokens_.number("visibility") != 0.0;
        if (order.keeps(key.time)) keys.push_back(key);
    }
    order.warn("visibility of '" + name + "'", tokens_, warnings_);
    return keys;
}

AffMorph AffKeys::morph() {
    AffMorph morph;
    const size_t count = tokens_.count("keys", 19);
    if (count == 0) tokens_.fail("an animated triangle needs a key, but has 0");
    Order order;
    for (size_t i = 0; i < count; ++i) {
        const double at = time();
        std::array<glm::vec3, 6> key;
        for (glm::vec3& v : key) v = tokens_.vector("corner or normal");
        if (!order.keeps(at)) continue;
        morph.times.push_back(at);
        morph.keys.push_back(key);
    }
    if (!has_warned_of_morph_) order.warn("animated triangle", tokens_, warnings_);
    has_warned_of_morph_ = has_warned_of_morph_ || order.left_out > 0;
    return morph;
}

}  // namespace render
