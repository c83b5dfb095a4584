# The report of rsh-bench table. Into the same program as the tests of the suites.
set(table ${CMAKE_CURRENT_LIST_DIR})
file(GLOB table_sources CONFIGURE_DEPENDS ${table}/*.cpp)
target_sources(rsh_bench_tests PRIVATE ${table_sources} ${table}/../timing.cpp)
