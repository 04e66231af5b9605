// A glTF file in memory: its JSON, checked against the schema, and the bytes of its buffers.
#pragma once
#include <fmt/format.h>

#include <cstddef>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace vkpt::gltf {

using Json = nlohmann::json;

/// Bytes that were never filled with zeros first.
struct Bytes {
    std::unique_ptr<std::byte[]> data;
    std::size_t size = 0;
    [[nodiscard]] std::span<const std::byte> view() const { return {data.get(), size}; }
};

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

    [[nodiscard]] const Json& root() const { return json_; }
    /// Items of one of the root's arrays; none where it is absent.
    [[nodiscard]] std::size_t count(std::string_view section) const;
    [[nodiscard]] const Json& item(std::string_view section, std::size_t index) const;
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
    void parse();
    void loadBuffers();

    std::filesystem::path file_;
    Bytes content_;
    std::span<const std::byte> jsonChunk_, binChunk_;
    bool hasBinChunk_ = false;
    Json json_;
    std::vector<Bytes> loaded_;                        ///< owners of the buffers that are not the BIN chunk
    std::vector<std::span<const std::byte>> buffers_;  ///< empty where a buffer has no data
};

/// `object[key]`, or null where it is absent.
[[nodiscard]] const Json& member(const Json& object, std::string_view key);
/// `object[key]` as a T, or `fallback` where it or the object is absent. The schema has checked the type.
template <typename T>
[[nodiscard]] T valueOr(const Json& object, std::string_view key, T fallback) {
    const Json& value = member(object, key);
    return value.is_null() ? fallback : value.template get<T>();
}
[[nodiscard]] inline std::string textOr(const Json& object, std::string_view key, const char* fallback) {
    return valueOr<std::string>(object, key, fallback);
}
/// `object.extensions[name]`, or null.
[[nodiscard]] const Json& extension(const Json& object, std::string_view name);

}  // namespace vkpt::gltf
