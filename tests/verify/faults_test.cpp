// Planted faults prove the verifier: each must be named by the check that is there for it, or be known as one that none
// can see.
#include "verify/faults.h"

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cstdio>

#include "registry.h"
#include "scene/camera.h"
#include "verify/ladder.h"
#include "verify/test_context.h"

namespace vkpt {

void PrintTo(const Fault& fault, std::ostream* out) { *out << fault.about; }

namespace {

std::vector<Fault> shaderFaults(bool quick) {
    std::vector<Fault> faults;
    for (const Fault& fault : allFaults())
        if (fault.inShaders() && fault.quick == quick) faults.push_back(fault);
    return faults;
}

struct Ground {
    SceneArrays scene = everyFeature();
    RenderOptions options = smallOptions();
};

/// What faults may need, and how the small scene gets it.
struct Need {
    std::string_view name;
    void (*provide)(Ground&);
};
constexpr std::array kNeeds = {
    Need{"fixed roulette",
         [](Ground& g) {
             g.options.params.rrMode = kRouletteFixed;
             g.options.params.rrFixed = 0.6F;
             g.options.params.rrDepth = 1;
         }},
    Need{"transparent background", [](Ground& g) { g.options.params.backgroundMode = kBackgroundTransparent; }},
    Need{"orthographic camera", [](Ground& g) { g.options.params.projection = kProjectionOrthographic; }},
    Need{"unlit material",
         [](Ground& g) {
             g.scene.materials[0].flags |= kMaterialUnlit;
             g.scene.features.unlit = true;
         }},
    Need{"few triangles", [](Ground& g) { g.scene = makeArrays(makeLamps()); }},
    Need{"panorama", [](Ground& g) { setProjection(g.options.params, kProjectionPanorama, 1); }},
    Need{"thin lens",
         [](Ground& g) {
             g.options.params.lensRadius = 0.2F;
             g.options.params.focusDistance = 5;
         }},
    Need{"mitchell filter",
         [](Ground& g) {
             g.options.params.pixelFilter = kFilterMitchell;
             g.options.params.filterRadius = 2;
         }},
    Need{"uniform hemisphere", [](Ground& g) { g.options.params.hemisphere = kHemisphereUniform; }},
    Need{"strategy light", [](Ground& g) { g.options.params.strategy = kStrategyLight; }},
    Need{"clamped light", [](Ground& g) { g.options.params.clampIndirect = 0.01F; }},
    Need{"direct light of several samples",
         [](Ground& g) {
             g.options.params.integrator = static_cast<std::uint32_t>(IntegratorId::Direct);
             g.options.params.maxDepth = 1;
             g.options.params.bsdfSamples = 2;
             g.options.params.lightSamples = 3;
         }},
    Need{"uniform ambient occlusion",
         [](Ground& g) {
             g.options.params.integrator = static_cast<std::uint32_t>(IntegratorId::Ao);
             g.options.params.hemisphere = kHemisphereUniform;
         }},
};

/// The small scene with what a fault needs.
Ground setUp(std::string_view needs) {
    Ground setup;
    const auto need = std::ranges::find(kNeeds, needs, &Need::name);
    if (need != kNeeds.end()) need->provide(setup);
    EXPECT_TRUE(needs.empty() || need != kNeeds.end()) << "unknown need: " << needs;
    return setup;
}

/// The first check that disagrees, as climb() finds it; its `check` is null where none does. Samplers, which take the
/// longest, are left out where no sampler has the fault.
CheckResult firstDisagreement(FaultyShaders& shaders, const Ground& setup) {
    VerifyConfig config = testConfig(false);
    config.wavefront.kernels = shaders.kernels();
    config.probes = shaders.probes();
    config.replicates = 8;
    VerifyContext context(setup.scene, setup.options, config);
    for (const Check& check : verifyChecks()) {
        if (check.name == "samplers" && !shaders.reads("shaders/probes/samplers.comp")) continue;
        CheckResult row;
        row.check = &check;
        check.run(context, row.findings);
        if (!row.agrees()) return row;
    }
    return {};
}

class ShaderFault : public testing::TestWithParam<Fault> {};

TEST_P(ShaderFault, IsNamedByItsCheck) {
    const Fault& fault = GetParam();
    FaultyShaders shaders(fault);
    if (!fault.needs.empty()) {
        EXPECT_EQ(firstDisagreement(shaders, {}).check, nullptr) << "found without " << fault.needs;
    }
    const CheckResult found = firstDisagreement(shaders, setUp(fault.needs));
    EXPECT_GT(shaders.count(), 0U) << "no kernel reads the edited file";
    if (!fault.survives.empty()) {
        EXPECT_EQ(found.check, nullptr) << "found after all, by " << found.check->name << ": take it off the survivors";
        return;
    }
    ASSERT_NE(found.check, nullptr) << "nobody sees it";
    const Disagreement& d = *found.findings.disagreement();
    EXPECT_EQ(found.check->name, fault.check) << d.quantity << ": " << d.what << "\n" << d.where;
    EXPECT_FALSE(d.where.empty());
    RecordProperty("finding", fmt::format("{}: {} ({})", d.quantity, d.what, d.where));
}

const auto nameOfFault = [](const auto& test) { return test.param.name; };
INSTANTIATE_TEST_SUITE_P(Quick, ShaderFault, testing::ValuesIn(shaderFaults(true)), nameOfFault);
INSTANTIATE_TEST_SUITE_P(Full, ShaderFault, testing::ValuesIn(shaderFaults(false)), nameOfFault);

#ifdef VKPT_FAULTY

struct Ended {
    int code = -1;
    std::string out;
};

/// The program with the fault active, as a user runs it.
Ended runFaulty(const Fault& fault) {
    const VerifyConfig config = testConfig(false);
    const std::string device = config.wavefront.device.empty() ? "" : " --device '" + config.wavefront.device + "'";
    const std::string command = fmt::format(
        "VKPT_PLANTED_FAULT={} '{}' verify '{}/cornell_box/scene.gltf' --size 48x32 --spp 2 --replicates 8 -q{} {} "
        "2>&1",
        fault.number, VKPT_FAULTY, VKPT_SCENES, device, fault.needs);
    Ended run;
    FILE* pipe = popen(command.c_str(), "r");
    if (pipe == nullptr) return run;
    std::array<char, 4096> chunk;
    while (const std::size_t got = fread(chunk.data(), 1, chunk.size(), pipe)) run.out.append(chunk.data(), got);
    const int status = pclose(pipe);
    if (WIFEXITED(status)) run.code = WEXITSTATUS(status);
    return run;
}

class ReferenceFault : public testing::TestWithParam<Fault> {};

TEST_P(ReferenceFault, EndsTheProgramWithCode2AndItsCheck) {
    const Fault& fault = GetParam();
    const Ended run = runFaulty(fault);
    if (!fault.survives.empty()) {
        EXPECT_EQ(run.code, 0) << "found after all: take it off the survivors\n" << run.out;
        return;
    }
    EXPECT_EQ(run.code, 2) << run.out;
    const auto found = std::ranges::find(verifyChecks(), std::string_view(fault.check), &Check::name);
    ASSERT_NE(found, verifyChecks().end());
    const auto rung = static_cast<std::size_t>(found->rung);
    const std::string line = fmt::format("disagreement at rung {} {}, {}: ", rung + 1, kRungs[rung].name, fault.check);
    EXPECT_NE(run.out.find(line), std::string::npos) << run.out;
}

std::vector<Fault> referenceFaults() {
    std::vector<Fault> faults;
    for (const Fault& fault : allFaults())
        if (!fault.inShaders()) faults.push_back(fault);
    return faults;
}
INSTANTIATE_TEST_SUITE_P(Full, ReferenceFault, testing::ValuesIn(referenceFaults()), nameOfFault);

TEST(FullFaults, WithoutAnActiveFaultTheFaultyProgramAgrees) {
    Fault none;
    none.number = -1;
    const Ended run = runFaulty(none);
    EXPECT_EQ(run.code, 0) << run.out;
}

#endif

TEST(Faults, AllApplyToTheSourcesAsTheyAre) {
    for (const Fault& fault : allFaults()) {
        const std::string text = readText(std::filesystem::path(VKPT_SOURCE) / fault.file);
        const std::size_t first = text.find(fault.right);
        EXPECT_NE(first, std::string::npos) << fault.name << ": its text is not in " << fault.file;
        EXPECT_EQ(text.find(fault.right, first + 1), std::string::npos) << fault.name << ": its text stands twice";
        const bool known = std::ranges::count(verifyChecks(), std::string_view(fault.check), &Check::name) == 1;
        EXPECT_TRUE(known || !fault.survives.empty()) << fault.name << ": there is no check '" << fault.check << "'";
    }
}

TEST(FullFaults, WhatTheyNeedDoesNotDisagreeByItself) {
    for (const Need& need : kNeeds) {
        VerifyConfig config = testConfig(true);
        const Ground setup = setUp(need.name);
        VerifyContext context(setup.scene, setup.options, config);
        for (const Check& check : verifyChecks()) {
            if (check.rung < Rung::Stages || check.name == "every feature") continue;
            Findings findings;
            check.run(context, findings);
            EXPECT_FALSE(findings.disagreement()) << need.name << ", " << check.name;
        }
    }
}

TEST(Faults, AreManyOnBothSidesAndChosenAfterTheFreezeToo) {
    const auto count = [](auto&& holds) { return std::ranges::count_if(allFaults(), holds); };
    EXPECT_GE(count([](const Fault& f) { return f.inShaders() && f.survives.empty(); }), 20);
    EXPECT_GE(count([](const Fault& f) { return !f.inShaders() && f.survives.empty(); }), 12);
    EXPECT_GE(count([](const Fault& f) { return f.chosen == "after" && f.survives.empty(); }), 8);
}

}  // namespace
}  // namespace vkpt
