// The one rule for faulty files, held against the Khronos validator's corpus and others: a fault in what vkpt reads is
// refused, one elsewhere is not. The validator's reports say what is wrong; what vkpt reads is written down here.
#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include "builder.h"

namespace vkpt::test {
namespace {

const std::filesystem::path kMalformed = std::filesystem::path(VKPT_ASSETS) / "malformed";

/// One message of a report with severity "error".
struct Fault {
    std::string code, pointer;
};

/// Faults of parts that vkpt does not look at, whatever they are.
bool isElsewhere(const std::string& pointer) {
    static constexpr std::array kParts = {"/animations",       "/skins", "/targets", "/weights",     "/skin",
                                          "/occlusionTexture", "/zfar",  "/znear",   "/extensions/", "/_CUSTOM_ATTR"};
    const bool honoured = pointer.find("/KHR_materials_emissive_strength/") != std::string::npos ||
                          pointer.find("/KHR_lights_punctual/") != std::string::npos;
    return !honoured && std::any_of(kParts.begin(), kParts.end(),
                                    [&](const char* part) { return pointer.find(part) != std::string::npos; });
}

/// Faults that leave no doubt of what is meant, or that concern what only other programs need.
bool isHarmless(const std::string& code) {
    static constexpr std::array kCodes = {"EMPTY_ENTITY",
                                          "DUPLICATE_ELEMENTS",
                                          "UNDECLARED_EXTENSION",
                                          "UNEXPECTED_EXTENSION_OBJECT",
                                          "GLB_CHUNK_LENGTH_UNALIGNED",
                                          "GLB_DUPLICATE_CHUNK",
                                          "GLB_UNEXPECTED_BIN_CHUNK",
                                          "CAMERA_ZFAR_LEQUAL_ZNEAR"};
    return std::find(kCodes.begin(), kCodes.end(), code) != kCodes.end();
}

/// Faults of data: buffers, accessors, images and how meshes use them. They count where something is drawn; none of
/// the files with such a fault has a scene that places it.
bool isOfData(const std::string& code) {
    static constexpr std::array kPrefixes = {"ACCESSOR_", "BUFFER_",  "MESH_",      "IMAGE_",
                                             "TEXTURE_",  "IO_ERROR", "INVALID_URI"};
    return std::any_of(kPrefixes.begin(), kPrefixes.end(), [&](const char* p) { return code.starts_with(p); });
}

std::vector<Fault> faultsIn(const std::filesystem::path& report) {
    std::vector<Fault> faults;
    const Json json = Json::parse(readText(report));
    for (const Json& message : json["issues"]["messages"])
        if (message["severity"] == 0) faults.push_back({message["code"], message.value("pointer", "")});
    return faults;
}

bool mustBeRefused(const std::vector<Fault>& faults) {
    return std::any_of(faults.begin(), faults.end(), [](const Fault& fault) {
        return !isElsewhere(fault.pointer) && !isHarmless(fault.code) && !isOfData(fault.code);
    });
}

/// Files without a report, and valid ones that vkpt cannot show: whether each is to be refused.
std::optional<bool> known(const std::filesystem::path& file) {
    static const std::map<std::string, bool> kKnown = {
        {"min_version_valid.gltf", true},  // needs glTF 2.1
        {"undefined_used_extensions.gltf", true},
        {"unused_objects.gltf", true},  // draws out of a buffer without data
        {"named_objects.gltf", true},   // likewise
        {"infinite_znear.gltf", true},  // 1e309 is no number that JSON parsers can hold
        {"node_skin_without_skinned_mesh.gltf", false},
        {"IndexOutOfRange.gltf", true},
        {"BoxTextured.gltf", true},  // its files are missing
        {"RecursiveNodes.gltf", true},
        {"BoxBadNormals.glb", true},
        {"NoScene.gltf", true},  // states a scene that is not there
        {"SceneWithoutNodes.gltf", false},
        {"texcoord_crash.gltf", true},
        {"badArray.gltf", true},
        {"badExtension.gltf", true},
        {"badNumber.gltf", true},
        {"invalid-buffer-index.gltf", true},
        {"invalid-buffer-view-index.gltf", true},
        {"zero-sized-bin-chunk-issue-440.glb", false},
        {"issue-416.gltf", true},
        {"minimal_accessor_invalid.gltf", false},  // lacks min and max, which vkpt does not read
        {"fuzz.glb", false}};
    const auto found = kKnown.find(file.filename().string());
    return found == kKnown.end() ? std::nullopt : std::optional(found->second);
}

TEST(Malformed, EveryFileFollowsTheRule) {
    if (!std::filesystem::exists(kMalformed)) GTEST_SKIP() << "no malformed files: " << kMalformed << " is absent";
    int refused = 0, taken = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(kMalformed)) {
        const std::filesystem::path& file = entry.path();
        if (file.extension() != ".gltf" && file.extension() != ".glb") continue;
        SCOPED_TRACE(file.string());
        const std::filesystem::path report = file.string() + ".report.json";
        ASSERT_TRUE(known(file) || std::filesystem::exists(report)) << "what should become of it?";
        const bool expected = known(file) ? *known(file) : mustBeRefused(faultsIn(report));
        std::string fault;
        try {
            (void)importGltf(file);
        } catch (const FileError& error) {
            fault = error.what();
        }
        EXPECT_EQ(!fault.empty(), expected) << fault;
        EXPECT_EQ(fault.find('\n'), std::string::npos) << fault;
        EXPECT_TRUE(fault.empty() || fault.starts_with(file.string() + ": ")) << fault;
        ++(fault.empty() ? taken : refused);
    }
    EXPECT_GT(refused, 50);
    EXPECT_GT(taken, 100);
}

}  // namespace
}  // namespace vkpt::test
