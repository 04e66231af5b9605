// A study of one or two BSDFs: what `vkpt bsdf` shows.
#pragma once
#include <string>
#include <vector>

#include "analysis/studies.h"
#include "scene/bsdf_spec.h"

namespace vkpt {

struct BsdfStudyRequest {
    std::vector<BsdfSpec> specs;  ///< one, or two to compare
    std::vector<std::string> names;
    bool multiscatter = true;  ///< of pictures; the table has the energy with and without
    std::uint32_t seed = 0;
    std::uint32_t draws = 20000;  ///< a direction
    bool facets = false;          ///< facetsJson in the JSON
    bool picture = false;         ///< fill Study::drawing
};

[[nodiscard]] Study studyBsdf(const BsdfStudyRequest& request);

}  // namespace vkpt
