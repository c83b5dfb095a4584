# rsh_bench_tests: the parts of rsh-bench frame that decide what its figures mean - scenes,
# rays, judgement of differences, fits, summary - without a device and without the peers'
# packages.
set(frame ${CMAKE_CURRENT_LIST_DIR})
find_package(CLI11 REQUIRED)
find_package(fmt REQUIRED)
add_executable(rsh_bench_tests
    ${frame}/checksum.cpp ${frame}/checksum_test.cpp
    ${frame}/embree/differences.cpp ${frame}/embree/differences_test.cpp
    ${frame}/diffuse.cpp ${frame}/diffuse_test.cpp
    ${frame}/fit.cpp ${frame}/fit_test.cpp
    ${frame}/frame_scene.cpp ${frame}/frame_scene_test.cpp
    ${frame}/frame_summary.cpp ${frame}/frame_summary_test.cpp
    ${frame}/still_room.cpp ${frame}/files/scene_files.cpp)
target_include_directories(rsh_bench_tests PRIVATE ${CMAKE_CURRENT_LIST_DIR}/..)
target_compile_definitions(rsh_bench_tests PRIVATE
    RSH_SCENE_FILES="${PROJECT_SOURCE_DIR}/samples/scenes")
target_link_libraries(rsh_bench_tests PRIVATE
    rsh_scene rsh::rsh OpenCL::OpenCL CLI11::CLI11 rsh_fmt GTest::gtest_main)
rsh_warnings(rsh_bench_tests)
rsh_add_shards(rsh_bench_tests 1)
