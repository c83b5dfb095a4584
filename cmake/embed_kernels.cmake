# Kernel sources as byte arrays: no string-length limit of any compiler, highlighting in the .cl
# files, rebuilt when one of them changes.
#
#   embed_kernels(<out_var> <root> <file>...)    adds rules; <out_var> gets the generated C++ file;
#                                                a file is named by its path in kernels/ or include/
#                                                of <root>
#   cmake -DOUTPUT=... -DROOT=... -DFILES=a|b -P embed_kernels.cmake    what those rules run
if(CMAKE_SCRIPT_MODE_FILE)
    string(REPLACE "|" ";" FILES "${FILES}")
    set(arrays "")
    set(rows "")
    foreach(file IN LISTS FILES)
        file(RELATIVE_PATH path ${ROOT} ${file})
        string(REGEX REPLACE "^(kernels|include)/" "" name ${path})
        string(MAKE_C_IDENTIFIER ${name} symbol)
        file(READ ${file} bytes HEX)
        string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${bytes}")
        string(APPEND arrays "const unsigned char ${symbol}[] = {${bytes}};\n")
        string(APPEND rows "    {\"${name}\", ${symbol}, sizeof ${symbol}},\n")
    endforeach()
    file(WRITE ${OUTPUT} "// Generated from the kernel sources by embed_kernels.cmake.
#include \"device/programs/kernel_source.hpp\"

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
function(embed_kernels out_var root)
    set(output ${CMAKE_CURRENT_BINARY_DIR}/embedded_kernels.cpp)
    string(REPLACE ";" "|" files "${ARGN}")
    add_custom_command(
        OUTPUT ${output}
        COMMAND ${CMAKE_COMMAND} -DOUTPUT=${output} -DROOT=${root} "-DFILES=${files}" -P ${RSH_EMBED_SCRIPT}
        DEPENDS ${ARGN} ${RSH_EMBED_SCRIPT}
        COMMENT "Embedding kernel sources"
        VERBATIM)
    set(${out_var} ${output} PARENT_SCOPE)
endfunction()
