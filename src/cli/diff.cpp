// vkpt diff: how far one image is from another, in figures, as a picture and as an exit code.
#include <fmt/format.h>

#include <array>
#include <iostream>
#include <memory>

#include "base/atomic_file.h"
#include "base/image_read.h"
#include "cli/command.h"
#include "cli/diff_report.h"
#include "cli/options.h"
#include "compare/heat_map.h"
#include "film/encode.h"
#include "film/write_image.h"

namespace vkpt {
namespace {

enum class MapKind : std::uint8_t { Absolute, Flip };
struct MapKindInfo {
    MapKind id;
    std::string_view name;
};
constexpr auto kMapKinds = std::to_array<MapKindInfo>({{MapKind::Absolute, "absolute"}, {MapKind::Flip, "flip"}});

struct DiffCommand {
    std::filesystem::path image, reference, heatMap;
    MapKind map = MapKind::Absolute;
    Threshold warn, fail;
    PerceptualOptions perceptual;
    bool json = false;
};

void addThreshold(CLI::App& app, const std::string& name, Threshold& threshold, const std::string& result) {
    const auto nonNegative = numberWithin(0.0);
    constexpr const char* expected = "a number, 0 or above";
    addParsed(app, "--" + name, threshold.above, nonNegative, "X",
              fmt::format("{} where a channel differs by more than X (default: 1e-06)", result), expected)
        ->group("Thresholds");
    addParsed(app, "--" + name + "percent", threshold.percent, numberWithin(0.0, 100.0), "P",
              fmt::format("let P percent of the pixels exceed --{} (default: 0)", name), "a number from 0 to 100")
        ->group("Thresholds");
    addParsed(app, "--hard" + name, threshold.hard, nonNegative, "X",
              fmt::format("{} where any one pixel differs by more than X (default: never)", result), expected)
        ->group("Thresholds");
}

/// Throws for what compareImages could not name the files of.
void checkPair(const DiffCommand& c, const Image& image, const Image& reference) {
    if (image.displayEncoded != reference.displayEncoded)
        throw FileError(c.image.string(),
                        fmt::format("{} while {} is not: compare PNG with PNG, and linear formats with each other",
                                    image.displayEncoded ? "is display-encoded" : "is linear", c.reference.string()));
    if (image.width != reference.width || image.height != reference.height)
        throw Error(ExitCode::SizeMismatch,
                    fmt::format("{} has {}x{} pixels, {} has {}x{}", c.image.string(), image.width, image.height,
                                c.reference.string(), reference.width, reference.height));
}

void writeHeatMap(const DiffCommand& c, const Image& image, const Image& reference, const Comparison& comparison) {
    const Image map = c.map == MapKind::Flip ? heatMap(comparison.perceptual.flip.map, {"FLIP", 1})
                                             : heatMap(absoluteDifference(image, reference), {"absolute difference"});
    writeFileAtomically(c.heatMap, encodePng(map, 8, {}));
}

ExitCode runDiff(const DiffCommand& c) {
    if (!c.heatMap.empty()) {
        if (imageFormat(c.heatMap) != ImageFormat::Png)
            throw usageError("--output", fmt::format("'{}' does not end in .png", c.heatMap.string()));
        checkWritable(c.heatMap);
    }
    const Image image = readImage(c.image), reference = readImage(c.reference);
    checkPair(c, image, reference);
    const Comparison comparison{compareImages(image, reference), comparePerceptually(image, reference, c.perceptual),
                                judge(image, reference, c.warn, c.fail)};
    if (!c.heatMap.empty()) writeHeatMap(c, image, reference, comparison);
    std::cout << (c.json ? jsonText(diffJson(comparison, c.warn, c.fail)) + "\n"
                         : diffText(comparison, c.warn, c.fail));
    return comparison.verdict.code;
}

std::function<ExitCode()> setUpDiff(CLI::App& app) {
    const auto command = std::make_shared<DiffCommand>();
    app.add_option("A", command->image, "image: .exr, .hdr, .pfm or .png")->required()->type_name("FILE");
    app.add_option("B", command->reference, "the reference, taken as true")->required()->type_name("FILE");
    app.add_option("-o,--output", command->heatMap, "write the differences as false colours with a scale, .png")
        ->type_name("FILE");
    addParsed(app, "--map", command->map, nameIn(kMapKinds), namesOf(kMapKinds),
              "what -o shows: the largest difference of the channels, or FLIP (default: absolute)");
    addThreshold(app, "fail", command->fail, "fail (exit 2)");
    addThreshold(app, "warn", command->warn, "warn (exit 1)");
    app.add_flag("--flip-per-channel", command->perceptual.flipPerChannel,
                 "FLIP of each channel, shown as grey, too: more than doubles the time");
    app.add_flag("--json", command->json, "figures as JSON");
    return [command] { return runDiff(*command); };
}

}  // namespace

const Command kDiffCommand{"diff", "how far an image is from a reference",
                           "vkpt diff noisy.exr converged.exr -o heat.png --fail 0.1 --failpercent 1", setUpDiff};

}  // namespace vkpt
