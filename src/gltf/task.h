// Work split over threads whose outcome does not depend on their timing.
#pragma once
#include <tbb/parallel_for.h>

#include <cstddef>
#include <exception>
#include <string>
#include <vector>

namespace vkpt::gltf {

/// Runs work(i, warnings) for each i in [0, count) in parallel; warnings come out in order of i. If several throw, the
/// exception of the lowest i is the one that is rethrown.
template <typename Work>
void runTasks(std::size_t count, std::vector<std::string>& warnings, Work&& work) {
    std::vector<std::vector<std::string>> said(count);
    std::vector<std::exception_ptr> thrown(count);
    tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
        try {
            work(i, said[i]);
        } catch (const std::exception&) {
            thrown[i] = std::current_exception();
        }
    });
    for (const std::exception_ptr& exception : thrown)
        if (exception) std::rethrow_exception(exception);
    for (const auto& lines : said) warnings.insert(warnings.end(), lines.begin(), lines.end());
}

}  // namespace vkpt::gltf
