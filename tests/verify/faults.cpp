#include "verify/faults.h"

#include <fmt/format.h>

#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

#include "verify/prober.h"
#include "wavefront/kernels.h"

namespace vkpt {
namespace {

namespace fs = std::filesystem;

const fs::path kRoot = VKPT_SOURCE;

std::vector<Fault> readFaults() {
    const auto json = nlohmann::json::parse(readText(kRoot / "tests/verify/faults.json"));
    std::vector<Fault> faults;
    for (const auto& f : json.at("faults"))
        faults.push_back({static_cast<int>(faults.size()), f.at("name"), f.at("about"), f.at("file"), f.at("right"),
                          f.at("broken"), f.value("check", ""), f.value("needs", ""), f.value("survives", ""),
                          f.at("chosen"), f.value("quick", false)});
    return faults;
}

}  // namespace

const std::vector<Fault>& allFaults() {
    static const std::vector<Fault> faults = readFaults();
    return faults;
}

const Fault& faultNamed(const std::string& name) {
    for (const Fault& fault : allFaults())
        if (fault.name == name) return fault;
    throw std::runtime_error("there is no fault " + name);
}

FaultyShaders::FaultyShaders(const Fault& fault) : fault_(fault) {
    std::string text = readText(kRoot / fault.file);
    const std::size_t at = text.find(fault.right);
    if (at == std::string::npos) throw std::runtime_error(fault.name + ": its text is not in " + fault.file);
    text.replace(at, fault.right.size(), fault.broken);
    (void)folder_.write(fault.file, text);
}

SpirvSource FaultyShaders::kernels() {
    return
        [this](std::string_view name) { return find(fmt::format("shaders/kernels/{}.comp", name), kernelSpirv(name)); };
}

SpirvSource FaultyShaders::probes() {
    return
        [this](std::string_view name) { return find(fmt::format("shaders/probes/{}.comp", name), probeSpirv(name)); };
}

std::span<const std::uint32_t> FaultyShaders::find(const std::string& file, std::span<const std::uint32_t> embedded) {
    if (const auto found = compiled_.find(file); found != compiled_.end()) return found->second;
    if (!reads(file)) return embedded;
    return compiled_[file] = compile(file);
}

bool FaultyShaders::reads(const fs::path& file) const {
    if (file == fault_.file) return true;
    std::istringstream text(readText(kRoot / file));
    constexpr std::string_view kInclude = "#include \"";
    for (std::string line; std::getline(text, line);) {
        if (!line.starts_with(kInclude)) continue;
        const std::string name = line.substr(kInclude.size(), line.find('"', kInclude.size()) - kInclude.size());
        if (fs::exists(kRoot / "shaders" / name) && reads(fs::path("shaders") / name)) return true;
        const fs::path generated = fs::path(VKPT_GENERATED) / name;  // from the registry: includes all its models
        if (fs::exists(generated) && reads(generated)) return true;
    }
    return false;
}

std::vector<std::uint32_t> FaultyShaders::compile(const std::string& file) const {
    const fs::path source = file == fault_.file ? folder_ / file : kRoot / file, binary = folder_ / "kernel.spv";
    const std::string command =
        fmt::format("'{}' --quiet -V --target-env vulkan1.2 '-I{}' '-I{}' '-I{}' '-I{}' -o '{}' '{}'", VKPT_GLSLANG,
                    (folder_ / "shaders").string(), (kRoot / "shaders").string(), (kRoot / "shaders/shared").string(),
                    VKPT_GENERATED, binary.string(), source.string());
    if (std::system(command.c_str()) != 0) throw std::runtime_error(fault_.name + ": " + file + " does not compile");
    const std::string bytes = readText(binary);
    std::vector<std::uint32_t> words(bytes.size() / sizeof(std::uint32_t));
    std::memcpy(words.data(), bytes.data(), words.size() * sizeof(std::uint32_t));
    return words;
}

}  // namespace vkpt
