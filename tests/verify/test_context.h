// What the tests of src/verify work on: a small scene in memory with every feature, on the device of VKPT_TEST_DEVICE.
#pragma once
#include <cstdlib>

#include "verify/context.h"
#include "verify/inputs/scenes.h"

namespace vkpt {

[[nodiscard]] inline const SceneArrays& everyFeature() {
    static const SceneArrays scene = makeEverything();
    return scene;
}

[[nodiscard]] inline const RenderOptions& smallOptions() {
    static const RenderOptions options = makeOptions(48, 32, 2);
    return options;
}

[[nodiscard]] inline VerifyConfig testConfig(bool validation) {
    VerifyConfig config;
    config.wavefront.device = getenv("VKPT_TEST_DEVICE") ? getenv("VKPT_TEST_DEVICE") : "";
    config.wavefront.validation = validation;
    return config;
}

}  // namespace vkpt
