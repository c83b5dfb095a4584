# The plug-in that shows how, and ones with a fault each for plugins_test.py.
enable_language(C)
function(rsh_add_bench_plugin name source)
    add_library(${name} MODULE ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/${source})
    set_target_properties(${name} PROPERTIES PREFIX "" C_STANDARD 99
        LIBRARY_OUTPUT_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/plugins)
    target_link_libraries(${name} PRIVATE OpenCL::OpenCL)
    rsh_warnings(${name})
endfunction()
rsh_add_bench_plugin(example_plugin example_plugin.c)
if(RSH_BUILD_TESTS)
    foreach(fault IDLE VERSION NAME TAKEN NO_RUN CREATE RUN REFUSE NO_PLUGIN)
        string(TOLOWER ${fault}_plugin name)
        rsh_add_bench_plugin(${name} broken_plugin.c)
        target_compile_definitions(${name} PRIVATE RSH_FAULT=${fault})
    endforeach()
    file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/no_symbol.c "int nothing;\n")
    add_library(no_symbol_plugin MODULE ${CMAKE_CURRENT_BINARY_DIR}/no_symbol.c)
    set_target_properties(no_symbol_plugin PROPERTIES PREFIX "" LIBRARY_OUTPUT_DIRECTORY
        ${CMAKE_CURRENT_BINARY_DIR}/plugins)
    add_test(NAME Reduce.TakesStreamsAndPluginsOfOthers
             COMMAND ${CMAKE_CURRENT_LIST_DIR}/plugins_test.py $<TARGET_FILE:rsh-bench>
                     ${CMAKE_CURRENT_BINARY_DIR}/plugins)
    set_tests_properties(Reduce.TakesStreamsAndPluginsOfOthers PROPERTIES
        ENVIRONMENT PYTHONDONTWRITEBYTECODE=1)
endif()
