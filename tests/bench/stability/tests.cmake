# Of rsh-bench stability, what needs no device. Into the same program as the tests of the suites.
set(stability ${CMAKE_CURRENT_LIST_DIR})
file(GLOB stability_families CONFIGURE_DEPENDS ${stability}/*_families.cpp
     ${stability}/spawned/*.cpp)
list(FILTER stability_families EXCLUDE REGEX "/spawn\\.cpp$")
target_sources(rsh_bench_tests PRIVATE
    ${stability_families} ${stability}/aim.cpp ${stability}/expected.cpp
    ${stability}/family_test.cpp ${stability}/stability_text.cpp ${stability}/sum.cpp
    ${stability}/sum_test.cpp ${stability}/tally.cpp ${stability}/tally_test.cpp)
target_link_libraries(rsh_bench_tests PRIVATE rsh_oracle)
