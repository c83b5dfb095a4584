// tinyobjloader.cpp - compiles the library, which is a header, with doubles: the build defines
// TINYOBJLOADER_USE_DOUBLE for all who include it.
#define TINYOBJLOADER_IMPLEMENTATION
#include <tiny_obj_loader.h>
