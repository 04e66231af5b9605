#include "gpu/pipeline_cache.h"

#include <fmt/format.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <vector>

#include "gpu/device.h"

namespace vkpt {

namespace {

namespace fs = std::filesystem;

/// Precedes the driver's data in the file, so that a truncated or damaged file never reaches the driver.
struct FileHeader {
    std::array<char, 8> magic{'v', 'k', 'p', 't', 'p', 'c', '0', '1'};
    std::uint64_t bytes = 0, hash = 0;
};
constexpr std::uint64_t kLargestFile = 256U << 20U;

/// FNV-1a, 64 bits.
std::uint64_t hashOf(const std::vector<char>& data) {
    std::uint64_t hash = 0xcbf29ce484222325U;
    for (const char c : data) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
    return hash;
}

fs::path cacheFolder() {
    const auto variable = [](const char* name) {
        const char* value = std::getenv(name);
        return fs::path(value ? value : "");
    };
    if (const fs::path xdg = variable("XDG_CACHE_HOME"); xdg.is_absolute()) return xdg / "vkpt";
    if (const fs::path home = variable("HOME"); home.is_absolute()) return home / ".cache" / "vkpt";
    return {};
}

std::string fileName(VkPhysicalDevice device) {
    VkPhysicalDeviceProperties properties;
    vkGetPhysicalDeviceProperties(device, &properties);
    std::string uuid;
    for (const std::uint8_t byte : properties.pipelineCacheUUID) uuid += fmt::format("{:02x}", byte);
    return fmt::format("pipelines-{:x}-{:x}-{:x}-{}.bin", properties.vendorID, properties.deviceID,
                       properties.driverVersion, uuid);
}

/// Empty where there is no whole file.
std::vector<char> load(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    FileHeader header;
    const FileHeader expected;
    if (!in.read(reinterpret_cast<char*>(&header), sizeof header)) return {};
    if (header.magic != expected.magic || header.bytes > kLargestFile) return {};
    std::vector<char> data(header.bytes);
    if (!in.read(data.data(), static_cast<std::streamsize>(data.size())) || hashOf(data) != header.hash) {
        spdlog::debug(fmt::format("ignoring damaged pipeline cache {}", file.string()));
        return {};
    }
    return data;
}

/// Writes beside the target and renames, so that readers see the old file or the new one.
bool replace(const fs::path& file, const std::vector<char>& data) {
    std::error_code error;
    fs::create_directories(file.parent_path(), error);
    const fs::path partial = fmt::format("{}.{}", file.string(), getpid());
    FileHeader header;
    header.bytes = data.size();
    header.hash = hashOf(data);
    {
        std::ofstream out(partial, std::ios::binary);
        out.write(reinterpret_cast<const char*>(&header), sizeof header);
        out.write(data.data(), static_cast<std::streamsize>(data.size()));
        if (!out.flush()) error = std::make_error_code(std::errc::io_error);
    }
    if (!error) fs::rename(partial, file, error);
    if (!error) return true;
    std::error_code ignored;
    fs::remove(partial, ignored);
    return false;
}

}  // namespace

PipelineCache::PipelineCache(Device& device) : device_(device) {
    if (const fs::path folder = cacheFolder(); !folder.empty()) file_ = folder / fileName(device.physical());
    const std::vector<char> data = load(file_);
    loadedBytes_ = data.size();
    VkPipelineCacheCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_PIPELINE_CACHE_CREATE_INFO;
    info.initialDataSize = data.size();
    info.pInitialData = data.data();
    VkPipelineCache cache = VK_NULL_HANDLE;
    check(vkCreatePipelineCache(device.handle(), &info, nullptr, &cache), "create the pipeline cache");
    cache_ = {device.handle(), cache};
}

PipelineCache::~PipelineCache() {
    if (touched_ && !file_.empty()) save();
}

void PipelineCache::save() const {
    std::size_t bytes = 0;
    if (vkGetPipelineCacheData(device_.handle(), handle(), &bytes, nullptr) != VK_SUCCESS) return;
    if (bytes == loadedBytes_ || bytes > kLargestFile) return;  // caches only grow: the same size is the same content
    std::vector<char> data(bytes);
    if (vkGetPipelineCacheData(device_.handle(), handle(), &bytes, data.data()) != VK_SUCCESS) return;
    data.resize(bytes);
    if (!replace(file_, data)) spdlog::debug(fmt::format("could not write pipeline cache {}", file_.string()));
}

}  // namespace vkpt
