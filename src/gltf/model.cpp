#include "gltf/model.h"

#include <algorithm>
#include <array>

namespace vkpt::gltf {
namespace {

/// The file as it stands, for tinygltf's callback too.
struct Source {
    const Document& document;
    const Json& root;
    std::optional<std::span<const unsigned char>> bin;
    /// False: a buffer that only an ignored extension fills. An error where something reads it.
    [[nodiscard]] bool hasData(std::size_t buffer) const {
        return root["buffers"][buffer].contains("uri") || (buffer == 0 && bin);
    }
};

// What tinygltf takes on trust or would refuse without saying where.
void check(const Source& source) {
    const auto& [document, root, bin] = source;
    static constexpr std::array kTypes = {"SCALAR", "VEC2", "VEC3", "VEC4", "MAT2", "MAT3", "MAT4"};
    static constexpr std::array kComponents = {5120, 5121, 5122, 5123, 5125, 5126};
    const auto each = [&](const char* section, auto&& visit) {
        const Json& items = member(root, section);
        for (std::size_t i = 0; i < items.size(); ++i) visit(i, items[i]);
    };
    each("accessors", [&](std::size_t i, const Json& accessor) {
        const auto& type = accessor["type"].get_ref<const std::string&>();
        if (std::find(kTypes.begin(), kTypes.end(), type) == kTypes.end())
            document.fail("accessors[{}].type: {} is none of glTF's", i, type);
        const int component = accessor["componentType"].get<int>();
        if (std::find(kComponents.begin(), kComponents.end(), component) == kComponents.end())
            document.fail("accessors[{}].componentType: {} is none of glTF's", i, component);
    });
    each("bufferViews", [&](std::size_t i, const Json& view) {
        const auto buffer = view["buffer"].get<std::size_t>(), length = view["byteLength"].get<std::size_t>();
        const auto offset = view.value("byteOffset", std::size_t{0});
        const auto held = root["buffers"][buffer]["byteLength"].get<std::size_t>();
        if (offset > held || length > held - offset)
            document.fail("bufferViews[{}]: needs {} bytes at offset {}, but buffers[{}] holds {}", i, length, offset,
                          buffer, held);
    });
    each("images", [&](std::size_t i, const Json& image) {
        if (!image.contains("uri") && !image.contains("bufferView"))
            document.fail("images[{}]: has neither uri nor bufferView", i);
        if (image.contains("uri")) return;
        const auto view = image["bufferView"].get<std::size_t>();
        const auto buffer = root["bufferViews"][view]["buffer"].get<std::size_t>();
        if (!source.hasData(buffer))
            document.fail("buffers[{}]: has no data, but bufferViews[{}] reads it", buffer, view);
    });
    each("cameras", [&](std::size_t i, const Json& camera) {
        const auto& type = camera["type"].get_ref<const std::string&>();
        if ((type != "perspective" && type != "orthographic") || !camera.contains(type))
            document.fail("cameras[{}]: must be perspective or orthographic and have the object of that name", i);
    });
}

// The JSON without what tinygltf 2.7 refuses although it is valid or harmless: strides that are no multiple of 4,
// indices without a buffer view, cameras without clipping planes, spots that are all default, skins (emptied by the
// schema). URIs are vkpt's own matter: tinygltf takes + for a space, looks in the working directory too and knows few
// data URIs.
std::string palatable(const Source& source) {
    Json root = source.root;
    for (std::size_t i = 0; i < root["buffers"].size(); ++i) {
        if (!source.hasData(i)) root["buffers"][i]["byteLength"] = 1;
        root["buffers"][i]["uri"] = std::to_string(i);
    }
    for (Json& view : root["bufferViews"]) view.erase("byteStride");
    for (Json& mesh : root["meshes"])
        for (Json& primitive : mesh["primitives"]) primitive.erase("indices");
    for (Json& image : root["images"])
        if (image.contains("uri")) image = {{"uri", "elsewhere"}, {"name", image.value("name", "")}};
    for (Json& camera : root["cameras"]) camera[camera["type"].get<std::string>()].update({{"znear", 0}, {"zfar", 0}});
    for (Json& light : root["extensions"]["KHR_lights_punctual"]["lights"]) light.emplace("spot", Json::object());
    for (Json& skin : root["skins"]) skin["joints"] = Json::array();
    return root.dump();
}

// Puts back what `palatable` took away.
void restore(const Source& source, tinygltf::Model& model) {
    const Json& root = source.root;
    for (std::size_t i = 0; i < model.buffers.size(); ++i)
        if (!source.hasData(i)) model.buffers[i].data.clear();
    for (std::size_t i = 0; i < model.bufferViews.size(); ++i)
        model.bufferViews[i].byteStride = root["bufferViews"][i].value("byteStride", std::size_t{0});
    for (std::size_t i = 0; i < model.meshes.size(); ++i)
        for (std::size_t p = 0; p < model.meshes[i].primitives.size(); ++p)
            model.meshes[i].primitives[p].indices = root["meshes"][i]["primitives"][p].value("indices", -1);
    for (std::size_t i = 0; i < model.images.size(); ++i) model.images[i].uri = root["images"][i].value("uri", "");
}

bool readBuffer(Bytes* bytes, std::string*, const std::string& name, void* user) {
    const Source& source = *static_cast<const Source*>(user);
    const std::size_t index = std::stoul(name);
    const std::string place = fmt::format("buffers[{}]", index);
    const Json& buffer = source.root["buffers"][index];
    if (!source.hasData(index)) {
        bytes->resize(1);  // tinygltf knows no empty buffers
        return true;
    }
    if (buffer.contains("uri"))
        *bytes = source.document.readUri(buffer["uri"].get_ref<const std::string&>(), place);
    else
        bytes->assign(source.bin->begin(), source.bin->end());
    const auto stated = buffer["byteLength"].get<std::size_t>();
    if (stated > bytes->size())
        source.document.fail("{}: states {} bytes, but its data holds {}", place, stated, bytes->size());
    bytes->resize(stated);
    return true;
}

// Decoding waits for all cores.
bool keepEncoded(tinygltf::Image* image, int, std::string*, std::string*, int, int, const unsigned char* bytes,
                 int size, void*) {
    image->as_is = true;
    image->image.assign(bytes, bytes + static_cast<unsigned>(size));
    return true;
}

}  // namespace

tinygltf::Model loadModel(const Document& document, const Json& root,
                          std::optional<std::span<const unsigned char>> bin) {
    Source source{document, root, bin};
    check(source);
    tinygltf::TinyGLTF loader;
    loader.SetFsCallbacks({[](const std::string&, void*) { return true; },
                           [](const std::string& name, void*) { return name; }, readBuffer, nullptr, &source});
    loader.SetImageLoader(keepEncoded, nullptr);

    const std::string text = palatable(source);
    tinygltf::Model model;
    std::string error, warning;
    if (!loader.LoadASCIIFromString(&model, &error, &warning, text.data(), static_cast<unsigned>(text.size()), ""))
        document.fail("{}", error.substr(0, error.find('\n')));
    restore(source, model);
    return model;
}

double numberOr(const tinygltf::Value& object, const std::string& key, double fallback) {
    return object.Has(key) ? object.Get(key).GetNumberAsDouble() : fallback;
}

const tinygltf::Value& extension(const tinygltf::ExtensionMap& extensions, const std::string& name) {
    static const tinygltf::Value kNone;
    const auto found = extensions.find(name);
    return found == extensions.end() ? kNone : found->second;
}

}  // namespace vkpt::gltf
