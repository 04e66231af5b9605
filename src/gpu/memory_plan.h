// What a job will allocate, known and refused before the first allocation.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "gpu/device_info.h"

namespace vkpt {

/// A list of the buffers a job needs.
class MemoryPlan {
public:
    /// `boundAsStorage`: a kernel binds the whole of it as one storage buffer.
    void add(std::string name, std::uint64_t bytes, bool boundAsStorage = true);
    [[nodiscard]] std::uint64_t totalBytes() const;
    /// Throws DeviceError, one line, where a buffer exceeds a limit of the device or the sum exceeds its memory.
    void check(const DeviceInfo& device) const;
    /// A line a buffer and a sum, for --verbose.
    [[nodiscard]] std::string describe() const;

private:
    struct Item {
        std::string name;
        std::uint64_t bytes;
        bool boundAsStorage;
    };
    std::vector<Item> items_;
};

}  // namespace vkpt
