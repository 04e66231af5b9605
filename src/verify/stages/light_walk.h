// The film's layers of light, as they follow from what each kernel of a batch adds to the sums of its paths.
#pragma once
#include <vector>

#include "film/film_layout.h"
#include "verify/findings.h"
#include "verify/stages/device_path.h"

namespace vkpt {

/// Sorts by length and group what the device adds between two snapshots. All integers: the film must equal it exactly.
class LightWalk {
public:
    LightWalk(const SceneArrays& scene, const RenderOptions& options)
        : scene_(scene), layout_(options.aovs, options.light) {}

    /// `before`: the snapshot that came before `now`.
    void see(const DevicePaths& paths, const StageSnapshot& before, const StageSnapshot& now);
    /// Compares the words of the batch's pixels.
    void compare(Findings& findings, const ObservedFilm& film, std::uint32_t samples);

private:
    void add(const StageSnapshot& before, const StageSnapshot& now, std::uint32_t path, std::uint32_t scatterings,
             std::uint32_t group);

    const SceneArrays& scene_;
    FilmLayout layout_;
    std::vector<PathSums> lengths_, groups_;  ///< of each pixel, one after the other
};

}  // namespace vkpt
