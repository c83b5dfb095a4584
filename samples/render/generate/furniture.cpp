// furniture.cpp - tables, chairs and shelves out of surfaces.
#include "generate/furniture.hpp"

#include <cmath>

namespace render {
namespace {

uint32_t any_glaze(const FurnitureMaterials& materials, Dice& dice) {
    return materials.first_glaze + dice.below(materials.glaze_count);
}

void add_leg(Patches& patches, glm::vec3 foot, float height, float width, uint32_t material) {
    add_turned(patches, foot,
               {{0.0f, 0.0f},
                {0.6f * width, 0.0f},
                {0.7f * width, 0.1f * height},
                {0.45f * width, 0.2f * height},
                {width, 0.7f * height},
                {0.8f * width, height}},
               material);
}

void add_legs(Patches& patches, glm::vec3 middle, glm::vec3 size, float width,
              uint32_t material) {
    for (const float x : {-1.0f, 1.0f})
        for (const float z : {-1.0f, 1.0f})
            add_leg(patches, middle + glm::vec3(x * size.x, 0, z * size.z), size.y, width,
                    material);
}

void add_vase(Patches& patches, glm::vec3 foot, float height, uint32_t material, Dice& dice) {
    const float belly = height * dice.between(0.22f, 0.34f);
    const float neck = height * dice.between(0.08f, 0.13f);
    const float thin = 0.02f * height;
    add_turned(patches, foot,
               {{0.0f, 0.0f},
                {0.6f * belly, 0.0f},
                {belly, 0.35f * height},
                {0.7f * belly, 0.65f * height},
                {neck, 0.85f * height},
                {1.5f * neck, height},
                {1.5f * neck - thin, height},
                {neck - thin, 0.85f * height},
                {0.7f * belly - thin, 0.6f * height},
                {0.0f, 0.4f * height}},
               material);
}

// `away` is the direction from the table to the chair, along x or z.
void add_chair(Patches& patches, glm::vec3 foot, glm::vec3 away, const FurnitureMaterials& m) {
    constexpr float kHalf = 0.21f, kSeat = 0.45f, kBack = 0.95f;
    add_legs(patches, foot, {kHalf - 0.03f, kSeat, kHalf - 0.03f}, 0.025f, m.dark_wood);
    add_box(patches, foot + glm::vec3(-kHalf, kSeat, -kHalf),
            foot + glm::vec3(kHalf, kSeat + 0.04f, kHalf), m.cloth);
    const glm::vec3 across(std::abs(away.z), 0, std::abs(away.x));
    for (const float slat : {-0.9f, -0.3f, 0.3f, 0.9f}) {
        const glm::vec3 at = foot + kHalf * 0.9f * (away + slat * across);
        add_turned(patches, at, {{0.018f, kSeat}, {0.024f, 0.7f}, {0.018f, kBack}},
                   m.dark_wood);
    }
    const glm::vec3 rail = foot + 0.9f * kHalf * away;
    const glm::vec3 half = kHalf * across + 0.02f * glm::abs(away);
    add_box(patches, rail - half + glm::vec3(0, kBack - 0.04f, 0),
            rail + half + glm::vec3(0, kBack + 0.04f, 0), m.dark_wood);
}

// Places on a shelf: x along the board and z off the wall, turned to the wall's direction.
struct Wall {
    glm::vec3 foot;
    int quarter_turns;

    glm::vec3 at(glm::vec3 p) const {
        for (int i = 0; i < quarter_turns; ++i) p = glm::vec3(p.z, p.y, -p.x);
        return foot + p;
    }
    void add_box(Patches& patches, glm::vec3 low, glm::vec3 high, uint32_t material) const {
        const glm::vec3 a = at(low), b = at(high);
        render::add_box(patches, glm::min(a, b), glm::max(a, b), material);
    }
};

void add_books(Patches& patches, const Wall& wall, glm::vec3 left, const FurnitureMaterials& m,
               Dice& dice) {
    float x = left.x;
    for (int book = 0; book < 5; ++book) {
        const glm::vec3 size(dice.between(0.03f, 0.07f), dice.between(0.2f, 0.3f), 0.2f);
        const glm::vec3 low(x, left.y, left.z);
        wall.add_box(patches, low, low + size, any_glaze(m, dice));
        x += size.x + 0.004f;
    }
}

void add_thing(Patches& patches, const Wall& wall, glm::vec3 at, const FurnitureMaterials& m,
               Dice& dice) {
    const uint32_t kind = dice.below(4);
    const float size = dice.between(0.2f, 0.36f);
    if (kind == 0)
        add_books(patches, wall, at - glm::vec3(0.12f, 0, 0.1f), m, dice);
    else if (kind == 1)
        add_ball(patches, wall.at(at + glm::vec3(0, 0.45f * size, 0)), 0.45f * size,
                 any_glaze(m, dice));
    else
        add_vase(patches, wall.at(at), size, any_glaze(m, dice), dice);
}

}  // namespace

void add_table_with_chairs(Patches& patches, glm::vec3 foot, const FurnitureMaterials& m,
                           Dice& dice) {
    constexpr float kHeight = 0.74f;
    const glm::vec3 half(0.62f, 0, 0.42f);
    add_legs(patches, foot, {half.x - 0.07f, kHeight, half.z - 0.07f}, 0.045f, m.wood);
    add_box(patches, foot + glm::vec3(-half.x, kHeight, -half.z),
            foot + glm::vec3(half.x, kHeight + 0.05f, half.z), m.wood);
    add_vase(patches, foot + glm::vec3(dice.between(-0.2f, 0.2f), kHeight + 0.05f, 0.0f), 0.34f,
             any_glaze(m, dice), dice);
    for (const float side : {-1.0f, 1.0f}) {
        const glm::vec3 away(side, 0, 0);
        add_chair(patches, foot + (half.x + dice.between(0.08f, 0.25f)) * away, away, m);
        const glm::vec3 front(0, 0, side);
        add_chair(patches, foot + (half.z + dice.between(0.08f, 0.25f)) * front, front, m);
    }
}

void add_shelf(Patches& patches, glm::vec3 foot, int quarter_turns, const FurnitureMaterials& m,
               Dice& dice) {
    constexpr float kWidth = 1.7f, kDepth = 0.34f, kHeight = 2.1f, kThick = 0.03f;
    constexpr int kBoards = 5;
    const Wall wall{foot, quarter_turns};
    for (const float x : {-0.5f * kWidth, 0.5f * kWidth - kThick})
        wall.add_box(patches, {x, 0, 0}, {x + kThick, kHeight, kDepth}, m.dark_wood);
    for (int board = 0; board < kBoards; ++board) {
        const float y = 0.08f + board * (kHeight - 0.11f) / (kBoards - 1);
        wall.add_box(patches, {kThick - 0.5f * kWidth, y, 0},
                     {0.5f * kWidth - kThick, y + kThick, kDepth - 0.01f}, m.wood);
        for (const float x : {-0.56f, -0.19f, 0.19f, 0.56f})
            add_thing(patches, wall, {x, y + kThick, 0.5f * kDepth}, m, dice);
    }
}

}  // namespace render
