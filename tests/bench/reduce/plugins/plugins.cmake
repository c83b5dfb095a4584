# The plug-in that shows how, and ones with a fault each for plugins_test.py.
enable_language(C)
function(rsh_add_bench_plugin name source)
    add_library(${name} MODULE ${source})
    set_target_properties(${name} PROPERTIES PREFIX "" C_STANDARD 99
        LIBRARY_OUTPUT_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/plugins)
    target_link_libraries(${name} PRIVATE OpenCL::OpenCL)
    rsh_warnings(${name})
endfunction()
rsh_add_bench_plugin(example_plugin ${CMAKE_CURRENT_LIST_DIR}/example_plugin.c)
# The test dumps the pairs of a scene file.
if(RSH_BUILD_TESTS AND TARGET rsh_scene)
    foreach(fault IDLE VERSION NAME TAKEN NO_RUN CREATE RUN REFUSE NO_PLUGIN)
        string(TOLOWER ${fault}_plugin name)
        rsh_add_bench_plugin(${name} ${CMAKE_CURRENT_LIST_DIR}/broken_plugin.c)
        target_compile_definitions(${name} PRIVATE RSH_FAULT=${fault})
    endforeach()
    set(no_symbol ${CMAKE_CURRENT_BINARY_DIR}/no_symbol.c)
    file(CONFIGURE OUTPUT ${no_symbol} CONTENT "int nothing;\n")
    rsh_add_bench_plugin(no_symbol_plugin ${no_symbol})
    add_test(NAME Reduce.TakesStreamsAndPluginsOfOthers
             COMMAND ${CMAKE_CURRENT_LIST_DIR}/plugins_test.py $<TARGET_FILE:rsh-bench>
                     ${CMAKE_CURRENT_BINARY_DIR}/plugins)
    set_tests_properties(Reduce.TakesStreamsAndPluginsOfOthers PROPERTIES
        ENVIRONMENT PYTHONDONTWRITEBYTECODE=1)
endif()
