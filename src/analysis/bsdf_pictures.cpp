#include "analysis/bsdf_pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "analysis/bsdf_sphere.h"
#include "analysis/sphere_quadrature.h"
#include "compare/false_color.h"

namespace vkpt {
namespace {

constexpr double kPanel = 250, kSpace = 30, kHeading = 40, kPicture = 240;
constexpr double kAngles[] = {0, 30, 60, 80};  ///< of wo, degrees
constexpr std::size_t kLobePanels = std::size(kAngles);

glm::dvec3 inPlane(double degrees) {
    const double t = degrees * std::numbers::pi / 180;
    return {std::sin(t), 0, std::cos(t)};
}

/// f |cos|, the light that a direction contributes.
double lobe(const BsdfDouble& b, const glm::dvec3& wo, const glm::dvec3& wi) {
    return reference::luminance(reference::evalBsdf(b, wo, wi)) * std::abs(wi.z);
}

/// Where directions of a lobe plot lie: the normal points up.
struct Plot {
    double x, y, radius;
    [[nodiscard]] double placeX(const glm::dvec3& w, double r) const { return x + w.x * r * radius; }
    [[nodiscard]] double placeY(const glm::dvec3& w, double r) const { return y - w.z * r * radius; }
};

struct LobeCurve {
    std::vector<std::pair<glm::dvec3, double>> points;
    std::vector<glm::dvec3> deltas;  ///< directions of delta lobes
};

LobeCurve lobeCurve(const BsdfDouble& b, const glm::dvec3& wo, bool bothSides) {
    LobeCurve curve;
    const int last = bothSides ? 360 : 90;
    constexpr double kStep = 0.5;
    for (double t = -90; t <= last - (bothSides ? 90 : 0); t += kStep) {
        const glm::dvec3 wi = inPlane(t);
        curve.points.emplace_back(wi, lobe(b, wo, wi));
    }
    constexpr int kChoices = 64;
    for (int i = 0; i < kChoices; ++i) {
        const auto s = reference::sampleBsdf(b, wo, (i + 0.5) / kChoices, glm::dvec2(0.5));
        if (!std::isinf(s.pdf)) continue;
        const bool known =
            std::ranges::any_of(curve.deltas, [&](const glm::dvec3& d) { return glm::distance(d, s.wi) < 1e-6; });
        if (!known) curve.deltas.push_back(s.wi);
    }
    return curve;
}

/// Radii are cube roots, so that narrow lobes leave room for wide ones.
void drawLobe(Drawing& d, const Plot& plot, const LobeCurve& curve, double top, double width, Ink ink) {
    const auto radius = [&](double value) { return std::cbrt(value / top); };
    for (std::size_t i = 1; i < curve.points.size(); ++i) {
        const auto& [w0, v0] = curve.points[i - 1];
        const auto& [w1, v1] = curve.points[i];
        d.line(plot.placeX(w0, radius(v0)), plot.placeY(w0, radius(v0)), plot.placeX(w1, radius(v1)),
               plot.placeY(w1, radius(v1)), width, ink);
    }
    for (const glm::dvec3& w : curve.deltas) {
        d.line(plot.x, plot.y, plot.placeX(w, 1), plot.placeY(w, 1), width, ink);
        d.circle(plot.placeX(w, 1), plot.placeY(w, 1), 3.5, ink);
    }
}

void drawLobePanel(Drawing& d, const Plot& plot, double angle, const std::vector<PicturedBsdf>& bsdfs, bool bothSides) {
    const glm::dvec3 wo = inPlane(-angle);
    d.line(plot.x - plot.radius, plot.y, plot.x + plot.radius, plot.y, 1, kGrey);
    const double reach = bothSides ? 360 : 180;
    for (double t = 0; t < reach; t += 3) {  // the circle of the largest value
        const glm::dvec3 a = inPlane(t - 90), b = inPlane(t - 88.5);
        d.line(plot.placeX(a, 1), plot.placeY(a, 1), plot.placeX(b, 1), plot.placeY(b, 1), 0.7, kGrey);
    }
    std::vector<LobeCurve> curves;
    double top = 0;
    for (const PicturedBsdf& p : bsdfs) {
        curves.push_back(lobeCurve(p.bsdf->seenFrom<double>(true), wo, bothSides));
        for (const auto& point : curves.back().points) top = std::max(top, point.second);
    }
    for (std::size_t i = 0; i < curves.size(); ++i) {
        const double width = 1.6 * static_cast<double>(curves.size() - i);  // where lobes coincide both show
        drawLobe(d, plot, curves[i], top > 0 ? top : 1, width, inkOf(i));
    }
    d.line(plot.x, plot.y, plot.placeX(wo, 1.08), plot.placeY(wo, 1.08), 1, kBlack);
    d.text(plot.x, plot.y - plot.radius - 14, fmt::format("{:.0f} degrees, largest {:.3g}", angle, top), 12,
           Align::Middle);
}

/// f |cos| over the upper hemisphere, seen from above in an equal-area disk; logarithmic, four decades.
void drawHemisphere(Drawing& d, const BsdfDouble& b, double x, double y, double side) {
    constexpr std::uint32_t kPixels = 80;
    const glm::dvec3 wo = inPlane(-45);
    std::vector<double> values(std::size_t{kPixels} * kPixels, -1);
    double top = 0;
    for (std::uint32_t j = 0; j < kPixels; ++j) {
        for (std::uint32_t i = 0; i < kPixels; ++i) {
            const glm::dvec2 p(2 * (i + 0.5) / kPixels - 1, 1 - 2 * (j + 0.5) / kPixels);
            const double r2 = glm::dot(p, p);
            if (r2 >= 1) continue;
            const glm::dvec3 wi(p * std::sqrt(2 - r2), 1 - r2);
            top = std::max(top, values[std::size_t{j} * kPixels + i] = lobe(b, wo, wi));
        }
    }
    Image image(kPixels, kPixels, 3);
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double decades = values[i] > 0 && top > 0 ? std::log10(values[i] / top) : -4;
        const glm::vec3 c = values[i] < 0 ? glm::vec3(1) : falseColor(static_cast<float>(1 + decades / 4));
        std::copy_n(&c.x, 3, image.pixels.data() + 3 * i);
    }
    d.picture(x, y, side, std::move(image));
    d.text(x, y + side + 16, fmt::format("from 45 degrees (left): f cos, 4 decades to {:.3g}", top), 12);
}

}  // namespace

Drawing drawBsdfs(const std::vector<PicturedBsdf>& bsdfs) {
    const bool bothSides = std::ranges::any_of(bsdfs, [](const PicturedBsdf& p) { return p.bsdf->transmits(); });
    const double lobeHeight = (bothSides ? 1 : 0.5) * kPanel;
    Drawing d;
    d.width = kSpace + kLobePanels * (kPanel + kSpace);
    d.height = 2 * kHeading + lobeHeight + kSpace + static_cast<double>(bsdfs.size()) * (kPicture + kHeading + kSpace);
    for (std::size_t i = 0; i < kLobePanels; ++i) {
        const Plot plot{kSpace + kPanel / 2 + static_cast<double>(i) * (kPanel + kSpace), 1.5 * kHeading + kPanel / 2,
                        kPanel / 2};
        drawLobePanel(d, plot, kAngles[i], bsdfs, bothSides);
    }
    double y = 2 * kHeading + lobeHeight;
    d.text(kSpace, y, "f |cos| in the plane of incidence, radius: cube root over that of the largest value", 12,
           Align::Left, kGrey);
    y += kSpace;
    for (std::size_t i = 0; i < bsdfs.size(); ++i) {
        const PicturedBsdf& p = bsdfs[i];
        d.line(kSpace, y + 8, kSpace + 16, y + 8, 2.4, inkOf(i));
        d.text(kSpace + 24, y + 12, p.name, 13);
        y += kHeading / 2;
        constexpr std::uint32_t kPixels = 120, kSamples = 128;
        drawHemisphere(d, p.bsdf->seenFrom<double>(true), kSpace, y, kPicture);
        d.picture(2 * kSpace + kPicture + 100, y, kPicture,
                  renderBsdfSphere(p.bsdf->spec(), p.multiscatter, kPixels, kSamples));
        y += kPicture + kHeading / 2 + kSpace;
    }
    return d;
}

}  // namespace vkpt
