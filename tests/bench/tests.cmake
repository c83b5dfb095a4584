# What all suites share: limits, memory, the JSON file. Into the program of frame/tests.cmake.
set(bench ${CMAKE_CURRENT_LIST_DIR})
target_sources(rsh_bench_tests PRIVATE
    ${bench}/document.cpp ${bench}/document_test.cpp
    ${bench}/host.cpp ${bench}/host_test.cpp
    ${bench}/left_out.cpp ${bench}/left_out_test.cpp
    ${bench}/limit.cpp ${bench}/limit_test.cpp
    ${bench}/memory.cpp)
