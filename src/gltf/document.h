// A glTF file in memory: tinygltf's model of it, checked, with the bytes of its buffers.
#pragma once
#include <fmt/format.h>

#include <cstddef>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gltf/tinygltf.h"

namespace vkpt::gltf {

using Json = nlohmann::json;
using Bytes = std::vector<unsigned char>;

/// Reads the whole of a regular file, or throws FileError(`blamed`, place + reason).
[[nodiscard]] Bytes readFile(const std::filesystem::path& file, const std::string& blamed, std::string_view place);

/// Where a relative URI of a glTF file leads: percent-decoded and inside `folder`. Throws FileError for anything
/// that has a scheme, is absolute or climbs out of the folder. [glTF 2.0, §2.8, §5.9.3; RFC 3986]
[[nodiscard]] std::filesystem::path resolveUri(std::string_view uri, const std::filesystem::path& folder,
                                               const std::string& blamed, std::string_view place);

/// The payload of a `data:` URI, base64 or percent-encoded. [RFC 2397]
[[nodiscard]] Bytes decodeDataUri(std::string_view uri, const std::string& blamed, std::string_view place);

/// Immutable after construction, so that many threads may read it.
class Document {
public:
    explicit Document(const std::filesystem::path& file);

    [[nodiscard]] const tinygltf::Model& model() const { return model_; }
    /// The bytes of bufferViews[index], whole.
    [[nodiscard]] std::span<const std::byte> bufferView(std::size_t index) const;
    /// The bytes behind an image's or buffer's uri.
    [[nodiscard]] Bytes readUri(std::string_view uri, std::string_view place) const;

    /// Throws FileError(file, "place: fault").
    template <typename... Args>
    [[noreturn]] void fail(fmt::format_string<Args...> text, Args&&... args) const {
        throwFault(fmt::format(text, std::forward<Args>(args)...));
    }

private:
    [[noreturn]] void throwFault(const std::string& fault) const;
    [[nodiscard]] Json parse(std::span<const unsigned char> text) const;

    std::filesystem::path file_;
    tinygltf::Model model_;
};

/// `object[key]`, or null where it is absent.
[[nodiscard]] const Json& member(const Json& object, std::string_view key);

}  // namespace vkpt::gltf
