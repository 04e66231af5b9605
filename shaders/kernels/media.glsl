// Absorption inside dielectrics. [estimator.md, Media] A medium is 1 + the index of its material; 0: none.

// What is left of light after `distance` metres, of an infinite way too.
vec3 transmittance(uint medium, float distance) {
    if (kHasMedia == 0u || medium == 0u) return vec3(1.0);
    vec3 absorption = loadAbsorption(max(medium, 1u) - 1u);
    return mix(exp(-absorption * distance), vec3(1.0), equal(absorption, vec3(0.0)));   // 0 x infinity is NaN
}
