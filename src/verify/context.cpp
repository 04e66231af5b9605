#include "verify/context.h"

#include <algorithm>

#include "reference/render.h"
#include "verify/stages/walk.h"

namespace vkpt {
namespace {

constexpr std::uint32_t kWalkPixels = 1U << 14U, kStrips = 8;

/// Calls visit(firstPixel, pixelCount) for all pixels of a small frame, for whole rows spread over a large one.
template <class Visit>
void forEachStrip(std::uint32_t width, std::uint32_t height, const Visit& visit) {
    const std::uint64_t pixels = std::uint64_t{width} * height;
    if (pixels <= kWalkPixels) return visit(0U, static_cast<std::uint32_t>(pixels));
    const std::uint32_t rows = std::max(1U, kWalkPixels / kStrips / width);
    const std::uint32_t count = std::min(width, kWalkPixels / kStrips) * rows;
    for (std::uint32_t strip = 0; strip < kStrips; ++strip)
        visit(static_cast<std::uint32_t>(std::uint64_t{height - rows} * strip / (kStrips - 1)) * width, count);
}

/// The reference's films with the eye moved by what rounding may move a hit by. Paths that meet curved mirrors again
/// and again magnify that until they part.
std::vector<Film> renderTwins(const SceneArrays& scene, const RenderOptions& options, const ReferenceConfig& config) {
    constexpr float kRounding = 2.5e-7F;  // relative
    const glm::vec3 reach =
        glm::max(glm::abs(options.params.eye), glm::max(glm::abs(scene.boundsMin), glm::abs(scene.boundsMax)));
    const float distance = kRounding * std::max({reach.x, reach.y, reach.z});
    std::vector<Film> films;
    for (const float side : {-distance, distance}) {
        RenderOptions moved = options;
        moved.params.eye += side * glm::normalize(moved.params.right);
        films.push_back(renderReference(scene, moved, {}, config));
    }
    return films;
}

}  // namespace

VerifyContext::VerifyContext(const SceneArrays& scene, const RenderOptions& options, VerifyConfig config)
    : scene_(scene), options_(options), config_(std::move(config)) {}

VerifyContext::~VerifyContext() = default;

Prober& VerifyContext::prober() {
    if (!prober_) {
        device_ = std::make_unique<Device>(DeviceOptions{config_.wavefront.device, config_.wavefront.validation});
        prober_ = std::make_unique<Prober>(*device_, config_.probes);
    }
    return *prober_;
}

WavefrontRenderer& VerifyContext::renderer() {
    if (!renderer_) {
        WavefrontConfig config = config_.wavefront;
        config.pathsInFlight = kWalkPixels;
        renderer_ = std::make_unique<WavefrontRenderer>(scene_, options_, config);
    }
    return *renderer_;
}

const StageWalk& VerifyContext::stages() {
    if (!stages_) {
        const RenderParams& p = options_.params;
        stages_ = std::make_unique<StageWalk>(scene_, options_, "scene");
        renderer().select(p.seed, options_.sampleEnd - 1, options_.sampleEnd);
        forEachStrip(p.width, p.height, [&](std::uint32_t firstPixel, std::uint32_t pixelCount) {
            stages_->run(renderer(), firstPixel, pixelCount);
        });
        stages_->finish();
    }
    return *stages_;
}

const SameSeedImages& VerifyContext::sameSeed() {
    if (sameSeed_) return *sameSeed_;
    SameSeedImages images;
    const std::uint32_t begin = options_.sampleBegin, end = options_.sampleEnd;
    const ReferenceConfig config{config_.threads};
    RenderOptions single = options_;
    for (std::uint32_t index = begin; index < end; ++index) {
        renderer().select(options_.params.seed, index, index + 1);
        const Film device = renderer().render({});
        single.sampleBegin = index;
        single.sampleEnd = index + 1;
        const Film reference = renderReference(scene_, single, {}, config);
        images.differences.add(device, reference, renderTwins(scene_, single, config));
        if (index == begin) {
            images.device = device;
            images.reference = reference;
        } else {
            addFilm(images.device, device);
            addFilm(images.reference, reference);
        }
        if (config_.progress) config_.progress(index + 1 - begin, end - begin);
    }
    return sameSeed_.emplace(std::move(images));
}

const ReplicateResult& VerifyContext::replicates() {
    if (replicates_) return *replicates_;
    const auto device = [&](std::uint32_t seed) {
        renderer().select(seed, options_.sampleBegin, options_.sampleEnd);
        return filmToImage(renderer().render({}));
    };
    const auto reference = [&](std::uint32_t seed) {
        RenderOptions options = options_;
        options.params.seed = seed;
        return filmToImage(renderReference(scene_, options, {}, ReferenceConfig{config_.threads}));
    };
    const auto progress = [&](std::uint32_t done) {
        if (config_.progress) config_.progress(done, config_.replicates);
    };
    return replicates_.emplace(
        compareReplicates(device, reference, options_.params.seed + 1, config_.replicates, progress));
}

std::uint64_t VerifyContext::validationMessages() const {
    return (device_ ? device_->validationMessages() : 0) + (renderer_ ? renderer_->validationMessages() : 0);
}

}  // namespace vkpt
