// Sizes and offsets of the device's path state, queues and counters: the host's side of shaders/kernels/state.glsl.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

namespace vkpt {

/// Push constants of every kernel.
struct BatchParams {
    std::uint32_t firstPixel = 0, pixelCount = 0;
    std::uint32_t firstSample = 0, sampleCount = 0;
    std::uint32_t bounce = 0;
    std::uint32_t capacity = 0;
    std::uint32_t pathCount = 0;
    std::uint32_t filmFirst = 0;
    std::uint32_t filmLayers = 0;  ///< word of the film buffer where the layers of its pixels begin
    std::uint32_t round = 0;       ///< of integrator direct, else 0: its paths begin anew, their sums go on
    std::uint32_t sampleReciprocal = 0, widthReciprocal = 0;  ///< reciprocalOf sampleCount, of the frame's width
};

/// What kernels divide by `number` with.
[[nodiscard]] constexpr std::uint32_t reciprocalOf(std::uint32_t number) { return 0xffffffffU / number; }

/// Which path lies in a slot.
struct SlotPlace {
    std::uint32_t pixel = 0, sample = 0;  ///< of the frame, row by row; of the whole render
};
[[nodiscard]] constexpr SlotPlace placeOfSlot(const BatchParams& batch, std::uint32_t slot) {
    return {batch.firstPixel + slot / batch.sampleCount, batch.firstSample + slot % batch.sampleCount};
}

inline constexpr std::uint32_t kGroupSize = 64;
inline constexpr std::uint32_t kStateArrays = 10;  ///< 16-byte words a path
inline constexpr std::uint32_t kQueueArrays = 6;   ///< two ray queues, hits a shade group, misses: uints a path

enum class Queue : std::uint32_t { Ray, Hit, Miss, HitMicrofacet, HitClassic, Shadow };
inline constexpr std::uint32_t kQueues = 6;
inline constexpr std::array kHitQueues = {Queue::Hit, Queue::HitMicrofacet, Queue::HitClassic};  ///< by kGroup*

/// Arrays of the path state, each as long as there are slots.
enum class StateArray : std::uint32_t {
    Origin,      ///< xyz; w: pdf of the direction, negative: MIS weight 1
    Direction,   ///< xyz; w: instance of the hit
    Throughput,  ///< xyz; w: medium that the path is in, 1 + its material; 0: none
    Hit,         ///< t, slot of the triangle, b1, b2
    Red,         ///< exact sums; w: alpha
    Green,       ///< w: a surface was met
    Blue,
    ShadowOrigin,   ///< xyz; w: slot of the path. The shadow arrays are indexed by their queue.
    ShadowTarget,   ///< xyz: from the origin to the light; w: tMax
    ShadowRadiance  ///< xyz; w: group of the light
};

/// Kernels in the order of a bounce; last the one that follows the intersections of the camera rays where layers are
/// asked for.
enum class Stage : std::uint32_t {
    Generate,
    Intersect,
    Miss,
    Shade,
    ShadeMicrofacet,
    ShadeClassic,
    Shadow,
    Accumulate,
    Layers
};
inline constexpr std::array kStageNames = {"generate",      "intersect", "miss",       "shade", "shade_microfacet",
                                           "shade_classic", "shadow",    "accumulate", "layers"};
inline constexpr std::array kShadeStages = {Stage::Shade, Stage::ShadeMicrofacet, Stage::ShadeClassic};  ///< by kGroup*
/// Which of kShadeStages; kShadeStages.size() for other stages.
[[nodiscard]] constexpr std::size_t shadeGroupOf(Stage stage) {
    std::size_t group = 0;
    while (group < kShadeStages.size() && kShadeStages[group] != stage) ++group;
    return group;
}

/// {groups, 1, 1, items} of one queue at one bounce, on a line of a cache of its own.
struct alignas(64) QueueCounter {
    std::uint32_t groups = 0, one0 = 1, one1 = 1, items = 0;
};

inline constexpr std::uint32_t kMaxBounceBlocks = 4096;
inline constexpr std::uint32_t kCounterBlock = kQueues * sizeof(QueueCounter) / 4;  ///< uints a bounce
inline constexpr std::uint32_t kRefusedCounter = 0;
inline constexpr std::uint32_t kRefusedInLayersCounter = 1;
inline constexpr std::uint32_t kFirstBlock = sizeof(QueueCounter) / 4;
inline constexpr std::uint32_t kQueueBase = kFirstBlock + kCounterBlock * kMaxBounceBlocks;

/// Byte offset of a queue's counter, which is also the argument of its indirect dispatch.
[[nodiscard]] constexpr std::size_t queueCounterOffset(std::uint32_t bounce, Queue queue) {
    return kFirstBlock * 4 + (std::size_t{bounce} * kQueues + static_cast<std::size_t>(queue)) * sizeof(QueueCounter);
}
/// Index of a queue's first entry among the words of the counters. Ray queues alternate by the parity of the bounce;
/// shadow items have no entries: they lie in the state arrays in the order of their slots.
[[nodiscard]] constexpr std::size_t queueArrayOffset(std::uint32_t bounce, Queue queue, std::uint32_t capacity) {
    const std::uint32_t array = queue == Queue::Ray ? bounce & 1U : static_cast<std::uint32_t>(queue) + 1;
    return kQueueBase + std::size_t{array} * capacity;
}
[[nodiscard]] constexpr std::size_t stateBytes(std::uint32_t capacity) {
    return std::size_t{capacity} * kStateArrays * 16;
}
[[nodiscard]] constexpr std::size_t counterBytes(std::uint32_t capacity) {
    return (std::size_t{kQueueBase} + std::size_t{capacity} * kQueueArrays) * 4;
}

}  // namespace vkpt
