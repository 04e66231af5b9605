// A BSDF outside any scene: what a spec stands for, as a renderer would meet it.
#pragma once
#include "reference/bsdf.h"
#include "scene/bsdf_spec.h"
#include "scene/scene_arrays.h"

namespace vkpt::reference {

class LoneBsdf {
public:
    /// `multiscatter`: with compensation of interreflection, where the model has it.
    LoneBsdf(const BsdfSpec& spec, bool multiscatter);

    [[nodiscard]] const BsdfSpec& spec() const { return spec_; }
    [[nodiscard]] bool transmits() const { return spec_.model == BsdfId::Dielectric; }
    /// The result points to tables of this object.
    template <class Real>
    [[nodiscard]] Bsdf<Real> seenFrom(bool front) const;

private:
    BsdfSpec spec_;
    BsdfRecord record_;
    SceneArrays scene_;
};

}  // namespace vkpt::reference
