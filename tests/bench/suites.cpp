// suites.cpp - the list of suites. One row each.
#include "ablation/ablation_suite.hpp"
#include "accuracy/accuracy_suite.hpp"
#include "approximate/approximate_suite.hpp"
#include "budgets/budgets_suite.hpp"
#include "frame/frame_suite.hpp"
#include "frame_memory/memory_suite.hpp"
#include "hits/hits_suite.hpp"
#include "mirrors/mirrors_suite.hpp"
#include "moving/moving_suite.hpp"
#include "paper/paper_suite.hpp"
#include "parity/parity_suite.hpp"
#include "programs/programs_suite.hpp"
#include "queries/queries_suite.hpp"
#include "reduce/reduce_suite.hpp"
#include "stability/stability_suite.hpp"
#include "suite.hpp"

namespace bench {

const std::vector<Suite*>& suites() {
    static AblationSuite ablation;
    static AccuracySuite accuracy;
    static ApproximateSuite approximate;
    static BudgetsSuite budgets;
    static FrameSuite frame;
    static HitsSuite hits;
    static MemorySuite memory;
    static MirrorsSuite mirrors;
    static MovingSuite moving;
    static PaperSuite paper;
    static ParitySuite parity;
    static ProgramsSuite programs;
    static QueriesSuite queries;
    static ReduceSuite reduce;
    static StabilitySuite stability;
    static const std::vector<Suite*> all = {
        &ablation, &accuracy, &approximate, &budgets,  &frame,   &hits,   &memory,   &mirrors,
        &moving,   &paper,    &parity,      &programs, &queries, &reduce, &stability};
    return all;
}

}  // namespace bench
