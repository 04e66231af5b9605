#include "gpu/probe.h"

#include "gpu/device.h"
#include "gpu/recorder.h"
#include "gpu/transfer.h"

namespace vkpt {

Kernel makeProbeKernel(Device& device, std::span<const std::uint32_t> spirv, std::string_view name,
                       const ProbeOptions& options) {
    std::vector<BindingKind> kinds{BindingKind::StorageBuffer, BindingKind::StorageBuffer};
    kinds.insert(kinds.end(), options.extraKinds.begin(), options.extraKinds.end());
    const std::size_t pushBytes = (1 + options.push.size()) * sizeof(std::uint32_t);
    return {device, spirv, kinds, pushBytes, options.specialization, name};
}

std::vector<std::byte> runProbe(Device& device, const Kernel& kernel, std::span<const std::byte> input,
                                std::size_t outputBytes, std::uint32_t count, const ProbeOptions& options) {
    std::vector<std::uint32_t> push{count};
    push.insert(push.end(), options.push.begin(), options.push.end());
    const Buffer in = makeStorage(device, input, "probe input");
    const Buffer out(device, BufferUse::Storage, (outputBytes + 3) / 4 * 4, "probe output");
    std::vector<Binding> bindings{in, out};
    bindings.insert(bindings.end(), options.extra.begin(), options.extra.end());
    const BindGroup group(device, kernel, bindings);

    Recorder recorder(device);
    recorder.begin();
    recorder.fill(out, 0, out.size(), 0);
    recorder.barrier();
    recorder.dispatchBytes(kernel, group, std::as_bytes(std::span(push)),
                           (count + kProbeGroupSize - 1) / kProbeGroupSize);
    recorder.submitAndWait();
    return readStorage<std::byte>(device, out, 0, outputBytes);
}

std::vector<std::byte> runProbe(Device& device, std::span<const std::uint32_t> spirv, std::string_view name,
                                std::span<const std::byte> input, std::size_t outputBytes, std::uint32_t count,
                                const ProbeOptions& options) {
    return runProbe(device, makeProbeKernel(device, spirv, name, options), input, outputBytes, count, options);
}

}  // namespace vkpt
