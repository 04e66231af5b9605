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
    Layer(const Bsdf<Real>& b, const Vec3<Real>& wo)
        : b_(b), delta_(b.isDelta()), row_(albedoRow(b, wo)), mean_(b.table.mean(row_)) {
        const Real keptMean = mean_.x + mean_.y;
        const auto share = [&](const Vec3<Real>& f0) {
            return returnedShare((Real(1) + Real(20) * f0) / Real(21), keptMean);
        };
        if (delta_) return;
        dielectric_ = share(Vec3<Real>(kF0<Real>)).x;
        returned_ = glm::mix(Vec3<Real>(dielectric_), share(b.color), b.metallic);
    }

    /// Interreflection in the layer, and the base below it.
    [[nodiscard]] Vec3<Real> eval(const Vec3<Real>& wo, const Vec3<Real>& wi) const {
        Vec3<Real> f = diffuseScale() * (left(wo) * left(wi) / kPiOf<Real>);
        if (!delta_) f += returned_ * lostEnergyLobe(kept(wo), kept(wi), mean_.x + mean_.y);
        return f;
    }

    [[nodiscard]] Real specularShare(const Vec3<Real>& wo) const {
        const Vec3<Real> f0 = glm::mix(Vec3<Real>(kF0<Real>), b_.color, b_.metallic);
        const Vec2<Real> a = at(wo);
        const Vec3<Real> specular = delta_ ? specularFresnel(b_, wo.z) : f0 * a.x + a.y;
        Vec3<Real> rest = (1 - b_.metallic) * b_.color * left(wo);
        if (!delta_) rest += returned_ * (1 - a.x - a.y);
        return shareOf(luminance(specular), luminance(rest));
    }

private:
    [[nodiscard]] Vec2<Real> at(const Vec3<Real>& w) const { return b_.table.albedo(w.z, row_); }
    [[nodiscard]] Real kept(const Vec3<Real>& w) const {
        const Vec2<Real> a = at(w);
        return a.x + a.y;
    }
    /// 1 - R(w): what the dielectric layer leaves.
    [[nodiscard]] Real left(const Vec3<Real>& w) const {
        if (delta_) return 1 - schlickFresnel(std::abs(w.z), Vec3<Real>(kF0<Real>)).x;
        const Vec2<Real> a = at(w);
        return 1 - (kF0<Real> * a.x + a.y + dielectric_ * (1 - a.x - a.y));
    }
    [[nodiscard]] Vec3<Real> diffuseScale() const {
        const Real mean =
            delta_ ? (1 + 20 * kF0<Real>) / 21 : kF0<Real> * mean_.x + mean_.y + dielectric_ * (1 - mean_.x - mean_.y);
        return (1 - b_.metallic) * b_.color / (1 - mean);
    }

    const Bsdf<Real>& b_;
    bool delta_;
    Real row_;
    Vec2<Real> mean_;
    Real dielectric_ = 0;     ///< Ms of the dielectric layer
    Vec3<Real> returned_{0};  ///< Ms of the layer
};

template <class Real>
bool isCoupled(const Bsdf<Real>& b) {
    return b.multiscatter && b.table.exists();
}

}  // namespace

template <class Real>
Real gltfSpecularShare(const Bsdf<Real>& b, const Vec3<Real>& wo) {
    if (isCoupled(b)) return Layer<Real>(b, wo).specularShare(wo);
    return shareOf(luminance(specularFresnel(b, std::abs(wo.z))), luminance(uncoupledAlbedo(b, std::abs(wo.z))));
}

template <class Real>
Vec3<Real> gltfEval(const Bsdf<Real>& b, const Vec3<Real>& wo, const Vec3<Real>& wi) {
    if (wi.z <= 0) return Vec3<Real>(0);
    const Vec3<Real> wm = glm::normalize(wo + wi);
    const Real cosine = std::abs(glm::dot(wo, wm));
    const Vec3<Real> rest = isCoupled(b) ? Layer<Real>(b, wo).eval(wo, wi) : uncoupledAlbedo(b, cosine) / kPiOf<Real>;
    if (b.isDelta()) return rest;
    return rest + specularFresnel(b, cosine) * (ggxD(wm, b.alphaX) * ggxVisibility(wo.z, wi.z, b.alphaX));
}

template <class Real>
Real gltfPdf(const Bsdf<Real>& b, const Vec3<Real>& wo, const Vec3<Real>& wi) {
    if (wi.z <= 0) return 0;
    const Real pSpecular = gltfSpecularShare(b, wo);
    const Real diffuse = (1 - pSpecular) * wi.z / kPiOf<Real>;
    if (b.isDelta()) return diffuse;
    const Vec3<Real> wm = glm::normalize(wo + wi);
    return pSpecular * ggxD(wm, b.alphaX) * ggxG1(wo.z, b.alphaX) / (4 * wo.z) + diffuse;
}

template <class Real>
BsdfSample<Real> gltfSample(const Bsdf<Real>& b, const Vec3<Real>& wo, Real uLobe, const Vec2<Real>& u) {
    const Real pSpecular = gltfSpecularShare(b, wo);
    if (!(uLobe < pSpecular)) return towards(squareToCosineHemisphere(u));
    if (b.isDelta()) return deltaSample(mirrored(wo), specularFresnel(b, wo.z) / pSpecular);
    return towards(reflectAbout(wo, sampleGgxVisibleNormal(wo, b.alphaX, u)));
}

template <class Real>
bool gltfHasDensity(const Bsdf<Real>& b, const Vec3<Real>& wo) {
    return !b.isDelta() || gltfSpecularShare(b, wo) < 1;
}

template float gltfSpecularShare(const Bsdf<float>&, const Vec3<float>&);
template double gltfSpecularShare(const Bsdf<double>&, const Vec3<double>&);
VKPT_INSTANTIATE_BSDF(gltf)

}  // namespace vkpt::reference
