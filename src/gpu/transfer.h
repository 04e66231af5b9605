// Moves arrays between host and device.
#pragma once
#include <span>
#include <vector>

#include "gpu/buffer.h"

namespace vkpt {

/// How bytes travel. Automatic: straight into memory the host can map, else through a staging buffer.
enum class TransferPath { Automatic, Staged };

/// Writes `data` at `offset` and waits. Staging takes at most 16 MiB, whatever the size. `offset` and the size of
/// `data` may be anything within the buffer.
void uploadBuffer(Device& device, const Buffer& to, std::size_t offset, std::span<const std::byte> data,
                  TransferPath path = TransferPath::Automatic);

/// Reads into `data` and waits.
void downloadBuffer(Device& device, const Buffer& from, std::size_t offset, std::span<std::byte> data,
                    TransferPath path = TransferPath::Automatic);

/// A storage buffer filled with an array (a whole dummy word where it is empty).
template <class T>
[[nodiscard]] Buffer makeStorage(Device& device, std::span<const T> data, std::string_view name) {
    Buffer buffer(device, BufferUse::Storage, data.size_bytes(), name);
    uploadBuffer(device, buffer, 0, std::as_bytes(data));
    return buffer;
}

/// `count` values of T that start at byte `offset`.
template <class T>
[[nodiscard]] std::vector<T> readStorage(Device& device, const Buffer& from, std::size_t offset, std::size_t count) {
    std::vector<T> values(count);
    downloadBuffer(device, from, offset, std::as_writable_bytes(std::span(values)));
    return values;
}

}  // namespace vkpt
