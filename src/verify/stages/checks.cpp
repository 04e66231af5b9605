#include "scene/light_groups.h"
#include "verify/context.h"
#include "verify/inputs/scenes.h"
#include "verify/stages.h"
#include "verify/stages/walk.h"

namespace vkpt {
namespace {

constexpr std::uint32_t kSomeLengths = 4;  ///< fewer than the paths of makeOptions have: the last takes more than one

void walk(VerifyContext& context, Findings& findings, const SceneArrays& arrays, const std::string& what) {
    RenderOptions options = makeOptions(64, 48, 2);
    if (!arrays.lightGroups.empty()) options.light = {kSomeLengths, arrays.lightGroups.names};
    WavefrontConfig config = context.config().wavefront;
    config.pathsInFlight = options.params.width * options.params.height * 2;
    WavefrontRenderer renderer(arrays, options, config);
    StageWalk walk(arrays, options, what);
    walk.run(renderer, 0, options.params.width * options.params.height);
    walk.finish();
    for (std::size_t stage = 0; stage < kStages; ++stage)
        findings.add(kStageNames[stage], walk.findings(static_cast<Stage>(stage)));
}

}  // namespace

void checkGenerate(VerifyContext& context, Findings& f) { f = context.stages().findings(Stage::Generate); }
void checkIntersect(VerifyContext& context, Findings& f) { f = context.stages().findings(Stage::Intersect); }
void checkMiss(VerifyContext& context, Findings& f) { f = context.stages().findings(Stage::Miss); }
void checkShade(VerifyContext& context, Findings& f) { f = context.stages().findings(Stage::Shade); }
void checkShadow(VerifyContext& context, Findings& f) { f = context.stages().findings(Stage::Shadow); }
void checkAccumulate(VerifyContext& context, Findings& f) { f = context.stages().findings(Stage::Accumulate); }

void checkEveryFeature(VerifyContext& context, Findings& findings) {
    SceneArrays arrays = makeEverything(true);
    groupLights(arrays, {true, {}}, false, "every feature");
    walk(context, findings, arrays, "every feature");
}

void checkEveryBsdf(VerifyContext& context, Findings& findings) {
    walk(context, findings, makeBsdfPatches(true), "every bsdf");
}

}  // namespace vkpt
