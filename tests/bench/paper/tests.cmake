# Of rsh-bench paper, what its figures rest on: rows, what stands for the paper's scenes, cones, bars, fits.
# Into the program of frame/tests.cmake.
set(paper ${CMAKE_CURRENT_LIST_DIR})
target_sources(rsh_bench_tests PRIVATE
    ${paper}/bars.cpp ${paper}/bars_test.cpp
    ${paper}/batches/sources.cpp ${paper}/batches/sources_test.cpp
    ${paper}/cones/cone.cpp ${paper}/cones/cone_test.cpp ${paper}/cones/false_positives.cpp
    ${paper}/scenes/layers.cpp ${paper}/scenes/reflectors.cpp ${paper}/rows.cpp ${paper}/rows_test.cpp
    ${paper}/scenes/statue.cpp ${paper}/scenes/scenes_test.cpp
    ${paper}/summary.cpp ${paper}/summary_test.cpp)
