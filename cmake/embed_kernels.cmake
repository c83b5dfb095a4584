# Kernel sources as byte arrays: no string-length limit of any compiler, highlighting in the .cl
# files, rebuilt when one of them changes.
#
#   embed_kernels(<out_var> <file>...)    adds rules; <out_var> gets the generated C++ file
#   cmake -DOUTPUT=... -DFILES=a|b -P embed_kernels.cmake    script mode, run by those rules
if(CMAKE_SCRIPT_MODE_FILE)
    string(REPLACE "|" ";" FILES "${FILES}")
    set(arrays "")
    set(rows "")
    foreach(file IN LISTS FILES)
        get_filename_component(name ${file} NAME)
        string(MAKE_C_IDENTIFIER ${name} symbol)
        file(READ ${file} bytes HEX)
        string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${bytes}")
        string(APPEND arrays "const unsigned char ${symbol}[] = {${bytes}};\n")
        string(APPEND rows "    {\"${name}\", ${symbol}, sizeof ${symbol}},\n")
    endforeach()
    file(WRITE ${OUTPUT} "// Generated from the kernel sources by embed_kernels.cmake.
#include \"cl/kernel_source.hpp\"

namespace rsh {
namespace {
${arrays}
}  // namespace

const EmbeddedFile kEmbeddedFiles[] = {
${rows}};
const size_t kEmbeddedFileCount = sizeof kEmbeddedFiles / sizeof kEmbeddedFiles[0];
}  // namespace rsh
")
    return()
endif()

set(RSH_EMBED_SCRIPT ${CMAKE_CURRENT_LIST_FILE})
function(embed_kernels out_var)
    set(output ${CMAKE_CURRENT_BINARY_DIR}/embedded_kernels.cpp)
    string(REPLACE ";" "|" files "${ARGN}")
    add_custom_command(
        OUTPUT ${output}
        COMMAND ${CMAKE_COMMAND} -DOUTPUT=${output} "-DFILES=${files}" -P ${RSH_EMBED_SCRIPT}
        DEPENDS ${ARGN} ${RSH_EMBED_SCRIPT}
        COMMENT "Embedding kernel sources"
        VERBATIM)
    set(${out_var} ${output} PARENT_SCOPE)
endfunction()
