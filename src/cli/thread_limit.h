// --nthreads: how many threads the process uses; and how lavapipe uses them.
#pragma once
#include <memory>

namespace vkpt {

/// While it lives the host uses at most `threads` threads, and so does a lavapipe device that is opened, unless the
/// environment says otherwise (LP_NUM_THREADS). 0: all cores, and of lavapipe several threads a core. Lavapipe also
/// takes vectors of 512 bits, where the processor computes them at once, unless LP_NATIVE_VECTOR_WIDTH says otherwise.
class ThreadLimit {
public:
    explicit ThreadLimit(unsigned threads);
    ~ThreadLimit();
    ThreadLimit(const ThreadLimit&) = delete;
    ThreadLimit& operator=(const ThreadLimit&) = delete;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace vkpt
