# Of rsh-bench programs, what needs no device. Into the same program as the tests of the suites.
set(programs ${CMAKE_CURRENT_LIST_DIR})
target_sources(rsh_bench_tests PRIVATE
    ${programs}/program_list.cpp ${programs}/program_list_test.cpp
    ${programs}/ptxas_log.cpp ${programs}/ptxas_log_test.cpp)
target_compile_definitions(rsh_bench_tests PRIVATE
    RSH_PROGRAM_LIST="${PROJECT_SOURCE_DIR}/tests/house/programs.txt")
