// Opens a file: GLB container, JSON, model. [glTF 2.0, §4 (GLB)]
#include "gltf/document.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <fstream>
#include <optional>
#include <system_error>

#include "base/error.h"
#include "base/memory.h"
#include "gltf/model.h"
#include "gltf/rules.h"
#include "gltf/schema.h"

namespace vkpt::gltf {
namespace {

static_assert(std::endian::native == std::endian::little, "glTF data is little-endian and is read as it lies");

constexpr std::uint32_t kGlbMagic = 0x46546C67, kJsonChunk = 0x4E4F534A, kBinChunk = 0x004E4942;
constexpr std::size_t kGlbHeader = 12, kChunkHeader = 8;

std::uint32_t word(std::span<const unsigned char> bytes, std::size_t offset) {
    std::uint32_t value = 0;
    std::memcpy(&value, bytes.data() + offset, sizeof value);
    return value;
}

struct GlbChunks {
    std::span<const unsigned char> json;
    std::optional<std::span<const unsigned char>> bin;
};

GlbChunks splitGlb(std::span<const unsigned char> bytes, const std::string& file) {
    if (bytes.size() < kGlbHeader + kChunkHeader) throw FileError(file, "GLB: ends inside its header");
    if (word(bytes, 4) != 2) throw FileError(file, fmt::format("GLB: version {} is not 2", word(bytes, 4)));
    const std::size_t length = word(bytes, 8);
    if (length > bytes.size())
        throw FileError(file, fmt::format("GLB: states {} bytes, but the file holds {}", length, bytes.size()));

    GlbChunks chunks;
    std::size_t offset = kGlbHeader;
    for (int index = 0; offset + kChunkHeader <= length; ++index) {
        const std::size_t size = word(bytes, offset);
        const std::uint32_t type = word(bytes, offset + 4);
        offset += kChunkHeader;
        if (size > length - offset)
            throw FileError(
                file, fmt::format("GLB: chunk {} states {} bytes, but {} are left", index, size, length - offset));
        const auto chunk = bytes.subspan(offset, size);
        if (index == 0 && type != kJsonChunk) throw FileError(file, "GLB: the first chunk is not JSON");
        if (index == 0) chunks.json = chunk;
        if (index == 1 && type == kBinChunk) chunks.bin = chunk;
        offset += size;
    }
    if (chunks.json.empty()) throw FileError(file, "GLB: has no JSON chunk");
    return chunks;
}

}  // namespace

Bytes readFile(const std::filesystem::path& file, const std::string& blamed, std::string_view place) {
    const std::string prefix = place.empty() ? "" : fmt::format("{}: {}: ", place, file.filename().string());
    std::error_code error;
    const auto status = std::filesystem::status(file, error);
    if (!std::filesystem::exists(status)) throw FileError(blamed, prefix + "no such file");
    if (!std::filesystem::is_regular_file(status)) throw FileError(blamed, prefix + "is not a file");
    const auto size = std::filesystem::file_size(file, error);
    std::ifstream stream(file, std::ios::binary);
    if (error || !stream) throw FileError(blamed, prefix + "cannot be opened");
    Bytes bytes(size);
    stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
    if (static_cast<std::size_t>(stream.gcount()) != size) throw FileError(blamed, prefix + "cannot be read");
    return bytes;
}

const Json& member(const Json& object, std::string_view key) {
    static const Json kNull;
    const auto found = object.find(key);
    return found == object.end() ? kNull : *found;
}

Document::Document(std::span<const unsigned char> bytes, const std::filesystem::path& file, Reach reach)
    : file_(file), reach_(reach) {
    GlbChunks chunks{bytes, {}};
    if (bytes.size() >= 4 && word(bytes, 0) == kGlbMagic) chunks = splitGlb(bytes, file.string());
    bin_ = chunks.bin;
    Json root = parse(chunks.json);
    for (Json& item : root["buffers"]) {
        Buffer& buffer = buffers_.emplace_back();
        buffer.length = item["byteLength"].get<std::size_t>();
        if (item.contains("uri")) buffer.uri = std::move(item["uri"].get_ref<std::string&>());
    }
    model_ = loadModel(*this, root);
}

Json Document::parse(std::span<const unsigned char> text) {
    constexpr std::array<unsigned char, 3> kByteOrderMark{0xEF, 0xBB, 0xBF};
    if (text.size() >= 3 && std::equal(kByteOrderMark.begin(), kByteOrderMark.end(), text.begin()))
        fail("JSON: begins with a byte order mark; save it without");
    Json root;
    try {
        root = Json::parse(text.begin(), text.end());
    } catch (const Json::exception& error) {
        // The library's messages open with "[json.exception.name.number] ".
        const std::string_view what = error.what();
        fail("JSON: {}", what.substr(what.find("] ") == std::string_view::npos ? 0 : what.find("] ") + 2));
    }
    // First of all: a file of another version breaks the schema too, but that is not what is wrong with it.
    const Json &version = member(member(root, "asset"), "version"),
               &least = member(member(root, "asset"), "minVersion");
    if (version.is_string() && !version.get_ref<const std::string&>().starts_with("2."))
        fail("asset.version: {} is not supported; vkpt reads glTF 2.0", version.get_ref<const std::string&>());
    if (least.is_string() && least != "2.0")
        fail("asset.minVersion: the file needs glTF {}; vkpt reads 2.0", least.get_ref<const std::string&>());
    checkSchema(root, file_.string());
    warnings_ = checkRules(root, file_.string());
    return root;
}

void Document::load(std::size_t index, Buffer& buffer) const {
    const std::string place = fmt::format("buffers[{}]", index);
    if (buffer.uri) {
        buffer.loaded = readUri(*buffer.uri, place);
        buffer.bytes = buffer.loaded;
    } else {
        buffer.bytes = *bin_;
    }
    if (buffer.length > buffer.bytes.size())
        fail("{}: states {} bytes, but its data holds {}", place, buffer.length, buffer.bytes.size());
    buffer.bytes = buffer.bytes.first(buffer.length);
    bytesLoaded_ += buffer.length;
}

std::span<const std::byte> Document::bufferView(std::size_t index) const {
    const tinygltf::BufferView& view = model_.bufferViews[index];
    const auto number = static_cast<std::size_t>(view.buffer);
    Buffer& buffer = buffers_[number];
    if (view.byteOffset > buffer.length || view.byteLength > buffer.length - view.byteOffset)
        fail("bufferViews[{}]: needs {} bytes at offset {}, but buffers[{}] holds {}", index, view.byteLength,
             view.byteOffset, number, buffer.length);
    if (!buffer.uri && !(number == 0 && bin_))
        fail("buffers[{}]: has no data, but bufferViews[{}] reads it", number, index);
    std::call_once(buffer.once, [&] { load(number, buffer); });
    return std::as_bytes(buffer.bytes).subspan(view.byteOffset, view.byteLength);
}

Bytes Document::readUri(std::string_view uri, std::string_view place) const {
    if (uri.starts_with("data:")) return decodeDataUri(uri, file_.string(), place);
    const std::filesystem::path file = resolveUri(uri, file_.parent_path(), reach_, file_.string(), place);
    {
        const std::lock_guard lock(filesMutex_);
        files_.insert(file);
    }
    return readFile(file, file_.string(), place);
}

std::vector<std::filesystem::path> Document::filesRead() const {
    const std::lock_guard lock(filesMutex_);
    return {files_.begin(), files_.end()};
}

void Document::countElements(std::uint64_t elements) const {
    constexpr std::uint64_t kFree = std::uint64_t{1} << 16;
    const std::uint64_t taken = elementsTaken_ += elements;
    if (taken > kFree + bytesLoaded_ * kMostElements)
        fail("meshes: their primitives draw more than {} elements for each byte of the buffers", kMostElements);
}

void Document::countImage(std::uint64_t bytes) const {
    const std::uint64_t total = imageBytes_ += bytes;
    if (total > physicalMemory())
        fail("images: decoded they take more than the {} MiB of memory of this machine", physicalMemory() >> 20U);
}

void Document::throwFault(const std::string& fault) const { throw FileError(file_.string(), fault); }

}  // namespace vkpt::gltf
