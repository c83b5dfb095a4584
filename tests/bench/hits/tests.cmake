# Of rsh-bench hits, the judgement of answers. Into the same program as the tests of the suites.
set(hits ${CMAKE_CURRENT_LIST_DIR})
target_sources(rsh_bench_tests PRIVATE ${hits}/errors.cpp ${hits}/errors_test.cpp)
