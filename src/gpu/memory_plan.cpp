#include "gpu/memory_plan.h"

#include <fmt/format.h>

#include <numeric>

#include "base/error.h"

namespace vkpt {

namespace {

double mebibytes(std::uint64_t bytes) { return static_cast<double>(bytes) / (1 << 20); }

}  // namespace

void MemoryPlan::add(std::string name, std::uint64_t bytes, bool boundAsStorage) {
    items_.push_back({std::move(name), bytes, boundAsStorage});
}

std::uint64_t MemoryPlan::totalBytes() const {
    return std::accumulate(items_.begin(), items_.end(), std::uint64_t{0},
                           [](std::uint64_t sum, const Item& item) { return sum + item.bytes; });
}

void MemoryPlan::check(const DeviceInfo& device) const {
    for (const Item& item : items_) {
        const bool tooLong = item.boundAsStorage && item.bytes > device.limits.maxStorageBufferRange;
        const std::uint64_t most =
            tooLong ? device.limits.maxStorageBufferRange : device.limits.maxMemoryAllocationSize;
        if (item.bytes > most)
            throw DeviceError(fmt::format("{} needs {:.1f} MiB; device '{}' takes {:.1f} MiB in one {}", item.name,
                                          mebibytes(item.bytes), device.name, mebibytes(most),
                                          tooLong ? "storage buffer" : "allocation"));
    }
    if (totalBytes() > device.heapBytes)
        throw DeviceError(fmt::format("{:.1f} MiB of device memory are needed; device '{}' has {:.1f} MiB",
                                      mebibytes(totalBytes()), device.name, mebibytes(device.heapBytes)));
}

std::string MemoryPlan::describe() const {
    std::string text;
    for (const Item& item : items_) text += fmt::format("{:<24}{:>10.1f} MiB\n", item.name, mebibytes(item.bytes));
    return text + fmt::format("{:<24}{:>10.1f} MiB", "device memory", mebibytes(totalBytes()));
}

}  // namespace vkpt
