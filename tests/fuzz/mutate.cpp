#include "fuzz/mutate.h"

#include <array>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string>

namespace vkpt::fuzz {
namespace {

using Json = nlohmann::json;

constexpr std::uint32_t kGlbMagic = 0x46546C67, kJsonChunk = 0x4E4F534A, kBinChunk = 0x004E4942;
constexpr std::size_t kHeader = 12, kChunkHeader = 8;

std::uint32_t word(std::span<const std::uint8_t> bytes, std::size_t offset) {
    std::uint32_t value = 0;
    if (offset + sizeof value <= bytes.size()) std::memcpy(&value, bytes.data() + offset, sizeof value);
    return value;
}

void append(Bytes& bytes, std::initializer_list<std::uint32_t> words) {
    for (const std::uint32_t w : words)
        for (int shift = 0; shift < 32; shift += 8) bytes.push_back(static_cast<std::uint8_t>(w >> shift));
}

/// A glTF file in its parts.
struct Parts {
    Json json;
    Bytes bin;
    bool glb = false;
};

Parts takeApart(std::span<const std::uint8_t> file) {
    Parts parts;
    std::span<const std::uint8_t> text = file;
    parts.glb = word(file, 0) == kGlbMagic;
    if (parts.glb) {
        const std::size_t size = word(file, kHeader), bin = kHeader + kChunkHeader + size;
        if (bin > file.size()) return {Json(Json::value_t::discarded), {}, true};
        text = file.subspan(kHeader + kChunkHeader, size);
        if (bin + kChunkHeader <= file.size())
            parts.bin.assign(file.begin() + static_cast<std::ptrdiff_t>(bin + kChunkHeader), file.end());
    }
    parts.json = Json::parse(text.begin(), text.end(), nullptr, false);
    return parts;
}

Bytes putTogether(Parts& parts) {
    std::string text = parts.json.dump(-1, ' ', false, Json::error_handler_t::replace);
    if (!parts.glb) return {text.begin(), text.end()};
    text.resize((text.size() + 3) / 4 * 4, ' ');
    parts.bin.resize((parts.bin.size() + 3) / 4 * 4);
    Bytes file;
    const auto json = static_cast<std::uint32_t>(text.size()), bin = static_cast<std::uint32_t>(parts.bin.size());
    append(file, {kGlbMagic, 2, static_cast<std::uint32_t>(kHeader + 2 * kChunkHeader) + json + bin});
    append(file, {json, kJsonChunk});
    file.insert(file.end(), text.begin(), text.end());
    append(file, {bin, kBinChunk});
    file.insert(file.end(), parts.bin.begin(), parts.bin.end());
    return file;
}

void collect(Json& value, std::vector<Json*>& all) {
    all.push_back(&value);
    if (value.is_structured())
        for (Json& item : value) collect(item, all);
}

class Mutator {
public:
    Mutator(Json& root, std::mt19937& random) : random_(random) { collect(root, values_); }

    /// One edit at a random place.
    void edit() {
        Json& value = *values_[below(values_.size())];
        if (value.is_array() && !value.empty() && below(2) == 0) return editArray(value);
        if (value.is_object() && !value.empty() && below(2) == 0) return editObject(value);
        switch (below(4)) {
            case 0:
                value = Json(*values_[below(values_.size())]);  // from elsewhere in the file
                return;
            case 1:
                value = strangeNumber();
                return;
            case 2:
                value = strangeValue();
                return;
            default:
                if (value.is_number()) value = value.get<double>() + (below(2) == 0 ? 1 : -1);
        }
    }

private:
    std::size_t below(std::size_t n) { return random_() % n; }

    void editArray(Json& array) {
        const auto at = static_cast<std::ptrdiff_t>(below(array.size()));
        if (below(2) == 0)
            array.erase(array.begin() + at);
        else
            array.push_back(Json(array[static_cast<std::size_t>(at)]));
    }

    void editObject(Json& object) {
        auto item = object.begin();
        std::advance(item, static_cast<std::ptrdiff_t>(below(object.size())));
        if (below(2) == 0)
            object.erase(item);
        else
            object[kKeys[below(kKeys.size())]] = Json(*item);
    }

    Json strangeNumber() {
        static const std::array<Json, 22> kNumbers{0,      1,     2,     3,     4,          5,         6,   -1,
                                                   255,    256,   5121,  5123,  65535,      65536,     0.5, 1e-40,
                                                   3.4e38, -1e30, 1e300, -0.0, 4294967295, 2147483647};
        return kNumbers[below(kNumbers.size())];
    }

    Json strangeValue() {
        static const std::array<Json, 18> kValues{
            nullptr, true,    false,  "",      "SCALAR",       "VEC2",   "VEC3", "VEC4",        "MAT4",
            "MASK",  "BLEND", "spot", "point", "orthographic", "data:,", "\n",   Json::array(), Json::object()};
        return kValues[below(kValues.size())];
    }

    static constexpr std::array kKeys{"sparse", "byteStride", "normalized", "bufferView", "indices",  "TANGENT",
                                      "NORMAL", "COLOR_0",    "TEXCOORD_0", "TEXCOORD_1", "matrix",   "mode",
                                      "camera", "mesh",       "children",   "material",   "sampler",  "texCoord",
                                      "scene",  "extensions", "targets",    "rotation",   "alphaMode"};
    std::mt19937& random_;
    std::vector<Json*> values_;
};

}  // namespace

Bytes mutateGltf(std::span<const std::uint8_t> file, std::mt19937& random, const MutateBytes& mutateBytes) {
    Parts parts = takeApart(file);
    if (parts.json.is_discarded() || random() % 16 == 0) {
        Bytes whole(file.begin(), file.end());
        mutateBytes(whole);
        return whole;
    }
    if (!parts.bin.empty() && random() % 4 == 0) mutateBytes(parts.bin);
    for (auto edits = random() % 4; edits > 0; --edits) Mutator(parts.json, random).edit();
    return putTogether(parts);
}

}  // namespace vkpt::fuzz
