#include "builder.h"

namespace vkpt::test {

std::string base64(const ByteVector& bytes) {
    static constexpr std::string_view kAlphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k) group = group << 8 | (i + k < bytes.size() ? bytes[i + k] : 0U);
        for (std::size_t k = 0; k < 4; ++k) text += i + k <= bytes.size() ? kAlphabet[group >> (18 - 6 * k) & 63] : '=';
    }
    return text;
}

int Builder::view(const void* data, std::size_t size, int stride) {
    bytes_.resize((bytes_.size() + 3) / 4 * 4);
    Json item = {{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", size}};
    if (stride > 0) item["byteStride"] = stride;
    const auto* begin = static_cast<const std::uint8_t*>(data);
    bytes_.insert(bytes_.end(), begin, begin + size);
    return push("bufferViews", item);
}

int Builder::push(const char* section, Json item) {
    json[section].push_back(std::move(item));
    return static_cast<int>(json[section].size()) - 1;
}

Json& Builder::primitive(Json attributes) {
    const int mesh = push("meshes", {{"primitives", {{{"attributes", std::move(attributes)}}}}});
    const int node = push("nodes", {{"mesh", mesh}});
    if (!json.contains("scenes")) json["scenes"].push_back({{"nodes", Json::array()}});
    json["scenes"][0]["nodes"].push_back(node);
    return json["meshes"][static_cast<std::size_t>(mesh)]["primitives"][0];
}

Json& Builder::triangle() { return primitive({{"POSITION", vec3({0, 0, 0, 1, 0, 0, 0, 1, 0})}}); }

void Builder::textured(Json image) {
    const int texture = push("textures", {{"source", push("images", std::move(image))}});
    const int material = push("materials", {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", texture}}}}}});
    Json& primitive = json["meshes"].back()["primitives"].back();
    primitive["material"] = material;
    if (!primitive["attributes"].contains("TEXCOORD_0"))
        primitive["attributes"]["TEXCOORD_0"] = vec2({0, 1, 1, 1, 0, 0});
}

ByteVector Builder::glb() const {
    Json whole = json;
    ByteVector bin = bytes_;
    if (!bin.empty()) whole["buffers"] = {{{"byteLength", bin.size()}}};
    std::string head = whole.dump();
    head.resize((head.size() + 3) / 4 * 4, ' ');
    bin.resize((bin.size() + 3) / 4 * 4);
    ByteVector out;
    const auto word = [&](std::size_t value) {
        for (int i = 0; i < 4; ++i) out.push_back(static_cast<std::uint8_t>(value >> 8 * i));
    };
    word(0x46546C67);
    word(2);
    word(12 + 8 + head.size() + (bin.empty() ? 0 : 8 + bin.size()));
    word(head.size());
    word(0x4E4F534A);
    out.insert(out.end(), head.begin(), head.end());
    if (!bin.empty()) {
        word(bin.size());
        word(0x004E4942);
        out.insert(out.end(), bin.begin(), bin.end());
    }
    return out;
}

std::string Builder::text() const {
    Json whole = json;
    if (!bytes_.empty())
        whole["buffers"] = {
            {{"byteLength", bytes_.size()}, {"uri", "data:application/octet-stream;base64," + base64(bytes_)}}};
    return whole.dump();
}

Scene Builder::import(ImportOptions options) const {
    const TemporaryFolder folder;
    return importGltf(folder.write("scene.gltf", text()), options);
}

Primitive Builder::importPrimitive() const { return import().meshes.at(0).primitives.at(0); }

void expectNear(const glm::vec3& actual, const glm::vec3& expected, float tolerance) {
    for (glm::length_t i = 0; i < 3; ++i)
        EXPECT_NEAR(actual[i], expected[i], tolerance)
            << "(" << actual.x << ", " << actual.y << ", " << actual.z << ") is not (" << expected.x << ", "
            << expected.y << ", " << expected.z << ")";
}

}  // namespace vkpt::test
