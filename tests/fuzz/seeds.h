// Where fuzzing begins: small files that use every feature vkpt reads.
#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace vkpt::fuzz {

struct Seed {
    std::string name;
    std::vector<std::uint8_t> bytes;
};

/// The bundled scenes as one file each (buffers and images inside), and small files of this test's own.
[[nodiscard]] std::vector<Seed> sceneSeeds();

/// EXR, HDR, PFM, PNG and JPEG files of the kinds that are read by different code.
[[nodiscard]] std::vector<Seed> imageSeeds();

/// Inputs kept from earlier runs: tests/fuzz/corpus/NAME/*.
[[nodiscard]] std::vector<Seed> corpus(const std::string& name);

}  // namespace vkpt::fuzz
