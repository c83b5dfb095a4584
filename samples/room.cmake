# rsh_room: the generated room and all that it needs, with glm and fmt alone; a part of rsh_scene,
# and all of the samples that rsh-bench needs where the packages of the other parts are missing.
find_package(fmt REQUIRED)
find_package(glm REQUIRED)

# What is built without shared libraries is to need none: Debian has no static fmt.
add_library(rsh_fmt INTERFACE)
if(BUILD_SHARED_LIBS)
    target_link_libraries(rsh_fmt INTERFACE fmt::fmt)
else()
    target_link_libraries(rsh_fmt INTERFACE fmt::fmt-header-only)
endif()

set(render ${CMAKE_CURRENT_LIST_DIR}/render)
file(GLOB room_sources CONFIGURE_DEPENDS ${render}/model/*.cpp ${render}/generate/*.cpp)
list(REMOVE_ITEM room_sources ${render}/model/creases.cpp)  # OpenMesh
add_library(rsh_room STATIC ${room_sources} ${render}/files/whole_file.cpp
            ${render}/scene/device_structs.cpp)
target_include_directories(rsh_room PUBLIC ${render} ${PROJECT_SOURCE_DIR}/include)
target_link_libraries(rsh_room PUBLIC glm::glm PRIVATE rsh_fmt)
rsh_warnings(rsh_room)
