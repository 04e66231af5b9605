// Schlick's Fresnel. [Schlick 94]
#pragma once
#include "reference/real.h"

namespace vkpt::reference {

/// (1 - cosine)^5: how far reflectance has gone from F0 to 1.
template <class Real>
[[nodiscard]] Real schlickWeight(Real cosine) {
    const Real m = 1 - cosine;
    const Real m2 = m * m;
    return m2 * m2 * m;
}

}  // namespace vkpt::reference
