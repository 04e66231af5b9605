// Compaction: one atomic a subgroup through ballot, or one a workgroup through shared memory.
// Every invocation of the workgroup must call appendSlot, with `wanted` false where it has nothing to append.
shared uint sharedCount, sharedBase;

uint appendSlot(uint bounce, uint queue, bool wanted) {
    uint block = queueCounter(bounce, queue);
#ifndef VKPT_NO_BALLOT
    if (kUseBallot != 0u) {
        uvec4 ballot = subgroupBallot(wanted);
        uint count = subgroupBallotBitCount(ballot), base = 0u;
        if (subgroupElect() && count > 0u) {
            base = atomicAdd(counters[block + 3u], count);
            atomicMax(counters[block], (base + count + 63u) / 64u);
        }
        return subgroupBroadcastFirst(base) + subgroupBallotExclusiveBitCount(ballot);
    }
#endif
    if (gl_LocalInvocationIndex == 0u) sharedCount = 0u;
    barrier();
    uint mine = wanted ? atomicAdd(sharedCount, 1u) : 0u;
    barrier();
    if (gl_LocalInvocationIndex == 0u && sharedCount > 0u) {
        sharedBase = atomicAdd(counters[block + 3u], sharedCount);
        atomicMax(counters[block], (sharedBase + sharedCount + 63u) / 64u);
    }
    barrier();
    uint slot = sharedBase + mine;
    barrier();
    return slot;
}
