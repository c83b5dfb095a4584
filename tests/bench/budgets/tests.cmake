# Of rsh-bench budgets, what needs no device. Into the same program as the tests of the suites.
set(budgets ${CMAKE_CURRENT_LIST_DIR})
target_sources(rsh_bench_tests PRIVATE
    ${budgets}/bounds.cpp ${budgets}/bounds_test.cpp
    ${budgets}/population.cpp ${budgets}/population_test.cpp
    ${budgets}/replaced.cpp ${budgets}/replaced_test.cpp)
