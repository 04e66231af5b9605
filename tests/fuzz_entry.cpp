// libFuzzer's entry points of one target, VKPT_FUZZ_TARGET.
#include <cstdlib>
#include <cstring>

#include "fuzz/mutate.h"
#include "fuzz/targets.h"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    vkpt::fuzz::VKPT_FUZZ_TARGET({data, size});
    return 0;
}

#ifdef VKPT_FUZZ_GLTF
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed) {
    std::mt19937 random(seed);
    const auto mutateBytes = [&](vkpt::fuzz::Bytes& bytes) {
        const std::size_t length = bytes.size();
        bytes.resize(length + 64);
        bytes.resize(LLVMFuzzerMutate(bytes.data(), length, bytes.size()));
    };
    const vkpt::fuzz::Bytes mutant = vkpt::fuzz::mutateGltf({data, size}, random, mutateBytes);
    if (mutant.empty() || mutant.size() > most) return LLVMFuzzerMutate(data, size, most);
    std::memcpy(data, mutant.data(), mutant.size());
    return mutant.size();
}
#endif
