// What samplers bring to the device.
#include "scene/sampler_table.h"

#include <gtest/gtest.h>

namespace vkpt {
namespace {

TEST(SamplerTable, OfEverySamplerIsBelowOneMegabyte) {
    for (const SamplerChoice& sampler : allSamplerChoices())
        EXPECT_LT(samplerTable(sampler).size() * sizeof(std::uint32_t), 1000000U) << samplerName(sampler.id);
}

}  // namespace
}  // namespace vkpt
