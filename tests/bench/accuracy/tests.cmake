# Of rsh-bench accuracy, the numbers that pictures are judged by. Into the same program as the tests of
# the suites.
set(accuracy ${CMAKE_CURRENT_LIST_DIR})
target_sources(rsh_bench_tests PRIVATE
    ${accuracy}/edges.cpp ${accuracy}/flip.cpp ${accuracy}/image.cpp ${accuracy}/metrics_test.cpp
    ${accuracy}/picture_errors.cpp)
target_link_libraries(rsh_bench_tests PRIVATE rsh_oracle)
