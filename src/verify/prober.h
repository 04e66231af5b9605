// Runs shaders/probes/NAME.comp, with a scene on the device where the probe reads one.
#pragma once
#include <array>
#include <cstring>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "gpu/probe.h"
#include "gpu/spirv_source.h"
#include "scene/render_options.h"
#include "scene/scene_arrays.h"
#include "verify/findings.h"

namespace vkpt {

/// SPIR-V of shaders/probes/NAME.comp; empty where there is none. Generated.
std::span<const std::uint32_t> probeSpirv(std::string_view name);

/// Runs probes on one device; each is compiled once for each set of specialization constants.
class Prober {
public:
    explicit Prober(Device& device, SpirvSource spirv = probeSpirv) : device_(device), spirv_(std::move(spirv)) {}

    [[nodiscard]] Device& device() const { return device_; }
    [[nodiscard]] std::span<const std::uint32_t> spirv(std::string_view name) const { return spirv_(name); }

    /// One Out for each input.
    template <class Out, class In>
    [[nodiscard]] std::vector<Out> evaluate(const std::string& name, const std::vector<In>& inputs,
                                            const ProbeOptions& options = {}) {
        static_assert(sizeof(In) % 16 == 0 && sizeof(Out) % 16 == 0, "probes pass whole words");
        const auto bytes = runProbe(device_, kernel(name, options), std::as_bytes(std::span(inputs)),
                                    inputs.size() * sizeof(Out), static_cast<std::uint32_t>(inputs.size()), options);
        std::vector<Out> outputs(inputs.size());
        if (!bytes.empty()) std::memcpy(outputs.data(), bytes.data(), bytes.size());
        return outputs;
    }

private:
    const Kernel& kernel(const std::string& name, const ProbeOptions& options);

    Device& device_;
    SpirvSource spirv_;
    std::map<std::pair<std::string, std::vector<std::uint32_t>>, Kernel> kernels_;
};

enum class Fetch { Texel, Storage };
inline constexpr std::array kFetchForms = {Fetch::Texel, Fetch::Storage};

/// A scene as WavefrontRenderer uploads it, at bindings 2 (frame), 3 (storage words) and 4 (texels). The texel form
/// searches the list of triangles where there is one, the storage form walks the tree.
class ProbeScene {
public:
    /// `lastIndex`: the highest sample index that a probe may ask for.
    ProbeScene(Prober& prober, const SceneArrays& arrays, const RenderParams& params = {},
               SamplerChoice sampler = SamplerId::Random, std::uint32_t lastIndex = ~0U);

    [[nodiscard]] const SceneHeader& header() const { return header_; }
    /// Bindings and specialization for one fetch form; valid as long as this object.
    [[nodiscard]] ProbeOptions options(Fetch form) const;

    /// One Out for each input, through both fetch forms, which must agree to the bit: they are compared first.
    template <class Out, class In>
    [[nodiscard]] std::vector<Out> evaluate(Findings& findings, const std::string& name,
                                            const std::vector<In>& inputs) const {
        const auto texel = prober_.evaluate<Out>(name, inputs, options(Fetch::Texel));
        const auto storage = prober_.evaluate<Out>(name, inputs, options(Fetch::Storage));
        for (std::size_t i = 0; i < inputs.size(); ++i) {
            findings.at(i);
            findings.holds("both fetch forms", std::memcmp(&texel[i], &storage[i], sizeof(Out)) == 0,
                           "texel and storage buffers give different bits");
        }
        return texel;
    }

private:
    Prober& prober_;
    SceneFeatures features_;
    SamplerChoice sampler_;
    std::uint32_t lastIndex_, listTriangles_, stackEntries_;
    SceneHeader header_;
    Buffer frame_, scene_, dummy_;
    TexelView sceneTexels_, dummyTexels_;
};

}  // namespace vkpt
