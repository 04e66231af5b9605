// The table that `vkpt info` prints.
#include <fmt/format.h>

#include "base/printable.h"
#include "scene/info.h"

namespace vkpt {
namespace {

constexpr int kLabelWidth = 16;

class Table {
public:
    void row(std::string_view label, const std::string& text) {
        out_ += fmt::format("{:<{}}{}\n", label, kLabelWidth, text);
    }
    /// Rows under one label, which only the first carries.
    void rows(std::string_view label, const std::vector<std::string>& texts) {
        for (std::size_t i = 0; i < texts.size(); ++i) row(i == 0 ? label : "", texts[i]);
    }
    std::string take() { return std::move(out_); }

private:
    std::string out_;
};

std::string grouped(const Json& number) {
    const std::string digits = std::to_string(number.get<std::uint64_t>());
    std::string out;
    for (std::size_t i = 0; i < digits.size(); ++i) {
        if (i != 0 && (digits.size() - i) % 3 == 0) out += ',';
        out += digits[i];
    }
    return out;
}

std::string size(const Json& number) {
    const double count = number.get<double>();
    if (count < 1024) return fmt::format("{:.0f} B", count);
    if (count < 1024 * 1024) return fmt::format("{:.1f} KiB", count / 1024);
    return fmt::format("{:.1f} MiB", count / (1024 * 1024));
}

std::string vector(const Json& v) {
    std::string text;
    for (const Json& x : v) text += fmt::format("{}{:.5g}", text.empty() ? "" : ", ", x.get<double>());
    return text;
}

std::string text(const Json& v) { return printable(v.get<std::string>()); }

std::string named(const Json& entry) { return text(entry["name"]).empty() ? "(unnamed)" : text(entry["name"]); }

std::string memoryText(const Json& memory) {
    std::string parts;
    for (const auto& [section, value] : memory.items()) {
        if (section == "total" || value == 0) continue;
        parts += fmt::format("{}{} {}", parts.empty() ? "" : ", ", section, size(value));
    }
    return parts.empty() ? size(memory["total"]) : fmt::format("{} ({})", size(memory["total"]), parts);
}

std::string cameraText(const Json& camera, std::size_t index) {
    const bool orthographic = camera.contains("ymag");
    return fmt::format("{} {}: {}, {} {:.4g}, eye {}", index, named(camera), text(camera["type"]),
                       orthographic ? "ymag" : "yfov", camera[orthographic ? "ymag" : "yfovDegrees"].get<double>(),
                       vector(camera["eye"]));
}

std::string lightText(const Json& light) {
    std::string line = fmt::format("{}: {}, {} {}", named(light), text(light["type"]), vector(light["intensity"]),
                                   text(light["unit"]));
    if (light.contains("range")) line += fmt::format(", range {:.4g}", light["range"].get<double>());
    if (light.contains("outerConeDegrees")) {
        line += fmt::format(", cone {:.4g} to {:.4g} degrees", light["innerConeDegrees"].get<double>(),
                            light["outerConeDegrees"].get<double>());
    }
    return line;
}

/// "conductor, alpha [0.2, 0.2], …"
std::string bsdfText(const Json& bsdf) {
    std::string line = text(bsdf["model"]);
    for (const auto& [key, value] : bsdf.items()) {
        if (key == "model") continue;
        line += fmt::format(", {} ", key);
        if (value.is_array() && value.size() == 3)
            line += vector(value);
        else if (value.is_number())
            line += fmt::format("{:.4g}", value.get<double>());
        else
            line += value.is_string() ? text(value) : jsonText(value, -1);
    }
    return line;
}

std::string materialText(const Json& material) {
    std::string line = named(material) + ": ";
    if (material.contains("bsdf"))
        line += bsdfText(material["bsdf"]);
    else
        line += fmt::format("{}, base {}, metallic {:.3g}, roughness {:.3g}", text(material["model"]),
                            vector(material["baseColor"]), material["metallic"].get<double>(),
                            material["roughness"].get<double>());
    if (material["emissive"] != Json{0.0, 0.0, 0.0}) line += ", emissive " + vector(material["emissive"]);
    if (material["alphaMode"] != "OPAQUE") line += ", " + text(material["alphaMode"]);
    if (material["doubleSided"].get<bool>()) line += ", double-sided";
    for (const Json& slot : material["textures"]) {
        line += (slot == material["textures"].front() ? "; textures " : ", ") + text(slot);
    }
    return line;
}

void addGeometry(Table& table, const Json& info) {
    const Json& n = info["counts"];
    table.row("triangles", fmt::format("{} in {} primitives of {} meshes", grouped(n["triangles"]),
                                       grouped(n["primitives"]), grouped(n["meshes"])));
    table.row("placed", fmt::format("{} by {} instances; {} stored", grouped(n["trianglesPlaced"]),
                                    grouped(n["instances"]), grouped(n["trianglesStored"])));
    table.row("vertices", grouped(n["vertices"]));
    table.row("images", fmt::format("{}, {} texels", grouped(n["images"]), grouped(n["texels"])));
    table.row("bounds", fmt::format("{} to {} (size {}) metres", vector(info["bounds"]["min"]),
                                    vector(info["bounds"]["max"]), vector(info["bounds"]["size"])));
    table.row("memory", memoryText(info["memory"]));
}

void addLists(Table& table, const Json& info) {
    std::vector<std::string> cameras, lights, materials;
    for (const Json& camera : info["cameras"]) cameras.push_back(cameraText(camera, cameras.size()));
    table.rows("cameras",
               cameras.empty() ? std::vector<std::string>{"none: framed from a three-quarter view"} : cameras);
    if (const Json& n = info["lights"]["emissiveTriangles"]; n != 0)
        lights.push_back(grouped(n) + " emissive triangles");
    for (const Json& light : info["lights"]["punctual"]) lights.push_back(lightText(light));
    if (info["lights"]["environment"].get<bool>()) lights.emplace_back("environment map");
    table.rows("lights", lights.empty() ? std::vector<std::string>{"none: lit by the built-in studio"} : lights);
    for (const Json& material : info["materials"]) materials.push_back(materialText(material));
    table.rows("materials", materials);
}

void addOmissions(Table& table, const Json& info) {
    for (const auto& [support, uses] : info["extensions"].items()) {
        std::vector<std::string> names;
        for (const Json& use : uses)
            names.push_back(text(use["name"]) + (use["required"].get<bool>() ? " (required)" : ""));
        table.rows(support, names);
    }
    const Json& out = info["leftOut"];
    for (const Json& feature : out["features"]) table.row("left out", text(feature));
    const auto count = [&](const char* key, std::string_view what) {
        if (out[key] != 0) table.row("left out", fmt::format("{} {}", grouped(out[key]), what));
    };
    count("points", "points");
    count("lines", "lines");
    count("degenerateTriangles", "triangles without area");
    count("degenerateInstances", "instances scaled to nothing");
    for (const Json& warning : info["warnings"]) table.row("warning", text(warning));
}

}  // namespace

std::string sceneInfoText(const Json& info) {
    Table table;
    table.row("file", text(info["file"]));
    addGeometry(table, info);
    addLists(table, info);
    addOmissions(table, info);
    return table.take();
}

}  // namespace vkpt
