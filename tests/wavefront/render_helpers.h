// Renders small films for tests, with the validation layers on.
#pragma once
#include <gtest/gtest.h>

#include <functional>

#include "verify/inputs/scenes.h"
#include "wavefront/renderer.h"

namespace vkpt {

/// The device of VKPT_TEST_DEVICE, with validation.
[[nodiscard]] WavefrontConfig makeConfig();

/// Renders; fails the test where the validation layers speak or a contribution is refused.
[[nodiscard]] Film renderWith(const SceneArrays& arrays, const RenderOptions& options,
                              const WavefrontConfig& config = makeConfig(), WavefrontStats* stats = nullptr,
                              const RenderControl& control = {});

/// Makes a renderer for films of many seeds (a test::Renderer); each fails the test as those of renderWith do.
[[nodiscard]] std::function<Film(std::uint32_t seed)> onDevice(const SceneArrays& arrays, const RenderOptions& options);

/// Equal to the bit, samples included.
[[nodiscard]] bool isSame(const Film& a, const Film& b);

/// Share of pixels of which a channel differs by more than 1e-3, relative.
[[nodiscard]] double divergedShare(const Film& a, const Film& b);

}  // namespace vkpt
