#include "verify/context.h"

namespace vkpt {

VerifyContext::VerifyContext(const SceneArrays& scene, const RenderOptions& options, VerifyConfig config)
    : scene_(scene), options_(options), config_(std::move(config)) {}

Prober& VerifyContext::prober() {
    if (!prober_) {
        device_ = std::make_unique<Device>(DeviceOptions{config_.wavefront.device, config_.wavefront.validation});
        prober_ = std::make_unique<Prober>(*device_, config_.probes);
    }
    return *prober_;
}

std::uint64_t VerifyContext::validationMessages() const { return device_ ? device_->validationMessages() : 0; }

}  // namespace vkpt
