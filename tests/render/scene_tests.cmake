# rsh_scene_tests: scene files, generated scenes and images, without OpenCL. Needs the samples.
if(NOT TARGET rsh_scene)
    message(STATUS "rsh_scene_tests are left out: RSH_BUILD_SAMPLES is off")
    return()
endif()
add_executable(rsh_scene_tests
    ${CMAKE_CURRENT_LIST_DIR}/device/ray_sample_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/files/image_file_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/generate/room_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/scene/motion_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/scene/scene_file_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/temporary_folder.cpp)
target_include_directories(rsh_scene_tests PRIVATE ${CMAKE_CURRENT_LIST_DIR})
target_link_libraries(rsh_scene_tests PRIVATE
    rsh_scene GTest::gtest_main LibArchive::LibArchive)
rsh_warnings(rsh_scene_tests)
gtest_discover_tests(rsh_scene_tests PROPERTIES TIMEOUT 300)

add_test(NAME Minimal.HitsTheTriangle COMMAND rsh-minimal)
