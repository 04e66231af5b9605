#include "base/hash.h"

#include <xxhash.h>

#include <fmt/format.h>

#include <bit>
#include <new>

namespace vkpt {

static_assert(std::endian::native == std::endian::little, "records are hashed as they lie in memory");

struct ContentHash::State {
    XXH3_state_t* xxh = XXH3_createState();
};

void ContentHash::Free::operator()(State* state) const {
    XXH3_freeState(state->xxh);
    delete state;
}

ContentHash::ContentHash() : state_(new State) {
    if (state_->xxh == nullptr) throw std::bad_alloc();
    XXH3_128bits_reset(state_->xxh);
}

ContentHash& ContentHash::add(std::span<const std::byte> bytes) {
    XXH3_128bits_update(state_->xxh, bytes.data(), bytes.size());
    return *this;
}

ContentHash& ContentHash::add(std::string_view text) {
    add(std::as_bytes(std::span(text)));
    constexpr std::byte end{0};
    return add(std::span(&end, 1));
}

std::string ContentHash::hex() const {
    const XXH128_hash_t hash = XXH3_128bits_digest(state_->xxh);
    return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

}  // namespace vkpt
