# rsh_add_shards(TARGET COUNT): the GoogleTests of TARGET as COUNT entries of ctest. A process for
# each test would start the driver and load the same programs hundreds of times. Shard i runs the
# tests i, i + COUNT, ...; one without any test fails. Each writes test-results/<entry>.json of the
# build folder, which tests/house/results.py counts test by test.
set(RSH_TEST_RESULTS ${CMAKE_BINARY_DIR}/test-results CACHE INTERNAL "")
function(rsh_add_shards target count)
    foreach(number RANGE 1 ${count})
        math(EXPR index "${number} - 1")
        set(entry ${target}.${number}_of_${count})
        add_test(NAME ${entry}
                 COMMAND ${target} --gtest_brief=1
                         --gtest_output=json:${RSH_TEST_RESULTS}/${entry}.json)
        set_tests_properties(${entry} PROPERTIES
            TIMEOUT 1200
            COST ${count}  # what is cut into more shards takes longer and starts first
            FAIL_REGULAR_EXPRESSION "==. 0 tests from"
            ENVIRONMENT "GTEST_TOTAL_SHARDS=${count};GTEST_SHARD_INDEX=${index}")
    endforeach()
endfunction()
