#include "cli/scene_setup.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "base/version.h"
#include "cli/metadata.h"
#include "cli/run_vkpt.h"

namespace vkpt {
namespace {

class SceneSetup : public testing::Test {
protected:
    SceneSetup() {
        scene_.file = folder_.write("t.gltf", triangleGltf());
        folder_.write("buffer.bin", triangleBuffer());
        scene_.size = {8, 8};
        setUpLog(Verbosity::Quiet);
    }
    [[nodiscard]] PreparedScene prepare() const { return prepareScene(scene_, sampling_); }
    [[nodiscard]] std::string hash() const { return settingsHash(renderSettings(prepare())); }
    void expectUsageError(const char* option) const {
        try {
            (void)prepare();
            ADD_FAILURE() << "no exception";
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ExitCode::Usage);
            EXPECT_THAT(error.what(), testing::HasSubstr(option));
        }
    }

    TemporaryFolder folder_;
    SceneOptions scene_;
    SamplingOptions sampling_;
};

TEST_F(SceneSetup, SceneWithoutLightGetsTheStudio) {
    const PreparedScene p = prepare();
    EXPECT_EQ(p.environment, "studio");
    EXPECT_TRUE(p.arrays.features.environment);
    EXPECT_FALSE(p.arrays.nodes.empty());
}

TEST_F(SceneSetup, NoneIsNone) {
    scene_.environment = *parseEnvironment("none");
    EXPECT_EQ(prepare().environment, "none");
    EXPECT_FALSE(prepare().arrays.features.environment);
}

TEST_F(SceneSetup, SizeFollowsTheCameraOfTheFile) {
    scene_.size.reset();
    EXPECT_EQ(prepare().options.params.width, 960U);
    EXPECT_EQ(prepare().options.params.height, 540U);
    scene_.file = VKPT_SCENES "/cornell_box/scene.gltf";  // its camera states an aspect ratio of 1
    EXPECT_EQ(prepare().options.params.width, 540U);
    EXPECT_EQ(prepare().options.params.height, 540U);
    scene_.eye = glm::vec3(0, 1, 3);
    EXPECT_EQ(prepare().options.params.width, 960U);
}

TEST_F(SceneSetup, EyeWithoutTargetLooksAtTheMiddle) {
    scene_.eye = glm::vec3(0.5F, 0.5F, 4);
    const RenderParams params = prepare().options.params;
    EXPECT_EQ(params.eye, glm::vec3(0.5F, 0.5F, 4));
    EXPECT_NEAR(params.forward.z, -1, 1e-6);
}

TEST_F(SceneSetup, SamplesKeepTheWholeCount) {
    sampling_.spp = 32;
    sampling_.samples = SampleRange{8, 16};
    const RenderOptions options = prepare().options;
    EXPECT_EQ(options.params.spp, 32U);
    EXPECT_EQ(options.sampleBegin, 8U);
    EXPECT_EQ(options.sampleEnd, 16U);
}

TEST_F(SceneSetup, ContradictionsAreUsageErrors) {
    sampling_.samples = SampleRange{64, 128};
    expectUsageError("--samples");
    sampling_.samples.reset();
    scene_.target = glm::vec3(0);
    expectUsageError("--target");
}

TEST_F(SceneSetup, LensAndProjectionReachTheCamera) {
    scene_.eye = glm::vec3(0.5F, 0.5F, 4);
    scene_.target = glm::vec3(0.5F, 0.5F, 1);
    scene_.fov = 90;
    scene_.aperture = 0.25F;
    EXPECT_EQ(prepare().options.params.lensRadius, 0.25F);
    EXPECT_NEAR(prepare().options.params.focusDistance, 3, 1e-5) << "the target is sharp";
    scene_.focus = 7;
    EXPECT_EQ(prepare().options.params.focusDistance, 7);
    scene_.projection = Projection::Orthographic;
    EXPECT_EQ(prepare().options.params.projection, kProjectionOrthographic);
    EXPECT_NEAR(glm::length(prepare().options.params.up), 3, 1e-5) << "as wide as the view at the target";
    scene_.ymag = 1.5F;
    EXPECT_NEAR(glm::length(prepare().options.params.up), 1.5, 1e-5);
}

TEST_F(SceneSetup, CamerasThatCannotBeAreUsageErrors) {
    scene_.ymag = 1.5F;
    expectUsageError("--ymag");
    scene_.ymag.reset();
    scene_.projection = Projection::Panorama;
    scene_.aperture = 1;
    expectUsageError("--aperture");
}

TEST_F(SceneSetup, FovIsOfThePerspectiveThatIsAskedForWhateverTheFilesCamera) {
    scene_.file = VKPT_SCENES "/orthographic/scene.gltf";
    scene_.fov = 90;
    expectUsageError("--fov");
    scene_.projection = Projection::Perspective;
    const RenderParams params = prepare().options.params;
    EXPECT_EQ(params.projection, kProjectionPerspective);
    EXPECT_NEAR(glm::length(params.up), 1, 1e-5) << "tan 45 degrees";
    EXPECT_NEAR(glm::length(params.right), 1, 1e-5) << "8x8 pixels";
}

TEST_F(SceneSetup, DirectLightNeedsSamples) {
    sampling_.integrator = IntegratorId::Direct;
    EXPECT_EQ(pathDepth(prepare().options.params), 1U);
    sampling_.bsdfSamples = sampling_.lightSamples = 0;
    expectUsageError("--bsdf-samples");
    sampling_.lightSamples = 1;
    sampling_.strategy = Strategy::Bsdf;
    expectUsageError("--strategy bsdf");
    sampling_.strategy = Strategy::Light;
    EXPECT_EQ(prepare().options.params.bsdfSamples, 0U);
    std::swap(sampling_.bsdfSamples, sampling_.lightSamples);
    expectUsageError("--strategy light");
}

TEST_F(SceneSetup, VarianceNeedsAFilterWithoutLobesBelowZero) {
    sampling_.aovs.add(Aov::Variance);
    sampling_.filter = *parseFilter("gaussian");
    EXPECT_EQ(prepare().options.params.filterRadius, 1.5F);
    sampling_.filter = *parseFilter("mitchell");
    expectUsageError("--aov");
}

TEST_F(SceneSetup, MissingEnvironmentIsAFileError) {
    scene_.environment = *parseEnvironment("absent.hdr");
    EXPECT_THROW((void)prepare(), FileError);
}

TEST_F(SceneSetup, SettingsHashFollowsWhatAltersTheImage) {
    const std::string before = hash();
    EXPECT_EQ(before, hash());
    sampling_.samples = SampleRange{1, 2};
    EXPECT_EQ(hash(), before) << "ranges of one render share their settings";
    sampling_.samples.reset();

    sampling_.seed = 1;
    EXPECT_NE(hash(), before);
    sampling_.seed = 0;
    sampling_.maxDepth = 2;
    EXPECT_NE(hash(), before);
    sampling_.maxDepth = 8;
    scene_.envStrength = 2;
    EXPECT_NE(hash(), before);
    scene_.envStrength = 1;
    scene_.fov = 20;
    EXPECT_NE(hash(), before);
    scene_.fov.reset();
    EXPECT_EQ(hash(), before);
    const auto expectAlters = [&](auto& option, auto value) {
        const auto kept = option;
        option = value;
        EXPECT_NE(hash(), before);
        option = kept;
    };
    expectAlters(sampling_.integrator, IntegratorId::Ao);
    expectAlters(sampling_.strategy, Strategy::Light);
    expectAlters(sampling_.hemisphere, Hemisphere::Uniform);
    expectAlters(sampling_.beta, 3.0F);
    expectAlters(sampling_.clampIndirect, 1.0F);
    expectAlters(sampling_.filter.radius, 1.0F);
    expectAlters(scene_.aperture, 1.0F);
    EXPECT_EQ(hash(), before);
}

TEST_F(SceneSetup, SettingsHashFollowsTheFilesOfTheScene) {
    scene_.eye = glm::vec3(0, 0, 4);  // framing would follow the change by itself
    scene_.target = glm::vec3(0);
    const std::string before = hash();
    folder_.write("buffer.bin", triangleBuffer(0.5F));
    EXPECT_NE(hash(), before);
    folder_.write("buffer.bin", triangleBuffer());
    EXPECT_EQ(hash(), before);
    folder_.write("t.gltf", triangleGltf() + " ");
    EXPECT_EQ(hash(), before) << "what the file says is hashed, not how";
}

TEST_F(SceneSetup, MetadataTellsTheWholeStory) {
    sampling_.clampIndirect = 8;
    Film film(8, 8);
    film.ranges = {{4, 6}};
    FilmRecord record{Film(8, 8), renderSettings(prepare()), {}};
    addSamples(record, film, "cpu", "CPU reference", "");
    const ImageMetadata metadata = imageMetadata(record);
    const auto value = [&](std::string_view key) {
        for (const auto& [k, v] : metadata)
            if (k == key) return v;
        return std::string("absent");
    };
    EXPECT_EQ(value("software"), kSoftware);
    EXPECT_EQ(value("vkpt:version"), kVersion);
    EXPECT_EQ(value("vkpt:scene"), "t.gltf");
    EXPECT_EQ(value("vkpt:spp"), "2");
    EXPECT_EQ(value("vkpt:samples"), "4:6");
    EXPECT_EQ(value("vkpt:seed"), "0");
    EXPECT_EQ(value("vkpt:sampler"), "sobol");
    EXPECT_EQ(value("vkpt:settingsHash"), hash());
    EXPECT_EQ(value("vkpt:backend"), "cpu");
    EXPECT_EQ(value("vkpt:device"), "CPU reference");
    EXPECT_EQ(Json::parse(value("vkpt:settings")).at("env"), "studio");
    EXPECT_EQ(Json::parse(value("vkpt:settings")).at("clampIndirect"), "8");
}

TEST(Version, IsTheProjectsOwn) {
    EXPECT_THAT(readText(VKPT_SOURCE "/CMakeLists.txt"),
                testing::HasSubstr("project(vkpt VERSION " + std::string(kVersion) + " "));
}

}  // namespace
}  // namespace vkpt
