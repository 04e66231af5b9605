// Every kernel of a batch against the reference, each from the state that the device itself had before it: a fault
// shows in the stage that has it, at the first bounce where it matters, and nowhere else.
#pragma once
#include <array>
#include <vector>

#include "verify/findings.h"
#include "verify/stages/device_path.h"
#include "verify/stages/hits.h"
#include "verify/stages/light_walk.h"
#include "verify/stages/rounding.h"
#include "wavefront/renderer.h"

namespace vkpt {

inline constexpr std::size_t kStages = kStageNames.size();

class StageWalk {
public:
    /// `what` names the scene in disagreements.
    StageWalk(const SceneArrays& scene, const RenderOptions& options, std::string what);

    /// Runs one batch: all samples of the renderer's range of `pixelCount` pixels from `firstPixel` on.
    void run(WavefrontRenderer& renderer, std::uint32_t firstPixel, std::uint32_t pixelCount);
    /// Ends the walk: what rounding excused must be little.
    void finish();

    [[nodiscard]] const Findings& findings(Stage stage) const { return findings_[static_cast<std::size_t>(stage)]; }

private:
    void see(const StageSnapshot& now);
    void generate(const StageSnapshot& now);
    void intersect(const StageSnapshot& now);
    void miss(const StageSnapshot& now);
    void shade(const StageSnapshot& now);
    void shadow(const StageSnapshot& now);
    void accumulate(const StageSnapshot& now, const ObservedFilm& film);

    void compareQueue(Findings& findings, std::string_view name, std::vector<std::uint32_t> actual,
                      std::vector<std::uint32_t> expected);
    [[nodiscard]] static bool beginsSums(const StageSnapshot& now);
    [[nodiscard]] bool seesBackground() const;
    [[nodiscard]] bool countsSearch() const;
    [[nodiscard]] std::uint32_t groupOf(const reference::Hit& hit) const;
    void compareCost(Findings& findings, const DevicePaths::Place& place, const glm::vec3& emitted,
                     const glm::vec3& throughput) const;
    void compareUntouched(Findings& findings, const StageSnapshot& now, const std::vector<bool>& touched);
    [[nodiscard]] glm::dvec3 added(const StageSnapshot& now, std::uint32_t path, bool first) const;
    [[nodiscard]] Findings& of(Stage stage) { return findings_[static_cast<std::size_t>(stage)]; }
    /// Describes slots of the current batch and bounce.
    [[nodiscard]] Findings::InputScope scope(Findings& findings, std::uint32_t bounce);

    const SceneArrays& scene_;
    const RenderParams& params_;
    double mostExcused_;
    DevicePaths paths_;
    LightWalk light_;
    std::string what_;
    StageSnapshot before_;
    HitCounts hits_;
    std::array<Findings, kStages> findings_;
};

}  // namespace vkpt
