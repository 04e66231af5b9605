#include "cli/options.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <CLI/CLI.hpp>

#include "cli/output_name.h"

namespace vkpt {
namespace {

struct Parsed {
    SceneOptions scene;
    SamplingOptions sampling;
    BackendOptions backend;
};

Parsed parse(const std::string& line) {
    Parsed parsed;
    CLI::App app;
    addSceneFile(app, parsed.scene, true);
    addSceneOptions(app, parsed.scene);
    addSamplingOptions(app, parsed.sampling);
    addBackend(app, parsed.backend);
    addDeviceOptions(app, parsed.backend);
    app.parse(line);
    return parsed;
}

TEST(Options, DefaultsAreTheDocumentedOnes) {
    const Parsed p = parse("a.glb");
    EXPECT_EQ(p.scene.file, "a.glb");
    EXPECT_FALSE(p.scene.size);
    EXPECT_EQ(p.sampling.spp, 64U);
    EXPECT_EQ(p.sampling.seed, 0U);
    EXPECT_EQ(p.sampling.sampler, SamplerId::Sobol);
    EXPECT_EQ(p.sampling.maxDepth, 8U);
    EXPECT_EQ(p.backend.backend, Backend::Vulkan);
}

TEST(Options, EverySamplerOfTheRegistryCanBeNamed) {
    for (const SamplerInfo& sampler : kSamplers)
        EXPECT_EQ(parse("a.glb --sampler " + std::string(sampler.name)).sampling.sampler, sampler.id);
}

TEST(Options, ArriveWhereTheyBelong) {
    const Parsed p = parse(
        "--eye -1.5,1,2 --target 0,0,-1 --fov 30 --env 1,2,3 --env-rotation -90 --env-strength 2 --size 8x4 "
        "--background transparent --spp 7 --seed 9 --samples 2:5 --max-depth 0 --rr off --rr-depth 1 a.glb "
        "--backend cpu --device llvm --fetch storage --nthreads 3 --validate --scene 1");
    EXPECT_EQ(p.scene.eye, glm::vec3(-1.5F, 1, 2));
    EXPECT_EQ(p.scene.target, glm::vec3(0, 0, -1));
    EXPECT_EQ(p.scene.fov, 30);
    EXPECT_EQ(p.scene.environment.color, glm::vec3(1, 2, 3));
    EXPECT_EQ(p.scene.envRotation, -90);
    EXPECT_EQ(p.scene.envStrength, 2);
    EXPECT_EQ(p.scene.size, glm::uvec2(8, 4));
    EXPECT_EQ(p.scene.background.mode, kBackgroundTransparent);
    EXPECT_EQ(p.scene.sceneIndex, 1);
    EXPECT_EQ(p.sampling.spp, 7U);
    EXPECT_EQ(p.sampling.seed, 9U);
    EXPECT_EQ(p.sampling.samples->begin, 2U);
    EXPECT_EQ(p.sampling.maxDepth, 0U);
    EXPECT_EQ(p.sampling.roulette.mode, kRouletteOff);
    EXPECT_EQ(p.sampling.rrDepth, 1U);
    EXPECT_EQ(p.backend.backend, Backend::Cpu);
    EXPECT_EQ(p.backend.device, "llvm");
    EXPECT_EQ(p.backend.fetch, WavefrontConfig::Fetch::Storage);
    EXPECT_EQ(p.backend.threads, 3U);
    EXPECT_TRUE(p.backend.validate);
}

TEST(Options, LightTransportIsPathTracingWithMisUnlessAsked) {
    const SamplingOptions defaults = parse("a.glb").sampling;
    EXPECT_EQ(defaults.integrator, IntegratorId::Path);
    EXPECT_EQ(defaults.strategy, Strategy::MisPower);
    EXPECT_EQ(defaults.beta, 2);
    EXPECT_EQ(defaults.hemisphere, Hemisphere::Bsdf);
    EXPECT_EQ(defaults.clampIndirect, 0);
    EXPECT_EQ(defaults.filter.id, kFilterBox);
    for (const IntegratorInfo& info : kIntegrators)
        EXPECT_EQ(parse("a.glb --integrator " + std::string(info.name)).sampling.integrator, info.id);
    for (const auto& strategy : kStrategies)
        EXPECT_EQ(parse("a.glb --strategy " + std::string(strategy.name)).sampling.strategy, strategy.id);
    for (const auto& hemisphere : kHemispheres)
        EXPECT_EQ(parse("a.glb --hemisphere " + std::string(hemisphere.name)).sampling.hemisphere, hemisphere.id);
    const SamplingOptions s = parse(
                                  "a.glb --beta 1.5 --bsdf-samples 3 --light-samples 0 --ao-distance 0.5 "
                                  "--clamp-indirect 8 --filter tent:2")
                                  .sampling;
    EXPECT_EQ(s.beta, 1.5F);
    EXPECT_EQ(s.bsdfSamples, 3U);
    EXPECT_EQ(s.lightSamples, 0U);
    EXPECT_EQ(s.aoDistance, 0.5F);
    EXPECT_EQ(s.clampIndirect, 8);
    EXPECT_EQ(s.filter.id, kFilterTent);
    EXPECT_EQ(s.filter.radius, 2);
}

TEST(Options, CameraHasAProjectionAndALens) {
    const SceneOptions s = parse("a.glb --projection orthographic --ymag 2 --aperture 0.1 --focus 3").scene;
    EXPECT_EQ(s.projection, Projection::Orthographic);
    EXPECT_EQ(s.ymag, 2);
    EXPECT_EQ(s.aperture, 0.1F);
    EXPECT_EQ(s.focus, 3);
    EXPECT_EQ(parse("a.glb --projection panorama").scene.projection, Projection::Panorama);
    EXPECT_FALSE(parse("a.glb").scene.projection);
}

TEST(Options, FaultsNameTheOptionAndWhatItTakes) {
    try {
        (void)parse("a.glb --size big");
        FAIL() << "no exception";
    } catch (const CLI::ParseError& error) {
        EXPECT_STREQ(error.what(), "--size: 'big' is not WxH");
    }
    for (const char* bad : {"--spp 0",
                            "--spp 1.5",
                            "--seed -1",
                            "--fov 180",
                            "--env-strength -1",
                            "--rr fixed:0",
                            "--sampler halton2",
                            "--backend gpu",
                            "--fetch ssbo",
                            "--nthreads 0",
                            "--env ''",
                            "--eye 1,1,1 --orbit 1,1,1",
                            "--camera 0 --eye 1,1,1",
                            "--camera 0 --target 1,1,1",
                            "--integrator bdpt",
                            "--strategy both",
                            "--beta -1",
                            "--hemisphere sphere",
                            "--bsdf-samples 1025",
                            "--ao-distance 0",
                            "--clamp-indirect -1",
                            "--filter sinc",
                            "--projection fisheye",
                            "--ymag 0",
                            "--aperture -1",
                            "--focus 0"})
        EXPECT_THROW((void)parse(std::string("a.glb ") + bad), CLI::ParseError) << bad;
}

TEST(DefaultOutput, IsTheStemOrTheFolderOfScenesWithoutAName) {
    EXPECT_EQ(defaultOutput("/models/Damaged Helmet.glb"), "Damaged Helmet.png");
    EXPECT_EQ(defaultOutput("scenes/cornell_box/scene.gltf"), "cornell_box.png");
    EXPECT_EQ(defaultOutput("/x/tree.v2/model.glb"), "tree.v2.png");
    EXPECT_EQ(defaultOutput("a.b.gltf"), "a.b.png");
    EXPECT_EQ(defaultOutput("/scene.gltf"), "scene.png") << "the root has no name";
    const std::string here = std::filesystem::current_path().filename().string();
    EXPECT_EQ(defaultOutput("scene.gltf"), here + ".png");
    EXPECT_EQ(defaultOutput("../" + here + "/./scene.gltf"), here + ".png");
}

}  // namespace
}  // namespace vkpt
