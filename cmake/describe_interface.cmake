# The tables behind rsh_describe_interface, from the headers that declare it.
#
#   describe_interface(<out_var> <header>...)    adds the rule; <out_var> gets the generated C++ file
#   cmake -DOUTPUT=... -DHEADERS=a|b -P describe_interface.cmake    what that rule runs
#
# Only names and types are read here. A declaration in an unknown form is an error, or does not
# compile; tests/api/interface.py reads the headers in another way and finds what is missing.
cmake_minimum_required(VERSION 3.20)
if(NOT CMAKE_SCRIPT_MODE_FILE)
    set(RSH_DESCRIBE_SCRIPT ${CMAKE_CURRENT_LIST_FILE})
    function(describe_interface out_var)
        set(output ${CMAKE_CURRENT_BINARY_DIR}/interface.cpp)
        string(REPLACE ";" "|" headers "${ARGN}")
        add_custom_command(
            OUTPUT ${output}
            COMMAND ${CMAKE_COMMAND} -DOUTPUT=${output} "-DHEADERS=${headers}" -P ${RSH_DESCRIBE_SCRIPT}
            DEPENDS ${ARGN} ${RSH_DESCRIBE_SCRIPT}
            COMMENT "Describing the interface"
            VERBATIM)
        set(${out_var} ${output} PARENT_SCOPE)
    endfunction()
    return()
endif()

# CMake's lists end at ; and are confused by [ and ]. Here these are $ and < and >.
function(read_header file out_var)
    file(READ ${file} text)
    string(REPLACE ";" "$" text "${text}")
    string(REPLACE "[" "<" text "${text}")
    string(REPLACE "]" ">" text "${text}")
    while(TRUE)
        string(FIND "${text}" "/*" begin)
        if(begin EQUAL -1)
            break()
        endif()
        string(SUBSTRING "${text}" 0 ${begin} before)
        string(SUBSTRING "${text}" ${begin} -1 text)
        string(FIND "${text}" "*/" end)
        math(EXPR end "${end} + 2")
        string(SUBSTRING "${text}" ${end} -1 text)
        string(APPEND kept "${before}")
    endwhile()
    string(APPEND kept "${text}")
    set(${out_var} "${kept}" PARENT_SCOPE)
endfunction()

# "const rsh_scene* scene" or "cl_uint pairs<RSH_MAX_LEVELS + 1>" into type, name and bounds.
macro(split_declaration text)
    if(NOT "${text}" MATCHES "^[ \n]*([a-z_0-9 ]*[a-z_0-9][ *]+)([a-z_0-9]+)(<[^>]*>)?[ \n]*$")
        message(FATAL_ERROR "cannot read the declaration: ${text}")
    endif()
    set(name ${CMAKE_MATCH_2})
    set(bounds "${CMAKE_MATCH_3}")
    string(STRIP "${CMAKE_MATCH_1}" type)
endmacro()

function(add_to part text)
    set_property(GLOBAL APPEND_STRING PROPERTY rsh_${part} "${text}")
endfunction()

function(describe_struct text)
    string(REGEX MATCH "^typedef struct (rsh_[a-z_0-9]+) {([^}]*)}" matched "${text}")
    set(struct ${CMAKE_MATCH_1})
    string(REGEX MATCHALL "[^$]+[$]" declarations "${CMAKE_MATCH_2}")
    foreach(declaration IN LISTS declarations)
        string(REPLACE "$" "" declaration "${declaration}")
        string(REPLACE "," ";" declarators "${declaration}")
        list(POP_FRONT declarators first)
        split_declaration("${first}")
        list(TRANSFORM declarators STRIP)
        foreach(field IN ITEMS ${name} ${declarators})
            string(APPEND rows "    field<decltype(${struct}::${field}), ${type}${bounds}>("
                               "\"${field}\", \"${type}\", offsetof(${struct}, ${field})),\n")
        endforeach()
    endforeach()
    add_to(arrays "constexpr rsh_field_info ${struct}_fields<> = {\n${rows}}$\n")
    add_to(structs "    {\"${struct}\", sizeof(${struct}), alignof(${struct}), ${struct}_fields,\n")
    add_to(structs "     std::size(${struct}_fields)},\n")
endfunction()

# `actual` is the type of a pointer to the function.
function(describe_function list function actual result parameters)
    string(STRIP "${result}" result)
    string(REGEX REPLACE "[ \n]+" " " parameters "${parameters}")
    set(array "nullptr, 0")
    set(types void)
    if(NOT parameters STREQUAL "void")
        set(types "")
        set(array "${function}_parameters, std::size(${function}_parameters)")
        string(REPLACE "," ";" parameters "${parameters}")
        foreach(parameter IN LISTS parameters)
            split_declaration("${parameter}")
            string(APPEND rows "    value<${type}>(\"${name}\", \"${type}\"),\n")
            list(APPEND types "${type}")
        endforeach()
        add_to(arrays "constexpr rsh_field_info ${function}_parameters<> = {\n${rows}}$\n")
    endif()
    string(REPLACE ";" ", " types "${types}")
    add_to(arrays "static_assert(std::is_same_v<${actual}, ${result} (*)(${types})>)$\n")
    add_to(${list} "    {\"${function}\", value<${result}>(\"\", \"${result}\"), ${array}},\n")
endfunction()

function(describe_header file)
    read_header(${file} text)
    string(REGEX MATCHALL "typedef struct rsh_[a-z_0-9]+ {[^}]*}" structs "${text}")
    foreach(struct IN LISTS structs)
        describe_struct("${struct}")
    endforeach()
    string(REGEX MATCHALL "enum [a-z_0-9]*[ ]*{[^}]*}" enums "${text}")
    string(REGEX MATCHALL "[{,][ \n]*RSH_[A-Z_0-9]+" enumerators "${enums}")
    string(REGEX MATCHALL "#define RSH_[A-Z_0-9]+ [^\n]" macros "${text}")
    foreach(constant IN LISTS enumerators macros)
        string(REGEX MATCH "RSH_[A-Z_0-9]+" constant "${constant}")
        if(NOT constant STREQUAL "RSH_API") # what exports a function
            add_to(constants "    constant(\"${constant}\", ${constant}),\n")
        endif()
    endforeach()
    string(REGEX MATCHALL "\nRSH_API [^$]*[$]" functions "${text}")
    foreach(function IN LISTS functions)
        string(REGEX MATCH "^\nRSH_API ([a-z_ *]*[ *])(rsh_[a-z_0-9]+)\\(([^()]*)\\)[$]$" matched "${function}")
        if(NOT matched)
            message(FATAL_ERROR "cannot read the declaration: ${function}")
        endif()
        describe_function(functions ${CMAKE_MATCH_2} "decltype(&${CMAKE_MATCH_2})"
                          "${CMAKE_MATCH_1}" "${CMAKE_MATCH_3}")
    endforeach()
    string(REGEX MATCHALL "typedef [a-z_]+ \\(\\*rsh_[a-z_0-9]+\\)\\([^()]*\\)" callbacks "${text}")
    foreach(callback IN LISTS callbacks)
        string(REGEX MATCH "^typedef ([a-z_]+) \\(\\*(rsh_[a-z_0-9]+)\\)\\(([^()]*)\\)$" matched "${callback}")
        describe_function(callbacks ${CMAKE_MATCH_2} ${CMAKE_MATCH_2} "${CMAKE_MATCH_1}" "${CMAKE_MATCH_3}")
    endforeach()
endfunction()

string(REPLACE "|" ";" HEADERS "${HEADERS}")
foreach(header IN LISTS HEADERS)
    describe_header(${header})
endforeach()
foreach(part IN ITEMS arrays structs constants functions callbacks)
    get_property(${part} GLOBAL PROPERTY rsh_${part})
endforeach()
set(text "// Generated from the headers by describe_interface.cmake.
#include \"api/describe.hpp\"

#include <cstddef>

namespace rsh::describe {
namespace {
${arrays}
constexpr rsh_struct_info kStructs<> = {
${structs}}$
constexpr rsh_constant_info kConstants<> = {
${constants}}$
constexpr rsh_function_info kFunctions<> = {
${functions}}$
constexpr rsh_function_info kCallbacks<> = {
${callbacks}}$
constexpr rsh_interface kInterface = {
    sizeof(rsh_interface), kStructs, std::size(kStructs), kConstants, std::size(kConstants),
    kFunctions, std::size(kFunctions), kCallbacks, std::size(kCallbacks)}$
}  // namespace
}  // namespace rsh::describe

const rsh_interface* rsh_describe_interface(void) {
    return &rsh::describe::kInterface$
}
")
string(REPLACE "$" ";" text "${text}")
string(REPLACE "<>" "[]" text "${text}")
string(REGEX REPLACE "<([A-Z_0-9+ ]+)>" "[\\1]" text "${text}")
file(WRITE ${OUTPUT} "${text}")
