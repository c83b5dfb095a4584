# The parts of rsh-bench reduce that decide what its figures mean: patterns, files and the judgement
# of answers. Into the same program as those of the frame suite.
target_sources(rsh_bench_tests PRIVATE
    ${CMAKE_CURRENT_LIST_DIR}/patterns.cpp
    ${CMAKE_CURRENT_LIST_DIR}/stream.cpp
    ${CMAKE_CURRENT_LIST_DIR}/stream_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/streams/bitmap.cpp
    ${CMAKE_CURRENT_LIST_DIR}/streams/stream_files.cpp
    ${CMAKE_CURRENT_LIST_DIR}/streams/stream_files_test.cpp)
