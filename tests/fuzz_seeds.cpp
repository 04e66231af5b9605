// fuzz_seeds FOLDER: writes the seeds to FOLDER/import, FOLDER/scene and FOLDER/image.
#include <cstdio>
#include <fstream>

#include "fuzz/seeds.h"

namespace {

constexpr std::size_t kMostBytes = 65536;  // larger ones are slow to run and slow to change

void write(const std::filesystem::path& folder, const std::vector<vkpt::fuzz::Seed>& seeds) {
    std::filesystem::create_directories(folder);
    for (const auto& seed : seeds)
        if (seed.bytes.size() <= kMostBytes)
            std::ofstream(folder / seed.name, std::ios::binary)
                .write(reinterpret_cast<const char*>(seed.bytes.data()),
                       static_cast<std::streamsize>(seed.bytes.size()));
}

}  // namespace

int main(int count, char** arguments) {
    if (count != 2) {
        std::fputs("usage: fuzz_seeds FOLDER\n", stderr);
        return 64;
    }
    const std::filesystem::path folder = arguments[1];
    for (const char* name : {"import", "scene"}) {
        write(folder / name, vkpt::fuzz::sceneSeeds());
        write(folder / name, vkpt::fuzz::corpus(name));
    }
    write(folder / "image", vkpt::fuzz::imageSeeds());
    write(folder / "image", vkpt::fuzz::corpus("image"));
}
