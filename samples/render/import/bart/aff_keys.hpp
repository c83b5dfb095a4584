// aff_keys.hpp - lists of keys in AFF files, put into an order that can be played. Knows no time but
// that of keys.
#pragma once

#include <string>
#include <vector>

#include "import/bart/aff_curve.hpp"
#include "import/bart/aff_scene.hpp"
#include "import/bart/aff_tokens.hpp"

namespace render {

// BART's own animations restart some lists at an earlier time. A program that looks a time up from
// the front never gets to such keys: they are left out, with a warning, up to the first one that is
// later than all before. Other lists have two keys at one time, as times are rounded to hundredths of a
// second; both stay, and what they move jumps there, with a warning too. Throws LoadError for a time
// that is no number.
class AffKeys {
public:
    AffKeys(AffTokens& tokens, std::vector<std::string>& warnings)
        : tokens_(tokens), warnings_(warnings) {}

    // "transl", "rot" or "scale" of the keys `name`; at least kMinCurveKeys come out.
    std::vector<CurveKey> curve(const std::string& kind, const std::string& name);
    std::vector<VisibilityKey> visibility(const std::string& name);
    // Times and keys; the vertex is not set. Only the first one with a slip is warned of.
    AffMorph morph();

private:
    struct Order;
    double time();

    AffTokens& tokens_;
    std::vector<std::string>& warnings_;
    bool has_warned_of_morph_ = false;
};

}  // namespace render
