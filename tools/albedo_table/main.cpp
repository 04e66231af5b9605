// Writes the albedo table of glTF's facets, at build time: make_albedo_table FILE.
#include <cstdio>
#include <fstream>

#include "scene/albedo_tables.h"

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fputs("usage: make_albedo_table FILE\n", stderr);
        return 64;
    }
    const auto table = vkpt::makeAlbedoTable({});
    std::ofstream out(argv[1], std::ios::binary);
    out.write(reinterpret_cast<const char*>(table.data()),
              static_cast<std::streamsize>(table.size() * sizeof(vkpt::AlbedoCell)));
    out.close();
    if (out) return 0;
    std::fprintf(stderr, "make_albedo_table: %s: cannot be written\n", argv[1]);
    return 4;
}
