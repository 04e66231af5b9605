// URIs of glTF files: relative references and embedded data.
#include <cctype>
#include <charconv>

#include "base/error.h"
#include "gltf/document.h"

namespace vkpt::gltf {
namespace {

constexpr std::size_t kShownUri = 80;  // longer URIs are cut in messages

std::string shown(std::string_view uri) {
    return uri.size() <= kShownUri ? std::string(uri) : std::string(uri.substr(0, kShownUri)) + "…";
}

// A percent sign that begins no valid escape stands for itself: exporters forget to encode it.
std::string percentDecode(std::string_view uri) {
    std::string text;
    text.reserve(uri.size());
    for (std::size_t i = 0; i < uri.size(); ++i) {
        const std::string_view digits = uri.substr(i + 1, 2);
        unsigned char code = 0;
        const auto end = std::from_chars(digits.data(), digits.data() + digits.size(), code, 16).ptr;
        const bool escape = uri[i] == '%' && end == digits.data() + 2;
        text += escape ? static_cast<char>(code) : uri[i];
        if (escape) i += 2;
    }
    return text;
}

bool hasScheme(std::string_view uri) {
    const std::size_t colon = uri.find(':');
    if (colon == std::string_view::npos || colon == 0 || uri.find('/') < colon) return false;
    if (!std::isalpha(static_cast<unsigned char>(uri[0]))) return false;
    for (const char c : uri.substr(0, colon))
        if (!std::isalnum(static_cast<unsigned char>(c)) && c != '+' && c != '-' && c != '.') return false;
    return true;
}

}  // namespace

std::filesystem::path resolveUri(std::string_view uri, const std::filesystem::path& folder, const std::string& blamed,
                                 std::string_view place) {
    const auto refuse = [&](std::string_view reason) {
        throw FileError(blamed, fmt::format("{}: uri \"{}\" {}", place, shown(uri), reason));
    };
    if (hasScheme(uri)) refuse("is not relative; only files in the scene's folder are read");
    const std::string text = percentDecode(uri);
    if (text.empty()) refuse("is empty");
    if (text.find('\0') != std::string::npos) refuse("holds a zero byte");
    const std::filesystem::path relative = std::filesystem::path(text).lexically_normal();
    if (relative.is_absolute() || *relative.begin() == "..")
        refuse("leaves the scene's folder; only files inside it are read");
    return folder / relative;
}

Bytes decodeDataUri(std::string_view uri, const std::string& blamed, std::string_view place) {
    const auto refuse = [&](std::string_view reason) {
        throw FileError(blamed, fmt::format("{}: data URI {}", place, reason));
    };
    const std::size_t comma = uri.find(',');
    if (comma == std::string_view::npos) refuse("has no data");
    std::string_view text = uri.substr(comma + 1);
    if (!uri.substr(0, comma).ends_with(";base64")) {
        const std::string plain = percentDecode(text);
        return {plain.begin(), plain.end()};
    }
    while (text.ends_with('=')) text.remove_suffix(1);
    if (text.size() % 4 == 1) refuse("is cut short");

    // tinygltf knows few media types and stops in silence at what is not base64.
    Bytes bytes;
    std::string ignored;
    tinygltf::DecodeDataURI(&bytes, ignored, fmt::format("data:application/octet-stream;base64,{}", text), 0, false);
    if (bytes.size() != text.size() * 3 / 4) refuse("holds a character that is not base64");
    return bytes;
}

}  // namespace vkpt::gltf
