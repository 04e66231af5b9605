#include "gpu/probe.h"

#include "gpu/device.h"
#include "gpu/recorder.h"
#include "gpu/transfer.h"

namespace vkpt {

std::vector<std::byte> runProbe(Device& device, std::span<const std::uint32_t> spirv, std::string_view name,
                                std::span<const std::byte> input, std::size_t outputBytes, std::uint32_t count,
                                const ProbeOptions& options) {
    std::vector<BindingKind> kinds{BindingKind::StorageBuffer, BindingKind::StorageBuffer};
    kinds.insert(kinds.end(), options.extraKinds.begin(), options.extraKinds.end());
    std::vector<std::uint32_t> push{count};
    push.insert(push.end(), options.push.begin(), options.push.end());
    const std::span<const std::byte> pushBytes = std::as_bytes(std::span(push));
    const Kernel kernel(device, spirv, kinds, pushBytes.size(), options.specialization, name);

    const Buffer in = makeStorage(device, input, "probe input");
    const Buffer out(device, BufferUse::Storage, (outputBytes + 3) / 4 * 4, "probe output");
    std::vector<Binding> bindings{in, out};
    bindings.insert(bindings.end(), options.extra.begin(), options.extra.end());
    const BindGroup group(device, kernel, bindings);

    Recorder recorder(device);
    recorder.begin();
    recorder.fill(out, 0, out.size(), 0);
    recorder.barrier();
    recorder.dispatchBytes(kernel, group, pushBytes, (count + kProbeGroupSize - 1) / kProbeGroupSize);
    recorder.submitAndWait();
    return readStorage<std::byte>(device, out, 0, outputBytes);
}

}  // namespace vkpt
