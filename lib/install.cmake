# Installs headers, libraries, the CMake package, rsh.pc and the licence. Everything is found
# relative to where it was installed, so that the installed tree may be moved. The package and
# rsh.pc name the OpenCL that the consumer's machine has, never a path of this one.
include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/rsh)

install(TARGETS ${RSH_LIBRARIES} EXPORT rsh-targets
        LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
        RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/rsh DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
        FILES_MATCHING PATTERN "*.h" PATTERN "*.hpp")
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})

install(EXPORT rsh-targets NAMESPACE rsh:: DESTINATION ${package_dir})
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/rsh-config.cmake.in
    ${CMAKE_CURRENT_BINARY_DIR}/rsh-config.cmake
    INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/rsh-config-version.cmake
    COMPATIBILITY ${RSH_COMPATIBILITY})
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/rsh-config.cmake
              ${CMAKE_CURRENT_BINARY_DIR}/rsh-config-version.cmake
        DESTINATION ${package_dir})

# Where a path of the installation is, seen from rsh.pc: relative to its prefix unless absolute.
function(rsh_pc_path out_var path)
    if(IS_ABSOLUTE ${path})
        set(${out_var} ${path} PARENT_SCOPE)
    else()
        set(${out_var} "\${prefix}/${path}" PARENT_SCOPE)
    endif()
endfunction()

rsh_pc_path(RSH_PC_LIBDIR ${CMAKE_INSTALL_LIBDIR})
rsh_pc_path(RSH_PC_INCLUDEDIR ${CMAKE_INSTALL_INCLUDEDIR})
if(IS_ABSOLUTE ${CMAKE_INSTALL_LIBDIR})
    set(RSH_PC_PREFIX ${CMAKE_INSTALL_PREFIX})
else()
    file(RELATIVE_PATH up /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
    string(REGEX REPLACE "/$" "" up ${up})
    set(RSH_PC_PREFIX "\${pcfiledir}/${up}")
endif()

# What a C linker lacks to link the archive. Without a shared library every link needs it.
set(RSH_PC_LIBS "-L\${libdir} -lrsh")
set(RSH_PC_LIBS_PRIVATE ${CMAKE_THREAD_LIBS_INIT})
foreach(library IN LISTS RSH_RUNTIME_LIBRARIES)
    string(APPEND RSH_PC_LIBS_PRIVATE " -l${library}")
endforeach()
string(STRIP "${RSH_PC_LIBS_PRIVATE}" RSH_PC_LIBS_PRIVATE)
if(NOT BUILD_SHARED_LIBS AND NOT RSH_BUILD_BOTH)
    string(APPEND RSH_PC_LIBS " ${RSH_PC_LIBS_PRIVATE}")
    set(RSH_PC_LIBS_PRIVATE "")
endif()
configure_file(${PROJECT_SOURCE_DIR}/cmake/rsh.pc.in ${CMAKE_CURRENT_BINARY_DIR}/rsh.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/rsh.pc
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
