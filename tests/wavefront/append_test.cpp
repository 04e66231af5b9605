// Compaction: wanted slots are handed out once each, without gaps, in both forms.
#include <algorithm>

#include "gpu/transfer.h"
#include "wavefront/layout.h"
#include "wavefront/probe_scene.h"
#include "wavefront/random_inputs.h"

namespace vkpt {
namespace {

using AppendProbe = GpuTest;

/// Which queue each invocation asks for: 1, or 0 for the other, or 2 for none.
using Choices = std::vector<glm::uvec4>;

enum class Form { Ballot, Shared, Portable };

void appendAll(const Choices& choices, Form form) {
    Device& device = testDevice();
    const std::vector<QueueCounter> fresh(3 * kQueues);
    const Buffer counters = makeStorage<QueueCounter>(device, fresh, "append counters");
    ProbeOptions options;
    options.specialization = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, form == Form::Ballot ? 1U : 0U};
    options.extraKinds = {BindingKind::StorageBuffer};
    options.extra = {counters};
    const auto out = evaluate<glm::uvec4>(form == Form::Portable ? "append_portable" : "append", choices, options);
    const auto after = readStorage<QueueCounter>(device, counters, 0, fresh.size());
    for (const std::uint32_t choice : {1U, 0U}) {
        std::vector<std::uint32_t> slots;
        for (std::size_t i = 0; i < choices.size(); ++i)
            if (choices[i].x == choice) slots.push_back(out[i].x);
        const QueueCounter& counter = after[kQueues + (choice == 1 ? 1 : 2)];  // block of bounce 1
        EXPECT_EQ(counter.items, slots.size());
        EXPECT_EQ(counter.groups, (slots.size() + kGroupSize - 1) / kGroupSize);
        EXPECT_TRUE(counter.one0 == 1 && counter.one1 == 1);
        std::ranges::sort(slots);
        for (std::size_t i = 0; i < slots.size(); ++i) ASSERT_EQ(slots[i], i);
    }
}

TEST_F(AppendProbe, EverySlotIsHandedOutOnce) {
    for (const Form form : {Form::Ballot, Form::Shared, Form::Portable}) {
        // Where ballot is missing, the module that names it does not load.
        if (form != Form::Portable && !testDevice().info().subgroupBallot) continue;
        for (const std::size_t count : {1, 63, 64, 65, 1000, 20000})
            for (const float share : {0.0F, 0.03F, 0.5F, 1.0F})
                for (const float idle : {0.0F, 0.4F}) {
                    SCOPED_TRACE(testing::Message() << "form " << static_cast<int>(form) << " count " << count
                                                    << " share " << share << " idle " << idle);
                    RandomInputs random(22);
                    Choices choices(count);
                    for (auto& c : choices) c.x = random.unit() < idle ? 2 : (random.unit() < share ? 1 : 0);
                    appendAll(choices, form);
                }
    }
}

}  // namespace
}  // namespace vkpt
