#include "scene_files.h"

#include <gtest/gtest.h>
#include <spdlog/spdlog.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace vkpt {

std::vector<std::string> sceneNames() {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(VKPT_SCENES))
        if (std::filesystem::exists(entry.path() / "scene.gltf")) names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

Json expectations(const std::string& scene) {
    return Json::parse(std::ifstream(std::filesystem::path(VKPT_SCENES) / scene / "expect.json"));
}

PreparedScene prepare(const std::string& scene, std::vector<std::string> options) {
    spdlog::set_level(spdlog::level::err);
    SceneOptions sceneOptions;
    SamplingOptions sampling;
    CLI::App app;
    addSceneFile(app, sceneOptions, false);
    addSceneOptions(app, sceneOptions);
    addSamplingOptions(app, sampling);
    std::reverse(options.begin(), options.end());  // CLI11 takes a vector from its back
    app.parse(options);
    sceneOptions.file = std::filesystem::path(VKPT_SCENES) / scene / "scene.gltf";
    return prepareScene(sceneOptions, sampling);
}

Image renderSeed(const PreparedScene& prepared, Backend backend, std::uint32_t seed, std::uint32_t times) {
    RenderOptions options = prepared.options;
    options.params.seed = seed;
    options.params.spp *= times;
    options.sampleEnd *= times;
    BackendOptions choice;
    choice.backend = backend;
    choice.validate = true;
    RenderReport report;
    const Film film = makeRenderer(prepared.arrays, options, choice, false)
                          ->render({options.sampleBegin, options.sampleEnd}, {}, report);
    EXPECT_EQ(report.validationMessages, 0U);
    EXPECT_EQ(film.refused, 0U);
    return filmToImage(film);
}

}  // namespace vkpt
