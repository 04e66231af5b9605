// Writes the tables of the samplers pmj02 and bluenoise; the build runs it: make_sampler_tables FOLDER.
#include <bit>
#include <cstdio>
#include <exception>
#include <fstream>
#include <random>
#include <string>
#include <vector>

#include "constants.h"
#include "pmj02.h"
#include "void_and_cluster.h"

namespace {

using namespace vkpt;

constexpr unsigned kSeed = 2018;

template <class Word>
void write(const std::string& file, const std::vector<Word>& words) {
    std::ofstream out(file, std::ios::binary);
    out.write(reinterpret_cast<const char*>(words.data()), static_cast<std::streamsize>(words.size() * sizeof(Word)));
    if (!out.flush()) throw std::runtime_error(file + ": cannot write");
}

/// Points as x | y << 16, table after table.
std::vector<std::uint32_t> pmj02Tables() {
    std::mt19937 random(kSeed);
    std::vector<std::uint32_t> words;
    for (std::uint32_t table = 0; table < kPmj02Tables; ++table)
        for (const Point16& p : makePmj02(std::countr_zero(kPmj02Points) / 2, random))
            words.push_back(p.x | p.y << 16U);
    return words;
}

std::vector<std::uint16_t> blueNoiseMask() {
    std::mt19937 random(kSeed);
    const auto ranks = makeVoidAndCluster(kMaskSide, random);
    return {ranks.begin(), ranks.end()};
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) return std::fputs("usage: make_sampler_tables FOLDER\n", stderr), 64;
    try {
        write(std::string(argv[1]) + "/pmj02.bin", pmj02Tables());
        write(std::string(argv[1]) + "/blue_noise.bin", blueNoiseMask());
    } catch (const std::exception& error) {
        std::fprintf(stderr, "make_sampler_tables: %s\n", error.what());
        return 70;
    }
    return 0;
}
