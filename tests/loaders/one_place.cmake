# one_place.cmake - only opencl.cpp names OpenCL's functions to the linker: what others call directly
# would crash where a process has two loaders.
#   -D NM=... -D OBJECTS=a;b;...
cmake_minimum_required(VERSION 3.21)
execute_process(COMMAND ${NM} --print-file-name --undefined-only --format=posix ${OBJECTS}
                OUTPUT_VARIABLE table RESULT_VARIABLE result)
if(NOT result EQUAL 0)
    message(FATAL_ERROR "${NM} failed on ${OBJECTS}")
endif()
string(REGEX MATCHALL "[^\n]*: cl[A-Z][A-Za-z]+ " names "${table}")
set(right 0)
foreach(name IN LISTS names)
    if(name MATCHES "/opencl\\.cpp\\.")
        math(EXPR right "${right} + 1")
    else()
        message(SEND_ERROR "must be called through opencl(object): ${name}")
    endif()
endforeach()
if(right EQUAL 0)
    message(SEND_ERROR "none of the objects names a function of OpenCL: is opencl.cpp gone?")
endif()
message(STATUS "${right} functions of OpenCL are named in opencl.cpp")
