// Compaction: invocations count in shared memory what they append, then one atomic for the workgroup takes the slots.
// Before it includes this, a kernel defines kAppends: to how many queues it appends.
shared uint sharedCounts[kAppends], sharedBases[kAppends];

// How many of the workgroup's have counted before, by one atomic for all of a subgroup where that is told by ballot.
uint countShared(uint queue, bool wanted) {
#ifndef VKPT_NO_BALLOT
    if (kUseBallot != 0u) {
        uvec4 ballot = subgroupBallot(wanted);
        uint count = subgroupBallotBitCount(ballot), base = 0u;
        if (subgroupElect() && count > 0u) base = atomicAdd(sharedCounts[queue], count);
        return subgroupBroadcastFirst(base) + subgroupBallotExclusiveBitCount(ballot);
    }
#endif
    return wanted ? atomicAdd(sharedCounts[queue], 1u) : 0u;
}

// The first of `count` slots of the queue whose counter is at `counter`. The next dispatch gets one workgroup more from
// whoever takes its first slot.
uint takeSlots(uint counter, uint count) {
    uint base = atomicAdd(counters[counter + 3u], count), groups = (base + count + 63u) / 64u;
    if (groups > (base + 63u) / 64u) atomicMax(counters[counter], groups);
    return base;
}

// A slot in each queue, by its counter, that an invocation wants to append to. kNone: no queue. Every invocation of the
// workgroup must call it, once. Best before the kernel writes: on x86 an atomic waits for all writes before it.
uint[kAppends] appendSlots(uint counterOf[kAppends], bool wanted[kAppends]) {
    uint slots[kAppends];
    if (gl_LocalInvocationIndex < kAppends) sharedCounts[gl_LocalInvocationIndex] = 0u;
    barrier();
    [[unroll]] for (uint q = 0u; q < kAppends; ++q)
        slots[q] = counterOf[q] != kNone ? countShared(q, wanted[q]) : 0u;
    barrier();
    if (gl_LocalInvocationIndex < kAppends) {
        uint q = gl_LocalInvocationIndex, count = sharedCounts[q];
        if (count > 0u) sharedBases[q] = takeSlots(counterOf[q], count);
    }
    barrier();
    [[unroll]] for (uint q = 0u; q < kAppends; ++q) slots[q] += sharedBases[q];
    return slots;
}
