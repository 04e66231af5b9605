// vkpt info: what a scene file holds, and what vkpt makes of it.
#include "scene/info.h"

#include <iostream>
#include <memory>

#include "base/json.h"
#include "bvh/build.h"
#include "cli/command.h"
#include "cli/options.h"
#include "gltf/import.h"
#include "scene/flatten.h"

namespace vkpt {
namespace {

struct InfoCommand {
    SceneOptions scene;
    bool json = false;
};

ExitCode runInfo(const InfoCommand& c) {
    setUpLog(Verbosity::Quiet);
    const Scene scene = importGltf(c.scene.file, {c.scene.sceneIndex, c.scene.allowExternal});
    SceneArrays arrays = flatten(scene);
    buildBvh(arrays);
    const Json info = sceneInfo(scene, arrays);
    std::cout << (c.json ? jsonText(info) : sceneInfoText(info));
    return ExitCode::Ok;
}

std::function<ExitCode()> setUpInfo(CLI::App& app) {
    const auto command = std::make_shared<InfoCommand>();
    addSceneFile(app, command->scene, true);
    app.add_flag("--json", command->json, "as JSON");
    return [command] { return runInfo(*command); };
}

}  // namespace

const Command kInfoCommand{"info", "what a scene file holds and what vkpt makes of it", "vkpt info Duck.glb --json",
                           setUpInfo};

}  // namespace vkpt
