#include "fuzz/seeds.h"

#include <ImfHeader.h>
#include <ImfRgbaFile.h>
#include <ImfTiledRgbaFile.h>

#include <fstream>

#include "encode_jpeg.h"
#include "encode_png.h"
#include "film/encode.h"
#include "gltf/builder.h"
#include "temporary_folder.h"

namespace vkpt::fuzz {
namespace {

using test::Builder;
using Json = nlohmann::json;
using Bytes = std::vector<std::uint8_t>;

Bytes readBytes(const std::filesystem::path& file) {
    const std::string text = readText(file);
    return {text.begin(), text.end()};
}

/// A bundled scene as a GLB with its buffer and images inside.
Bytes packScene(const std::filesystem::path& folder) {
    Json json = Json::parse(readText(folder / "scene.gltf"));
    json.erase("buffers");
    Builder builder(std::move(json), readBytes(folder / "scene.bin"));
    if (builder.json.contains("images"))
        for (std::size_t i = 0; i < builder.json["images"].size(); ++i) {
            const std::string uri = builder.json["images"][i]["uri"];
            builder.json["images"][i] = {{"bufferView", builder.view(readBytes(folder / uri))},
                                         {"mimeType", "image/png"}};
        }
    return builder.glb();
}

Bytes plainPng(std::uint8_t depth, std::uint8_t type, std::size_t bytes) {
    return encodePng({4, 4, depth, type, Bytes(bytes, 0x9c)});
}

/// Triangles, attributes, a texture in every slot, cameras, lights and the extensions.
Bytes everything() {
    Builder b;
    Json& p = b.triangle();
    p["attributes"]["NORMAL"] = b.vec3({0, 0, 1, 0, 0, 1, 0, 0, 1});
    p["attributes"]["TEXCOORD_0"] = b.vec2({0, 1, 1, 1, 0, 0});
    p["attributes"]["TEXCOORD_1"] = b.accessor<std::uint8_t>({0, 255, 255, 255, 0, 0}, "VEC2", 2, true);
    p["attributes"]["COLOR_0"] = b.accessor<std::uint16_t>(std::vector<std::uint16_t>(12, 50000), "VEC4", 4, true);
    p["indices"] = b.accessor<std::uint16_t>({0, 1, 2}, "SCALAR", 1);
    p["material"] = 0;
    b.push("images", {{"bufferView", b.view(plainPng(8, SPNG_COLOR_TYPE_TRUECOLOR_ALPHA, 64))}});
    b.push("samplers", {{"wrapS", 33071}, {"wrapT", 33648}, {"magFilter", 9728}, {"minFilter", 9987}});
    b.push("textures", {{"source", 0}, {"sampler", 0}});
    const Json moved = {
        {"KHR_texture_transform", {{"offset", {0.5, 0.25}}, {"rotation", 1.5}, {"scale", {2, -3}}, {"texCoord", 1}}}};
    b.push("materials", {{"pbrMetallicRoughness",
                          {{"baseColorFactor", {1, 0.5, 0.25, 0.75}},
                           {"metallicFactor", 0.5},
                           {"roughnessFactor", 0.5},
                           {"baseColorTexture", {{"index", 0}, {"extensions", moved}}},
                           {"metallicRoughnessTexture", {{"index", 0}}}}},
                         {"normalTexture", {{"index", 0}, {"scale", 2}}},
                         {"emissiveTexture", {{"index", 0}, {"texCoord", 1}}},
                         {"emissiveFactor", {1, 1, 0.5}},
                         {"alphaMode", "MASK"},
                         {"alphaCutoff", 0.25},
                         {"doubleSided", true},
                         {"extensions", {{"KHR_materials_emissive_strength", {{"emissiveStrength", 4}}}}}});
    b.push("cameras", {{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"aspectRatio", 1.5}, {"znear", 1}}}});
    b.push("cameras",
           {{"type", "orthographic"}, {"orthographic", {{"xmag", 1}, {"ymag", 2}, {"znear", 0}, {"zfar", 9}}}});
    b.json["extensionsUsed"] = {"KHR_texture_transform", "KHR_materials_emissive_strength", "KHR_lights_punctual"};
    b.json["extensions"] = {
        {"KHR_lights_punctual",
         {{"lights",
           {{{"type", "point"}, {"range", 5}},
            {{"type", "spot"}, {"spot", {{"innerConeAngle", 0.1}, {"outerConeAngle", 0.7}}}, {"intensity", 3}},
            {{"type", "directional"}, {"color", {1, 0.5, 0}}}}}}}};
    for (int i = 0; i < 3; ++i)
        b.push("nodes", {{"camera", i % 2},
                         {"rotation", {0, 0.6, 0, 0.8}},
                         {"scale", {1, -2, 1}},
                         {"translation", {i, 1, 2}},
                         {"extensions", {{"KHR_lights_punctual", {{"light", i}}}}}});
    b.json["nodes"][0]["children"] = {1, 2, 3};
    b.json["scene"] = 0;
    return b.glb();
}

/// Every primitive mode, sparse and quantised accessors, one mesh placed often, an external and a data URI.
Bytes geometry() {
    Builder b;
    for (int mode = 0; mode < 7; ++mode)
        b.primitive({{"POSITION", b.vec3({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 2, 0, 1, 2, 1, 1})}})["mode"] = mode;
    Json& quantised =
        b.primitive({{"POSITION", b.accessor<std::int16_t>({0, 0, 0, 0, 9, 0, 0, 0, 0, 9, 0, 0}, "VEC3", 4)},
                     {"NORMAL", b.accessor<std::int8_t>({0, 0, 127, 0, 0, 0, 127, 0, 0, 0, 127, 0}, "VEC3", 4, true)}});
    for (const char* attribute : {"POSITION", "NORMAL"}) {
        const auto accessor = quantised["attributes"][attribute].get<std::size_t>();
        const auto view = b.json["accessors"][accessor]["bufferView"].get<std::size_t>();
        b.json["bufferViews"][view]["byteStride"] = attribute == std::string("NORMAL") ? 4 : 8;
    }
    b.json["accessors"][0]["sparse"] = {
        {"count", 2},
        {"indices", {{"bufferView", b.view(std::vector<std::uint8_t>{1, 4})}, {"componentType", 5121}}},
        {"values", {{"bufferView", b.view(std::vector<float>{3, 3, 3, 4, 4, 4})}}}};
    for (int i = 0; i < 4; ++i)
        b.push("nodes", {{"mesh", 4}, {"matrix", {i % 2 == 0 ? -1 : 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 5, i, 0, 1}}});
    for (int i = 8; i < 12; ++i) b.json["scenes"][0]["nodes"].push_back(i);
    b.push("scenes", {{"nodes", {11}}});
    b.json["extensionsUsed"] = {"KHR_mesh_quantization"};
    b.json["extensionsRequired"] = {"KHR_mesh_quantization"};
    const std::string text = b.text();
    return {text.begin(), text.end()};
}

/// A textured, blended, unlit quad whose picture is a JPEG.
Bytes picture() {
    Builder b;
    Json& p = b.primitive(
        {{"POSITION", b.vec3({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0})}, {"TEXCOORD_0", b.vec2({0, 1, 1, 1, 1, 0, 0, 0})}});
    p["indices"] = b.accessor<std::uint8_t>({0, 1, 2, 0, 2, 3}, "SCALAR", 1);
    const int view = b.view(encodeJpeg(8, 8, 3, JCS_RGB, Bytes(192, 90)));
    b.textured({{"bufferView", view}, {"mimeType", "image/jpeg"}});
    b.json["materials"][0]["alphaMode"] = "BLEND";
    b.json["materials"][0]["extensions"] = {{"KHR_materials_unlit", Json::object()}};
    b.json["extensionsUsed"] = {"KHR_materials_unlit"};
    return b.glb();
}

Image gradient(std::uint32_t channels) {
    Image image(9, 5, channels);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = static_cast<float>(i) / 16;
    return image;
}

Bytes bytesOf(const std::vector<std::byte>& bytes) {
    const auto* first = reinterpret_cast<const std::uint8_t*>(bytes.data());
    return {first, first + bytes.size()};
}

void addExr(std::vector<Seed>& seeds) {
    const TemporaryFolder folder;
    const std::string file = (folder / "a.exr").string();
    const std::vector<Imf::Rgba> pixels(10 * 6, Imf::Rgba(1, 2, 3, 0.5F));
    for (int c = 0; c < Imf::NUM_COMPRESSION_METHODS; ++c) {
        Imf::Header header(10, 6);
        header.compression() = static_cast<Imf::Compression>(c);
        {
            Imf::RgbaOutputFile out(file.c_str(), header, c % 2 == 0 ? Imf::WRITE_RGBA : Imf::WRITE_YCA);
            out.setFrameBuffer(pixels.data(), 1, 10);
            out.writePixels(6);
        }
        seeds.push_back({"scanline" + std::to_string(c) + ".exr", readBytes(file)});
        {
            Imf::TiledRgbaOutputFile out(file.c_str(), header, Imf::WRITE_RGBA, 4, 4, Imf::MIPMAP_LEVELS);
            for (int level = 0; level < out.numLevels(); ++level) {
                out.setFrameBuffer(pixels.data(), 1, 10);
                out.writeTiles(0, out.numXTiles(level) - 1, 0, out.numYTiles(level) - 1, level);
            }
        }
        seeds.push_back({"tiled" + std::to_string(c) + ".exr", readBytes(file)});
    }
}

}  // namespace

std::vector<Seed> sceneSeeds() {
    std::vector<Seed> seeds{
        {"everything.glb", everything()}, {"geometry.gltf", geometry()}, {"picture.glb", picture()}};
    for (const auto& entry : std::filesystem::directory_iterator(VKPT_SCENES))
        if (std::filesystem::exists(entry.path() / "scene.gltf"))
            seeds.push_back({entry.path().filename().string() + ".glb", packScene(entry.path())});
    return seeds;
}

std::vector<Seed> imageSeeds() {
    std::vector<Seed> seeds{{"rgb.hdr", bytesOf(encodeHdr(gradient(3)))},
                            {"rgb.pfm", bytesOf(encodePfm(gradient(3)))},
                            {"rgba.exr", bytesOf(encodeExr(gradient(4), {{"note", "text"}}))},
                            {"grey1.png", plainPng(1, SPNG_COLOR_TYPE_GRAYSCALE, 4)},
                            {"grey16.png", plainPng(16, SPNG_COLOR_TYPE_GRAYSCALE_ALPHA, 64)},
                            {"rgb16.png", plainPng(16, SPNG_COLOR_TYPE_TRUECOLOR, 96)},
                            {"rgba8.png", plainPng(8, SPNG_COLOR_TYPE_TRUECOLOR_ALPHA, 64)},
                            {"rgb.jpg", encodeJpeg(24, 9, 3, JCS_RGB, Bytes(648, 90))},
                            {"grey.jpg", encodeJpeg(9, 9, 1, JCS_GRAYSCALE, Bytes(81, 90), true)},
                            {"cmyk.jpg", encodeJpeg(8, 8, 4, JCS_CMYK, Bytes(256, 90))}};
    const spng_plte palette{2, {{1, 2, 3, 255}, {4, 5, 6, 255}}};
    seeds.push_back({"palette.png", encodePng({4, 4, 8, SPNG_COLOR_TYPE_INDEXED, Bytes(16, 1)}, &palette)});
    addExr(seeds);
    return seeds;
}

std::vector<Seed> corpus(const std::string& name) {
    std::vector<Seed> seeds;
    const std::filesystem::path folder = std::filesystem::path(VKPT_SOURCE) / "tests" / "fuzz" / "corpus" / name;
    if (!std::filesystem::exists(folder)) return seeds;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        seeds.push_back({entry.path().filename().string(), readBytes(entry.path())});
    return seeds;
}

}  // namespace vkpt::fuzz
