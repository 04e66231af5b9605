// URIs of glTF files: relative references and embedded data.
#include <algorithm>
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

// file:///a/b, file:/a/b and file://localhost/a/b name /a/b. [RFC 8089]
std::string_view withoutFileScheme(std::string_view uri) {
    constexpr std::string_view kFile = "file:";
    const auto same = [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == b; };
    const std::string_view scheme = uri.substr(0, kFile.size());
    if (!std::equal(scheme.begin(), scheme.end(), kFile.begin(), kFile.end(), same)) return uri;
    const std::string_view path = uri.substr(kFile.size());
    return path.starts_with("//") ? path.substr(std::min(path.find('/', 2), path.size())) : path;
}

// Whether `file`, its links followed, lies below `folder`.
bool isBelow(const std::filesystem::path& file, const std::filesystem::path& folder) {
    std::error_code error, folderError;
    const auto real = std::filesystem::weakly_canonical(file, error);
    const auto where = std::filesystem::weakly_canonical(folder.empty() ? "." : folder, folderError);
    const auto relative = std::filesystem::absolute(real).lexically_relative(std::filesystem::absolute(where));
    return !error && !folderError && !relative.empty() && *relative.begin() != "..";
}

}  // namespace

std::filesystem::path resolveUri(std::string_view uri, const std::filesystem::path& folder, Reach reach,
                                 const std::string& blamed, std::string_view place) {
    const auto refuse = [&](std::string_view reason) {
        throw FileError(blamed, fmt::format("{}: uri \"{}\" {}", place, shown(uri), reason));
    };
    const bool anywhere = reach == Reach::Anywhere;
    const std::string_view path = withoutFileScheme(uri);
    if (hasScheme(path)) refuse("is no file; fetch it and refer to the copy");
    if (!anywhere && path.size() != uri.size()) refuse("is not relative; --allow-external lets it be read");
    const std::string text = percentDecode(path);
    if (text.empty()) refuse("is empty");
    if (text.find('\0') != std::string::npos) refuse("holds a zero byte");
    const std::filesystem::path relative(text), file = (folder / relative).lexically_normal();
    if (!anywhere && (relative.is_absolute() || !isBelow(file, folder)))
        refuse("leaves the scene's folder; --allow-external lets it be read");
    return file;
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
