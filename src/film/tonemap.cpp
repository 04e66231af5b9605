#include "film/tonemap.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace vkpt {
namespace {

float maxComponent(glm::vec3 v) { return std::max({v.x, v.y, v.z}); }
float minComponent(glm::vec3 v) { return std::min({v.x, v.y, v.z}); }

/// [Khronos PBR Neutral 24, specification]
glm::vec3 neutral(glm::vec3 color) {
    constexpr float f90 = 0.04F;      // the specular reflection the mapper takes off again
    constexpr float ks = 0.8F - f90;  // compression starts here
    constexpr float kd = 0.15F;       // speed of desaturation
    const float x = minComponent(color);
    const float f = x <= 2 * f90 ? x - x * x / (4 * f90) : f90;
    const glm::vec3 base = color - f;
    const float p = maxComponent(base);
    if (p <= ks) return base;
    const float pn = 1 - (1 - ks) * (1 - ks) / (p + 1 - 2 * ks);
    const float g = 1 / (kd * (p - pn) + 1);
    return base * (pn / p * g) + pn * (1 - g);
}

/// Fit of the ACES reference rendering and sRGB output transforms [Hill 15]. The factor 1/0.6 is three.js's
/// brightness for this curve, which glTF authors know.
glm::vec3 aces(glm::vec3 color) {
    const glm::mat3 input{0.59719F, 0.07600F, 0.02840F, 0.35458F, 0.90834F, 0.13383F, 0.04823F, 0.01566F, 0.83777F};
    const glm::mat3 output{1.60475F,  -0.10208F, -0.00327F, -0.53108F, 1.10813F,
                           -0.07276F, -0.07367F, -0.00605F, 1.07602F};
    const glm::vec3 v = input * (color / 0.6F);
    const glm::vec3 a = v * (v + 0.0245786F) - 0.000090537F;
    const glm::vec3 b = v * (0.983729F * v + 0.4329510F) + 0.238081F;
    return output * (a / b);
}

/// AgX base look: inset matrix, log2 encoding over 16.5 stops, sixth-degree fit of the contrast curve, outset
/// matrix, display gamma 2.2 undone. [Wrensch 23]
glm::vec3 agx(glm::vec3 color) {
    const glm::mat3 inset{0.842479062253094F,  0.0423282422610123F, 0.0423756549057051F,
                          0.0784335999999992F, 0.878468636469772F,  0.0784336F,
                          0.0792237451477643F, 0.0791661274605434F, 0.879142973793104F};
    const glm::mat3 outset{1.19687900512017F,    -0.0528968517574562F, -0.0529716355144438F,
                           -0.0980208811401368F, 1.15190312990417F,    -0.0980434501171241F,
                           -0.0990297440797205F, -0.0989611768448433F, 1.15107367264116F};
    constexpr float minEv = -12.47393F, maxEv = 4.026069F;
    const glm::vec3 floored = glm::max(inset * color, glm::vec3(1e-10F));
    const glm::vec3 x = (glm::clamp(glm::log2(floored), minEv, maxEv) - minEv) / (maxEv - minEv);
    const glm::vec3 x2 = x * x, x4 = x2 * x2;
    const glm::vec3 contrast =
        15.5F * x4 * x2 - 40.14F * x4 * x + 31.96F * x4 - 6.868F * x2 * x + 0.4298F * x2 + 0.1191F * x - 0.00232F;
    return glm::pow(glm::max(outset * contrast, glm::vec3(0)), glm::vec3(2.2F));
}

}  // namespace

glm::vec3 toneMap(ToneMap map, glm::vec3 color) {
    glm::vec3 mapped = color;
    switch (map) {
        case ToneMap::Neutral:
            mapped = neutral(color);
            break;
        case ToneMap::Aces:
            mapped = aces(color);
            break;
        case ToneMap::Agx:
            mapped = agx(color);
            break;
        case ToneMap::None:
            break;
    }
    return glm::clamp(mapped, 0.0F, 1.0F);
}

float srgbEncode(float linear) {
    const float x = std::clamp(linear, 0.0F, 1.0F);
    return x <= 0.0031308F ? 12.92F * x : 1.055F * std::pow(x, 1 / 2.4F) - 0.055F;
}

Image displayImage(const Image& linear, const Display& display) {
    assert(linear.channels == 4);
    Image image(linear.width, linear.height, display.transparent ? 4 : 3);
    image.displayEncoded = true;
    const float scale = std::exp2(display.exposure);
    const std::size_t count = std::size_t{linear.width} * linear.height;
    for (std::size_t i = 0; i < count; ++i) {
        const float* in = &linear.pixels[4 * i];
        float* out = &image.pixels[image.channels * i];
        glm::vec3 color{in[0], in[1], in[2]};
        if (display.transparent) {
            out[3] = std::clamp(in[3], 0.0F, 1.0F);
            if (in[3] > 0) color /= in[3];
        }
        const glm::vec3 shown = toneMap(display.toneMap, glm::max(color * scale, 0.0F));
        for (int c = 0; c < 3; ++c) out[c] = srgbEncode(shown[c]);
    }
    return image;
}

}  // namespace vkpt
