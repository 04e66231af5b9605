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
}

TEST(Version, IsTheProjectsOwn) {
    EXPECT_THAT(readText(VKPT_SOURCE "/CMakeLists.txt"),
                testing::HasSubstr("project(vkpt VERSION " + std::string(kVersion) + " "));
}

}  // namespace
}  // namespace vkpt
