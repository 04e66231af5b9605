// tinygltf's implementation; it lives in its header.
#include <fstream>
#define TINYGLTF_IMPLEMENTATION
#include "gltf/tinygltf.h"
