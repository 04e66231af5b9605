#include "verify/images.h"

#include "film/light_images.h"
#include "verify/context.h"
#include "verify/replay.h"

namespace vkpt {
namespace {

std::string_view channelName(std::uint32_t channel) { return std::string_view("RGB").substr(channel, 1); }

/// Where and at which vertex a path parts.
std::string locate(VerifyContext& context, const PathDifferences::Parted& path) {
    const std::string place = fmt::format("pixel {},{}, sample {}", path.x, path.y, path.index);
    const auto replayed = replayPixel(context, path.x, path.y, path.index, path.index + 1);
    const auto parting = replayed.empty() ? std::nullopt : replayed[0].parting();
    if (!parting) return place;
    return fmt::format("{}, bounce {}: {} {} instead of {}", place, parting->bounce, parting->row, parting->device,
                       parting->reference);
}

void tellMean(Findings& f, const MeanComparison& c) {
    const double difference = c.b.mean == 0 ? 0 : c.a.mean / c.b.mean - 1;
    f.figure(fmt::format("mean {}, vulkan / cpu - 1", channelName(c.channel)), difference,
             fmt::format("{:+.3f} %", 100 * difference));
}

/// Layers of light, pixel by pixel: their means stay within the errors that parted paths explain.
void compareLight(const std::vector<LightImage>& device, const std::vector<LightImage>& reference, Findings& f) {
    for (std::size_t layer = 0; layer < device.size(); ++layer) {
        PathDifferences d;
        d.add(device[layer].image, reference[layer].image, 0);
        double worst = 0;
        for (int c = 0; c < 3; ++c) worst = std::max(worst, d.meanShare(c));
        f.figure("layer " + device[layer].name, worst, fmt::format("{:.2f} of what its mean may be off by", worst));
        if (worst > 1 && d.worst())
            f.disagree("layer " + device[layer].name, fmt::format("pixel {},{}", d.worst()->x, d.worst()->y),
                       fmt::format("its mean is off by {:.3g} times three standard errors", worst));
    }
}

}  // namespace

void checkSameSeed(VerifyContext& context, Findings& f) {
    const SameSeedImages& images = context.sameSeed();
    const PathDifferences& d = images.differences;
    if (d.mean(0) + d.mean(1) + d.mean(2) == 0) return f.refuse("the image is black: there is nothing to compare");
    f.tally("paths", d.paths(), d.parted());
    f.figure("paths that part", d.partedShare(), fmt::format("{:.4f} %", 100 * d.partedShare()));
    f.figure("their mean difference", d.partedSize(), fmt::format("{:.2f} of the mean", d.partedSize()));
    if (d.excused() > 0)
        f.figure("of them by rounding", d.excusedShare(), fmt::format("{:.4f} %", 100 * d.excusedShare()));
    const double most = PathDifferences::mostParted(context.options().params),
                 unexcused = d.partedShare() - d.excusedShare();
    if (unexcused > most && d.worst())
        f.disagree("paths that part", locate(context, *d.worst()),
                   fmt::format("{:.3f} % where {} % are allowed", 100 * unexcused, 100 * most));
    f.atMost("share of paths that rounding decides", d.excusedShare(), PathDifferences::kMostExcused);
    for (int c = 0; c < 3; ++c) {
        const double relative = d.mean(c) == 0 ? 0 : d.meanDifference(c) / d.mean(c);
        f.figure(fmt::format("mean difference {}", channelName(static_cast<std::uint32_t>(c))), relative,
                 fmt::format("{:+.2g} %", 100 * relative));
        const double allowed = 3 * d.standardError(c) + PathDifferences::kRounding * d.mean(c);
        const bool inside = std::abs(d.meanDifference(c)) <= allowed;
        if (!inside && d.worst())
            f.disagree("mean difference", locate(context, *d.worst()),
                       fmt::format("{:.3g} in channel {}, where three standard errors are {:.3g}", d.meanDifference(c),
                                   channelName(static_cast<std::uint32_t>(c)), allowed));
    }
    compareLight(lengthImages(images.device), lengthImages(images.reference), f);
    compareLight(groupImages(images.device), groupImages(images.reference), f);
}

void checkOtherSeeds(VerifyContext& context, Findings& f) {
    if (!context.options().sampler.isRandomised())
        return f.refuse(
            "this sampler gives the same numbers for every seed, so replicates would be copies: choose "
            "another --sampler or --scramble");
    const ReplicateResult& result = context.replicates();
    const MeanComparison& worst = result.worst();
    f.tally("means", result.tiles.size() + result.whole.size(), 0);
    f.figure("replicates a side", context.config().replicates, fmt::format("{}", context.config().replicates));
    for (const MeanComparison& c : result.whole) tellMean(f, c);
    f.figure("least p", worst.test.p, fmt::format("{:.2g} (level {:.2g})", worst.test.p, result.level));
    if (result.agrees()) return;
    const bool whole = worst.width == result.meanA.width && worst.height == result.meanA.height;
    f.disagree(
        whole ? "mean of the image" : "mean of a tile",
        fmt::format("{}channel {}",
                    whole ? ""
                          : fmt::format("pixels {},{} to {},{}, ", worst.x, worst.y, worst.x + worst.width - 1,
                                        worst.y + worst.height - 1),
                    channelName(worst.channel)),
        fmt::format("{:.5g} instead of {:.5g}: t = {:.2f}, {:.0f} degrees of freedom, p = {:.1g}, level {:.1g}",
                    worst.a.mean, worst.b.mean, worst.test.statistic, worst.test.degrees, worst.test.p, result.level));
}

}  // namespace vkpt
