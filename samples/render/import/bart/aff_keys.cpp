// aff_keys.cpp - reads lists of keys, one at a time.
#include "import/bart/aff_keys.hpp"

#include <cmath>

namespace render {

// Which keys of a list are kept, and what is wrong with their times.
struct AffKeys::Order {
    struct Slip {
        size_t keys = 0;
        std::string where;    // the first of them,
        double time = 0.0;    // its time
        double latest = 0.0;  // and the latest one before it
    };
    bool is_first = true, has_restarted = false;
    double latest = 0.0;  // of the keys kept
    Slip restarts, jumps;

    // Of the key whose time has just been read.
    bool keeps(double time, AffTokens& tokens) {
        const bool is_later = has_restarted ? time > latest : time >= latest;
        if (!is_first && !is_later) {
            note(restarts, time, tokens);
            has_restarted = true;
            return false;
        }
        if (!is_first && time == latest) note(jumps, time, tokens);
        is_first = has_restarted = false;
        latest = time;
        return true;
    }

    void note(Slip& slip, double time, AffTokens& tokens) const {
        if (slip.keys++ == 0) slip = {1, tokens.where(), time, latest};
    }

    bool is_right() const { return restarts.keys == 0 && jumps.keys == 0; }

    void warn(const std::string& what, std::vector<std::string>& warnings) const {
        if (restarts.keys > 0)
            warnings.push_back(restarts.where + ": " + what +
                               ": keys that go back in time and are left out: " +
                               std::to_string(restarts.keys) + "; the first, at " +
                               std::to_string(restarts.time) + " s, comes after one at " +
                               std::to_string(restarts.latest) + " s");
        if (jumps.keys > 0)
            warnings.push_back(jumps.where + ": " + what +
                               ": keys at the time of the key before, where it jumps: " +
                               std::to_string(jumps.keys) + "; the first at " +
                               std::to_string(jumps.time) + " s");
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
        const bool is_kept = order.keeps(key.time, tokens_);
        key.value = tokens_.vector("value");
        if (is_rotation) key.degrees = tokens_.number("angle");
        key.tension = tokens_.number("tension");
        key.continuity = tokens_.number("continuity");
        key.bias = tokens_.number("bias");
        if (is_kept) keys.push_back(key);
    }
    order.warn(kind + " of '" + name + "'", warnings_);
    while (keys.size() < kMinCurveKeys) keys.push_back(keys.back());
    return keys;
}

std::vector<VisibilityKey> AffKeys::visibility(const std::string& name) {
    std::vector<VisibilityKey> keys;
    Order order;
    for (size_t i = 0, count = tokens_.count("keys", 2); i < count; ++i) {
        VisibilityKey key;
        key.time = time();
        const bool is_kept = order.keeps(key.time, tokens_);
        key.is_visible = tokens_.number("visibility") != 0.0;
        if (is_kept) keys.push_back(key);
    }
    order.warn("visibility of '" + name + "'", warnings_);
    return keys;
}

AffMorph AffKeys::morph() {
    AffMorph morph;
    const size_t count = tokens_.count("keys", 19);
    if (count == 0) tokens_.fail("an animated triangle needs a key, but has 0");
    Order order;
    for (size_t i = 0; i < count; ++i) {
        const double at = time();
        const bool is_kept = order.keeps(at, tokens_);
        std::array<glm::vec3, 6> key;
        for (glm::vec3& v : key) v = tokens_.vector("corner or normal");
        if (!is_kept) continue;
        morph.times.push_back(at);
        morph.keys.push_back(key);
    }
    if (!has_warned_of_morph_) order.warn("animated triangle", warnings_);
    has_warned_of_morph_ = has_warned_of_morph_ || !order.is_right();
    return morph;
}

}  // namespace render
