# consumer.cmake - installs the build tree into a folder of its own, moves that folder, builds the
# consumer against it and runs both programs.
#   -D BUILD=... build tree   -D SOURCE=... consumer   -D WORK=... scratch folder   -D LIBDIR=lib
cmake_minimum_required(VERSION 3.21)
function(run)
    execute_process(COMMAND ${ARGV} RESULT_VARIABLE result)
    if(NOT result EQUAL 0)
        message(FATAL_ERROR "failed (${result}): ${ARGV}")
    endif()
endfunction()

file(REMOVE_RECURSE ${WORK})
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/installed)
# What still points at the first place breaks here.
file(RENAME ${WORK}/installed ${WORK}/moved)
set(ENV{PKG_CONFIG_PATH} ${WORK}/moved/${LIBDIR}/pkgconfig)
run(${CMAKE_COMMAND} -S ${SOURCE} -B ${WORK}/build -DCMAKE_PREFIX_PATH=${WORK}/moved
    -DCMAKE_C_FLAGS=${C_FLAGS})
run(${CMAKE_COMMAND} --build ${WORK}/build)
run(${WORK}/build/by_package)
run(${WORK}/build/by_pkg_config)
