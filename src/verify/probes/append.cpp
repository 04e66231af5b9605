// Compaction: wanted slots are handed out once each, without gaps, in every form.
#include <algorithm>

#include "gpu/device.h"
#include "gpu/transfer.h"
#include "verify/context.h"
#include "verify/inputs/random_inputs.h"
#include "verify/probes.h"
#include "wavefront/kernels.h"
#include "wavefront/layout.h"

namespace vkpt {
namespace {

/// Which queue each invocation asks for: 1, or 0 for the other, or 2 for none.
using Choices = std::vector<glm::uvec4>;

struct Form {
    const char* name;
    bool ballot, portable;
};
constexpr Form kForms[] = {{"ballot", true, false}, {"shared memory", false, false}, {"portable", false, true}};

void appendAll(Prober& prober, Findings& findings, const Choices& choices, const Form& form) {
    Device& device = prober.device();
    const std::vector<QueueCounter> fresh(3);
    const Buffer counters = makeStorage<QueueCounter>(device, fresh, "append counters");
    ProbeOptions options;
    options.specialization = specializationOf({}, {}, {.useBallot = form.ballot});
    options.extraKinds = {BindingKind::StorageBuffer};
    options.extra = {counters};
    const auto out = prober.evaluate<glm::uvec4>(form.portable ? "append_portable" : "append", choices, options);
    const auto after = readStorage<QueueCounter>(device, counters, 0, fresh.size());
    for (const std::uint32_t choice : {1U, 0U}) {
        std::vector<std::uint32_t> slots;
        for (std::size_t i = 0; i < choices.size(); ++i)
            if (choices[i].x == choice) slots.push_back(out[i].x);
        const QueueCounter& counter = after[choice == 1 ? 1 : 2];
        findings.equal("items", counter.items, slots.size());
        findings.equal("groups", counter.groups, (slots.size() + kGroupSize - 1) / kGroupSize);
        findings.holds("the other arguments", counter.one0 == 1 && counter.one1 == 1, "are not 1");
        std::ranges::sort(slots);
        for (std::size_t i = 0; i < slots.size(); ++i)
            if (!findings.equal("slots in order", slots[i], i)) break;
    }
}

}  // namespace

void checkAppend(VerifyContext& context, Findings& findings) {
    Prober& prober = context.prober();
    for (const Form& form : kForms) {
        // Where ballot is missing, the module that names it does not load.
        if (!form.portable && !prober.device().info().subgroupBallot) continue;
        for (const std::size_t count : {1, 63, 64, 65, 1000, 20000})
            for (const float share : {0.0F, 0.03F, 0.5F, 1.0F})
                for (const float idle : {0.0F, 0.4F}) {
                    const auto scope = findings.inputs([&](std::size_t) {
                        return fmt::format("appendSlot by {}: {} invocations, {} of them idle, {} for the first queue",
                                           form.name, count, idle, share);
                    });
                    RandomInputs random(22);
                    Choices choices(count);
                    for (auto& c : choices) c.x = random.unit() < idle ? 2 : (random.unit() < share ? 1 : 0);
                    appendAll(prober, findings, choices, form);
                }
    }
}

}  // namespace vkpt
