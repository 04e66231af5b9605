// Runs shaders/probes/NAME.comp, with a scene on the device where the probe reads one.
#pragma once
#include <array>
#include <cstring>
#include <string>
#include <vector>

#include "gpu/probe.h"
#include "scene/render_options.h"
#include "scene/scene_arrays.h"
#include "test_device.h"

namespace vkpt {

std::span<const std::uint32_t> probeSpirv(std::string_view name);

/// One Out for each input of a probe without a scene.
template <class Out, class In>
[[nodiscard]] std::vector<Out> evaluate(std::string_view name, const std::vector<In>& inputs,
                                        const ProbeOptions& options = {}) {
    static_assert(sizeof(In) % 16 == 0 && sizeof(Out) % 16 == 0, "probes pass whole words");
    return probe<Out>(testDevice(), probeSpirv(name), name, inputs, 1, options);
}

enum class Fetch { Texel, Storage };
inline constexpr std::array kFetchForms = {Fetch::Texel, Fetch::Storage};
[[nodiscard]] inline std::string nameOf(Fetch form) { return form == Fetch::Texel ? "texel" : "storage"; }

/// A scene as WavefrontRenderer would upload it, at bindings 2 (frame), 3 (storage words) and 4 (texels).
class ProbeScene {
public:
    explicit ProbeScene(const SceneArrays& arrays, const RenderParams& params = {});

    [[nodiscard]] const SceneHeader& header() const { return header_; }
    /// Bindings and specialization for one fetch form; valid as long as this object.
    [[nodiscard]] ProbeOptions options(Fetch form, SamplerId sampler = SamplerId::Random) const;

    /// One Out for each input, through both fetch forms, which must agree to the bit.
    template <class Out, class In>
    [[nodiscard]] std::vector<Out> evaluate(std::string_view name, const std::vector<In>& inputs,
                                            SamplerId sampler = SamplerId::Random) const {
        const auto texel = vkpt::evaluate<Out>(name, inputs, options(Fetch::Texel, sampler));
        const auto storage = vkpt::evaluate<Out>(name, inputs, options(Fetch::Storage, sampler));
        EXPECT_EQ(std::memcmp(texel.data(), storage.data(), texel.size() * sizeof(Out)), 0)
            << name << ": the texel and the storage form differ";
        return texel;
    }

private:
    SceneFeatures features_;
    SceneHeader header_;
    Buffer frame_, scene_, dummy_;
    TexelView sceneTexels_, dummyTexels_;
};

}  // namespace vkpt
