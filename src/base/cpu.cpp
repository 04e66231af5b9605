#include "base/cpu.h"

#ifdef __x86_64__
#include <cpuid.h>
#endif

namespace vkpt {

#ifdef __x86_64__
namespace {

/// AMD's processor family, 0 of other makers.
unsigned familyOfAmd() {
    unsigned a = 0, b = 0, c = 0, d = 0;
    if (__get_cpuid(0, &a, &b, &c, &d) == 0 || b != signature_AMD_ebx || c != signature_AMD_ecx) return 0;
    if (__get_cpuid(1, &a, &b, &c, &d) == 0) return 0;
    const unsigned base = a >> 8U & 0xfU, extension = a >> 20U & 0xffU;
    return base == 0xf ? base + extension : base;
}

}  // namespace

bool computes512Bits() { return __builtin_cpu_supports("avx512bw") != 0 && familyOfAmd() >= 26; }
#else
bool computes512Bits() { return false; }
#endif

}  // namespace vkpt
