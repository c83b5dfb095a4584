# A program with two OpenCL loaders: what it is linked to, and a copy of that, or what
# RSH_SECOND_LOADER names.
get_target_property(linked_loader OpenCL::OpenCL IMPORTED_LOCATION)
if(NOT linked_loader)
    get_target_property(linked_loader OpenCL::OpenCL IMPORTED_LOCATION_RELEASE)
endif()
if(UNIX AND NOT APPLE AND BUILD_SHARED_LIBS)
    file(REAL_PATH ${linked_loader} linked_loader)
    set(second_loader ${CMAKE_CURRENT_BINARY_DIR}/second_loader.so)
    configure_file(${linked_loader} ${second_loader} COPYONLY)
    add_executable(rsh_two_loaders_tests loaders/second_loader.cpp loaders/two_loaders_test.cpp)
    target_include_directories(rsh_two_loaders_tests PRIVATE
        ${CMAKE_CURRENT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/lib)
    target_link_libraries(rsh_two_loaders_tests PRIVATE
        rsh::rsh GTest::gtest_main ${CMAKE_DL_LIBS} Threads::Threads)
    rsh_warnings(rsh_two_loaders_tests)
    add_test(NAME TwoLoaders COMMAND rsh_two_loaders_tests --gtest_brief=1)
    set_tests_properties(TwoLoaders PROPERTIES
        ENVIRONMENT "RSH_SECOND_LOADER=${second_loader}"
        FAIL_REGULAR_EXPRESSION "==. 0 tests from")
endif()
if(CMAKE_NM)
    add_test(NAME Symbols.OpenClIsNamedInOnePlace
             COMMAND ${CMAKE_COMMAND} -D NM=${CMAKE_NM} "-DOBJECTS=$<TARGET_OBJECTS:rsh_objects>"
                     -P ${CMAKE_CURRENT_SOURCE_DIR}/loaders/one_place.cmake)
endif()
