// Bytes in memory as OpenEXR reads them.
#pragma once
#include <ImfIO.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>

namespace vkpt {

/// Reads bytes that are somebody else's and must outlive it. Throws Iex::InputExc beyond their end.
class ExrInput final : public Imf::IStream {
public:
    ExrInput(const std::string& name, std::span<const std::uint8_t> bytes) : IStream(name.c_str()), bytes_(bytes) {}
    bool read(char c[], int n) override {
        const auto count = static_cast<std::uint64_t>(n);
        if (count > bytes_.size() - std::min<std::uint64_t>(next_, bytes_.size())) {
            throw Iex::InputExc("the file ends too early");
        }
        std::memcpy(c, bytes_.data() + next_, count);
        next_ += count;
        return next_ < bytes_.size();
    }
    std::uint64_t tellg() override { return next_; }
    void seekg(std::uint64_t position) override { next_ = position; }

private:
    std::span<const std::uint8_t> bytes_;
    std::uint64_t next_ = 0;
};

}  // namespace vkpt
