// Against double: Vulkan itself allows sin and cos 2^-11 and atan 4096 ulp, hence functions of our own.
#include <cmath>

#include "verify/context.h"
#include "verify/inputs/random_inputs.h"
#include "verify/probes.h"

namespace vkpt {
namespace {

struct In {
    float turns = 0, y = 0, x = 1, cosine = 0;
};
struct Out {
    glm::vec2 cosSin;
    float angle, arcCosine;
};

std::vector<In> turnsInputs() {
    std::vector<In> inputs;
    for (int i = -4096; i <= 4096; ++i) inputs.push_back({.turns = static_cast<float>(i) / 1024});
    RandomInputs random(2);
    for (int i = 0; i < 8000; ++i) inputs.push_back({.turns = random.between(-1, 1)});
    return inputs;
}

/// Every quadrant, the joints of the polynomial's ranges, and magnitudes from e^-20 to e^20.
std::vector<In> tangentInputs() {
    std::vector<In> inputs;
    for (const float y : {-2.0F, -1.0F, -0.41421356F, -1e-20F, 0.0F, 1e-20F, 0.41421356F, 1.0F, 2.0F})
        for (const float x : {-2.0F, -1.0F, -0.41421356F, 0.0F, 0.41421356F, 1.0F, 2.0F})
            inputs.push_back({0, y, x, 0});
    RandomInputs random(3);
    for (int i = 0; i < 8000; ++i) {
        const float size = std::exp(random.between(-20, 20));
        inputs.push_back({0, random.between(-1, 1) * size, random.between(-1, 1) * size, 0});
    }
    return inputs;
}

std::vector<In> cosineInputs() {
    std::vector<In> inputs;
    for (const float c : {-1.0F, -0.99999994F, -0.9999999F, -1e-30F, 0.0F, 0.5F, 0.9999999F, 0.99999994F, 1.0F})
        inputs.push_back({.cosine = c});
    for (int i = -4096; i <= 4096; ++i) inputs.push_back({.cosine = static_cast<float>(i) / 4096});
    return inputs;
}

}  // namespace

void checkTrigonometry(VerifyContext& context, Findings& findings) {
    std::vector<In> inputs = turnsInputs();
    const auto scope = findings.inputs([&](std::size_t i) {
        const In& in = inputs[i];
        return fmt::format("turns {}, y {}, x {}, cosine {}", in.turns, in.y, in.x, in.cosine);
    });
    const auto compare = [&](const auto& compareOne) {
        const auto out = context.prober().evaluate<Out>("trigonometry", inputs);
        for (std::size_t i = 0; i < inputs.size(); ++i) {
            findings.at(i);
            compareOne(inputs[i], out[i]);
        }
    };
    compare([&](const In& in, const Out& out) {
        const double angle = 2 * M_PI * double{in.turns};
        findings.near("cosSinTurns", out.cosSin, glm::dvec2(std::cos(angle), std::sin(angle)), 2e-7);
    });
    inputs = tangentInputs();
    compare([&](const In& in, const Out& out) {
        findings.near("atan2Accurate", out.angle, std::atan2(double{in.y}, double{in.x}), 3e-7);
    });
    inputs = cosineInputs();
    compare([&](const In& in, const Out& out) {
        findings.near("acosAccurate", out.arcCosine, std::acos(double{in.cosine}), 6e-7);
    });
}

}  // namespace vkpt
