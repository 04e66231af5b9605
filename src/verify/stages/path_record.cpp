#include "verify/stages/path_record.h"

namespace vkpt {
namespace {

/// Gathers the steps of every path from the device's state between kernels.
class Recording {
public:
    explicit Recording(const DevicePaths& paths) : paths_(paths) {}

    void see(const StageSnapshot& now) {
        const std::uint32_t bounce = now.batch.bounce;
        records_.resize(now.batch.pathCount);
        begins_.resize(now.batch.pathCount);
        if (now.stage == Stage::Generate) {
            for (const std::uint32_t path : now.queue(0, Queue::Ray)) begin(now, path, 0);
        } else if (now.stage == Stage::Intersect) {
            for (const Queue queue : kHitQueues)
                for (const std::uint32_t path : now.queue(bounce, queue)) last(path).hit = paths_.hitOf(now, path);
        } else if (now.stage == Stage::Miss) {
            for (const std::uint32_t path : now.queue(bounce, Queue::Miss)) emit(now, path);
        } else if (shadeGroupOf(now.stage) < kShadeStages.size()) {
            shade(now);
        } else if (now.stage == Stage::Shadow) {
            for (std::uint32_t item = 0; item < now.queueSize(bounce, Queue::Shadow); ++item) {
                const std::uint32_t path = shadowOf(now, item).path;
                shaded(path, bounce).arrives = sumsOf(now, path) != sumsOf(before_, path);
            }
        }
        before_ = now;
    }
    [[nodiscard]] std::vector<PathRecord> take() { return std::move(records_); }

private:
    void begin(const StageSnapshot& now, std::uint32_t path, std::uint32_t bounce) {
        PathStep step;
        step.state = paths_.stateOf(now, path, bounce);
        if (bounce == 0) begins_[path] = records_[path].size();
        records_[path].push_back(step);
    }
    PathStep& last(std::uint32_t path) { return records_[path].back(); }
    PathStep& shaded(std::uint32_t path, std::uint32_t bounce) { return records_[path][begins_[path] + bounce]; }

    void emit(const StageSnapshot& now, std::uint32_t path) {
        last(path).emitted = addedTo(now.batch.bounce == 0 && now.batch.round == 0 ? PathSums{} : sumsOf(before_, path),
                                     sumsOf(now, path));
    }

    void shade(const StageSnapshot& now) {
        const std::uint32_t bounce = now.batch.bounce;
        for (const std::uint32_t path : before_.queue(bounce, kHitQueues[shadeGroupOf(now.stage)])) emit(now, path);
        for (std::uint32_t item = before_.queueSize(bounce, Queue::Shadow); item < now.queueSize(bounce, Queue::Shadow);
             ++item) {
            const DeviceShadow shadow = shadowOf(now, item);
            last(shadow.path).direct = shadow.light;
        }
        const auto appended = before_.queueSize(bounce + 1, Queue::Ray);
        for (const std::uint32_t path : now.queue(bounce + 1, Queue::Ray).subspan(appended)) {
            last(path).next = paths_.stateOf(now, path, bounce + 1);
            begin(now, path, bounce + 1);
        }
    }

    const DevicePaths& paths_;
    StageSnapshot before_;
    std::vector<PathRecord> records_;
    std::vector<std::size_t> begins_;  ///< of the current round, a path
};

}  // namespace

std::vector<PathRecord> recordDevice(const DevicePaths& paths, WavefrontRenderer& renderer, std::uint32_t pixel) {
    Recording recording(paths);
    (void)renderer.observe(pixel, 1, [&](const StageSnapshot& now) { recording.see(now); });
    return recording.take();
}

PathRecord recordReference(const reference::PathTracer& tracer, std::uint32_t x, std::uint32_t y, std::uint32_t index) {
    PathRecord record;
    for (std::uint32_t round = 0; round < tracer.rounds(); ++round) {
        std::optional<reference::PathState> state = tracer.start(x, y, index);
        state->round = round;
        while (state) {
            PathStep step;
            step.state = *state;
            step.hit = tracer.intersect(*state);
            if (!step.hit) {
                const bool seen = state->bounce > 0 || round == 0;
                if (seen) step.emitted = tracer.miss(*state);
                record.push_back(step);
                break;
            }
            const reference::PathVertex vertex = tracer.shade(*state, *step.hit);
            step.emitted = vertex.emitted;
            step.direct = vertex.direct;
            step.arrives = vertex.direct && !tracer.isOccluded(*state, *vertex.direct);
            step.next = vertex.next;
            record.push_back(step);
            state = vertex.next;
        }
    }
    return record;
}

}  // namespace vkpt
