// Compiled kernels kept between runs, one file a device and driver.
#pragma once
#include <filesystem>

#include "gpu/vulkan.h"

namespace vkpt {

class Device;

/// Owns the VkPipelineCache that all kernels of a device share. Read from, and at destruction written to,
/// $XDG_CACHE_HOME/vkpt (else ~/.cache/vkpt). A damaged or foreign file is ignored; a failure to write is only logged.
class PipelineCache {
public:
    explicit PipelineCache(Device& device);
    ~PipelineCache();
    PipelineCache(const PipelineCache&) = delete;
    PipelineCache& operator=(const PipelineCache&) = delete;

    [[nodiscard]] VkPipelineCache handle() const { return cache_.get(); }
    /// Call after a pipeline was made: there may be something new to keep.
    void touch() { touched_ = true; }
    /// Empty where no cache folder can be told from the environment.
    [[nodiscard]] const std::filesystem::path& file() const { return file_; }

private:
    void save() const;

    Device& device_;
    std::filesystem::path file_;
    Owned<VkPipelineCache, &vkDestroyPipelineCache> cache_;
    std::size_t loadedBytes_ = 0;
    bool touched_ = false;
};

}  // namespace vkpt
