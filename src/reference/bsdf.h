// BSDF models: the dispatch over registry.def. Local frame, normal +z; wo and wi point away from the surface; f
// excludes the cosine; pdf is per solid angle. A new model is a .cpp in bsdf/ and a registry line.
#pragma once
#include "reference/bsdf/model.h"

namespace vkpt {
struct SceneArrays;
}

namespace vkpt::reference {

// Eval: f of the lobes that are no deltas. Pdf: the density with which Sample draws wi through them. Sample: wi alone,
// or all of a delta lobe; `uLobe` chooses the lobe, `u` the direction in it. HasDensity: some lobe is no delta.
#define VKPT_BSDF(Name, stem)                                                                                  \
    template <class Real>                                                                                      \
    Vec3<Real> stem##Eval(const Bsdf<Real>& b, const Vec3<Real>& wo, const Vec3<Real>& wi);                    \
    template <class Real>                                                                                      \
    Real stem##Pdf(const Bsdf<Real>& b, const Vec3<Real>& wo, const Vec3<Real>& wi);                           \
    template <class Real>                                                                                      \
    BsdfSample<Real> stem##Sample(const Bsdf<Real>& b, const Vec3<Real>& wo, Real uLobe, const Vec2<Real>& u); \
    template <class Real>                                                                                      \
    bool stem##HasDensity(const Bsdf<Real>& b, const Vec3<Real>& wo);
#include "reference_bsdfs.inc"
#undef VKPT_BSDF

/// glTF's material, `alpha` its roughness squared.
template <class Real>
[[nodiscard]] Bsdf<Real> makeGltfBsdf(const Vec3<Real>& base, Real metallic, Real alpha) {
    Bsdf<Real> b;
    b.color = base;
    b.metallic = metallic;
    b.alphaX = b.alphaY = alpha;
    return b;
}
/// Probabilities of glTF's lobes.
template <class Real>
struct GltfShares {
    Real interreflection;  ///< of facets of the layer, against both others
    Real specular;         ///< of the rest, against the diffuse lobe
};
/// Seen from wo.
template <class Real>
[[nodiscard]] GltfShares<Real> gltfShares(const Bsdf<Real>& b, const Vec3<Real>& wo);

/// Uniform in [0,1) again: what glTF's choices of a lobe have not used up of u. [Shirley 96]
template <class Real>
[[nodiscard]] Real gltfAfterChoices(const Bsdf<Real>& b, const Vec3<Real>& wo, Real u);

/// Another model. `map` multiplies its colour, `mapRoughness` its roughness. `front`: wo is on the front of the
/// surface. The tables are those of the scene.
template <class Real>
[[nodiscard]] Bsdf<Real> makeBsdf(BsdfId model, const BsdfRecord& record, const Vec3<Real>& map, Real mapRoughness,
                                  bool front, const SceneArrays& scene);

/// False where delta lobes are all there is: then light sampling is of no use.
template <class Real>
[[nodiscard]] bool hasDensity(const Bsdf<Real>& b, const Vec3<Real>& wo);

/// Whether it has a delta lobe or transmits: then directions drawn over the hemisphere would miss some of it.
template <class Real>
[[nodiscard]] bool needsItsOwnDraws(const Bsdf<Real>& b);

/// f(wo, wi) of the lobes that are no deltas. Radiance: what crosses a boundary is divided by eta^2.
template <class Real>
[[nodiscard]] Vec3<Real> evalBsdf(const Bsdf<Real>& b, const Vec3<Real>& wo, const Vec3<Real>& wi);

/// Density with which sampleBsdf draws wi through the lobes that are no deltas. The share to 1 are draws without a
/// direction.
template <class Real>
[[nodiscard]] Real pdfBsdf(const Bsdf<Real>& b, const Vec3<Real>& wo, const Vec3<Real>& wi);

/// Draws wi: `uLobe` chooses the lobe, `u` its direction. wi.z < 0: through the surface.
template <class Real>
[[nodiscard]] BsdfSample<Real> sampleBsdf(const Bsdf<Real>& b, const Vec3<Real>& wo, Real uLobe, const Vec2<Real>& u);

}  // namespace vkpt::reference
