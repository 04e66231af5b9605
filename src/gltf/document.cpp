// Opens a file: GLB container, JSON, buffers. [glTF 2.0, §4 (GLB), §3.6 (buffers)]
#include "gltf/document.h"

#include <bit>
#include <cstring>
#include <fstream>
#include <system_error>

#include "base/error.h"
#include "gltf/schema.h"

namespace vkpt::gltf {
namespace {

static_assert(std::endian::native == std::endian::little, "glTF data is little-endian and is read as it lies");

constexpr std::uint32_t kGlbMagic = 0x46546C67, kJsonChunk = 0x4E4F534A, kBinChunk = 0x004E4942;
constexpr std::size_t kGlbHeader = 12, kChunkHeader = 8;

std::uint32_t word(std::span<const std::byte> bytes, std::size_t offset) {
    std::uint32_t value = 0;
    std::memcpy(&value, bytes.data() + offset, sizeof value);
    return value;
}

struct GlbChunks {
    std::span<const std::byte> json, bin;
    bool hasBin = false;
};

GlbChunks splitGlb(std::span<const std::byte> bytes, const std::string& file) {
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
        if (index == 1 && type == kBinChunk) {
            chunks.bin = chunk;
            chunks.hasBin = true;
        }
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
    Bytes bytes{std::make_unique_for_overwrite<std::byte[]>(size), size};
    stream.read(reinterpret_cast<char*>(bytes.data.get()), static_cast<std::streamsize>(size));
    if (static_cast<std::size_t>(stream.gcount()) != size) throw FileError(blamed, prefix + "cannot be read");
    return bytes;
}

const Json& member(const Json& object, std::string_view key) {
    static const Json kNull;
    const auto found = object.find(key);
    return found == object.end() ? kNull : *found;
}

const Json& extension(const Json& object, std::string_view name) { return member(member(object, "extensions"), name); }

Document::Document(const std::filesystem::path& file) : file_(file), content_(readFile(file, file.string(), "")) {
    const auto bytes = content_.view();
    if (bytes.size() >= 4 && word(bytes, 0) == kGlbMagic) {
        const GlbChunks chunks = splitGlb(bytes, file.string());
        jsonChunk_ = chunks.json;
        binChunk_ = chunks.bin;
        hasBinChunk_ = chunks.hasBin;
    } else {
        jsonChunk_ = bytes;
    }
    parse();
    loadBuffers();
}

void Document::parse() {
    const auto* text = reinterpret_cast<const char*>(jsonChunk_.data());
    try {
        json_ = Json::parse(text, text + jsonChunk_.size());
    } catch (const Json::exception& error) {
        // The library's messages open with "[json.exception.name.number] ".
        const std::string_view what = error.what();
        fail("JSON: {}", what.substr(what.find("] ") == std::string_view::npos ? 0 : what.find("] ") + 2));
    }
    checkSchema(json_, file_.string());
    const std::string version = member(member(json_, "asset"), "version").get<std::string>();
    if (!version.starts_with("2.")) fail("asset.version: {} is not supported; vkpt reads glTF 2.0", version);
    const Json& minVersion = member(member(json_, "asset"), "minVersion");
    if (minVersion.is_string() && minVersion != "2.0")
        fail("asset.minVersion: the file needs glTF {}; vkpt reads 2.0", minVersion.get<std::string>());
}

void Document::loadBuffers() {
    const std::size_t n = count("buffers");
    buffers_.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
        const Json& buffer = item("buffers", i);
        const std::string place = fmt::format("buffers[{}]", i);
        const Json& uri = member(buffer, "uri");
        if (uri.is_string()) {
            loaded_.push_back(readUri(uri.get_ref<const std::string&>(), place));
            buffers_[i] = loaded_.back().view();
        } else if (i == 0 && hasBinChunk_) {
            buffers_[i] = binChunk_;
        } else {
            continue;  // a buffer that only an ignored extension fills: an error where something reads it
        }
        const auto stated = member(buffer, "byteLength").get<std::size_t>();
        if (stated > buffers_[i].size())
            fail("{}: states {} bytes, but its data holds {}", place, stated, buffers_[i].size());
        buffers_[i] = buffers_[i].first(stated);
    }
}

std::size_t Document::count(std::string_view section) const { return member(json_, section).size(); }

const Json& Document::item(std::string_view section, std::size_t index) const { return member(json_, section)[index]; }

std::span<const std::byte> Document::bufferView(std::size_t index) const {
    const Json& view = item("bufferViews", index);
    const auto buffer = member(view, "buffer").get<std::size_t>();
    const std::size_t offset = valueOr(view, "byteOffset", std::size_t{0});
    const auto length = member(view, "byteLength").get<std::size_t>();
    const std::size_t held = buffers_[buffer].size();
    if (buffers_[buffer].data() == nullptr)
        fail("buffers[{}]: has no data, but bufferViews[{}] reads it", buffer, index);
    if (offset > held || length > held - offset)
        fail("bufferViews[{}]: needs {} bytes at offset {}, but buffers[{}] holds {}", index, length, offset, buffer,
             held);
    return buffers_[buffer].subspan(offset, length);
}

Bytes Document::readUri(std::string_view uri, std::string_view place) const {
    if (uri.starts_with("data:")) return decodeDataUri(uri, file_.string(), place);
    return readFile(resolveUri(uri, file_.parent_path(), file_.string(), place), file_.string(), place);
}

void Document::throwFault(const std::string& fault) const { throw FileError(file_.string(), fault); }

}  // namespace vkpt::gltf
