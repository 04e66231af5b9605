#include "reference/bsdf.h"

#include <stdexcept>

#include "scene/scene_arrays.h"

namespace vkpt::reference {

namespace {

/// Whether the colour map multiplies `diffuse`, else `color`.
bool mapsDiffuse(BsdfId model) {
    return model == BsdfId::Plastic || model == BsdfId::CookTorrance || model == BsdfId::AshikhminShirley ||
           model == BsdfId::Phong || model == BsdfId::BlinnPhong;
}

/// Turns a dielectric that is met from behind.
template <class Real>
void turn(Bsdf<Real>& b) {
    b.eta = Real(1) / b.eta;
    std::swap(b.table, b.farTable);
}

}  // namespace

template <class Real>
Bsdf<Real> makeBsdf(BsdfId model, const BsdfRecord& r, const Vec3<Real>& map, Real mapRoughness, bool front,
                    const SceneArrays& scene) {
    Bsdf<Real> b;
    b.model = model;
    b.flags = r.flags;
    b.color = Vec3<Real>(r.color);
    b.diffuse = Vec3<Real>(r.diffuse);
    (mapsDiffuse(model) ? b.diffuse : b.color) *= map;
    b.eta = Vec3<Real>(r.eta);
    b.k = Vec3<Real>(r.k);
    b.average = Vec3<Real>(r.average);
    b.alphaX = Real(r.alphaX) * mapRoughness;
    b.alphaY = Real(r.alphaY) * mapRoughness;
    b.exponentX = Real(r.exponentX);
    b.exponentY = Real(r.exponentY);
    b.sigma = Real(r.sigma) * mapRoughness;
    b.weight = Real(r.weight);
    b.specular = Real(r.specular);
    b.multiscatter = scene.features.multiscatter;
    if (r.table != kNone) b.table.cells = &scene.albedoTables[r.table];
    if (model == BsdfId::Dielectric) {
        if (b.table.exists()) b.farTable.cells = b.table.cells + kAlbedoTableWords;
        if (!front) turn(b);
    }
    return b;
}

template <class Real>
bool hasDensity(const Bsdf<Real>& b, const Vec3<Real>& wo) {
    switch (b.model) {
#define VKPT_BSDF(Name, stem) \
    case BsdfId::Name:        \
        return stem##HasDensity(b, wo);
#include "reference_bsdfs.inc"
#undef VKPT_BSDF
    }
    throw std::logic_error("BSDF model is not in the registry");
}

template <class Real>
bool needsItsOwnDraws(const Bsdf<Real>& b) {
    switch (b.model) {
        case BsdfId::Mirror:
        case BsdfId::Dielectric:
            return true;
        case BsdfId::Gltf:
        case BsdfId::Conductor:
        case BsdfId::Plastic:
        case BsdfId::TorranceSparrow:
            return b.isDelta();
        default:
            return false;
    }
}

template <class Real>
Vec3<Real> evalBsdf(const Bsdf<Real>& b, const Vec3<Real>& wo, const Vec3<Real>& wi) {
    if (wo.z <= 0) return Vec3<Real>(0);
    switch (b.model) {
#define VKPT_BSDF(Name, stem) \
    case BsdfId::Name:        \
        return stem##Eval(b, wo, wi);
#include "reference_bsdfs.inc"
#undef VKPT_BSDF
    }
    throw std::logic_error("BSDF model is not in the registry");
}

template <class Real>
Real pdfBsdf(const Bsdf<Real>& b, const Vec3<Real>& wo, const Vec3<Real>& wi) {
    if (wo.z <= 0) return 0;
    switch (b.model) {
#define VKPT_BSDF(Name, stem) \
    case BsdfId::Name:        \
        return stem##Pdf(b, wo, wi);
#include "reference_bsdfs.inc"
#undef VKPT_BSDF
    }
    throw std::logic_error("BSDF model is not in the registry");
}

namespace {

template <class Real>
BsdfSample<Real> drawDirection(const Bsdf<Real>& b, const Vec3<Real>& wo, Real uLobe, const Vec2<Real>& u) {
    switch (b.model) {
#define VKPT_BSDF(Name, stem) \
    case BsdfId::Name:        \
        return stem##Sample(b, wo, uLobe, u);
#include "reference_bsdfs.inc"
#undef VKPT_BSDF
    }
    throw std::logic_error("BSDF model is not in the registry");
}

}  // namespace

template <class Real>
BsdfSample<Real> sampleBsdf(const Bsdf<Real>& b, const Vec3<Real>& wo, Real uLobe, const Vec2<Real>& u) {
    if (wo.z <= 0) return {};
    BsdfSample<Real> sample = drawDirection(b, wo, uLobe, u);
    if (std::isinf(sample.pdf)) return sample;
    sample.pdf = pdfBsdf(b, wo, sample.wi);
    if (sample.pdf > 0) sample.weight = evalBsdf(b, wo, sample.wi) * (std::abs(sample.wi.z) / sample.pdf);
    return sample;
}

#define VKPT_INSTANTIATE(Real)                                                                                  \
    template Bsdf<Real> makeBsdf(BsdfId, const BsdfRecord&, const Vec3<Real>&, Real, bool, const SceneArrays&); \
    template bool hasDensity(const Bsdf<Real>&, const Vec3<Real>&);                                             \
    template bool needsItsOwnDraws(const Bsdf<Real>&);                                                          \
    template Vec3<Real> evalBsdf(const Bsdf<Real>&, const Vec3<Real>&, const Vec3<Real>&);                      \
    template Real pdfBsdf(const Bsdf<Real>&, const Vec3<Real>&, const Vec3<Real>&);                             \
    template BsdfSample<Real> sampleBsdf(const Bsdf<Real>&, const Vec3<Real>&, Real, const Vec2<Real>&);
VKPT_INSTANTIATE(float)
VKPT_INSTANTIATE(double)
#undef VKPT_INSTANTIATE

}  // namespace vkpt::reference
