#include "reference/hash.h"

#include "verify/context.h"
#include "verify/inputs/random_inputs.h"
#include "verify/probes.h"

namespace vkpt {
namespace {

struct Out {
    glm::uvec4 hash;
    glm::vec4 unit;
};

}  // namespace

void checkHash(VerifyContext& context, Findings& findings) {
    std::vector<glm::uvec4> inputs{
        {0, 0, 0, 0}, {~0U, ~0U, ~0U, ~0U}, {1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 0, 0x80000000}};
    RandomInputs random(1);
    for (int i = 0; i < 4000; ++i) inputs.push_back({random.bits(), random.bits(), random.bits(), random.bits()});
    const auto out = context.prober().evaluate<Out>("hash", inputs);
    const auto scope = findings.inputs([&](std::size_t i) { return "hash of " + show(inputs[i]); });
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        findings.at(i);
        const glm::uvec4 expected = reference::hash(inputs[i]);
        findings.equal("hash", out[i].hash, expected);
        for (int c = 0; c < 4; ++c) {
            findings.equal("toUnit", out[i].unit[c], reference::toUnit(expected[c]));
            findings.holds("unit range", out[i].unit[c] >= 0 && out[i].unit[c] < 1, "is outside [0, 1)");
        }
    }
}

}  // namespace vkpt
