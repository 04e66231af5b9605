// How the two ways of finding light share it: weights of multiple importance sampling. estimator.md, Strategies.
#pragma once
#include <cmath>

#include "constants.h"
#include "layout.h"
#include "registry.h"

namespace vkpt::reference {

/// Weight of a sample of density `mine`, of which n are drawn, against another technique. [Veach 97, sec. 9.2: power
/// heuristic] 1 where `mine` is infinite or the other technique never finds the sample.
[[nodiscard]] inline float misWeight(float nMine, float mine, float nOther, float other, float beta) {
    if (std::isinf(mine) || nOther * other == 0) return 1;
    const float ratio = nOther * other / (nMine * mine);  // powers of the densities would overflow
    if (beta == 1) return 1 / (1 + ratio);
    return 1 / (1 + (beta == 2 ? ratio * ratio : std::pow(ratio, beta)));
}

class Heuristic {
public:
    explicit Heuristic(const RenderParams& params)
        : strategy_(params.strategy), beta_(params.strategy == kStrategyMisBalance ? 1 : params.beta) {
        if (params.integrator != static_cast<std::uint32_t>(IntegratorId::Direct)) return;
        bsdfSamples_ = params.bsdfSamples;
        lightSamples_ = params.lightSamples;
    }

    /// How many of each kind are drawn at a surface.
    [[nodiscard]] std::uint32_t bsdfSamples() const { return bsdfSamples_; }
    [[nodiscard]] std::uint32_t lightSamples() const { return strategy_ == kStrategyBsdf ? 0 : lightSamples_; }

    /// Of emission that a ray met by chance. `isLight`: light samples could have found it, with density pdfLight.
    [[nodiscard]] float ofEmission(float pdfBsdf, bool isLight, float pdfLight) const {
        if (!isLight || std::isinf(pdfBsdf)) return 1;
        if (strategy_ == kStrategyLight) return pdfLight > 0 ? 0 : 1;
        return misWeight(static_cast<float>(bsdfSamples()), pdfBsdf, static_cast<float>(lightSamples()), pdfLight,
                         beta_);
    }
    /// Of a light sample that a BSDF sample could have found with density pdfBsdf.
    [[nodiscard]] float ofLight(float pdfLight, float pdfBsdf) const {
        if (strategy_ == kStrategyLight) return 1;
        return misWeight(static_cast<float>(lightSamples()), pdfLight, static_cast<float>(bsdfSamples()), pdfBsdf,
                         beta_);
    }

private:
    std::uint32_t strategy_;
    float beta_;
    std::uint32_t bsdfSamples_ = 1, lightSamples_ = 1;
};

}  // namespace vkpt::reference
