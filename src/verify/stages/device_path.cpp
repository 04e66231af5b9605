#include "verify/stages/device_path.h"

#include <bit>

namespace vkpt {
namespace {

glm::vec4 floats(const uvec4& word) { return std::bit_cast<glm::vec4>(word); }

}  // namespace

DevicePaths::Place DevicePaths::placeOf(const BatchParams& batch, std::uint32_t path) const {
    const SlotPlace place = placeOfSlot(batch, path);
    return {place.pixel % width_, place.pixel / width_, place.sample};
}

reference::PathState DevicePaths::stateOf(const StageSnapshot& device, std::uint32_t path, std::uint32_t bounce) const {
    const Place place = placeOf(device.batch, path);
    reference::PathState state;
    state.sample = tracer_.sampleOf(place.x, place.y, place.index);
    state.bounce = bounce;
    const glm::vec4 origin = floats(device.word(StateArray::Origin, path));
    state.ray = {glm::vec3(origin), glm::vec3(floats(device.word(StateArray::Direction, path)))};
    state.round = device.batch.round;
    const uvec4& throughput = device.word(StateArray::Throughput, path);
    state.throughput = glm::vec3(floats(throughput));
    if (throughput.w != 0) state.medium = throughput.w - 1;
    if (origin.w >= 0) state.pdfBsdf = origin.w;
    return state;
}

reference::Hit DevicePaths::hitOf(const StageSnapshot& device, std::uint32_t path) const {
    const uvec4& word = device.word(StateArray::Hit, path);
    const glm::vec4 hit = floats(word);
    return {hit.x,
            {1 - hit.z - hit.w, hit.z, hit.w},
            word.y,
            scene_.instances.empty() ? kNone : device.word(StateArray::Direction, path).w};
}

PathSums sumsOf(const StageSnapshot& device, std::uint32_t path) {
    return {sumOf(device.word(StateArray::Red, path)), sumOf(device.word(StateArray::Green, path)),
            sumOf(device.word(StateArray::Blue, path))};
}

PathSums changeOf(const PathSums& before, const PathSums& now) {
    PathSums change;
    for (std::size_t i = 0; i < change.size(); ++i) change[i] = (now[i] - before[i]) % kModulus;
    return change;
}

glm::dvec3 addedTo(const PathSums& before, const PathSums& now) {
    glm::dvec3 added;
    for (int c = 0; c < 3; ++c) {
        const auto i = static_cast<std::size_t>(c);
        const U128 sum = changeOf(before, now)[i];
        const bool negative = sum >= kModulus / 2;
        const auto magnitude = static_cast<double>(negative ? kModulus - sum : sum) * 0x1p-48;
        added[c] = negative ? -magnitude : magnitude;
    }
    return added;
}

DeviceShadow shadowOf(const StageSnapshot& device, std::uint32_t item) {
    const uvec4& origin = device.word(StateArray::ShadowOrigin, item);
    const glm::vec4 target = floats(device.word(StateArray::ShadowTarget, item));
    const uvec4& radiance = device.word(StateArray::ShadowRadiance, item);
    return {origin.w,
            {{glm::vec3(floats(origin)), glm::vec3(target)}, target.w, glm::vec3(floats(radiance)), radiance.w}};
}

}  // namespace vkpt
