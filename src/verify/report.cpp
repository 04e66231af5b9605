#include "verify/report.h"

#include <algorithm>
#include <cmath>

#include "base/atomic_file.h"
#include "base/error.h"
#include "compare/heat_map.h"
#include "film/tonemap.h"
#include "film/write_image.h"
#include "verify/context.h"
#include "verify/report_page.h"

namespace vkpt {
namespace {

Bytes displayPng(const Image& linear) { return encodePng(displayImage(linear, {}), 8, {}); }

/// The worst |t| of each tile's channels.
Image tileStatistics(const ReplicateResult& result) {
    constexpr std::uint32_t kTile = ReplicateResult::kTile;
    Image image((result.meanA.width + kTile - 1) / kTile, (result.meanA.height + kTile - 1) / kTile, 1);
    for (const MeanComparison& c : result.tiles) {
        float& value = *image.at(c.x / kTile, c.y / kTile);
        value = std::max(value, static_cast<float>(std::abs(c.test.statistic)));
    }
    return image;
}

void writeBytes(const std::filesystem::path& path, std::span<const std::byte> bytes) {
    writeFileAtomically(path, bytes);
}

}  // namespace

void makeReportFolder(const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) throw FileError(folder.string(), fmt::format("cannot be made: {}", error.message()));
}

void writeReport(VerifyContext& context, const ReportInput& input) {
    const SameSeedImages& same = context.sameSeed();
    const Image device = filmToImage(same.device), reference = filmToImage(same.reference);
    writeImage(input.folder / "gpu.exr", device, {}, input.deviceMetadata);
    writeImage(input.folder / "cpu.exr", reference, {}, input.referenceMetadata);
    const Bytes difference =
        encodePng(heatMap(absoluteDifference(device, reference), {"|vulkan - cpu|, same random numbers"}), 8, {});
    writeBytes(input.folder / "diff.png", difference);

    ReportPage page{input.title, context.prober().device().info().name, input.ladder, {}, {}, input.settings};
    const std::uint32_t samples = same.device.samples();
    const double aspect = static_cast<double>(device.width) / device.height;
    page.pairs.push_back({"same seed", fmt::format("{} samples a pixel of the same random numbers", samples), aspect,
                          displayPng(device), displayPng(reference)});
    page.heats.push_back(
        {"same seed", "Where the two images of the same random numbers differ. Black: not at all.", difference});
    if (const auto& replicates = context.replicatesSoFar()) {
        page.pairs.push_back(
            {"other seeds",
             fmt::format("mean of {} images a side, of {} samples a pixel each", context.config().replicates, samples),
             aspect, displayPng(replicates->meanA), displayPng(replicates->meanB)});
        page.heats.push_back(
            {"other seeds",
             fmt::format("Welch's t of every 8x8 tile, the largest of three channels. Equal renderers exceed {:.1f} in "
                         "one run of a hundred.",
                         replicates->limit()),
             encodePng(heatMap(tileStatistics(*replicates), {"|t| of tile means", replicates->limit()}), 8, {})});
    }
    const std::string html = reportHtml(page);
    writeBytes(input.folder / "index.html", std::as_bytes(std::span(html)));
}

}  // namespace vkpt
