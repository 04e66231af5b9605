// The order of the folders under src/: each includes only those above it.
#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace vkpt {
namespace {

namespace fs = std::filesystem;

/// Folders on one line are siblings: neither includes the other.
const std::vector<std::vector<std::string>> kOrder{
    {"base"}, {"scene"}, {"gltf"}, {"bvh"}, {"gpu"}, {"film"}, {"wavefront", "reference"}, {"compare"}, {"verify"}, {"plot"}, {"analysis"}, {"cli"}};

std::optional<std::size_t> levelOf(const std::string& folder) {
    for (std::size_t level = 0; level < kOrder.size(); ++level)
        if (std::ranges::count(kOrder[level], folder) > 0) return level;
    return std::nullopt;
}

/// Includes of other folders in a source file: `gpu` for `#include "gpu/buffer.h"`.
std::vector<std::string> foldersIncluded(std::istream& source) {
    std::vector<std::string> folders;
    constexpr std::string_view kInclude = "#include \"";
    for (std::string line; std::getline(source, line);) {
        if (!line.starts_with(kInclude)) continue;
        const std::string path = line.substr(kInclude.size(), line.find('"', kInclude.size()) - kInclude.size());
        if (const auto slash = path.find('/'); slash != std::string::npos) folders.push_back(path.substr(0, slash));
    }
    return folders;
}

bool mayInclude(const std::string& folder, const std::string& included) {
    if (folder == included) return true;
    if (folder == "gpu") return included == "base";  // it knows nothing of rendering
    return levelOf(included).has_value() && levelOf(included) < levelOf(folder);
}

TEST(Structure, RulesTellRightFromWrong) {
    EXPECT_TRUE(mayInclude("film", "base"));
    EXPECT_TRUE(mayInclude("film", "film"));
    EXPECT_FALSE(mayInclude("base", "film"));
    EXPECT_FALSE(mayInclude("wavefront", "reference"));
    EXPECT_FALSE(mayInclude("reference", "wavefront"));
    EXPECT_FALSE(mayInclude("gpu", "scene"));
    EXPECT_FALSE(mayInclude("cli", "shaders"));
    std::istringstream source("#include <vector>\n#include \"gpu/x.h\"\n#include \"layout.h\"  // a/b\n");
    EXPECT_THAT(foldersIncluded(source), testing::ElementsAre("gpu"));
}

TEST(Structure, EveryFolderHasItsPlaceInTheOrder) {
    for (const auto& entry : fs::directory_iterator(fs::path(VKPT_SOURCE) / "src"))
        EXPECT_TRUE(!entry.is_directory() || levelOf(entry.path().filename().string()))
            << entry.path() << " is not in the order";
}

TEST(Structure, EachFolderIncludesOnlyThoseAboveIt) {
    const fs::path root = fs::path(VKPT_SOURCE) / "src";
    std::size_t includes = 0;
    for (const auto& entry : fs::recursive_directory_iterator(root)) {
        const fs::path relative = entry.path().lexically_relative(root);
        if (!entry.is_regular_file() || !relative.has_parent_path()) continue;  // main.cpp may include all
        std::ifstream source(entry.path());
        for (const std::string& included : foldersIncluded(source)) {
            ++includes;
            EXPECT_TRUE(mayInclude(*relative.begin(), included)) << relative << " includes " << included << "/";
        }
    }
    EXPECT_GT(includes, 50U) << "hardly anything was looked at";
}

}  // namespace
}  // namespace vkpt
