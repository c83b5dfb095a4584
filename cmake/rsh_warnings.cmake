# rsh_warnings(target): the warnings that our own code is kept free of, errors with
# RSH_WERROR.
function(rsh_warnings target)
    if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
        target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow
                               $<$<BOOL:${RSH_WERROR}>:-Werror>)
    endif()
endfunction()
