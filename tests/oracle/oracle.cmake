# rsh_oracle: right answers and what they are asked of, meshes and rays, without GoogleTest and
# without a device, for the tests and for rsh-bench.
find_package(Threads REQUIRED)
get_filename_component(tests ${CMAKE_CURRENT_LIST_DIR}/.. ABSOLUTE)
set(oracle_files closest crossings/crossings crossings/judge_crossings crossings/lattice_crossings
    crossings/windings exact filter found frame/reference_frame frame/scene_bvh hit judge lattice
    lattice_numbers leaving/inside leaving/separated leaving/snell leaving/spawned_ray mirrors/float_state
    mirrors/growth mirrors/lines mirrors/mirrors mirrors/path mirrors/path_errors mirrors/room
    mirrors/waves whitted)
set(generator_files bodies closed_meshes mesh random rays scene)
list(TRANSFORM oracle_files REPLACE "(.+)" "${tests}/oracle/\\1.cpp")
list(TRANSFORM generator_files REPLACE "(.+)" "${tests}/support/\\1.cpp")
add_library(rsh_oracle STATIC ${oracle_files} ${generator_files})
target_include_directories(rsh_oracle PUBLIC ${tests})
target_link_libraries(rsh_oracle PUBLIC rsh::rsh OpenCL::OpenCL Threads::Threads)
rsh_warnings(rsh_oracle)

# Expansion arithmetic means every rounding as written; what GCC is to vectorize, it needs to be told
# that no comparison traps in.
if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
    target_compile_options(rsh_oracle PRIVATE -ffp-contract=off)
    set_source_files_properties(${tests}/oracle/filter.cpp ${tests}/oracle/crossings/windings.cpp
        PROPERTIES COMPILE_OPTIONS "-O3;-fno-trapping-math")
endif()
