#include "gpu/transfer.h"

#include <algorithm>
#include <cassert>
#include <cstring>

#include "gpu/device.h"
#include "gpu/recorder.h"

namespace vkpt {

namespace {

constexpr std::size_t kChunk = std::size_t{16} << 20U;

}  // namespace

void uploadBuffer(Device& device, const Buffer& to, std::size_t offset, std::span<const std::byte> data,
                  TransferPath path) {
    assert(offset + data.size() <= to.size());
    if (data.empty()) return;
    if (path == TransferPath::Automatic && to.isMappable()) {
        std::memcpy(to.map().data() + offset, data.data(), data.size());
        return;
    }
    const Buffer staging(device, BufferUse::Upload, std::min(kChunk, data.size()), "upload staging");
    Recorder recorder(device);
    for (std::size_t done = 0; done < data.size(); done += kChunk) {
        const std::size_t bytes = std::min(kChunk, data.size() - done);
        std::memcpy(staging.map().data(), data.data() + done, bytes);
        recorder.begin();
        recorder.copy(staging, 0, to, offset + done, bytes);
        recorder.submitAndWait();
    }
}

void downloadBuffer(Device& device, const Buffer& from, std::size_t offset, std::span<std::byte> data,
                    TransferPath path) {
    assert(offset + data.size() <= from.size());
    if (data.empty()) return;
    if (path == TransferPath::Automatic && from.isMappable()) {
        std::memcpy(data.data(), from.map().data() + offset, data.size());
        return;
    }
    const Buffer staging(device, BufferUse::Readback, std::min(kChunk, data.size()), "download staging");
    Recorder recorder(device);
    for (std::size_t done = 0; done < data.size(); done += kChunk) {
        const std::size_t bytes = std::min(kChunk, data.size() - done);
        recorder.begin();
        recorder.copy(from, offset + done, staging, 0, bytes);
        recorder.submitAndWait();
        std::memcpy(data.data() + done, staging.map().data(), bytes);
    }
}

}  // namespace vkpt
