// src/wavefront/layout.h says the same as shaders/kernels/state.glsl: push constants, state arrays, counters, queues.
#include <cstring>

#include "gpu/recorder.h"
#include "gpu/transfer.h"
#include "verify/context.h"
#include "verify/probes.h"
#include "wavefront/kernels.h"
#include "wavefront/layout.h"
#include "wavefront/scene_upload.h"

namespace vkpt {
namespace {

constexpr std::uint32_t kBounces = 3, kSlots = 40, kWidth = 10;
constexpr BatchParams kBatch{11, 12, 13, 14, 5, 40, 17, 18, 19, 20, reciprocalOf(14), reciprocalOf(kWidth)};

struct Read {
    std::vector<std::uint32_t> outputs;
    std::vector<uvec4> state;
};

Read runStateProbe(Prober& prober) {
    Device& device = prober.device();
    const Kernel kernel(device, prober.spirv("state"), kKernelBindings, sizeof(BatchParams), {}, "state");
    const Buffer frame(device, BufferUse::Uniform, sizeof(Frame), "frame");
    RenderParams params{};
    params.width = kWidth;
    std::memcpy(frame.map().data() + offsetof(Frame, params), &params, sizeof params);
    const std::vector<uvec4> empty(std::size_t{kStateArrays} * kBatch.capacity);
    const Buffer state = makeStorage<uvec4>(device, empty, "state"), words = makeStorage<uvec4>(device, empty, "words"),
                 outputs = makeStorage<uvec4>(device, empty, "outputs");
    const TexelView texels(device, words, VK_FORMAT_R32G32B32A32_UINT, 0, words.size());
    const std::array<Binding, 7> bindings = {frame, words, texels, state, words, outputs, texels};
    const BindGroup group(device, kernel, bindings);
    Recorder recorder(device);
    recorder.begin();
    recorder.dispatch(kernel, group, kBatch, 1);
    recorder.submitAndWait();
    return {readStorage<std::uint32_t>(device, outputs, 0, 14 + kBounces * kQueues * 2 + 2 * kSlots),
            readStorage<uvec4>(device, state, 0, empty.size())};
}

std::vector<std::pair<std::string, std::size_t>> expectedOutputs() {
    const BatchParams& b = kBatch;
    std::vector<std::pair<std::string, std::size_t>> list = {
        {"firstPixel", b.firstPixel},
        {"pixelCount", b.pixelCount},
        {"firstSample", b.firstSample},
        {"sampleCount", b.sampleCount},
        {"bounce", b.bounce},
        {"capacity", b.capacity},
        {"pathCount", b.pathCount},
        {"filmFirst", b.filmFirst},
        {"filmLayers", b.filmLayers},
        {"round", b.round},
        {"sampleReciprocal", b.sampleReciprocal},
        {"widthReciprocal", b.widthReciprocal},
        {"counter of refusals", kRefusedCounter},
        {"counter of refusals in layers", kRefusedInLayersCounter}};
    for (std::uint32_t bounce = 0; bounce < kBounces; ++bounce)
        for (std::uint32_t q = 0; q < kQueues; ++q) {
            const auto queue = static_cast<Queue>(q);
            list.emplace_back(fmt::format("counter of queue {}, bounce {}", q, bounce),
                              queueCounterOffset(bounce, queue) / 4);
            list.emplace_back(fmt::format("array of queue {}, bounce {}", q, bounce),
                              queueArrayOffset(bounce, queue, b.capacity));
        }
    for (std::uint32_t slot = 0; slot < kSlots; ++slot) {
        const SlotPlace place = placeOfSlot(b, slot);
        list.emplace_back(fmt::format("pixel of slot {}", slot), place.pixel % kWidth | (place.pixel / kWidth) << 16U);
        list.emplace_back(fmt::format("sample of slot {}", slot), place.sample);
    }
    return list;
}

}  // namespace

void checkState(VerifyContext& context, Findings& findings) {
    const Read read = runStateProbe(context.prober());
    const auto expected = expectedOutputs();
    {
        const auto scope = findings.inputs([&](std::size_t i) { return expected[i].first; });
        for (std::size_t i = 0; i < expected.size(); ++i) {
            findings.at(i);
            findings.equal("batch and queues", read.outputs[i], expected[i].second);
        }
    }
    const auto scope = findings.inputs([](std::size_t word) { return fmt::format("word {} of the state", word); });
    for (std::uint32_t word = 0; word < read.state.size(); ++word) {
        findings.at(word);
        const std::uint32_t array = word / kBatch.capacity, slot = word % kBatch.capacity;
        const uvec4 mark(100 + array, 200 + array, 300 + array, 400 + array);
        findings.equal("state arrays", read.state[word], slot == kBatch.bounce ? mark : uvec4(0));
    }
}

}  // namespace vkpt
