// Small glTF files for the importer's tests: built in memory, written to a folder of the test's own.
#pragma once
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <concepts>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "gltf/import.h"
#include "temporary_folder.h"

namespace vkpt::test {

using Json = nlohmann::json;
using ByteVector = std::vector<std::uint8_t>;

/// glTF's componentType of a C++ type.
template <typename T>
constexpr int componentType() {
    if constexpr (std::is_same_v<T, std::int8_t>) return 5120;
    if constexpr (std::is_same_v<T, std::uint8_t>) return 5121;
    if constexpr (std::is_same_v<T, std::int16_t>) return 5122;
    if constexpr (std::is_same_v<T, std::uint16_t>) return 5123;
    if constexpr (std::is_same_v<T, std::uint32_t>) return 5125;
    return 5126;
}

[[nodiscard]] std::string base64(const ByteVector& bytes);

/// A glTF file in the making. `json` may be edited at will between the calls.
class Builder {
public:
    Json json = {{"asset", {{"version", "2.0"}}}};

    Builder() = default;
    /// Of a file that has one buffer, `bytes`.
    Builder(Json file, ByteVector bytes) : json(std::move(file)), bytes_(std::move(bytes)) {}

    /// Appends to the binary buffer, aligned to 4; returns the index of the new bufferView.
    int view(const void* data, std::size_t bytes, int stride = 0);
    template <typename T>
    int view(const std::vector<T>& data, int stride = 0) {
        return view(data.data(), data.size() * sizeof(T), stride);
    }
    /// Accessor of `type` over a view of its own.
    template <typename T>
    int accessor(const std::vector<T>& values, const char* type, std::size_t components, bool normalized = false) {
        return push("accessors", {{"bufferView", view(values)},
                                  {"componentType", componentType<T>()},
                                  {"count", values.size() / components},
                                  {"normalized", normalized},
                                  {"type", type}});
    }
    int vec2(const std::vector<float>& values) { return accessor(values, "VEC2", 2); }
    int vec3(const std::vector<float>& values) { return accessor(values, "VEC3", 3); }
    int vec4(const std::vector<float>& values) { return accessor(values, "VEC4", 4); }

    /// Appends to one of the root's arrays; returns the index.
    int push(const char* section, Json item);
    /// A mesh of one primitive with a node of its own in the scene; returns the primitive.
    Json& primitive(Json attributes);
    /// `primitive` of the triangle (0,0,0), (1,0,0), (0,1,0).
    Json& triangle();
    /// A material with one base colour texture from `image`, for the last primitive; TEXCOORD_0 for its three vertices
    /// where it has none.
    void textured(Json image);

    [[nodiscard]] ByteVector glb() const;
    /// JSON with the buffer as a data URI.
    [[nodiscard]] std::string text() const;
    [[nodiscard]] const ByteVector& bytes() const { return bytes_; }
    /// Imports the file as .gltf from a fresh folder.
    [[nodiscard]] Scene import(ImportOptions options = {}) const;
    [[nodiscard]] Primitive importPrimitive() const;

private:
    ByteVector bytes_;
};

/// The message of the FileError that `work` must throw.
template <std::invocable Work>
std::string faultOf(Work&& work) {
    try {
        work();
    } catch (const FileError& error) {
        EXPECT_EQ(error.code(), ExitCode::File);
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << "more than one line: " << error.what();
        return error.what();
    }
    ADD_FAILURE() << "no FileError";
    return {};
}
inline std::string faultOf(const Builder& builder) {
    return faultOf([&] { (void)builder.import(); });
}

void expectNear(const glm::vec3& actual, const glm::vec3& expected, float tolerance = 1e-6F);

}  // namespace vkpt::test
