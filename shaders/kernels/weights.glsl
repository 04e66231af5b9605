// How light samples and BSDF samples share what both can find. [estimator.md, Options]
#include "math/mis.glsl"

// Samples of each kind that a vertex takes.
float lightSamples() { return kIntegrator == kIntegratorDirect ? float(render.lightSamples) : 1.0; }
float bsdfSamples() { return kIntegrator == kIntegratorDirect ? float(render.bsdfSamples) : 1.0; }

// Of a light sample.
float weightOfLightSample(float pdfLight, float pdfBsdf) {
    if (kStrategy == kStrategyLight) return 1.0;
    return misWeight(lightSamples() * pdfLight, bsdfSamples() * pdfBsdf, render.beta);
}

// Of a light that light samples reach, too, and that a BSDF sample met. pdfBsdf is negative for camera rays and mirrors,
// pdfLight 0 where light samples do not reach it from there.
float weightOfBsdfSample(float pdfBsdf, float pdfLight) {
    if (pdfBsdf < 0.0 || kStrategy == kStrategyBsdf) return 1.0;
    if (kStrategy == kStrategyLight) return pdfLight > 0.0 ? 0.0 : 1.0;
    return misWeight(bsdfSamples() * pdfBsdf, lightSamples() * pdfLight, render.beta);
}
