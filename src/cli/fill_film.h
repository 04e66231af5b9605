// Renders the samples that a film lacks, saving it now and then.
#pragma once
#include <functional>

#include "cli/backend.h"
#include "film/film_record.h"

namespace vkpt {

/// When filling stops, and what happens meanwhile.
struct FillControl {
    const std::atomic<bool>* stop = nullptr;
    std::optional<std::chrono::steady_clock::time_point> deadline;
    std::function<void(std::uint64_t pathsDone, std::uint64_t pathsTotal)> progress;
    std::optional<double> checkpointSeconds;  ///< between two calls of `save`
    std::function<void(const FilmRecord&)> save;
};

/// Adds to `record` the samples of `missing`, in this order, until all are there or `control` says to stop, which is
/// heard after a pass. At least one pass is made. The film does not depend on where it was saved or stopped.
/// Returns the report of all that was rendered.
RenderReport fillFilm(FilmRecord& record, SceneRenderer& renderer, const SampleRanges& missing,
                      const FillControl& control);

}  // namespace vkpt
