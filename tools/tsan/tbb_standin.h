// The part of oneTBB that vkpt uses, on std::thread. Only the preset tsan is built with it: ThreadSanitizer cannot see
// how the library's own threads wait for each other, so that under the real one every loop looks like a race. Here the
// only order between two iterations is the one that the loop's start and end give, which is what a race detector should
// assume. Nested loops run in the thread they are in.
#pragma once
#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <map>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace oneapi::tbb {
namespace standin {

inline constexpr std::size_t kThreads = 4, kChunks = 16;
inline thread_local bool insideLoop = false;

/// work(i) for each i in [0, count), on several threads.
template <typename Work>
void spread(std::size_t count, Work&& work) {
    if (insideLoop || count < 2) {
        for (std::size_t i = 0; i < count; ++i) work(i);
        return;
    }
    std::atomic<std::size_t> next = 0;
    const auto run = [&] {
        insideLoop = true;
        // Relaxed: taking a number orders nothing else.
        for (std::size_t i = next.fetch_add(1, std::memory_order_relaxed); i < count;
             i = next.fetch_add(1, std::memory_order_relaxed))
            work(i);
    };
    std::vector<std::thread> threads;
    for (std::size_t i = 0; i < std::min(kThreads, count); ++i) threads.emplace_back(run);
    for (std::thread& thread : threads) thread.join();
}

}  // namespace standin

template <typename T>
class blocked_range {
public:
    blocked_range(T begin, T end, std::size_t grain = 1) : begin_(begin), end_(end), grain_(grain) {}
    [[nodiscard]] T begin() const { return begin_; }
    [[nodiscard]] T end() const { return end_; }
    [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(end_ - begin_); }
    [[nodiscard]] bool empty() const { return !(begin_ < end_); }
    /// Parts of at least the grain.
    [[nodiscard]] std::vector<blocked_range> parts() const {
        const std::size_t step = std::max(grain_, size() / standin::kChunks + 1);
        std::vector<blocked_range> all;
        for (std::size_t i = 0; i < size(); i += step)
            all.push_back({static_cast<T>(begin_ + static_cast<T>(i)),
                           static_cast<T>(begin_ + static_cast<T>(std::min(i + step, size()))), grain_});
        return all;
    }

private:
    T begin_, end_;
    std::size_t grain_;
};

template <typename T>
class blocked_range2d {
public:
    blocked_range2d(T row, T rows, std::size_t rowGrain, T column, T columns, std::size_t columnGrain)
        : rows_(row, rows, rowGrain), cols_(column, columns, columnGrain) {}
    blocked_range2d(const blocked_range<T>& rows, const blocked_range<T>& columns) : rows_(rows), cols_(columns) {}
    [[nodiscard]] const blocked_range<T>& rows() const { return rows_; }
    [[nodiscard]] const blocked_range<T>& cols() const { return cols_; }
    [[nodiscard]] std::vector<blocked_range2d> parts() const {
        std::vector<blocked_range2d> all;
        for (const auto& rows : rows_.parts())
            for (const auto& columns : cols_.parts()) all.push_back({rows, columns});
        return all;
    }

private:
    blocked_range<T> rows_, cols_;
};

template <typename Range, typename Body>
void parallel_for(const Range& range, const Body& body) {
    const auto parts = range.parts();
    standin::spread(parts.size(), [&](std::size_t i) { body(parts[i]); });
}

template <typename T, typename Body>
void parallel_for(T first, T last, const Body& body) {
    if (first < last)
        standin::spread(static_cast<std::size_t>(last - first),
                        [&](std::size_t i) { body(static_cast<T>(first + static_cast<T>(i))); });
}

template <typename Range, typename Value, typename Body, typename Join>
Value parallel_reduce(const Range& range, const Value& identity, const Body& body, const Join& join) {
    const auto parts = range.parts();
    std::vector<Value> values(parts.size(), identity);
    standin::spread(parts.size(), [&](std::size_t i) { values[i] = body(parts[i], identity); });
    Value all = identity;
    for (const Value& value : values) all = join(all, value);
    return all;
}

template <typename A, typename B>
void parallel_invoke(const A& a, const B& b) {
    standin::spread(2, [&](std::size_t i) { i == 0 ? a() : b(); });
}

template <typename T>
class combinable {
public:
    T& local() {
        const std::lock_guard lock(mutex_);
        return values_[std::this_thread::get_id()];
    }
    template <typename Join>
    T combine(const Join& join) {
        T all{};
        for (const auto& [thread, value] : values_) all = join(all, value);
        return all;
    }
    template <typename Visit>
    void combine_each(const Visit& visit) {
        for (const auto& [thread, value] : values_) visit(value);
    }

private:
    std::mutex mutex_;
    std::map<std::thread::id, T> values_;
};

struct global_control {
    enum parameter { max_allowed_parallelism };
    global_control(parameter, std::size_t) {}
};

struct task_arena {
    static constexpr int automatic = -1;
    explicit task_arena(int = automatic) {}
    template <typename Work>
    auto execute(const Work& work) {
        return work();
    }
};

}  // namespace oneapi::tbb

namespace tbb = oneapi::tbb;
