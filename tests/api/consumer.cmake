# consumer.cmake - builds and runs the consumer with rsh found in one way:
#   package, package_static          find_package in an installed tree that was moved
#   pkg_config, pkg_config_static    pkg-config in one; the second has no shared library
#   subproject                       FetchContent; then its install is used by find_package
#   -D CASE=...  -D BUILD=build tree  -D CONSUMER=consumer  -D RSH_SOURCE=rsh  -D WORK=scratch folder
#   -D LIBDIR=lib
cmake_minimum_required(VERSION 3.20)
function(run)
    execute_process(COMMAND ${ARGV} RESULT_VARIABLE result)
    if(NOT result EQUAL 0)
        message(FATAL_ERROR "failed (${result}): ${ARGV}")
    endif()
endfunction()

function(build_consumer case folder)
    run(${CMAKE_COMMAND} -S ${CONSUMER} -B ${folder} -DCASE=${case} ${ARGN} -DCMAKE_C_FLAGS=${C_FLAGS})
    run(${CMAKE_COMMAND} --build ${folder} --parallel --target consumer)
    run(${folder}/consumer)
endfunction()

# What still points at the place of installation breaks when the tree is used in another one.
function(install_moved folder)
    run(${CMAKE_COMMAND} --install ${folder} --prefix ${WORK}/installed)
    file(RENAME ${WORK}/installed ${WORK}/moved)
endfunction()

file(REMOVE_RECURSE ${WORK})
set(ENV{CMAKE_BUILD_TYPE} "")
set(ENV{PKG_CONFIG_PATH} ${WORK}/moved/${LIBDIR}/pkgconfig)
if(CASE STREQUAL "subproject")
    build_consumer(subproject ${WORK}/parent -DRSH_SOURCE=${RSH_SOURCE})
    run(${CMAKE_COMMAND} --build ${WORK}/parent --target consumer_static)
    run(${WORK}/parent/consumer_static)
    install_moved(${WORK}/parent)
    build_consumer(package ${WORK}/build -DCMAKE_PREFIX_PATH=${WORK}/moved)
else()
    install_moved(${BUILD})
    if(CASE STREQUAL "pkg_config_static")
        file(GLOB shared ${WORK}/moved/${LIBDIR}/librsh.so*)
        file(REMOVE ${shared})
    endif()
    build_consumer(${CASE} ${WORK}/build -DCMAKE_PREFIX_PATH=${WORK}/moved)
endif()
