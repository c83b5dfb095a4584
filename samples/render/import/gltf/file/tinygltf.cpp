// tinygltf.cpp - compiles the library, which is a header; the build defines what it leaves out.
#include <fstream>  // which the header forgets

#define TINYGLTF_IMPLEMENTATION
#include <tiny_gltf.h>
