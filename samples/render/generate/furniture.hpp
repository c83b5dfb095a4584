// furniture.hpp - things that stand in the generated room, each a few patches: boxes, turned
// (lathe) shapes, balls, tables, chairs, shelves. Says nothing about how finely they are cut.
#pragma once

#include <glm/glm.hpp>

#include <random>
#include <vector>

#include "generate/patch.hpp"

namespace render {

using Patches = std::vector<Patch>;

// The parallelogram corner + u * along_u + v * along_v; its normal is along_u x along_v.
void add_plane(Patches& patches, glm::vec3 corner, glm::vec3 along_u, glm::vec3 along_v,
               uint32_t material);

void add_box(Patches& patches, glm::vec3 low, glm::vec3 high, uint32_t material);

void add_ball(Patches& patches, glm::vec3 centre, float radius, uint32_t material);

// A shape turned about the vertical axis through `foot`: (radius, height) of its outline,
// upwards, joined by a Catmull-Rom spline. An outline that starts or ends at radius 0 is closed
// there.
void add_turned(Patches& patches, glm::vec3 foot, const std::vector<glm::vec2>& outline,
                uint32_t material);

// Numbers in [low, high), the same on every platform (std::uniform_real_distribution is not).
class Dice {
public:
    explicit Dice(uint32_t seed) : generator_(seed) {}
    float between(float low, float high) {
        return low + (high - low) * static_cast<float>(generator_() * 0x1p-32);
    }
    uint32_t below(uint32_t count) { return generator_() % count; }

private:
    std::mt19937 generator_;
};

struct FurnitureMaterials {
    uint32_t wood, dark_wood, cloth, first_glaze, glaze_count;
};

void add_table_with_chairs(Patches& patches, glm::vec3 foot,
                           const FurnitureMaterials& materials, Dice& dice);

// Boards, two sides, and vases, balls and books on them; the back is towards -z turned by
// `quarter_turns` times 90 degrees about y.
void add_shelf(Patches& patches, glm::vec3 foot, int quarter_turns,
               const FurnitureMaterials& materials, Dice& dice);

}  // namespace render
