// A glTF file in memory: tinygltf's model of it, checked, with the bytes of its buffers.
#pragma once
#include <fmt/format.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gltf/tinygltf.h"

namespace vkpt::gltf {

/// Elements that primitives may take for each byte of the buffers. A grid of spheres in 98 materials takes 9.
inline constexpr std::uint64_t kMostElements = 64;

using Json = nlohmann::json;
using Bytes = std::vector<unsigned char>;

/// Reads the whole of a regular file, or throws FileError(`blamed`, place + reason).
[[nodiscard]] Bytes readFile(const std::filesystem::path& file, const std::string& blamed, std::string_view place);

/// Which files a URI of a glTF file may name.
enum class Reach {
    Folder,   ///< those in the scene's folder and below, links followed
    Anywhere  ///< any file of this machine
};

/// The file that a URI names, percent-decoded, relative to `folder`. Throws FileError for what lies beyond `reach`: by
/// an absolute path, `..`, a symbolic link or a `file:` URI; for other schemes always. [glTF 2.0, §2.8; RFC 3986]
[[nodiscard]] std::filesystem::path resolveUri(std::string_view uri, const std::filesystem::path& folder, Reach reach,
                                               const std::string& blamed, std::string_view place);

/// The payload of a `data:` URI, base64 or percent-encoded. [RFC 2397]
[[nodiscard]] Bytes decodeDataUri(std::string_view uri, const std::string& blamed, std::string_view place);

/// Does not change once constructed but for buffers, which are loaded when first read; many threads may read it.
class Document {
public:
    /// `bytes` are the file's own, .gltf or .glb, and must outlive the document.
    Document(std::span<const unsigned char> bytes, const std::filesystem::path& file, Reach reach);

    [[nodiscard]] const tinygltf::Model& model() const { return model_; }
    /// Slips of the document that do no harm, one line each.
    [[nodiscard]] const std::vector<std::string>& warnings() const { return warnings_; }
    /// The bytes of bufferViews[index], whole.
    [[nodiscard]] std::span<const std::byte> bufferView(std::size_t index) const;
    /// The bytes behind an image's or buffer's uri.
    [[nodiscard]] Bytes readUri(std::string_view uri, std::string_view place) const;
    /// The files that readUri has opened so far, sorted.
    [[nodiscard]] std::vector<std::filesystem::path> filesRead() const;

    /// Counts elements that a primitive is about to take from accessors, whose buffers are loaded. Many primitives may
    /// share an accessor, but memory must not outgrow the file: throws FileError beyond kMostElements for each byte.
    void countElements(std::uint64_t elements) const;
    /// Counts bytes of decoded images. Throws FileError once they are more than the machine has.
    void countImage(std::uint64_t bytes) const;

    /// Throws FileError(file, "place: fault").
    template <typename... Args>
    [[noreturn]] void fail(fmt::format_string<Args...> text, Args&&... args) const {
        throwFault(fmt::format(text, std::forward<Args>(args)...));
    }

private:
    struct Buffer {
        std::optional<std::string> uri;
        std::size_t length = 0;  ///< as the file states it
        std::once_flag once;
        Bytes loaded;
        std::span<const unsigned char> bytes;
    };

    [[noreturn]] void throwFault(const std::string& fault) const;
    [[nodiscard]] Json parse(std::span<const unsigned char> text);
    void load(std::size_t index, Buffer& buffer) const;

    std::filesystem::path file_;
    Reach reach_;
    std::vector<std::string> warnings_;
    tinygltf::Model model_;
    std::optional<std::span<const unsigned char>> bin_;  ///< the GLB's binary chunk
    mutable std::deque<Buffer> buffers_;
    mutable std::mutex filesMutex_;
    mutable std::set<std::filesystem::path> files_;
    mutable std::atomic<std::uint64_t> elementsTaken_ = 0, bytesLoaded_ = 0, imageBytes_ = 0;
};

/// `object[key]`, or null where it is absent.
[[nodiscard]] const Json& member(const Json& object, std::string_view key);

}  // namespace vkpt::gltf
