#include "gpu/instance.h"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <array>
#include <cstring>
#include <mutex>

#include "base/error.h"
#include "gpu/flush_denormals.h"
#include "gpu/requirements.h"

namespace vkpt {

namespace {

constexpr const char* kValidationLayer = "VK_LAYER_KHRONOS_validation";
constexpr std::size_t kKeptMessages = 100;
constexpr VkDebugUtilsMessageTypeFlagsEXT kLayerMessages =
    VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_TYPE_PERFORMANCE_BIT_EXT;

void loadVulkan() {
    static const VkResult result = volkInitialize();
    if (result != VK_SUCCESS)
        throw DeviceError(
            "no Vulkan loader; install packages libvulkan1 and mesa-vulkan-drivers, or use --backend cpu");
}

[[noreturn]] void throwNoDriver() {
    throw DeviceError("no Vulkan device; install a driver, e.g. package mesa-vulkan-drivers, or use --backend cpu");
}

bool hasInstanceExtension(const char* name) {
    std::uint32_t count = 0;
    check(vkEnumerateInstanceExtensionProperties(nullptr, &count, nullptr), "list instance extensions");
    std::vector<VkExtensionProperties> extensions(count);
    check(vkEnumerateInstanceExtensionProperties(nullptr, &count, extensions.data()), "list instance extensions");
    for (const auto& extension : extensions)
        if (std::strcmp(extension.extensionName, name) == 0) return true;
    return false;
}

}  // namespace

struct MessageLog {
    std::mutex mutex;
    std::uint64_t count = 0;
    std::vector<std::string> texts;
};

namespace {

VKAPI_ATTR VkBool32 VKAPI_CALL onMessage(VkDebugUtilsMessageSeverityFlagBitsEXT, VkDebugUtilsMessageTypeFlagsEXT types,
                                         const VkDebugUtilsMessengerCallbackDataEXT* data, void* user) {
    if ((types & kLayerMessages) == 0) {  // loader's and driver's remarks
        spdlog::debug(fmt::format("Vulkan: {}", data->pMessage));
        return VK_FALSE;
    }
    spdlog::error(fmt::format("Vulkan validation: {}", data->pMessage));
    auto& log = *static_cast<MessageLog*>(user);
    const std::lock_guard lock(log.mutex);
    ++log.count;
    if (log.texts.size() < kKeptMessages) log.texts.emplace_back(data->pMessage);
    return VK_FALSE;
}

VkDebugUtilsMessengerCreateInfoEXT messengerInfo(MessageLog* log) {
    VkDebugUtilsMessengerCreateInfoEXT info{};
    info.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT;
    info.messageSeverity =
        VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
    info.messageType = kLayerMessages | VK_DEBUG_UTILS_MESSAGE_TYPE_GENERAL_BIT_EXT;
    info.pfnUserCallback = onMessage;
    info.pUserData = log;
    return info;
}

}  // namespace

Instance::Instance(const InstanceOptions& options) : log_(std::make_unique<MessageLog>()) {
    loadVulkan();
    debugUtils_ = options.validation && hasInstanceExtension(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
    create(options);
    volkLoadInstance(instance_);
    if (debugUtils_) createMessenger();
}

void Instance::create(const InstanceOptions& options) {
    if (volkGetInstanceVersion() < kRequiredApiVersion)
        throw DeviceError(fmt::format("the Vulkan loader offers {}; {} is needed: update package libvulkan1",
                                      versionText(volkGetInstanceVersion()), versionText(kRequiredApiVersion)));
    VkApplicationInfo application{};
    application.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO;
    application.pApplicationName = "vkpt";
    application.apiVersion = kRequiredApiVersion;

    const std::array enabled{VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT};
    VkDebugUtilsMessengerCreateInfoEXT early = messengerInfo(log_.get());  // for messages of creation itself
    VkValidationFeaturesEXT features{};
    features.sType = VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT;
    features.pNext = debugUtils_ ? &early : nullptr;
    features.enabledValidationFeatureCount = enabled.size();
    features.pEnabledValidationFeatures = enabled.data();

    const char* debugUtils = VK_EXT_DEBUG_UTILS_EXTENSION_NAME;
    VkInstanceCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO;
    info.pApplicationInfo = &application;
    info.enabledExtensionCount = debugUtils_ ? 1 : 0;
    info.ppEnabledExtensionNames = &debugUtils;
    if (options.validation) {
        info.pNext = &features;
        info.enabledLayerCount = 1;
        info.ppEnabledLayerNames = &kValidationLayer;
    }
    const FlushDenormals flush;  // the driver may start threads
    const VkResult result = vkCreateInstance(&info, nullptr, &instance_);
    if (result == VK_ERROR_INCOMPATIBLE_DRIVER) throwNoDriver();
    check(result, "create the instance");
}

void Instance::createMessenger() {
    const VkDebugUtilsMessengerCreateInfoEXT info = messengerInfo(log_.get());
    const VkResult result = vkCreateDebugUtilsMessengerEXT(instance_, &info, nullptr, &messenger_);
    if (result == VK_SUCCESS) return;
    vkDestroyInstance(instance_, nullptr);
    check(result, "create the debug messenger");
}

Instance::~Instance() {
    // Of this instance: volk's pointer is that of the one opened last, which may lack the extension.
    const auto destroyMessenger = reinterpret_cast<PFN_vkDestroyDebugUtilsMessengerEXT>(
        vkGetInstanceProcAddr(instance_, "vkDestroyDebugUtilsMessengerEXT"));
    if (messenger_ != VK_NULL_HANDLE) destroyMessenger(instance_, messenger_, nullptr);
    vkDestroyInstance(instance_, nullptr);
}

std::vector<VkPhysicalDevice> Instance::physicalDevices() const {
    std::uint32_t count = 0;
    const FlushDenormals flush;  // the driver may start threads
    const VkResult result = vkEnumeratePhysicalDevices(instance_, &count, nullptr);
    if (result == VK_ERROR_INITIALIZATION_FAILED || (result == VK_SUCCESS && count == 0)) throwNoDriver();
    check(result, "list devices");
    std::vector<VkPhysicalDevice> devices(count);
    check(vkEnumeratePhysicalDevices(instance_, &count, devices.data()), "list devices");
    return devices;
}

std::vector<DeviceInfo> Instance::devices() const {
    std::vector<DeviceInfo> infos;
    for (VkPhysicalDevice device : physicalDevices())
        infos.push_back(describeDevice(device, static_cast<std::uint32_t>(infos.size())));
    return infos;
}

std::uint64_t Instance::validationMessages() const {
    const std::lock_guard lock(log_->mutex);
    return log_->count;
}

std::vector<std::string> Instance::validationLog() const {
    const std::lock_guard lock(log_->mutex);
    return log_->texts;
}

}  // namespace vkpt
