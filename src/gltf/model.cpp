#include "gltf/model.h"

#include <algorithm>
#include <array>

namespace vkpt::gltf {
namespace {

constexpr std::array kTypes = {"SCALAR", "VEC2", "VEC3", "VEC4", "MAT2", "MAT3", "MAT4"};
constexpr std::array kComponents = {5120, 5121, 5122, 5123, 5125, 5126};

template <typename Known, typename Value>
bool isOneOf(const Known& known, const Value& value) {
    return std::find(known.begin(), known.end(), value) != known.end();
}

// The JSON without what tinygltf 2.7 refuses although it is valid or harmless: strides that are no multiple of 4,
// indices without a buffer view, types that later versions may add, cameras without clipping planes, spots that are all
// default, skins (emptied by the schema). Buffers and images are vkpt's own matter: tinygltf would read them all, takes
// + for a space, looks in the working directory too and knows few data URIs.
std::string palatable(Json root) {
    for (Json& buffer : root["buffers"]) buffer = {{"byteLength", 1}, {"uri", "elsewhere"}};
    for (Json& view : root["bufferViews"]) view.erase("byteStride");
    for (Json& accessor : root["accessors"]) {
        if (!isOneOf(kTypes, accessor["type"])) accessor["type"] = kTypes.front();
        if (!isOneOf(kComponents, accessor["componentType"])) accessor["componentType"] = kComponents.front();
    }
    for (Json& mesh : root["meshes"])
        for (Json& primitive : mesh["primitives"]) primitive.erase("indices");
    for (Json& image : root["images"]) image = {{"uri", "elsewhere"}, {"name", image.value("name", "")}};
    for (Json& camera : root["cameras"]) camera[camera["type"].get<std::string>()].update({{"znear", 0}, {"zfar", 0}});
    for (Json& light : root["extensions"]["KHR_lights_punctual"]["lights"]) light.emplace("spot", Json::object());
    for (Json& skin : root["skins"]) skin["joints"] = Json::array();
    return root.dump();
}

// Puts back what `palatable` took away.
void restore(const Json& root, tinygltf::Model& model) {
    for (std::size_t i = 0; i < model.bufferViews.size(); ++i)
        model.bufferViews[i].byteStride = root["bufferViews"][i].value("byteStride", std::size_t{0});
    for (std::size_t i = 0; i < model.accessors.size(); ++i) {
        const Json& accessor = root["accessors"][i];
        if (!isOneOf(kTypes, accessor["type"])) model.accessors[i].type = kUnknown;
        if (!isOneOf(kComponents, accessor["componentType"])) model.accessors[i].componentType = kUnknown;
    }
    for (std::size_t i = 0; i < model.meshes.size(); ++i)
        for (std::size_t p = 0; p < model.meshes[i].primitives.size(); ++p)
            model.meshes[i].primitives[p].indices = root["meshes"][i]["primitives"][p].value("indices", -1);
    for (std::size_t i = 0; i < model.images.size(); ++i) {
        model.images[i].uri = root["images"][i].value("uri", "");
        model.images[i].bufferView = root["images"][i].value("bufferView", -1);
    }
}

}  // namespace

tinygltf::Model loadModel(const Document& document, const Json& root) {
    tinygltf::TinyGLTF loader;
    loader.SetFsCallbacks({[](const std::string&, void*) { return true; },
                           [](const std::string& name, void*) { return name; },
                           [](Bytes* bytes, std::string*, const std::string&, void*) {
                               bytes->resize(1);
                               return true;
                           },
                           nullptr, nullptr});
    const std::string text = palatable(root);
    tinygltf::Model model;
    std::string error, warning;
    if (!loader.LoadASCIIFromString(&model, &error, &warning, text.data(), static_cast<unsigned>(text.size()), ""))
        document.fail("{}", error.substr(0, error.find('\n')));
    restore(root, model);
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
