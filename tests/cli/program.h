// Small renders of the Cornell box, and other commands, through the program.
#pragma once
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfStringAttribute.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/image_read.h"
#include "cli/run_vkpt.h"

namespace vkpt {

using Words = std::vector<std::string>;

inline const std::string kCornellBox = VKPT_SCENES "/cornell_box/scene.gltf";

class Program : public testing::Test {
protected:
    [[nodiscard]] RunResult run(Words arguments, RunOptions options = {}) const {
        options.folder = folder_.path();
        return runVkpt(arguments, options);
    }
    /// render kCornellBox, small, with more arguments.
    [[nodiscard]] RunResult render(const Words& more, const RunOptions& options = {}, const char* spp = "2") const {
        Words all{"render", kCornellBox, "--size", "24x16", "--spp", spp};
        all.insert(all.end(), more.begin(), more.end());
        return run(all, options);
    }
    [[nodiscard]] std::string attribute(const char* file, const char* key) const {
        Imf::InputFile in((folder_ / file).c_str());
        const auto* value = in.header().findTypedAttribute<Imf::StringAttribute>(key);
        return value ? value->value() : "absent";
    }
    [[nodiscard]] Image image(const char* file) const { return readImage(folder_ / file); }

    TemporaryFolder folder_;
};

}  // namespace vkpt
