#include "cli/diff_report.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <string_view>

namespace vkpt {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

std::string_view word(ExitCode code) {
    return code == ExitCode::Ok ? "pass" : code == ExitCode::Warning ? "warning" : "fail";
}

std::string cell(double value) { return std::isnan(value) ? "-" : fmt::format("{:.6g}", value); }

std::string tableRow(std::string_view name, const ErrorFigures& f, double ssim, double flip) {
    std::string row = fmt::format("{:<6}", name);
    for (const double v :
         {f.meanAbsolute, f.rootMeanSquare, f.meanSquare, f.relativeMse, f.mrse, f.psnr, ssim, flip, f.maximum})
        row += fmt::format(" {:>11}", cell(v));
    row += '\n';
    return row;
}

/// The perceptual figures of the i-th channel, where it has some: alpha has none, a grey image those of the whole.
PerceptualFigures perceptualOf(const PerceptualDifference& p, const ChannelFigures& channel, std::size_t i) {
    if (i < p.channels.size()) return p.channels[i];
    if (channel.name == "Y") return {channel.name, p.ssim, p.flip.mean};
    return {channel.name, kNone, kNone};
}

std::string countLine(std::uint64_t count, std::uint64_t pixels, const char* name, const Threshold& threshold) {
    return fmt::format("{} of {} pixels ({:.3g} %) differ by more than {:g} (--{})\n", count, pixels,
                       100 * static_cast<double>(count) / static_cast<double>(pixels), threshold.above, name);
}

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json figuresJson(const ErrorFigures& f, double ssim, double flip) {
    return {{"values", f.values},
            {"mae", number(f.meanAbsolute)},
            {"rms", number(f.rootMeanSquare)},
            {"mse", number(f.meanSquare)},
            {"relMse", number(f.relativeMse)},
            {"mrse", number(f.mrse)},
            {"psnr", number(f.psnr)},
            {"ssim", number(ssim)},
            {"flip", number(flip)},
            {"maximum", number(f.maximum)},
            {"maximumAt", {f.x, f.y}}};
}

Json thresholdJson(const Threshold& t, std::uint64_t pixels) {
    return {{"above", t.above}, {"percent", t.percent}, {"hard", number(t.hard)}, {"pixels", pixels}};
}

}  // namespace

std::string diffText(const Comparison& comparison, const Threshold& warn, const Threshold& fail) {
    const auto& [d, p, verdict] = comparison;
    std::string text = fmt::format("{:<6}", "");
    for (const char* head : {"MAE", "RMS", "MSE", "relMSE", "MRSE", "PSNR dB", "SSIM", "FLIP", "maximum"})
        text += fmt::format(" {:>11}", head);
    text += '\n';
    text += tableRow("whole", d, p.ssim, p.flip.mean);
    for (std::size_t i = 0; i < d.channels.size(); ++i) {
        const PerceptualFigures figures = perceptualOf(p, d.channels[i], i);
        text += tableRow(figures.name, d.channels[i], figures.ssim, figures.flip);
    }
    if (d.maximum > 0) text += fmt::format("largest difference at pixel {},{}\n", d.x, d.y);
    text += fmt::format("peak of PSNR {:g}", d.peak);
    if (p.flipExposures.count > 1)
        text += fmt::format("; FLIP at {} exposures from {:.2f} to {:.2f} EV", p.flipExposures.count,
                            p.flipExposures.start, p.flipExposures.stop);
    text += '\n';
    if (d.nonFinite.inImage + d.nonFinite.inReference > 0)
        text +=
            fmt::format("not finite: {} values of the image, {} of the reference; {} differ; none is in the means\n",
                        d.nonFinite.inImage, d.nonFinite.inReference, d.nonFinite.differing);
    text += countLine(verdict.failed, verdict.pixels, "fail", fail);
    if (warn.above != fail.above) text += countLine(verdict.warned, verdict.pixels, "warn", warn);
    text += word(verdict.code);
    text += '\n';
    return text;
}

Json diffJson(const Comparison& comparison, const Threshold& warn, const Threshold& fail) {
    const auto& [d, p, verdict] = comparison;
    Json channels = Json::object();
    for (std::size_t i = 0; i < d.channels.size(); ++i) {
        const PerceptualFigures figures = perceptualOf(p, d.channels[i], i);
        channels[std::string(figures.name)] = figuresJson(d.channels[i], figures.ssim, figures.flip);
    }
    return {{"whole", figuresJson(d, p.ssim, p.flip.mean)},
            {"channels", channels},
            {"peak", number(d.peak)},
            {"flipExposures",
             {{"count", p.flipExposures.count}, {"start", p.flipExposures.start}, {"stop", p.flipExposures.stop}}},
            {"nonFinite",
             {{"image", d.nonFinite.inImage},
              {"reference", d.nonFinite.inReference},
              {"differing", d.nonFinite.differing}}},
            {"pixels", verdict.pixels},
            {"fail", thresholdJson(fail, verdict.failed)},
            {"warn", thresholdJson(warn, verdict.warned)},
            {"verdict", word(verdict.code)}};
}

}  // namespace vkpt
