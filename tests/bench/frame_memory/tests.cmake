# Of rsh-bench memory, the choice of budgets. Into the same program as the tests of the suites.
set(frame_memory ${CMAKE_CURRENT_LIST_DIR})
target_sources(rsh_bench_tests PRIVATE ${frame_memory}/budgets_of.cpp ${frame_memory}/budgets_of_test.cpp)
