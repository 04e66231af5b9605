#include "reference/lone_bsdf.h"

#include "scene/albedo_tables.h"

namespace vkpt::reference {

LoneBsdf::LoneBsdf(const BsdfSpec& spec, bool multiscatter) : spec_(spec), record_(bsdfRecord(spec)) {
    scene_.features.multiscatter = multiscatter;
    AlbedoTables tables(multiscatter);
    tables.add(spec.model, false, record_);
    scene_.albedoTables = tables.take();
}

template <class Real>
Bsdf<Real> LoneBsdf::seenFrom(bool front) const {
    if (spec_.model != BsdfId::Gltf) return makeBsdf<Real>(spec_.model, record_, Vec3<Real>(1), 1, front, scene_);
    const Real roughness(spec_.sigma);
    Bsdf<Real> b = makeGltfBsdf<Real>(Vec3<Real>(spec_.color), Real(spec_.metallic), roughness * roughness);
    b.multiscatter = scene_.features.multiscatter;
    if (b.multiscatter) b.table.cells = scene_.albedoTables.data();
    return b;
}

template Bsdf<float> LoneBsdf::seenFrom(bool) const;
template Bsdf<double> LoneBsdf::seenFrom(bool) const;

}  // namespace vkpt::reference
