#include <cmath>

#include "reference/intersect.h"
#include "verify/context.h"
#include "verify/inputs/random_inputs.h"
#include "verify/probes.h"

namespace vkpt {
namespace {

struct In {
    glm::vec4 origin, direction, v0, v1, v2;
};
struct Out {
    float t, b0, b1, facing;
};

glm::vec4 word(const glm::vec3& v) { return {v, 0}; }

std::string describe(const In& in) {
    return fmt::format("ray from {} along {}, triangle {}, {}, {}", show(glm::vec3(in.origin)),
                       show(glm::vec3(in.direction)), show(glm::vec3(in.v0)), show(glm::vec3(in.v1)),
                       show(glm::vec3(in.v2)));
}

/// Rays towards points of random triangles, a third of them aimed past the edge; triangles of many sizes and shapes.
std::vector<In> raysAtTriangles() {
    std::vector<In> inputs;
    RandomInputs random(13);
    for (int i = 0; i < 8000; ++i) {
        const float size = std::exp(random.between(-6, 6));
        const glm::vec3 low(-size), high(size), v0 = random.inBox(low, high), v1 = random.inBox(low, high);
        const glm::vec3 v2 =
            i % 5 == 0 ? glm::mix(v0, v1, random.unit()) + 0.01F * random.inBox(low, high) : random.inBox(low, high);
        const float b0 = random.between(-0.2F, 1.2F), b1 = random.between(-0.2F, 1 - b0);
        const glm::vec3 origin = random.inBox(low * 3.0F, high * 3.0F), target = b0 * v0 + b1 * v1 + (1 - b0 - b1) * v2;
        const glm::vec3 d = i % 7 == 0 ? glm::vec3(0, i % 2 == 0 ? 1 : -1, 0) : target - origin;
        inputs.push_back({word(i % 7 == 0 ? target - d * size : origin), word(d), word(v0), word(v1), word(v2)});
    }
    return inputs;
}

/// How near the ray passes an edge, as a share of the triangle; and how oblique it is.
struct Margin {
    double edge, sine;
};
Margin marginOf(const In& in, glm::dvec3& truth) {
    const glm::dvec3 o(in.origin), d(in.direction), a(in.v0), e1 = glm::dvec3(in.v1) - a, e2 = glm::dvec3(in.v2) - a;
    const glm::dvec3 p = glm::cross(d, e2), s = o - a, q = glm::cross(s, e1);
    const double det = glm::dot(e1, p), b1 = glm::dot(s, p) / det, b2 = glm::dot(d, q) / det;
    truth = {glm::dot(e2, q) / det, 1 - b1 - b2, b1};
    return {std::min({std::abs(b1), std::abs(b2), std::abs(truth.y)}),
            std::abs(det) / (glm::length(d) * glm::length(e1) * glm::length(e2))};
}

/// Against the reference, and against the truth in double where rounding neither decides nor spoils t.
void compareHits(Prober& prober, Findings& findings) {
    const auto inputs = raysAtTriangles();
    const auto out = prober.evaluate<Out>("triangle", inputs);
    const auto scope = findings.inputs([&](std::size_t i) { return describe(inputs[i]); });
    int hits = 0, clear = 0;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        findings.at(i);
        const In& in = inputs[i];
        glm::dvec3 truth;
        const Margin margin = marginOf(in, truth);
        if (margin.edge < 1e-3 || margin.sine < 1e-3) continue;
        ++clear;
        const reference::ShearedRay ray({glm::vec3(in.origin), glm::vec3(in.direction)});
        const auto expected = ray.intersect(glm::vec3(in.v0), glm::vec3(in.v1), glm::vec3(in.v2));
        const bool hit = out[i].facing != 0 && out[i].t > 0;
        if (!findings.equal("hit", hit, expected.has_value()) || !hit) continue;
        ++hits;
        findings.equal("front", out[i].facing > 0, expected->front);
        findings.near("barycentrics", glm::vec2(out[i].b0, out[i].b1), glm::vec2(expected->barycentrics), 1e-3);
        findings.near("t against double", out[i].t, truth.x, 0, 1e-3);
        findings.near("t", out[i].t, expected->t, 0, 1e-3);
    }
    findings.atLeast("rays clear of edges", clear, 6001);
    findings.atLeast("hits", hits, 1501);
}

/// Rays through points of an edge, from all sides: none may slip between the two triangles that share it.
void compareEdges(Prober& prober, Findings& findings) {
    std::vector<In> inputs;
    RandomInputs random(14);
    for (int i = 0; i < 20000; ++i) {
        const float size = std::exp(random.between(-3, 3));
        const glm::vec3 low(-size), high(size);
        const glm::vec3 a = random.inBox(low, high), b = random.inBox(low, high), c = random.inBox(low, high);
        const glm::vec3 d = a + b - c;  // across the edge ab
        const glm::vec3 origin = random.inBox(low * 2.0F, high * 2.0F),
                        target = glm::mix(a, b, random.between(0.01F, 0.99F));
        inputs.push_back({word(origin), word(target - origin), word(a), word(b), word(c)});
        inputs.push_back({word(origin), word(target - origin), word(b), word(a), word(d)});
    }
    const auto out = prober.evaluate<Out>("triangle", inputs);
    const auto scope = findings.inputs([&](std::size_t i) { return describe(inputs[i]); });
    int met = 0;
    for (std::size_t i = 0; i < inputs.size(); i += 2) {
        findings.at(i);
        glm::dvec3 truth;
        if (marginOf(inputs[i], truth).sine < 0.01 || marginOf(inputs[i + 1], truth).sine < 0.01) continue;
        findings.holds("shared edge", out[i].facing != 0 || out[i + 1].facing != 0, "lets a ray through");
        ++met;
    }
    findings.atLeast("rays at edges", met, 8001);
}

/// Rays in the plane, and triangles without area, are misses.
void compareDegenerate(Prober& prober, Findings& findings) {
    const std::vector<In> inputs = {
        {word({-1, 0.2F, 0}), word({1, 0, 0}), word({0, 0, 0}), word({1, 0, 0}), word({0, 1, 0})},
        {word({0, 0, 1}), word({0, 0, -1}), word({-1, 0, 0}), word({1, 0, 0}), word({-1, 0, 0})},
        {word({0, 0, 1}), word({0, 0, -1}), word({0, 0, 0}), word({0, 0, 0}), word({0, 0, 0})}};
    const auto out = prober.evaluate<Out>("triangle", inputs);
    const auto scope = findings.inputs([&](std::size_t i) { return describe(inputs[i]); });
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        findings.at(i);
        findings.equal("degenerate triangle", out[i].facing, 0.0F);
    }
}

}  // namespace

void checkTriangle(VerifyContext& context, Findings& findings) {
    compareHits(context.prober(), findings);
    compareEdges(context.prober(), findings);
    compareDegenerate(context.prober(), findings);
}

}  // namespace vkpt
