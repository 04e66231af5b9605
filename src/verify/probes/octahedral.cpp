#include "base/math.h"
#include "reference/geometry.h"
#include "verify/context.h"
#include "verify/inputs/random_inputs.h"
#include "verify/probes.h"

namespace vkpt {
namespace {

struct In {
    std::uint32_t normal, tangent;
    glm::uvec2 unused{0};
};
struct Out {
    glm::vec4 normal, tangent;
};

}  // namespace

void checkOctahedral(VerifyContext& context, Findings& findings) {
    std::vector<In> inputs;
    std::vector<glm::vec4> axes;  // come back exactly
    for (int axis = 0; axis < 3; ++axis)
        for (const float sign : {1.0F, -1.0F}) {
            glm::vec4 v(0, 0, 0, sign);
            v[axis] = sign;
            axes.push_back(v);
            inputs.push_back({packNormal(glm::vec3(v)), packTangent(v)});
        }
    RandomInputs random(6);
    for (int i = 0; i < 4000; ++i) {
        const glm::vec3 n = random.direction(), t = random.direction();
        inputs.push_back({packNormal(n), packTangent(glm::vec4(t, random.unit() < 0.5F ? -1 : 1))});
    }
    const auto out = context.prober().evaluate<Out>("octahedral", inputs);
    const auto scope = findings.inputs([&](std::size_t i) {
        return fmt::format("packed normal {:08x}, tangent {:08x}", inputs[i].normal, inputs[i].tangent);
    });
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        findings.at(i);
        findings.near("unpackNormal", glm::vec3(out[i].normal), reference::unpackNormal(inputs[i].normal), 3e-7);
        findings.near("unpackTangent", out[i].tangent, reference::unpackTangent(inputs[i].tangent), 3e-7);
        if (i >= axes.size()) continue;
        findings.equal("normals along axes", glm::vec3(out[i].normal), glm::vec3(axes[i]));
        findings.equal("tangents along axes", out[i].tangent, axes[i]);
    }
}

}  // namespace vkpt
