// Files, containers, URIs, the schema, extensions.
#include "builder.h"

namespace vkpt::test {
namespace {

using testing::HasSubstr;

// A triangle whose buffer is the file `uri` points to.
std::string withBufferUri(const Builder& builder, const std::string& uri) {
    Json json = builder.json;
    json["buffers"] = {{{"byteLength", builder.bytes().size()}, {"uri", uri}}};
    return json.dump();
}

std::size_t triangleCount(const Scene& scene) { return scene.meshes.at(0).primitives.at(0).triangles.size(); }

class DocumentTest : public testing::Test {
protected:
    DocumentTest() { builder.triangle(); }
    std::string faultOfUri(const std::string& uri) const {
        return faultOf([&] { (void)importGltf(folder.write("scene.gltf", withBufferUri(builder, uri))); });
    }
    std::string faultOfBytes(const ByteVector& bytes) const {
        return faultOf([&] { (void)importGltf(folder.write("scene.glb", bytes)); });
    }
    TemporaryFolder folder;
    Builder builder;
};

TEST_F(DocumentTest, ReadsDataUri) { EXPECT_EQ(triangleCount(builder.import()), 1U); }

TEST_F(DocumentTest, ReadsGlbWhateverItsName) {
    EXPECT_EQ(triangleCount(importGltf(folder.write("a.glb", builder.glb()))), 1U);
    EXPECT_EQ(triangleCount(importGltf(folder.write("b.gltf", builder.glb()))), 1U);
}

TEST_F(DocumentTest, IgnoresUnknownGlbChunks) {
    ByteVector bytes = builder.glb();
    bytes.insert(bytes.end(), {4, 0, 0, 0, 'X', 'Y', 'Z', 'W', 1, 2, 3, 4});
    bytes[8] = static_cast<std::uint8_t>(bytes.size());
    bytes[9] = static_cast<std::uint8_t>(bytes.size() >> 8);
    EXPECT_EQ(triangleCount(importGltf(folder.write("a.glb", bytes))), 1U);
}

TEST_F(DocumentTest, ReadsExternalBuffersByEncodedUnicodeAndPlusNames) {
    for (const auto& [name, uri] :
         std::vector<std::pair<std::string, std::string>>{{"plain.bin", "plain.bin"},
                                                          {"with space.bin", "with%20space.bin"},
                                                          {"with space.bin", "with space.bin"},
                                                          {"a+b.bin", "a+b.bin"},
                                                          {"100%.bin", "100%.bin"},
                                                          {"sub/dir/x.bin", "sub/dir/x.bin"},
                                                          {"x.bin", "sub/../x.bin"},
                                                          {"x.bin", "./x.bin"},
                                                          {"Ünï❤♻.bin", "Ünï❤♻.bin"},
                                                          {"❤.bin", "%E2%9D%A4.bin"}}) {
        SCOPED_TRACE(uri);
        folder.write(name, builder.bytes());
        EXPECT_EQ(triangleCount(importGltf(folder.write("Szene ❤.gltf", withBufferUri(builder, uri)))), 1U);
    }
}

TEST_F(DocumentTest, RefusesUrisThatLeaveTheFolder) {
    const std::filesystem::path outside = folder.path().parent_path() / (folder.path().filename().string() + ".bin");
    for (const std::string& uri :
         {std::string("../x.bin"), std::string("a/../../x.bin"), std::string("%2E%2E/x.bin"), std::string("..%2Fx.bin"),
          std::string("/etc/hostname"), std::string("%2Fetc/hostname"), "file://" + outside.string(),
          std::string("http://example.com/x.bin"), std::string("FILE:x.bin"), std::string("x%00.bin"),
          std::string("")}) {
        SCOPED_TRACE(uri);
        EXPECT_THAT(faultOfUri(uri), HasSubstr("scene.gltf: buffers[0]: uri \""));
    }
}

TEST_F(DocumentTest, LinksCountWhereTheyLead) {
    namespace fs = std::filesystem;
    const TemporaryFolder elsewhere;
    folder.write("here/x.bin", builder.bytes());
    fs::create_symlink(elsewhere.write("x.bin", builder.bytes()), folder / "file.bin");
    fs::create_directory_symlink(elsewhere.path(), folder / "out");
    fs::create_directory_symlink(folder / "here", folder / "in");
    EXPECT_THAT(faultOfUri("file.bin"), HasSubstr("buffers[0]: uri \"file.bin\" leaves the scene's folder"));
    EXPECT_THAT(faultOfUri("out/x.bin"), HasSubstr("leaves the scene's folder"));
    EXPECT_THAT(faultOfUri("in/../out/x.bin"), HasSubstr("leaves the scene's folder"));
    EXPECT_EQ(triangleCount(importGltf(folder.write("a.gltf", withBufferUri(builder, "in/x.bin")))), 1U);
}

TEST_F(DocumentTest, AllowExternalReadsAnyFileButFetchesNone) {
    const TemporaryFolder elsewhere;
    const std::string outside = elsewhere.write("a b.bin", builder.bytes()).string();
    std::filesystem::create_symlink(outside, folder / "link.bin");
    const std::string up = "../" + elsewhere.path().filename().string() + "/a%20b.bin";
    for (const std::string& uri : {outside, up, std::string("link.bin"), "file://" + outside, "FILE:" + outside,
                                   "file://localhost" + elsewhere.path().string() + "/a%20b.bin"}) {
        SCOPED_TRACE(uri);
        EXPECT_FALSE(faultOfUri(uri).empty());
        const auto file = folder.write("a.gltf", withBufferUri(builder, uri));
        EXPECT_EQ(triangleCount(importGltf(file, {.allowExternal = true})), 1U);
    }
    const auto fetched = folder.write("b.gltf", withBufferUri(builder, "http://example.com/x.bin"));
    EXPECT_THAT(faultOf([&] { (void)importGltf(fetched, {.allowExternal = true}); }),
                HasSubstr("is no file; fetch it"));
}

TEST_F(DocumentTest, ListsTheFilesItRead) {
    folder.write("x.bin", builder.bytes());
    const Scene scene = importGltf(folder.write("a.gltf", withBufferUri(builder, "x.bin")));
    EXPECT_THAT(scene.files, testing::ElementsAre(folder / "x.bin"));
    EXPECT_TRUE(builder.import().files.empty());
}

TEST_F(DocumentTest, NamesWhatIsMissing) {
    EXPECT_THAT(faultOf([&] { (void)importGltf(folder.path() / "none.gltf"); }), HasSubstr("none.gltf: no such file"));
    EXPECT_THAT(faultOf([&] { (void)importGltf(folder.path()); }), HasSubstr("is not a file"));
    EXPECT_THAT(faultOfUri("gone.bin"), HasSubstr("scene.gltf: buffers[0]: gone.bin: no such file"));
}

TEST_F(DocumentTest, RefusesShortBuffers) {
    folder.write("short.bin", ByteVector(8));
    EXPECT_THAT(faultOfUri("short.bin"), HasSubstr("buffers[0]: states 36 bytes, but its data holds 8"));
    EXPECT_THAT(faultOfUri("data:,abc"), HasSubstr("buffers[0]: states 36 bytes, but its data holds 3"));
    EXPECT_THAT(faultOfUri("data:;base64,QUJ*"), HasSubstr("not base64"));
}

TEST_F(DocumentTest, TakesBuffersLongerThanStated) {
    ByteVector longer = builder.bytes();
    longer.resize(longer.size() + 5);
    folder.write("longer.bin", longer);
    EXPECT_EQ(triangleCount(importGltf(folder.write("a.gltf", withBufferUri(builder, "longer.bin")))), 1U);
    const std::string uri = "data:any/thing;charset=x;base64," + base64(longer);
    EXPECT_EQ(triangleCount(importGltf(folder.write("b.gltf", withBufferUri(builder, uri)))), 1U);
}

TEST_F(DocumentTest, BuffersWithoutDataAreFaultsOnlyWhereTheyAreRead) {
    builder.json["buffers"] = {{{"byteLength", 36}}};
    const auto file = folder.write("a.gltf", builder.json.dump());
    EXPECT_THAT(faultOf([&] { (void)importGltf(file); }),
                HasSubstr("buffers[0]: has no data, but bufferViews[0] reads it"));
    builder.json["nodes"][0].erase("mesh");
    EXPECT_TRUE(importGltf(folder.write("b.gltf", builder.json.dump())).meshes.empty());
    builder.json["images"] = {{{"bufferView", 0}, {"mimeType", "image/png"}}};
    EXPECT_TRUE(importGltf(folder.write("c.gltf", builder.json.dump())).images.empty());
}

TEST_F(DocumentTest, FilesThatNothingReadsMayBeMissing) {
    builder.json["images"] = {{{"uri", "gone.png"}}, {{"uri", "http://example.com/a.png"}}};
    Json file = Json::parse(builder.text());
    file["buffers"].push_back({{"byteLength", 4}, {"uri", "../gone.bin"}});
    file["bufferViews"].push_back({{"buffer", 1}, {"byteLength", 4}});
    file["accessors"].push_back(
        {{"bufferView", 1}, {"componentType", 5126}, {"type", "LATER"}, {"count", 1}, {"byteOffset", 9}});
    EXPECT_EQ(triangleCount(importGltf(folder.write("a.gltf", file.dump()))), 1U);
}

TEST_F(DocumentTest, EveryTruncationOfAGlbIsRefused) {
    const ByteVector whole = builder.glb();
    for (std::size_t size = 0; size < whole.size(); ++size)
        EXPECT_FALSE(
            faultOfBytes(ByteVector(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size))).empty());
}

TEST_F(DocumentTest, RefusesBrokenGlbHeaders) {
    ByteVector bytes = builder.glb();
    bytes[4] = 1;
    EXPECT_THAT(faultOfBytes(bytes), HasSubstr("GLB: version 1 is not 2"));
    bytes = builder.glb();
    bytes[15] = 0x7f;
    EXPECT_THAT(faultOfBytes(bytes), HasSubstr("GLB: chunk 0 states"));
    bytes = builder.glb();
    bytes[16] = 'j';
    EXPECT_THAT(faultOfBytes(bytes), HasSubstr("first chunk is not JSON"));
}

TEST_F(DocumentTest, RefusesAByteOrderMark) {
    EXPECT_THAT(faultOf([&] { (void)importGltf(folder.write("a.gltf", "\xEF\xBB\xBF" + builder.text())); }),
                HasSubstr("JSON: begins with a byte order mark"));
}

TEST_F(DocumentTest, RefusesWhatIsNoJson) {
    for (const char* text : {"", "{", "[]", "nonsense", "{\"asset\":{\"version\":\"2.0\"},\"scene\":1e999}"}) {
        SCOPED_TRACE(text);
        EXPECT_THAT(faultOf([&] { (void)importGltf(folder.write("scene.gltf", std::string_view(text))); }),
                    HasSubstr("scene.gltf: "));
    }
    const std::string deep(200000, '[');
    EXPECT_THAT(faultOf([&] { (void)importGltf(folder.write("scene.gltf", deep)); }), HasSubstr("JSON"));
}

TEST_F(DocumentTest, SchemaFaultsNameTheirPlace) {
    const auto fault = [](const Json& patch) {
        Builder b;
        b.triangle();
        b.json.merge_patch(patch);
        return faultOf(b);
    };
    EXPECT_THAT(fault({{"asset", nullptr}}), HasSubstr("asset: is missing"));
    EXPECT_THAT(fault({{"asset", {{"version", "1.0"}}}}), HasSubstr("asset.version: 1.0 is not supported"));
    EXPECT_THAT(fault({{"asset", {{"minVersion", "2.1"}}}}), HasSubstr("asset.minVersion"));
    EXPECT_THAT(fault({{"nodes", 7}}), HasSubstr("nodes: must be an array"));
    EXPECT_THAT(fault({{"nodes", {{{"mesh", 3}}}}}), HasSubstr("nodes[0].mesh: 3, but the file has 1 meshes"));
    EXPECT_THAT(fault({{"nodes", {{{"mesh", -1}}}}}), HasSubstr("nodes[0].mesh: must be an index"));
    EXPECT_THAT(fault({{"nodes", {{{"translation", {1, 2}}}}}}),
                HasSubstr("nodes[0].translation: must be an array of 3 numbers"));
    EXPECT_THAT(fault({{"nodes", {{{"scale", {1, 2, "x"}}}}}}), HasSubstr("nodes[0].scale[2]: must be a number"));
    EXPECT_THAT(fault({{"nodes", {{{"scale", {1, 2, 1e300}}}}}}), HasSubstr("nodes[0].scale[2]: must be a number"));
    EXPECT_THAT(fault({{"materials", {{{"normalTexture", {{"index", 0}}}}}}}),
                HasSubstr("materials[0].normalTexture.index: 0, but the file has 0 textures"));
    EXPECT_THAT(fault({{"scene", 2}}), HasSubstr("scene: 2, but the file has 1 scenes"));
    EXPECT_THAT(fault({{"accessors", {{{"componentType", 5126}, {"count", 0}, {"type", "VEC3"}}}}}),
                HasSubstr("accessors[0].count: must be an integer from 1 up"));
    EXPECT_THAT(fault({{"meshes", {{{"primitives", Json::array()}}}}}),
                HasSubstr("meshes[0].primitives: must not be empty"));
}

TEST_F(DocumentTest, OtherVersionsAreToldByTheirVersion) {
    const auto file = folder.write("one.gltf", R"({"asset": {"version": "1.0"}, "buffers": {"b": {}}, "scene": "s"})");
    EXPECT_THAT(faultOf([&] { (void)importGltf(file); }), HasSubstr("asset.version: 1.0 is not supported"));
}

TEST_F(DocumentTest, NumbersOutOfRangeNameTheirPlace) {
    const auto fault = [](const Json& patch) {
        Builder b;
        b.triangle();
        b.json["materials"] = {Json::object()};
        b.json["materials"][0].merge_patch(patch);
        return faultOf(b);
    };
    EXPECT_THAT(fault({{"pbrMetallicRoughness", {{"metallicFactor", 1.5}}}}),
                HasSubstr("materials[0].pbrMetallicRoughness.metallicFactor: 1.5 is not between 0 and 1"));
    EXPECT_THAT(fault({{"pbrMetallicRoughness", {{"baseColorFactor", {1, 1, -1, 1}}}}}),
                HasSubstr("baseColorFactor[2]: -1 is not between 0 and 1"));
    EXPECT_THAT(fault({{"emissiveFactor", {0, 2, 0}}}), HasSubstr("materials[0].emissiveFactor[1]: 2"));
    EXPECT_THAT(fault({{"alphaCutoff", -0.5}}), HasSubstr("materials[0].alphaCutoff: -0.5 is not 0 or more"));
    EXPECT_THAT(fault({{"extensions", {{"KHR_materials_emissive_strength", {{"emissiveStrength", -1}}}}}}),
                HasSubstr("emissiveStrength: -1 is not 0 or more"));
}

TEST_F(DocumentTest, HarmlessSlipsAreWarnings) {
    builder.json["extensionsUsed"] = {"KHR_texture_transform", "KHR_texture_transform"};
    builder.json["materials"] = {{{"extensions", {{"KHR_materials_unlit", Json::object()}}}}};
    builder.json["animations"] = builder.json["skins"] = builder.json["cameras"] = Json::array();
    EXPECT_THAT(builder.import().warnings,
                testing::ElementsAre(HasSubstr("names KHR_texture_transform more than once"),
                                     HasSubstr("does not name KHR_materials_unlit, which the file uses")));
}

TEST_F(DocumentTest, NamesCannotBreakALineOrSteerATerminal) {
    builder.json["extensionsRequired"] = {"EXT_\n\x1b[2Jx"};
    EXPECT_THAT(faultOf(builder), HasSubstr("needs EXT_??[2Jx, which"));
    builder.json["extensionsUsed"] = builder.json["extensionsRequired"];
    builder.json.erase("extensionsRequired");
    EXPECT_THAT(builder.import().warnings, testing::ElementsAre(HasSubstr("EXT_??[2Jx is not supported")));
}

TEST_F(DocumentTest, TakesIntegersInFloatingPointForm) {
    builder.json["accessors"][0]["count"] = 3.0;
    builder.json["accessors"][0]["componentType"] = 5126.0;
    EXPECT_EQ(triangleCount(builder.import()), 1U);
}

TEST_F(DocumentTest, RefusesIntegersThatWouldWrapAround) {
    builder.json["meshes"][0]["primitives"][0]["mode"] = 4294967300;  // 2^32 + 4
    EXPECT_THAT(faultOf(builder), HasSubstr("meshes[0].primitives[0].mode: must be an integer from 0 to 2147483647"));
}

TEST_F(DocumentTest, DeepJsonThatNothingReadsDoesNoHarm) {
    const std::string deep = std::string(200000, '[') + std::string(200000, ']');
    builder.json["meshes"][0]["primitives"][0]["targets"] = "DEEP";
    builder.json["asset"]["extras"] = "DEEP";
    std::string text = builder.text();
    for (std::size_t at = text.find("\"DEEP\""); at != std::string::npos; at = text.find("\"DEEP\"", at))
        text.replace(at, 6, deep);
    EXPECT_EQ(triangleCount(importGltf(folder.write("scene.gltf", text))), 1U);
}

TEST_F(DocumentTest, RequiredExtensionsMustBeSupported) {
    builder.json["extensionsUsed"] = {"KHR_texture_transform", "EXT_unheard_of"};
    builder.json["extensionsRequired"] = {"KHR_texture_transform"};
    const Scene scene = builder.import();
    ASSERT_EQ(scene.extensions.size(), 2U);
    EXPECT_EQ(scene.extensions[0].support, "honoured");
    EXPECT_TRUE(scene.extensions[0].required);
    EXPECT_EQ(scene.extensions[1].support, "ignored");
    EXPECT_FALSE(scene.extensions[1].required);
    EXPECT_THAT(scene.warnings, testing::ElementsAre(HasSubstr("EXT_unheard_of")));

    builder.json["extensionsRequired"].push_back("EXT_unheard_of");
    EXPECT_THAT(faultOf(builder), HasSubstr("EXT_unheard_of"));
}

TEST_F(DocumentTest, ReportsIgnoredFeatures) {
    builder.json["animations"] = {Json::object()};
    builder.json["skins"] = {Json::object()};
    builder.json["meshes"][0]["primitives"][0]["targets"] = {Json::object()};
    const Scene scene = builder.import();
    EXPECT_THAT(scene.ignored, testing::ElementsAre("animations", "skins", "morph targets"));
    EXPECT_EQ(scene.warnings.size(), 3U);
    EXPECT_EQ(triangleCount(scene), 1U);
}

TEST_F(DocumentTest, SameFaultEveryTimeHoweverManyThreads) {
    for (int i = 0; i < 50; ++i) builder.triangle()["indices"] = builder.accessor<std::uint8_t>({0, 1, 9}, "SCALAR", 1);
    for (int i = 0; i < 20; ++i) EXPECT_THAT(faultOf(builder), HasSubstr("meshes[1].primitives[0].indices"));
}

}  // namespace
}  // namespace vkpt::test
