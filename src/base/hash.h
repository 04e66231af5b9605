// A hash of content that is the same on every machine and in every version.
#pragma once
#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace vkpt {

/// XXH3, 128 bits. [Collet 20] Tells apart by accident, not by malice.
class ContentHash {
public:
    ContentHash();
    ContentHash& add(std::span<const std::byte> bytes);
    /// The text and its end: "ab","c" and "a","bc" differ.
    ContentHash& add(std::string_view text);
    /// The number of records, then their bytes; records must have no padding of the compiler's.
    template <class Record>
    ContentHash& add(const std::vector<Record>& records) {
        static_assert(std::is_trivially_copyable_v<Record>);
        const std::uint64_t count = records.size();
        return add(std::as_bytes(std::span(&count, 1))).add(std::as_bytes(std::span(records)));
    }

    /// Of all that was added: 32 hexadecimal digits.
    [[nodiscard]] std::string hex() const;

private:
    struct State;
    struct Free {
        void operator()(State* state) const;
    };
    std::unique_ptr<State, Free> state_;
};

}  // namespace vkpt
