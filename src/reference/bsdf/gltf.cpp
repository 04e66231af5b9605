// glTF 2.0 metallic-roughness (specification, appendix B): Lambert under a GGX layer. With interreflection [Kulla 17]
// the diffuse part takes what the layer leaves on the way in and out [Kelemen 01].
#include "reference/bsdf.h"
#include "reference/bsdf/compensation.h"
#include "reference/microfacet/ggx.h"

namespace vkpt::reference {

namespace {

template <class Real>
inline constexpr Real kF0 = Real(kDielectricF0);

/// F = mix(Fd, Fm, metallic).
template <class Real>
Vec3<Real> specularFresnel(const Bsdf<Real>& b, Real cosine) {
    const Real w = schlickWeight(cosine);
    const Real fd = kF0<Real> + (1 - kF0<Real>)*w;
    const Vec3<Real> fm = b.color + (Real(1) - b.color) * w;
    return glm::mix(Vec3<Real>(fd), fm, b.metallic);
}

/// What Fresnel at the half vector leaves for the diffuse lobe: (1 - metallic) (1 - Fd) base.
template <class Real>
Vec3<Real> uncoupledAlbedo(const Bsdf<Real>& b, Real cosine) {
    const Real fd = kF0<Real> + (1 - kF0<Real>)*schlickWeight(cosine);
    return (1 - b.metallic) * (1 - fd) * b.color;
}

/// The layer with interreflection: its albedos and what both lobes become.
template <class Real>
class Layer {
public:
    explicit Layer(const Bsdf<Real>& b) : b_(b), delta_(b.isDelta()), mean_(albedoMean(b, b.table)) {
        if (delta_) return;
        const auto share = [&](const Vec3<Real>& f0) {
            return returnedShare((Real(1) + Real(20) * f0) / Real(21), mean_.lost);
        };
        dielectric_ = share(Vec3<Real>(kF0<Real>)).x;
        returned_ = glm::mix(Vec3<Real>(dielectric_), share(b.color), b.metallic);
    }

    /// Interreflection in the layer, and the base below it.
    [[nodiscard]] Vec3<Real> eval(const Vec3<Real>& wo, const Vec3<Real>& wi) const {
        const Albedo<Real> o = at(wo), i = at(wi);
        const Vec3<Real> base = (1 - b_.metallic) * b_.color / (1 - reflected(mean_));
        Vec3<Real> f = base * (left(wo, o) * left(wi, i) / kPiOf<Real>);
        if (!delta_) f += returned_ * lostEnergyLobe(o.lost, i.lost, mean_.lost);
        return f;
    }

    [[nodiscard]] GltfShares<Real> shares(const Vec3<Real>& wo) const {
        const Vec3<Real> f0 = glm::mix(Vec3<Real>(kF0<Real>), b_.color, b_.metallic);
        const Albedo<Real> o = at(wo);
        const Vec3<Real> specular = delta_ ? specularFresnel(b_, wo.z) : f0 * o.first() + o.second;
        const Real base = luminance((1 - b_.metallic) * b_.color * left(wo, o));
        const Real returned = delta_ ? Real(0) : luminance(returned_) * o.lost;
        const Real once = luminance(specular);
        return {returned > 0 ? shareOf(returned, once + base) : Real(0), shareOf(once, base)};
    }

private:
    [[nodiscard]] Albedo<Real> at(const Vec3<Real>& w) const { return b_.table.albedo(albedoPlace(b_, w)); }
    /// What the dielectric layer reflects, R.
    [[nodiscard]] Real reflected(const Albedo<Real>& a) const {
        if (delta_) return (1 + 20 * kF0<Real>) / 21;
        return kF0<Real> * a.first() + a.second + dielectric_ * a.lost;
    }
    /// What it leaves towards w.
    [[nodiscard]] Real left(const Vec3<Real>& w, const Albedo<Real>& a) const {
        return 1 - (delta_ ? schlickFresnel(std::abs(w.z), Vec3<Real>(kF0<Real>)).x : reflected(a));
    }

    const Bsdf<Real>& b_;
    bool delta_;
    Albedo<Real> mean_;
    Real dielectric_ = 0;     ///< Ms of the dielectric layer
    Vec3<Real> returned_{0};  ///< Ms of the layer
};

template <class Real>
bool isCoupled(const Bsdf<Real>& b) {
    return b.multiscatter && b.table.exists();
}

}  // namespace

template <class Real>
GltfShares<Real> gltfShares(const Bsdf<Real>& b, const Vec3<Real>& wo) {
    if (isCoupled(b)) return Layer<Real>(b).shares(wo);
    const Real cosine = std::abs(wo.z);
    return {0, shareOf(luminance(specularFresnel(b, cosine)), luminance(uncoupledAlbedo(b, cosine)))};
}

template <class Real>
Real gltfAfterChoices(const Bsdf<Real>& b, const Vec3<Real>& wo, Real u) {
    const GltfShares<Real> p = gltfShares(b, wo);
    if (!choose(u, p.interreflection)) (void)choose(u, p.specular);
    return std::min(u, Real(kBelowOne));
}

template <class Real>
Vec3<Real> gltfEval(const Bsdf<Real>& b, const Vec3<Real>& wo, const Vec3<Real>& wi) {
    if (wi.z <= 0) return Vec3<Real>(0);
    const Vec3<Real> wm = glm::normalize(wo + wi);
    const Real cosine = std::abs(glm::dot(wo, wm));
    const Vec3<Real> rest = isCoupled(b) ? Layer<Real>(b).eval(wo, wi) : uncoupledAlbedo(b, cosine) / kPiOf<Real>;
    if (b.isDelta()) return rest;
    return rest + specularFresnel(b, cosine) * (ggxD(wm, b.alphaX) * ggxVisibility(wo.z, wi.z, b.alphaX));
}

template <class Real>
Real gltfPdf(const Bsdf<Real>& b, const Vec3<Real>& wo, const Vec3<Real>& wi) {
    if (wi.z <= 0) return 0;
    const GltfShares<Real> p = gltfShares(b, wo);
    Real once = (1 - p.specular) * wi.z / kPiOf<Real>;
    if (!b.isDelta()) {
        const Vec3<Real> wm = glm::normalize(wo + wi);
        once += p.specular * ggxD(wm, b.alphaX) * ggxG1(wo.z, b.alphaX) / (4 * wo.z);
    }
    return p.interreflection > 0 ? p.interreflection * lostEnergyLobePdf(b, wi) + (1 - p.interreflection) * once : once;
}

template <class Real>
BsdfSample<Real> gltfSample(const Bsdf<Real>& b, const Vec3<Real>& wo, Real uLobe, const Vec2<Real>& u) {
    const GltfShares<Real> p = gltfShares(b, wo);
    if (choose(uLobe, p.interreflection)) return towards(sampleLostEnergyLobe(b, u));
    if (choose(uLobe, p.specular)) {
        if (b.isDelta()) return deltaSample(mirrored(wo), specularFresnel(b, wo.z) / p.specular);
        return towards(reflectAbout(wo, sampleGgxVisibleNormal(wo, b.alphaX, u)));
    }
    return towards(squareToCosineHemisphere(u));
}

template <class Real>
bool gltfHasDensity(const Bsdf<Real>& b, const Vec3<Real>& wo) {
    return !b.isDelta() || gltfShares(b, wo).specular < 1;
}

template float gltfAfterChoices(const Bsdf<float>&, const Vec3<float>&, float);
template GltfShares<float> gltfShares(const Bsdf<float>&, const Vec3<float>&);
template GltfShares<double> gltfShares(const Bsdf<double>&, const Vec3<double>&);
VKPT_INSTANTIATE_BSDF(gltf)

}  // namespace vkpt::reference
