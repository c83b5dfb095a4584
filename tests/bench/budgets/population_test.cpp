// population_test.cpp - what a search goes on from.
#include <gtest/gtest.h>

#include "budgets/search.hpp"

namespace {

using bench::budgets::Population;

// Item i has the error i and the input 10 i.
Population made(size_t items) {
    Population population(items, 1);
    for (size_t i = 0; i < items; ++i) {
        population.worst[i] = float(i);
        population.inputs[i] = 10.0f * float(i);
    }
    return population;
}

TEST(Population, KnowsTheLargestError) {
    Population population = made(16);
    EXPECT_EQ(population.largest(), 15u);
    population.worst[3] = 99;
    EXPECT_EQ(population.largest(), 3u);
}

TEST(Population, KeepsItsBetterHalf) {
    Population population = made(16);
    population.breed();
    for (size_t i = 8; i < 16; ++i) {
        EXPECT_EQ(population.worst[i], float(i));
        EXPECT_EQ(population.inputs[i], 10.0f * float(i));
    }
}

TEST(Population, GoesOnFromTheBestAndFromNothing) {
    Population population = made(16);
    population.breed();
    size_t copies = 0, anew = 0;
    for (size_t i = 0; i < 8; ++i) {
        if (population.worst[i] < 0)
            ++anew;
        else if (population.worst[i] >= 14 && population.inputs[i] == 10 * population.worst[i])
            ++copies;
    }
    EXPECT_EQ(anew, 4u);
    EXPECT_EQ(copies, 4u);
}

}  // namespace
