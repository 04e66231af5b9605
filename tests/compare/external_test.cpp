// The figures beside those of programs by others: OpenImageIO's idiff, scikit-image, and FLIP from its papers in
// Python.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "base/atomic_file.h"
#include "base/image_read.h"
#include "base/json.h"
#include "compare/metrics.h"
#include "compare/perceptual.h"
#include "compare/verdict.h"
#include "film/encode.h"
#include "temporary_folder.h"

namespace vkpt {
namespace {

namespace fs = std::filesystem;

constexpr const char* kPython = "/usr/bin/python3";  // the one that Debian's packages belong to

/// Smooth shapes with edges, and on the `noisy` one grain and a colour cast: what renderings differ by.
Image picture(std::uint32_t width, std::uint32_t height, float largest, bool noisy) {
    Image image(width, height, 3);
    std::mt19937 generator(7);
    std::normal_distribution<float> grain(0, 0.2F);
    for (std::uint32_t y = 0; y < height; ++y) {
        for (std::uint32_t x = 0; x < width; ++x) {
            const float u = static_cast<float>(x) / static_cast<float>(width);
            const float v = static_cast<float>(y) / static_cast<float>(height);
            const bool disk = std::hypot(u - 0.4F, v - 0.5F) < 0.25F, bar = std::abs(u + v - 1.5F) < 0.03F;
            for (std::uint32_t c = 0; c < 3; ++c) {
                const float phase = static_cast<float>(c) * 1.3F;
                float value = 0.12F + 0.1F * std::sin(9 * u + phase) * std::cos(7 * v - phase);
                value += disk ? 0.4F - 0.15F * static_cast<float>(c) : bar ? 0.25F * static_cast<float>(c) : 0;
                if (noisy) value = value * (1.03F - 0.02F * static_cast<float>(c)) + value * grain(generator);
                image.at(x, y)[c] = std::max(0.0F, value);
            }
        }
    }
    std::fill_n(image.at(width / 3, height / 3), 3, 1.0F);  // the largest value of both
    for (float& value : image.pixels) value = std::min(value, 1.0F) * largest;
    return image;
}

fs::path write(const fs::path& path, const Bytes& bytes) {
    writeFileAtomically(path, bytes);
    return path;
}

/// What the command prints; empty where there is no such program (the shell's exit code 127).
std::optional<std::string> outputOf(const std::string& command) {
    FILE* pipe = ::popen((command + " 2>&1").c_str(), "r");
    if (pipe == nullptr) return std::nullopt;
    std::string text;
    std::array<char, 4096> part{};
    while (const std::size_t count = std::fread(part.data(), 1, part.size(), pipe)) text.append(part.data(), count);
    const int status = ::pclose(pipe);
    if (WEXITSTATUS(status) == 127) return std::nullopt;
    return text;
}

/// The number that begins at a place of `text`; not a number where there is none.
double numberAt(const std::string& text, std::size_t place) {
    return place < text.size() ? std::strtod(text.c_str() + place, nullptr) : std::nan("");
}

/// The number after the last `label`.
double lastNumber(const std::string& text, const std::string& label) {
    const std::size_t found = text.rfind(label);
    return found == std::string::npos ? std::nan("") : numberAt(text, found + label.size());
}

/// The number at the head of the last line that ends with `end`.
double headOfLine(const std::string& text, const std::string& end) {
    const std::size_t found = text.rfind(end);
    return found == std::string::npos ? std::nan("") : numberAt(text, text.rfind('\n', found) + 1);
}

/// Compares our figures with those that idiff prints, which have six digits.
void expectAsIdiff(const fs::path& a, const fs::path& b) {
    const Threshold fail{0.05}, warn{0.01};
    const auto text = outputOf("idiff -v -fail 0.05 -warn 0.01 " + a.string() + " " + b.string());
    ASSERT_TRUE(text) << "idiff is absent: install package openimageio-tools, as tools/test does";
    const Image image = readImage(a), reference = readImage(b);
    const ImageDifference d = compareImages(image, reference);
    const Verdict verdict = judge(image, reference, warn, fail);
    EXPECT_NEAR(d.meanAbsolute / lastNumber(*text, "Mean error = "), 1, 1e-5) << *text;
    EXPECT_NEAR(d.rootMeanSquare / lastNumber(*text, "RMS error = "), 1, 1e-5) << *text;
    EXPECT_NEAR(d.psnr / lastNumber(*text, "Peak SNR = "), 1, 1e-5) << *text;
    EXPECT_NEAR(d.maximum / lastNumber(*text, "Max error  = "), 1, 1e-5) << *text;
    EXPECT_EQ(d.x, lastNumber(*text, "@ ("));
    EXPECT_EQ(d.y, numberAt(*text, text->find(',', text->rfind("@ (")) + 1));
    EXPECT_EQ(static_cast<double>(verdict.warned), headOfLine(*text, "over 0.01"));
    EXPECT_EQ(static_cast<double>(verdict.failed), headOfLine(*text, "over 0.05"));
    EXPECT_GT(verdict.failed, 0U);
}

TEST(External, IdiffFindsTheSameOfPng) {
    const TemporaryFolder folder;
    for (const int bits : {8, 16}) {
        const fs::path a = write(folder / "a.png", encodePng(picture(90, 70, 1, true), bits, {}));
        expectAsIdiff(a, write(folder / "b.png", encodePng(picture(90, 70, 1, false), bits, {})));
    }
}

// idiff takes the largest value of both images as the peak, at least 1: here that is the reference's.
TEST(External, IdiffFindsTheSameOfExrAndHdr) {
    const TemporaryFolder folder;
    const Image a = picture(90, 70, 7.5F, true), b = picture(90, 70, 7.5F, false);
    expectAsIdiff(write(folder / "a.exr", encodeExr(a, {})), write(folder / "b.exr", encodeExr(b, {})));
    expectAsIdiff(write(folder / "a.hdr", encodeHdr(a)), write(folder / "b.hdr", encodeHdr(b)));
}

/// Images of display and of linear values, larger than a tile of ours.
std::vector<std::pair<Image, Image>> pythonCases() {
    std::vector<std::pair<Image, Image>> cases;
    for (const float largest : {1.0F, 40.0F}) {
        cases.emplace_back(picture(270, 150, largest, true), picture(270, 150, largest, false));
        cases.back().first.displayEncoded = cases.back().second.displayEncoded = largest == 1;
    }
    return cases;
}

TEST(External, PythonFindsTheSameSsimAndFlip) {
    const TemporaryFolder folder;
    std::string command = std::string(kPython) + " " VKPT_SOURCE "/tests/compare/reference_metrics.py";
    const auto cases = pythonCases();
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const std::string a = "a" + std::to_string(i) + ".pfm", b = "b" + std::to_string(i) + ".pfm";
        command += cases[i].first.displayEncoded ? " display " : " linear ";
        command += write(folder / a, encodePfm(cases[i].first)).string() + " ";
        command += write(folder / b, encodePfm(cases[i].second)).string();
    }
    ASSERT_TRUE(outputOf(std::string(kPython) + " -c 'import skimage' || exit 127"))
        << "scikit-image is absent: install package python3-skimage, as tools/test does";
    const Json results = Json::parse(outputOf(command).value_or(""));
    ASSERT_EQ(results.size(), cases.size());
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const PerceptualDifference p = comparePerceptually(cases[i].first, cases[i].second);
        EXPECT_NEAR(p.ssim, results[i].at("ssim").get<double>(), 1e-6);
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(p.channels.at(c).ssim, results[i].at("channels").at(c).get<double>(), 1e-6);
        EXPECT_NEAR(p.flip.mean, results[i].at("flip").get<double>(), 1e-6);
        EXPECT_GT(p.flip.mean, 0.01);
        EXPECT_LT(p.ssim, 0.99);
    }
}

}  // namespace
}  // namespace vkpt
