#include "cli/estimator_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

namespace vkpt {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(IdleOptions, ThereAreNoneAmongDefaults) {
    for (const IntegratorInfo& integrator : kIntegrators) {
        SamplingOptions sampling;
        sampling.integrator = integrator.id;
        EXPECT_THAT(idleOptions({}, sampling), IsEmpty()) << integrator.name;
        if (integrator.id != IntegratorId::Path && integrator.id != IntegratorId::Direct) continue;
        sampling.maxDepth = 1;
        EXPECT_THAT(idleOptions({}, sampling), IsEmpty()) << integrator.name;
    }
}

TEST(IdleOptions, AreToldWithWhatTheyNeed) {
    using Change = std::function<void(SceneOptions&, SamplingOptions&)>;
    const auto direct = [](SamplingOptions& s) { s.integrator = IntegratorId::Direct; };
    const std::pair<Change, const char*> cases[] = {
        {[](auto&, auto& s) { s.beta = 3, s.strategy = Strategy::MisBalance; },
         "--beta has no effect without --strategy mis-power"},
        {[](auto&, auto& s) { s.bsdfSamples = 4; }, "--bsdf-samples has no effect without --integrator direct"},
        {[](auto&, auto& s) { s.lightSamples = 4; }, "--light-samples has no effect without --integrator direct"},
        {[&](auto&, auto& s) { direct(s), s.lightSamples = 4, s.strategy = Strategy::Bsdf; },
         "--light-samples has no effect with --strategy bsdf"},
        {[](auto&, auto& s) { s.aoDistance = 1; }, "--ao-distance has no effect without --integrator ao"},
        {[&](auto&, auto& s) { direct(s), s.clampIndirect = 1; },
         "--clamp-indirect has no effect without --integrator path"},
        {[&](auto&, auto& s) { direct(s), s.maxDepth = 3; },
         "--max-depth above 1 has no effect with --integrator direct"},
        {[&](auto&, auto& s) { direct(s), s.rrDepth = 1; }, "--rr has no effect without --integrator path"},
        {[](auto&, auto& s) { s.integrator = IntegratorId::Ao, s.maxDepth = 2; },
         "--max-depth has no effect without --integrator path or direct"},
        {[](auto&, auto& s) { s.integrator = IntegratorId::Ao, s.strategy = Strategy::Light; },
         "--strategy has no effect without --integrator path or direct"},
        {[](auto&, auto& s) { s.integrator = IntegratorId::Normal, s.hemisphere = Hemisphere::Uniform; },
         "--hemisphere has no effect without --integrator path, direct or ao"},
        {[](auto& c, auto&) { c.focus = 1; }, "--focus has no effect without --aperture"},
        {[](auto& c, auto&) { c.fov = 30, c.projection = Projection::Panorama; },
         "--fov has no effect with --projection panorama"},
    };
    for (const auto& [change, line] : cases) {
        SceneOptions scene;
        SamplingOptions sampling;
        change(scene, sampling);
        EXPECT_THAT(idleOptions(scene, sampling), ElementsAre(line));
    }
}

TEST(UnfoundLight, IsThatOfPunctualLightsWithoutLightSamples) {
    SceneArrays arrays;
    for (const std::uint32_t kind : {kLightTriangle, kLightPoint, kLightEnvironment, kLightSpot, kLightDirectional}) {
        arrays.lights.emplace_back().kind = kind;
    }
    RenderParams params = defaultParams();
    params.maxDepth = 8;
    EXPECT_EQ(unfoundLight(arrays, params), "");
    params.strategy = kStrategyBsdf;
    EXPECT_THAT(unfoundLight(arrays, params), HasSubstr("--strategy bsdf"));
    EXPECT_THAT(unfoundLight(arrays, params), HasSubstr("how many stay dark: 3"));
    params.maxDepth = 0;
    EXPECT_EQ(unfoundLight(arrays, params), "") << "emission alone needs no light samples";
    params.maxDepth = 8;
    params.strategy = kStrategyMisPower;
    params.lightSamples = 0;
    EXPECT_EQ(unfoundLight(arrays, params), "") << "which is of integrator direct";
    params.integrator = static_cast<std::uint32_t>(IntegratorId::Direct);
    EXPECT_THAT(unfoundLight(arrays, params), HasSubstr("--light-samples 0"));
    arrays.lights.resize(1);
    EXPECT_EQ(unfoundLight(arrays, params), "");
}

}  // namespace
}  // namespace vkpt
