#include "base/memory.h"

#include <unistd.h>

#include <algorithm>
#include <fstream>

namespace vkpt {

std::uint64_t physicalMemory() {
    const auto machine =
        static_cast<std::uint64_t>(::sysconf(_SC_PHYS_PAGES)) * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
    std::uint64_t group = 0;
    std::ifstream limit("/sys/fs/cgroup/memory.max");  // a number, or "max"
    return limit >> group ? std::min(machine, group) : machine;
}

}  // namespace vkpt
