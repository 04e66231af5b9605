// Faults of faults.json, and shaders that have one.
#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "gpu/spirv_source.h"
#include "temporary_folder.h"

namespace vkpt {

/// One edit that breaks one function or stage.
struct Fault {
    int number = 0;  ///< place in the list
    std::string name, about, file, right, broken;
    std::string check;     ///< that must name it
    std::string needs;     ///< feature (of the reference: option) without which the broken code does not run; or empty
    std::string survives;  ///< why none can; empty where one must
    std::string chosen;    ///< "before" or "after" the verifier was frozen
    bool quick = false;

    [[nodiscard]] bool inShaders() const { return file.starts_with("shaders/"); }
};

[[nodiscard]] const std::vector<Fault>& allFaults();
[[nodiscard]] const Fault& faultNamed(const std::string& name);

/// Kernels and probes whose sources have the fault: those that read the edited file are compiled when they are asked
/// for, the others are the embedded ones. Throws std::runtime_error where a text is not there or does not compile.
class FaultyShaders {
public:
    explicit FaultyShaders(const Fault& fault);

    [[nodiscard]] SpirvSource kernels();
    [[nodiscard]] SpirvSource probes();
    /// Whether a source, given from the root, is the edited one or includes it.
    [[nodiscard]] bool reads(const std::filesystem::path& file) const;
    /// How many were compiled.
    [[nodiscard]] std::size_t count() const { return compiled_.size(); }

private:
    std::span<const std::uint32_t> find(const std::string& file, std::span<const std::uint32_t> embedded);
    [[nodiscard]] std::vector<std::uint32_t> compile(const std::string& file) const;

    const Fault& fault_;
    TemporaryFolder folder_;
    std::map<std::string, std::vector<std::uint32_t>> compiled_;
};

}  // namespace vkpt
