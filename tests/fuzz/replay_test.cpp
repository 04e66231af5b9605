// The fuzz targets over their seeds, the kept corpus and a fixed lot of mutants. tools/fuzz searches further.
#include <gtest/gtest.h>

#include "fuzz/mutate.h"
#include "fuzz/seeds.h"
#include "fuzz/targets.h"

namespace vkpt::fuzz {
namespace {

void replay(void (*target)(Input), const std::vector<Seed>& seeds) {
    for (const Seed& seed : seeds) {
        SCOPED_TRACE(seed.name);
        EXPECT_NO_THROW(target(seed.bytes));
    }
}

/// Flips or drops a few bytes.
void scribble(Bytes& bytes, std::mt19937& random) {
    if (bytes.empty()) return;
    for (auto n = 1 + random() % 4; n > 0; --n) bytes[random() % bytes.size()] = static_cast<std::uint8_t>(random());
    if (random() % 8 == 0) bytes.resize(random() % bytes.size());
}

TEST(Fuzz, EverySeedIsTaken) {
    ASSERT_GT(sceneSeeds().size(), 15U);
    replay(fuzzScene, sceneSeeds());
    replay(fuzzImage, imageSeeds());
}

TEST(Fuzz, CorpusIsTaken) {
    for (const Target& target : kTargets) replay(target.run, corpus(std::string(target.name)));
}

TEST(Fuzz, MutantsOfGltfAreTaken) {
    std::mt19937 random(1);
    for (const Seed& seed : sceneSeeds()) {
        if (seed.bytes.size() > 50000) continue;
        SCOPED_TRACE(seed.name);
        for (int i = 0; i < 300; ++i) {
            const Bytes mutant = mutateGltf(seed.bytes, random, [&](Bytes& bytes) { scribble(bytes, random); });
            EXPECT_NO_THROW(fuzzScene(mutant)) << "mutant " << i;
        }
    }
}

TEST(Fuzz, MutantsOfImagesAreTaken) {
    std::mt19937 random(2);
    for (const Seed& seed : imageSeeds()) {
        SCOPED_TRACE(seed.name);
        for (int i = 0; i < 100; ++i) {
            Bytes mutant = seed.bytes;
            scribble(mutant, random);
            EXPECT_NO_THROW(fuzzImage(mutant)) << "mutant " << i;
        }
    }
}

}  // namespace
}  // namespace vkpt::fuzz
