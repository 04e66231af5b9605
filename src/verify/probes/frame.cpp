#include "reference/frame.h"

#include "verify/context.h"
#include "verify/inputs/random_inputs.h"
#include "verify/probes.h"

namespace vkpt {
namespace {

struct In {
    glm::vec4 normal, vector;
};
struct Out {
    glm::vec4 t, b, n, local, world;
};

std::vector<In> normals() {
    std::vector<In> inputs;
    RandomInputs random(7);
    const auto add = [&](const glm::vec3& n) { inputs.push_back({glm::vec4(n, 0), glm::vec4(random.direction(), 0)}); };
    for (const float sign : {1.0F, -1.0F}) {
        add({sign, 0, 0});
        add({0, sign, 0});
        add({0, 0, sign});
        add({0.6F, 0.8F * sign, -0.0F});
        add(glm::normalize(glm::vec3(1e-4F, sign * 1e-4F, -1)));
        add(glm::normalize(glm::vec3(1e-20F, 1, sign * 1e-20F)));
    }
    for (int i = 0; i < 4000; ++i) add(random.direction());
    return inputs;
}

}  // namespace

void checkFrame(VerifyContext& context, Findings& findings) {
    const auto inputs = normals();
    const auto out = context.prober().evaluate<Out>("frame", inputs);
    const auto scope = findings.inputs([&](std::size_t i) {
        return fmt::format("normal {}, vector {}", show(inputs[i].normal), show(inputs[i].vector));
    });
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        findings.at(i);
        const glm::vec3 normal(inputs[i].normal), vector(inputs[i].vector);
        const reference::Frame<float> expected{normal};
        findings.near("tangent", glm::vec3(out[i].t), expected.x, 1e-6);
        findings.near("bitangent", glm::vec3(out[i].b), expected.y, 1e-6);
        findings.near("toLocal", glm::vec3(out[i].local), expected.toLocal(vector), 1e-6);

        const glm::dvec3 t(out[i].t), b(out[i].b), n(out[i].n);
        findings.equal("normal", glm::vec3(n), normal);
        findings.near("orthonormality", glm::dvec3(glm::dot(t, t), glm::dot(b, b), glm::dot(t, b)), glm::dvec3(1, 1, 0),
                      1e-6);
        findings.near("right-handedness", glm::cross(t, b), n, 1e-6);
        findings.near("toWorld of toLocal", glm::vec3(out[i].world), vector, 1e-6);
    }
}

}  // namespace vkpt
