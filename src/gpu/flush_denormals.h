// Denormal numbers off while a driver starts its threads.
#pragma once
#if defined(__SSE__)
#include <immintrin.h>
#endif

namespace vkpt {

/// While it lives, threads that are started treat denormal floats as zero (they inherit the mode); the calling
/// thread's own mode comes back at the end. For drivers that run shaders on the CPU: their idle lanes compute on
/// whatever bits they hold, and each denormal operand costs some 150 cycles (measured: rays 4 times slower).
/// Vulkan lets shaders flush denormals.
class FlushDenormals {
public:
#if defined(__SSE__)
    FlushDenormals() : saved_(_mm_getcsr()) { _mm_setcsr(saved_ | kFlushToZero | kDenormalsAreZero); }
    ~FlushDenormals() { _mm_setcsr(saved_); }
#else
    FlushDenormals() = default;
    ~FlushDenormals() = default;
#endif
    FlushDenormals(const FlushDenormals&) = delete;
    FlushDenormals& operator=(const FlushDenormals&) = delete;

private:
#if defined(__SSE__)
    static constexpr unsigned kFlushToZero = 0x8000, kDenormalsAreZero = 0x0040;
    unsigned saved_;
#endif
};

}  // namespace vkpt
